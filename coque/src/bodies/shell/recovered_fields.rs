//! What fields show of the stresses of a shell at its particles.

use std::io;

use mesh_io::{At, FieldWriter, Values, rows};
use sph_core::Vec3;

use super::stress_fields::Stressed;
use crate::bodies::invariants::{principal, von_mises};
use crate::bodies::recovered::{Share, recovery, section};
use crate::bodies::sampled::face_stress;
use crate::scene::ShellFace;
use crate::scene::units::Quantity;

const PLANE: &[&str] = &["11", "22", "12"];
const ACROSS: &[&str] = &["1", "2"];
const ONE_TWO: &[&str] = &["1", "2"];

/// Resultants at a particle along its own axes, and the section there.
struct Nodal {
    force: [f64; 3],
    moment: [f64; 3],
    shear_force: [f64; 2],
    /// Where the first axis points now.
    t1: Vec3,
    /// Thickness, and height of its middle \[L, L\].
    section: [f64; 2],
}

impl Stressed<'_> {
    /// Writes resultants at particles, of homogeneous shells stresses of both faces, principal ones where these are wanted.
    pub fn recovered(&self, with_principal: bool, to: &mut dyn FieldWriter) -> io::Result<()> {
        let nodal: Vec<Nodal> = recovery(self.shell, 0..self.shell.len() as u32)
            .iter()
            .map(|shares| self.nodal(shares))
            .collect();
        let t1 = rows(nodal.len(), |a| <[f64; 3]>::from(nodal[a].t1).map(|value| value as f32));
        to.numbers(At::Points, "nodal_t1", "", &[], Values::Single(&t1))?;
        let put = |to: &mut dyn FieldWriter, name: &str, quantity, of: &dyn Fn(&Nodal) -> [f64; 3]| {
            let all = rows(nodal.len(), |a| of(&nodal[a]).map(|value| value as f32));
            to.numbers(At::Points, name, &self.units.symbol(quantity), PLANE, Values::Single(&all))
        };
        put(to, "nodal_membrane_force", Quantity::ForcePerLength, &|own| own.force)?;
        put(to, "nodal_moment", Quantity::MomentPerLength, &|own| own.moment)?;
        let shear = rows(nodal.len(), |a| nodal[a].shear_force.map(|value| value as f32));
        let per_length = self.units.symbol(Quantity::ForcePerLength);
        to.numbers(At::Points, "nodal_shear_force", &per_length, ACROSS, Values::Single(&shear))?;
        if !self.shell.homogeneous() {
            return Ok(());
        }
        let stress = self.units.symbol(Quantity::Stress);
        let at = |own: &Nodal, face| face_stress([own.force, own.moment], own.section, face);
        for (name, face) in
            [("top", ShellFace::Top), ("middle", ShellFace::Middle), ("bottom", ShellFace::Bottom)]
        {
            if face != ShellFace::Middle {
                put(to, &format!("nodal_stress_{name}"), Quantity::Stress, &|own| at(own, face))?;
                let all = rows(nodal.len(), |a| [von_mises(at(&nodal[a], face)) as f32]);
                let name = format!("nodal_von_mises_{name}");
                to.numbers(At::Points, &name, &stress, &[], Values::Single(&all))?;
            }
            if with_principal {
                let all = rows(nodal.len(), |a| principal(at(&nodal[a], face)).0.map(|value| value as f32));
                let name = format!("nodal_principal_stress_{name}");
                to.numbers(At::Points, &name, &stress, ONE_TWO, Values::Single(&all))?;
            }
        }
        Ok(())
    }

    fn nodal(&self, shares: &[Share]) -> Nodal {
        let mut own = Nodal {
            force: [0.0; 3],
            moment: [0.0; 3],
            shear_force: [0.0; 2],
            t1: Vec3::zeros(),
            section: section(self.shell, shares),
        };
        for share in shares {
            let cell = &self.results[share.cell as usize];
            for (sum, part) in [(&mut own.force, cell.force), (&mut own.moment, cell.moment)] {
                sum.iter_mut().zip(share.tensor(part)).for_each(|(sum, part)| *sum += part);
            }
            let shear = share.vector(cell.shear_force);
            own.shear_force.iter_mut().zip(shear).for_each(|(sum, part)| *sum += part);
            let [t1, t2] = self.frame(share.cell as usize);
            let [cos, sin] = share.turn;
            own.t1 += (t1 * cos + t2 * sin) * share.weight;
        }
        own.t1 = own.t1.try_normalize(0.0).unwrap_or_default();
        own
    }
}
