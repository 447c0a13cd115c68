//! Strips of a cantilever: rolled up by an end couple, lifted by an end force.

use super::{CaseError, Solved, load_steps, solve_path};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// A strip without lateral contraction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Length \[L\].
    pub length: f64,
    /// Width \[L\].
    pub width: f64,
    /// Thickness \[L\].
    pub thickness: f64,
    /// Young's modulus \[F/L²\].
    pub young: f64,
}

impl Strip {
    /// The thick ring of `seed_ring_bending`, t/L = 0.1.
    pub const RING: Self = Self { length: 10.0, width: 1.0, thickness: 1.0, young: 1200.0 };
    /// The thin ring of `sze_cantilever_end_moment`, t/L = 1/120.
    pub const THIN_RING: Self = Self { length: 12.0, width: 1.0, thickness: 0.1, young: 1.2e6 };
    /// The strip of `sze_cantilever_end_shear`.
    pub const END_SHEAR: Self = Self { length: 10.0, width: 1.0, thickness: 0.1, young: 1.2e6 };

    /// Bending stiffness EI \[F L²\].
    fn bending(&self) -> f64 {
        self.young * self.width * self.thickness.powi(3) / 12.0
    }

    fn solve(
        &self,
        [columns, rows]: [usize; 2],
        load: impl Fn(Vec<usize>) -> Load,
        steps: usize,
    ) -> Result<Solved, CaseError> {
        let mesh = Mesh::plate(columns, rows, self.length, self.width);
        let supports = [Support::clamp(mesh.side(Side::XiStart))];
        let section = Section::isotropic(self.young, 0.0, self.thickness, 1.0);
        let model = Model::new(&mesh, section, Vector3::x(), &supports, &[load(mesh.side(Side::XiEnd))])?;
        let tip = mesh.node(columns, rows / 2);
        let names = ["level [-]", "minus_U_tip [length]", "W_tip [length]"];
        let (solved, path) = solve_path(model, &load_steps(steps), &names, |level, model| {
            let moved = model.displacement(tip);
            vec![level, -moved.x, moved.z]
        })?;
        path.end?;
        Ok(solved)
    }
}

/// Rolled up to a full circle by the couple 2πEI/L: elements along and across, load steps.
pub fn end_moment(strip: &Strip, elements: [usize; 2], steps: usize) -> Result<Solved, CaseError> {
    let couple = -Vector3::y() * (TAU * strip.bending() / strip.length);
    strip.solve(elements, |end| Load::EdgeCouple(end, couple), steps)
}

/// Lifted by the dead end force 4EI/L².
pub fn end_shear(strip: &Strip, elements: [usize; 2], steps: usize) -> Result<Solved, CaseError> {
    let force = Vector3::z() * (4.0 * strip.bending() / strip.length.powi(2));
    strip.solve(elements, |end| Load::Edge(end, force), steps)
}
