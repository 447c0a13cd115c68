//! What fields show of the stresses of a shell beside their components: principal stresses with their directions, stresses of plies, reserve factors.

use std::io;

use mesh_io::{At, FieldWriter, Values, rows};
use shell_kinematics::{LayeredSection, Through};
use sph_core::Vec3;
use sph_shell::{PointResult, Shell};

use super::linear_forces::numbers;
use crate::bodies::StressFields;
use crate::bodies::invariants::{principal, tresca};
use crate::bodies::plies::{MOST_RESERVE, Plies, margin};
use crate::bodies::sampled::face_stress;
use crate::scene::units::{Quantity, Units};
use crate::scene::{Criterion, ShellFace};

const ONE_TWO: &[&str] = &["1", "2"];
const OF_FIBRE: &[&str] = &["along", "across", "shear"];
const FACES: [(&str, ShellFace); 3] =
    [("top", ShellFace::Top), ("middle", ShellFace::Middle), ("bottom", ShellFace::Bottom)];

/// The plies at a point, and what goes through them; none where stresses do not follow from strains.
type OfPoint<'a> = Option<(&'a LayeredSection, Through)>;

/// The sampling points of a shell with their strains and resultants.
pub(super) struct Stressed<'a> {
    pub shell: &'a Shell,
    pub results: &'a [PointResult],
    pub units: Units,
    /// Where strains are sampled.
    pub at: At,
}

impl Stressed<'_> {
    /// Writes what is wanted.
    pub fn write(&self, wanted: StressFields, to: &mut dyn FieldWriter) -> io::Result<()> {
        if wanted.principal && self.shell.homogeneous() {
            self.principal(to)?;
        }
        if !wanted.plies && wanted.reserve.is_none() {
            return Ok(());
        }
        let plies = Plies::of(self.shell, 0..self.results.len());
        // Of several bodies those show it that have it.
        let criterion = wanted.reserve.filter(|_| plies.any_strength());
        let through: Vec<OfPoint<'_>> = (0..self.results.len())
            .map(|i| {
                let mut found = self.results[i];
                plies.through(i, &numbers(&mut found))
            })
            .collect();
        if wanted.plies && !self.shell.homogeneous() {
            self.plies(plies.most(), &through, criterion, to)?;
        }
        criterion.map_or(Ok(()), |criterion| self.reserve(&through, criterion, to))
    }

    /// A row for each sampling point, in single precision.
    fn put<const N: usize>(
        &self,
        to: &mut dyn FieldWriter,
        name: &str,
        quantity: Quantity,
        components: &[&str],
        row: impl Fn(usize) -> [f64; N],
    ) -> io::Result<()> {
        let all = rows(self.results.len(), |i| row(i).map(|value| value as f32));
        to.numbers(self.at, name, &self.units.symbol(quantity), components, Values::Single(&all))
    }

    fn principal(&self, to: &mut dyn FieldWriter) -> io::Result<()> {
        for (name, face) in FACES {
            let found: Vec<([f64; 2], f64)> =
                (0..self.results.len()).map(|i| principal(self.at_face(i, face))).collect();
            self.put(to, &format!("principal_stress_{name}"), Quantity::Stress, ONE_TWO, |i| found[i].0)?;
            self.put(to, &format!("principal_direction_{name}"), Quantity::Ratio, &[], |i| {
                let (s, c) = libm::sincos(found[i].1);
                let [t1, t2] = self.frame(i);
                (t1 * c + t2 * s).into()
            })?;
            self.put(to, &format!("tresca_{name}"), Quantity::Stress, &[], |i| [tresca(found[i].0)])?;
        }
        Ok(())
    }

    fn at_face(&self, point: usize, face: ShellFace) -> [f64; 3] {
        let PointResult { force, moment, .. } = self.results[point];
        let section = self.shell.section_at(point);
        face_stress([force, moment], [section.thickness, section.height], face)
    }

    /// The directions of the components of a point as they lie now: the first along x,1, the second across it in the surface.
    pub(super) fn frame(&self, point: usize) -> [Vec3; 2] {
        let stencil = self.shell.reference().operator.stencil(point);
        let along = |weights: &[f64]| -> Vec3 {
            let of = |(&a, weight): (&u32, &f64)| self.shell.position(a as usize) * *weight;
            stencil.particles.iter().zip(weights).map(of).sum()
        };
        let [x1, x2] = [along(stencil.g1), along(stencil.g2)];
        let t1 = x1.normalize();
        [t1, x1.cross(&x2).normalize().cross(&t1)]
    }

    /// Stresses of each ply at both of its faces; zero where a point has fewer plies.
    fn plies(
        &self,
        most: usize,
        through: &[OfPoint<'_>],
        reserve: Option<Criterion>,
        to: &mut dyn FieldWriter,
    ) -> io::Result<()> {
        for ply in 0..most {
            let number = ply + 1;
            for (face, share) in [("bottom", 0.0), ("top", 1.0)] {
                let name = format!("ply_{number}_{face}");
                self.put(to, &name, Quantity::Stress, OF_FIBRE, |i| match &through[i] {
                    Some((own, through)) if ply < own.plies().len() => own.ply_stress(ply, through, share),
                    _ => [0.0; 3],
                })?;
            }
            if let Some(criterion) = reserve {
                let name = format!("ply_{number}_reserve_factor");
                self.put(to, &name, Quantity::Ratio, &[], |i| {
                    let of = |(own, through): &(&LayeredSection, Through)| {
                        margin(own, through, Some(ply), criterion).reserve
                    };
                    [through[i].as_ref().map_or(MOST_RESERVE, of).min(MOST_RESERVE)]
                })?;
            }
        }
        Ok(())
    }

    /// The least reserve factor, the number of its ply, zero where none has a strength, and the greatest failure index.
    fn reserve(
        &self,
        through: &[OfPoint<'_>],
        criterion: Criterion,
        to: &mut dyn FieldWriter,
    ) -> io::Result<()> {
        let of = |point: &OfPoint<'_>| {
            let Some((own, through)) = point else { return [MOST_RESERVE, 0.0, 0.0] };
            let worst = own.worst_ply(criterion.of_fibres(), through);
            let number = worst.map_or(0, |(ply, _)| ply + 1);
            let all = margin(own, through, None, criterion);
            [all.reserve.min(MOST_RESERVE), number as f64, all.index]
        };
        let found: Vec<[f64; 3]> = through.iter().map(of).collect();
        for (k, name) in ["reserve_factor", "worst_ply", "failure_index"].into_iter().enumerate() {
            self.put(to, name, Quantity::Ratio, &[], |i| [found[i][k]])?;
        }
        Ok(())
    }
}
