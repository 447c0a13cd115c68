//! How far masses of marches are from those of the surface, for motions as a whole.

use nalgebra::{DMatrix, Matrix3, Matrix6, SymmetricEigen, Vector6};
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::supports::DirectorHold;
use crate::formulation::Formulation;
use crate::junction::rotation::{across, of_arm};
use crate::second_moments::missing_moment;

/// Eigenvalues below this part of the largest count as zero: far above rounding, far below what holds one spacing away from an axis.
const FREE: f64 = 1e-10;

/// Inertia of marches over that of the surface, the ratio farthest from one \[–\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningInertia {
    /// Of rotations of the whole shell about its centre of mass.
    pub whole: f64,
    /// Of the rigid motions that supports leave free; none where they leave no rotation.
    pub free: Option<f64>,
}

/// A quadratic form of rigid motions `[τ, ω·size]`, `v = τ + ω × arm`.
fn form(mass: f64, moment: &Vec3, tensor: &Matrix3<f64>, size: f64) -> Matrix6<f64> {
    let mut form = Matrix6::zeros();
    form.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * mass));
    let coupling = moment.cross_matrix() / size;
    form.fixed_view_mut::<3, 3>(0, 3).copy_from(&-coupling);
    form.fixed_view_mut::<3, 3>(3, 0).copy_from(&coupling);
    form.fixed_view_mut::<3, 3>(3, 3).copy_from(&(tensor / (size * size)));
    form
}

/// The eigenvalue of one form over another on a space that is farthest from one.
fn farthest(one: &Matrix6<f64>, other: &Matrix6<f64>, basis: &DMatrix<f64>) -> f64 {
    let on = |form: &Matrix6<f64>| basis.transpose() * DMatrix::from_fn(6, 6, |i, j| form[(i, j)]) * basis;
    let root = SymmetricEigen::new(on(other));
    let scale = &root.eigenvectors * DMatrix::from_diagonal(&root.eigenvalues.map(|v| 1.0 / v.sqrt()));
    let ratios = SymmetricEigen::new(scale.transpose() * on(one) * &scale).eigenvalues;
    ratios
        .iter()
        .copied()
        .fold(1.0, |far, ratio| if (ratio - 1.0).abs() > f64::abs(far - 1.0) { ratio } else { far })
}

impl Shell {
    /// What lumped masses and scaled rotary inertia make of rigid motions; none where strains are sampled at the particles.
    ///
    /// Cells of n a side give a plate `1 + 2/n²` by their corners and `1/n²` more by its directors, however thin it is.
    pub fn turning_inertia(&self) -> Option<TurningInertia> {
        if !matches!(self.points.formulation, Formulation::StressPoint(_)) {
            return None;
        }
        let cloud = &self.reference.cloud;
        let [masses, inertias] = self.moving_masses();
        let alone = |a: &usize| self.dependents.ties.of(*a).is_none();
        let all = || (0..self.len()).filter(alone);
        let mass = all().map(|a| masses[a]).sum::<f64>();
        let centre = all().map(|a| cloud.positions[a] * masses[a]).sum::<Vec3>() / mass;
        let size = (all().map(|a| (cloud.positions[a] - centre).norm_squared() * masses[a]).sum::<f64>()
            / mass)
            .sqrt();
        // Lumped masses, and what is missing of the surface: of rigid cells both have it.
        let lumped = all().map(|a| of_arm(&(cloud.positions[a] - centre)) * masses[a]).sum::<Matrix3<f64>>();
        let (mut scaled, mut exact) = (lumped, lumped);
        for (c, cell) in cloud.cells.iter().enumerate() {
            let cell_mass = self.material.cell_mass(&self.reference, c);
            let moment = missing_moment(&self.reference, c, &centre) * cell_mass;
            let missing = Matrix3::identity() * moment.trace() - moment;
            let section = self.material.at(c);
            let own = section.thickness.powi(2) / 12.0 + section.height.powi(2);
            let turning = across(&cell.geometry(&cloud.positions).normal) * (cell_mass * own);
            exact += missing + turning;
            if self.dependents.junctions.body_around(cell).is_some() {
                scaled += missing + turning;
                continue;
            }
            for &b in cell.particles() {
                let b = b as usize;
                let share = cell_mass / f64::from(cell.count) / self.reference.masses[b];
                scaled += across(&cloud.frames[b].n) * (share * inertias[b]);
            }
        }
        let rest = self.reference.rest();
        let (mut mass, mut moment) = (mass, Vec3::zeros());
        for group in &self.dependents.junctions.groups {
            let Some(body) = &group.body else { continue };
            // The mass at its reference point; inertia of its own is in neither.
            let arm = group.pole(&rest) + body.arm(&group.triad(&rest)) - centre;
            mass += body.mass;
            moment += arm * body.mass;
            scaled += of_arm(&arm) * body.mass;
            exact += of_arm(&arm) * body.mass;
        }
        let forms = [scaled, exact].map(|tensor| form(mass, &moment, &tensor, size));
        let turns = DMatrix::from_fn(6, 3, |i, j| f64::from(u8::from(i == j + 3)));
        let free = self.free_motions(&centre, size);
        let spins = (0..free.ncols()).any(|k| free.column(k).rows(3, 3).norm() > FREE.sqrt());
        Some(TurningInertia {
            whole: farthest(&forms[0], &forms[1], &turns),
            free: spins.then(|| farthest(&forms[0], &forms[1], &free)),
        })
    }

    /// Orthonormal rigid motions `[τ, ω·size]` about a centre that no support holds, as columns.
    fn free_motions(&self, centre: &Vec3, size: f64) -> DMatrix<f64> {
        let mut held = Matrix6::<f64>::zeros();
        let mut hold = |e: &Vec3, moment: Vec3| {
            let row = Vector6::from_iterator(e.iter().copied().chain(moment.iter().map(|m| m / size)));
            held += row * row.transpose();
        };
        let rest = self.reference.rest();
        for a in (0..self.len())
            .filter(|&a| self.dependents.ties.of(a).is_none() && self.dependents.junctions.first(a) == a)
        {
            let Some(constraint) = self.constraint(a) else { continue };
            let group = self.dependents.junctions.of(a);
            let at = group.and_then(|group| {
                let body = group.body.as_ref()?;
                Some(group.pole(&rest) + body.arm(&group.triad(&rest)))
            });
            let arm = at.unwrap_or(self.reference.cloud.positions[a]) - centre;
            constraint.held.basis().iter().for_each(|e| hold(e, arm.cross(e)));
            let frame = self.reference.cloud.frames[a];
            let turns: Vec<Vec3> = match (constraint.director, group) {
                (DirectorHold::Free, _) => Vec::new(),
                (DirectorHold::InPlane(n), None) => vec![frame.n.cross(&n)],
                (DirectorHold::InPlane(n), Some(_)) => {
                    let plane = sph_core::Frame::from_normal(n);
                    vec![plane.t1, plane.t2]
                }
                (DirectorHold::Fixed, None) => vec![frame.t1, frame.t2],
                (DirectorHold::Fixed, Some(_)) => vec![Vec3::x(), Vec3::y(), Vec3::z()],
            };
            turns.iter().for_each(|axis| hold(&Vec3::zeros(), *axis * size));
        }
        let eigen = SymmetricEigen::new(held);
        let bound = FREE * eigen.eigenvalues.max();
        let free: Vec<usize> = (0..6).filter(|&i| eigen.eigenvalues[i] <= bound).collect();
        DMatrix::from_fn(6, free.len(), |i, j| eigen.eigenvectors[(i, free[j])])
    }
}
