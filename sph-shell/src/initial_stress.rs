//! Stresses that are there before anything is strained: of welding and forming, of a membrane that was stretched into its frame; and what of them and of
//! heat (heat.rs) is there at a level.
//!
//! A stress with the mean σ_m through the thickness t and a linear part, ±σ_b at the faces, has the resultants
//!
//! ```text
//! N₀ = t σ_m        M₀ = t²/6 σ_b + e N₀          e the height of the section over the particles
//! ```
//!
//! of the unstrained point: `N = N₀ + A e_m + B κ` ([`shell_kinematics::StressedPack`]). They need not be in balance. A balance is what statics finds
//! first, as it does of a preload ([`LoadCase::Preload`]); a march sets out from the unstrained shell.

use sph_core::Vec3;

use crate::Shell;
use crate::conditions::case::LoadCase;
use crate::conditions::spread::check_cells;
use crate::error::ShellError;
use crate::heat::Shares;
use crate::points::results::PointResult;
use crate::reference::Reference;
use crate::regions::PointSection;
use crate::statics::static_shell::StaticShell;

/// A direction closer to the normal than this has none in the surface.
const ACROSS: f64 = 1e-6;

/// Part of the forces of heat up to which what is left of them is rounding, where all of them cancel.
const ROUNDING: f64 = 1e-13;

/// A stress of some cells before they are strained.
#[derive(Clone, Debug)]
pub struct InitialStress {
    /// The cells.
    pub cells: Vec<u32>,
    /// Direction whose projection on the surface at rest is the first; without, the stress must be the same in all directions.
    pub axis: Option<Vec3>,
    /// Mean through the thickness, `σ11, σ22, σ12` \[F/L²\].
    pub membrane: [f64; 3],
    /// Linear part at the face to which the normal points, the opposite at the other \[F/L²\].
    pub bending: [f64; 3],
}

impl InitialStress {
    /// Components in a frame whose first direction sees the axis at `along`, a unit vector.
    fn turned([s11, s22, s12]: [f64; 3], [c, s]: [f64; 2]) -> [f64; 3] {
        [
            c * c * s11 + s * s * s22 - 2.0 * c * s * s12,
            s * s * s11 + c * c * s22 + 2.0 * c * s * s12,
            c * s * (s11 - s22) + (c * c - s * s) * s12,
        ]
    }
}

/// Resultants of each unstrained cell under stresses; those of one cell add up. `section` is what is read of the section of a cell.
///
/// # Errors
/// [`ShellError`] for empty sets, cells beyond the cloud, and an axis that stands on the surface somewhere.
pub(crate) fn resultants_of(
    stresses: &[InitialStress],
    reference: &Reference,
    section: impl Fn(usize) -> PointSection,
) -> Result<Vec<[f64; 6]>, ShellError> {
    let mut sums = vec![[0.0; 6]; reference.cloud.cells.len()];
    for (number, stress) in stresses.iter().enumerate() {
        check_cells("an initial stress", &stress.cells, &reference.cloud)?;
        for &cell in &stress.cells {
            let along = match stress.axis {
                Some(axis) => seen(reference, cell, &axis).ok_or(ShellError::StressAxis { number, cell })?,
                None => [1.0, 0.0],
            };
            let section = section(cell as usize);
            let [mean, faces] = [stress.membrane, stress.bending].map(|s| InitialStress::turned(s, along));
            let sum = &mut sums[cell as usize];
            for i in 0..3 {
                let force = section.thickness * mean[i];
                sum[i] += force;
                sum[3 + i] += section.thickness.powi(2) / 6.0 * faces[i] + section.height * force;
            }
        }
    }
    Ok(sums)
}

/// Where the projection of a direction on a cell at rest lies in the frame of its point, a unit vector.
fn seen(reference: &Reference, cell: u32, axis: &Vec3) -> Option<[f64; 2]> {
    let frame = &reference.operator.points[cell as usize].frame;
    let [a, b] = [axis.dot(&frame.t1), axis.dot(&frame.t2)];
    let size = libm::hypot(a, b);
    (size > ACROSS * axis.norm()).then(|| [a / size, b / size])
}

impl Shell {
    /// Whether some cells are under stress before they are strained.
    pub fn is_stressed(&self) -> bool {
        !self.material.stresses.is_empty()
    }

    /// Tension of the present state, of all directions \[F/L\], and bending stiffness \[F L\], means over the area at rest; none where it is
    /// not in tension.
    pub fn mean_tension(&self) -> Option<[f64; 2]> {
        let points = &self.reference.operator.points;
        let mut results = vec![PointResult::default(); points.len()];
        self.point_results(&mut results);
        let mut sums = [0.0; 3];
        for (p, PointResult { force, .. }) in results.iter().enumerate() {
            let weight = points[p].weight;
            let more = [1.0, 0.5 * (force[0] + force[1]), self.material.bending(p)];
            sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += weight * more);
        }
        let [area, tension, bending] = sums;
        (tension > 0.0).then(|| [tension / area, bending / area])
    }

    /// Whether a temperature of some cells changes.
    pub fn is_heated(&self) -> bool {
        self.material.heat.is_some()
    }

    /// Parts of initial stress and heat at a level of the case that is under way.
    fn shares(&self, level: f64) -> Shares {
        let part = |case: LoadCase| case.factor(self.loading.case, level);
        let (preload, loading) = (part(LoadCase::Preload), part(LoadCase::Loading));
        Shares { stress: part(self.material.stress_case), preload, loading }
    }

    /// Leaves so much of initial stress and heat as belongs to a level of the case that is under way.
    pub(crate) fn put_stress(&mut self, level: f64) {
        self.put_shares(&self.shares(level));
    }

    fn put_shares(&mut self, shares: &Shares) {
        let Self { material, points, .. } = self;
        match &material.heat {
            None => points.set_stress_share(shares.stress),
            Some(_) => points.put_stresses(|point| material.unstrained(point, shares)),
        }
    }

    /// Internal forces of parts of initial stress and heat by themselves in the present state, by rows; no state is changed, what is there of them is
    /// that of a level.
    pub(crate) fn forces_of_stress(&mut self, shares: &Shares, level: f64) -> Vec<[f64; 6]> {
        let none = Shares { stress: 0.0, preload: 0.0, loading: 0.0 };
        let [none, all] = [&none, shares].map(|shares| {
            self.put_shares(shares);
            self.evaluate_internal(false);
            (0..self.len()).map(|a| self.internal_force(a)).collect::<Vec<_>>()
        });
        self.put_stress(level);
        self.evaluate_internal(false);
        let difference =
            |(with, without): (&[f64; 6], &[f64; 6])| std::array::from_fn(|k| with[k] - without[k]);
        all.iter().zip(&none).map(difference).collect()
    }

    /// Norm of what parts of initial stress and heat exert on all particles, cells added up by size \[F\]; couples over `arc`.
    fn exerted(&self, arc: f64, shares: &Shares) -> f64 {
        let operator = &self.reference.operator;
        let mut sums = vec![0.0; self.len()];
        for p in 0..operator.points.len() {
            let (resultants, _) = self.material.unstrained(p, shares);
            let (stencil, weight) = (operator.stencil(p), operator.points[p].weight);
            let size = |of: &[f64]| of.iter().map(|value| value * value).sum::<f64>().sqrt();
            let force = weight * libm::hypot(size(&resultants[..3]), size(&resultants[3..]) / arc);
            for (k, &b) in stencil.particles.iter().enumerate() {
                sums[b as usize] += force * libm::hypot(stencil.g1[k], stencil.g2[k]);
            }
        }
        sums.iter().map(|sum| sum * sum).sum::<f64>().sqrt()
    }
}

impl<S: std::ops::DerefMut<Target = Shell>> StaticShell<S> {
    /// Whether the level of the analysis brings the initial stress up.
    pub fn stress_counted_by_level(&self) -> bool {
        self.shell.material.stress_case == LoadCase::Loading
    }

    /// Part of the forces of the initial stress that nothing in the unstrained shell balances \[–\]; zero without stress.
    ///
    /// Wants the unstrained shell as its present state, whose internal forces it evaluates.
    pub fn unbalanced_stress(&mut self) -> f64 {
        let stress = Shares { stress: 1.0, preload: 0.0, loading: 0.0 };
        if !self.shell.is_stressed() {
            return 0.0;
        }
        let whole = self.shell.exerted(self.dofs.arc, &stress);
        if whole == 0.0 {
            return 0.0;
        }
        let rows = self.shell.forces_of_stress(&stress, 1.0);
        let mut left = vec![0.0; self.dofs.count()];
        self.project(|a| rows[a], &mut left);
        left.iter().map(|force| force * force).sum::<f64>().sqrt() / whole
    }

    /// Takes what a unit of level adds to the forces of initial stress and heat along the unknowns, nothing where that is rounding.
    pub(crate) fn subtract_stress_rate(&mut self, level: f64, out: &mut [f64]) {
        let under_way = self.shell.loading.case;
        let part = |case: LoadCase| if case == under_way { 1.0 } else { 0.0 };
        let heated = self.shell.is_heated();
        let stressed = self.shell.is_stressed() && self.shell.material.stress_case == under_way;
        if !(stressed || heated) {
            return;
        }
        let stress = if stressed { 1.0 } else { 0.0 };
        let shares = Shares { stress, preload: part(LoadCase::Preload), loading: part(LoadCase::Loading) };
        let rows = self.shell.forces_of_stress(&shares, level);
        let mut rate = vec![0.0; out.len()];
        self.project(|a| rows[a], &mut rate);
        let size = || rate.iter().map(|force| force * force).sum::<f64>().sqrt();
        if heated && size() <= ROUNDING * self.shell.exerted(self.dofs.arc, &shares) {
            return;
        }
        out.iter_mut().zip(&rate).for_each(|(sum, part)| *sum -= part);
    }

    /// Norm of what heat and what comes with it exert at a level, cells added up by size \[F\]; zero of a shell that is not heated.
    pub(crate) fn stress_forces_at(&self, level: f64) -> f64 {
        if self.shell.is_heated() {
            self.shell.exerted(self.dofs.arc, &self.shell.shares(level))
        } else {
            0.0
        }
    }
}
