//! The volume that flows through a line of a plane, or through a face in space, in a time.
//!
//! Each particle whose foot on the section lies within its bounds counts with its volume at rest V₀ = Δxᵈ, its velocity along
//! the normal, and a cubic B-spline β of its distance s from the section, of half width 2Δx and integral one:
//!
//! ```text
//! Q = Σ_a V₀ (v_a·n) β(s_a)  =  d/dt Σ_a V₀ B(s_a),    B' = β
//! ```
//!
//! so that the integral of Q over time is V₀ times the number of particles that have passed. Splines of particles Δx apart sum
//! to 1/Δx wherever the section lies: of a lattice in uniform motion the flux is that of a continuum.

use sph_core::Vec3;

use crate::fluid::Fluid;

/// Component of a normal along an axis above which it is that axis: rounding.
const ALONG: f64 = 1.0 - 1e-12;

/// A line in a plane, a face in space, through which a fluid flows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// A point of it \[L\].
    pub point: Vec3,
    /// Its unit normal, along which flow counts as positive.
    pub normal: Vec3,
    /// Least coordinates of the part that counts, itself included \[L\].
    pub min: Vec3,
    /// Greatest coordinates of that part, itself not included \[L\].
    pub max: Vec3,
}

impl Section {
    /// Distance of a place along the normal \[L\]; none where its foot lies beside the section.
    fn distance(&self, at: &Vec3, fluid: &Fluid) -> Option<f64> {
        let (way, dimensions) = (at - self.point, fluid.dimensions);
        // Across periodic sides that it lies along, a particle is as far as the nearer of its images.
        let (normal, axis) = (self.normal, self.normal.iamax());
        let round = if normal[axis].abs() > ALONG { fluid.shortest(way)[axis] - way[axis] } else { 0.0 };
        let distance = normal.dot(&way) + normal[axis] * round;
        let foot = at - normal * (distance - normal[axis] * round);
        let within = (0..dimensions).all(|i| self.min[i] <= foot[i] && foot[i] < self.max[i]);
        within.then_some(distance)
    }
}

impl Fluid {
    /// Volume at rest of so many of its particles that flows through a section in a time \[L³/T; L²/T in a plane\], with the
    /// velocities of [`Fluid::velocities`].
    pub fn flux(&self, section: &Section, particles: impl Iterator<Item = usize>) -> f64 {
        let volume = self.mass / self.liquid.density;
        let (positions, velocities) = (&self.shown().positions, &self.shown().velocities);
        let own = |a: usize| {
            let Some(distance) = section.distance(&positions[a], self) else { return 0.0 };
            volume * velocities[a].dot(&section.normal) * spline(distance / self.spacing) / self.spacing
        };
        particles.map(own).sum()
    }
}

/// The cubic B-spline on whole numbers: its shifts by one sum to one.
fn spline(x: f64) -> f64 {
    let x = x.abs();
    if x < 1.0 {
        2.0 / 3.0 - x * x * (1.0 - 0.5 * x)
    } else if x < 2.0 {
        (2.0 - x).powi(3) / 6.0
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of four numbers of order one.
    #[test]
    fn shifted_splines_sum_to_one() {
        for i in 0..=20 {
            let at = f64::from(i) / 20.0;
            let sum: f64 = (-3..=3).map(|k| spline(at - f64::from(k))).sum();
            assert!((sum - 1.0).abs() < 1e-15, "{at}: {sum}");
        }
    }
}
