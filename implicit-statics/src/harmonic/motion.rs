//! A steady motion of all unknowns, and its energies over a cycle.

use std::f64::consts::PI;

use crate::Equilibrium;
use crate::pattern::product;
use crate::rank_one::RankOne;
use crate::vectors::dot;

/// Unknowns that go as `real cos ωt − imaginary sin ωt`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HarmonicMotion {
    /// What goes with the cosine, in phase with the load.
    pub real: Vec<f64>,
    /// What goes with the negative sine.
    pub imaginary: Vec<f64>,
}

impl HarmonicMotion {
    /// The motion at the phase of the cycle at which the sum of its squares, each times a weight, is largest.
    ///
    /// `|a cos θ − b sin θ|²` has its extremes where `tan 2θ = −2 a·b / (a·a − b·b)`.
    pub fn widest(&self, weights: &[f64]) -> Vec<f64> {
        let product = |x: &[f64], y: &[f64]| -> f64 {
            weights.iter().zip(x.iter().zip(y)).map(|(w, (x, y))| w * x * y).sum()
        };
        let (a, b) = (&self.real[..], &self.imaginary[..]);
        let theta = 0.5 * libm::atan2(-2.0 * product(a, b), product(a, a) - product(b, b));
        let (sin, cos) = libm::sincos(theta);
        a.iter().zip(b).map(|(a, b)| cos * a - sin * b).collect()
    }
}

/// Energies of a steady vibration \[F L\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CycleEnergies {
    /// Mean of what is stored in the stiffness, ¼ uᴴKu.
    pub internal: f64,
    /// Mean kinetic energy, ¼ ω² uᴴMu.
    pub kinetic: f64,
    /// What the loads bring in during a cycle, −π p·Im u.
    pub external: f64,
    /// What damping takes in a cycle, `π (Im κ uᴴKu + ωα uᴴMu)`.
    pub dissipated: f64,
}

impl CycleEnergies {
    /// Of `uᴴKu`, `uᴴMu` and `p·Im u` at a circular frequency, with α and Im κ.
    pub(super) fn of([stored, moving, out]: [f64; 3], omega: f64, (mass, loss): (f64, f64)) -> Self {
        Self {
            internal: 0.25 * stored,
            kinetic: 0.25 * omega * omega * moving,
            external: -PI * out,
            dissipated: PI * (loss * stored + omega * mass * moving),
        }
    }
}

/// K and M of a state, as they weigh motions.
pub struct EnergyForms {
    pub(super) pattern: Vec<(usize, usize)>,
    pub(super) stiffness: Vec<f64>,
    pub(super) beside: Vec<RankOne>,
    pub(super) masses: Vec<f64>,
}

impl EnergyForms {
    /// Of the present state of a system.
    pub fn of<E: Equilibrium + ?Sized>(system: &mut E, level: f64) -> Self {
        let pattern = system.pattern();
        let mut stiffness = vec![0.0; pattern.len()];
        system.tangent(level, &mut stiffness);
        Self { pattern, stiffness, beside: system.beside_pattern(level), masses: system.vibrating_masses() }
    }

    /// `uᴴKu`, `uᴴMu` and `Re p·Im u − Im p·Re u` under a load with both parts, the second empty where it is zero.
    pub(super) fn sums(&self, [real, imaginary]: [&[f64]; 2], motion: &HarmonicMotion) -> [f64; 3] {
        let stiff = |x: &[f64]| {
            quadratic(x, |x, image| {
                product(&self.pattern, &self.stiffness, x, image);
                self.beside.iter().for_each(|term| term.add_product(1.0, x, image));
            })
        };
        let stored = stiff(&motion.real) + stiff(&motion.imaginary);
        let moving = weighed(&self.masses, &motion.real) + weighed(&self.masses, &motion.imaginary);
        let ahead: f64 = imaginary.iter().zip(&motion.real).map(|(p, u)| p * u).sum();
        [stored, moving, dot(real, &motion.imaginary) - ahead]
    }

    /// Energies of a steady motion under a load `Re p cos ωt − Im p sin ωt`: damping takes what the load brings in.
    pub fn of_cycle(&self, load: [&[f64]; 2], motion: &HarmonicMotion, omega: f64) -> CycleEnergies {
        let found = CycleEnergies::of(self.sums(load, motion), omega, (0.0, 0.0));
        CycleEnergies { dissipated: found.external, ..found }
    }
}

/// `Σ m x²`.
pub(super) fn weighed(masses: &[f64], x: &[f64]) -> f64 {
    masses.iter().zip(x).map(|(m, x)| m * x * x).sum()
}

/// `x·Kx` by a product with K.
pub(super) fn quadratic(x: &[f64], product: impl FnOnce(&[f64], &mut [f64])) -> f64 {
    let mut image = vec![0.0; x.len()];
    product(x, &mut image);
    dot(x, &image)
}

#[cfg(test)]
mod tests {
    use super::HarmonicMotion;

    #[test]
    fn the_widest_phase_is_that_of_the_long_axis() {
        // On an ellipse with the half axes 5 and 1, the long one 40° from the first part, seen at some phase.
        let [long, short] = [[libm::cos(0.7), libm::sin(0.7)], [-libm::sin(0.7), libm::cos(0.7)]];
        let (sin, cos) = libm::sincos(0.4);
        let part = |x: f64, y: f64| (0..2).map(|k| 5.0 * x * long[k] + y * short[k]).collect::<Vec<f64>>();
        let motion = HarmonicMotion { real: part(cos, sin), imaginary: part(-sin, cos) };
        let widest = motion.widest(&[1.0; 2]);
        assert!((libm::hypot(widest[0], widest[1]) - 5.0).abs() < 1e-14);
    }
}
