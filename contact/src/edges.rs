//! Edges that cross between vertices: a guard that pushes them apart where vertices and faces do not see them.
//!
//! Vertices miss edges that cross between them, such as thin rims. A pair of edges has the energy
//!
//! ```text
//! U = k d_c² m φ(y),   y = d/d_c,   φ = −(1 − y)² ln y      k = 2κ Ā_A Ā_B/(Ā_A + Ā_B)
//! m = q(2 − q),        q = min(1, |e₁ × e₂|²/(10⁻² |e₁|²|e₂|² at rest))
//! ```
//!
//! d the distance of the segments, d_c half of the contact distance D, or D where both are rims, which have no faces beyond. In ordinary
//! contact, less than half of D deep, edges inside a surface are silent. m takes out pairs that are nearly parallel, whose nearest places jump.

use libm::log;
use sph_core::Vec3;

use crate::nearest::of_segments;

/// Square of the sine below which two edges count as nearly parallel.
const PARALLEL: f64 = 1e-2;
/// Distance over d_c that stands for all below: edges that would have come through.
const THROUGH: f64 = 1e-9;

/// A pair of edges that pushes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crossing {
    /// Energy \[F L\].
    pub energy: f64,
    /// Forces on the ends of both \[F\].
    pub forces: [Vec3; 4],
    /// Weights of the ends in the distance \[–\].
    pub weights: [f64; 4],
    /// Direction from the second edge to the first.
    pub normal: Vec3,
    /// Distance of the two \[L\].
    pub distance: f64,
    /// Curvature of the energy in the distance \[F/L\].
    pub curvature: f64,
}

/// Square of the sine from which the lines of two edges have a distance that rounding does not blur.
const CLEARLY: f64 = 1e-6;

/// Distance from which two edges push where faces touch at a distance \[L\].
pub(crate) fn of_edges(distance: f64, both_rims: bool) -> f64 {
    if both_rims { distance } else { 0.5 * distance }
}

/// The line through an edge, to be looked at with many others.
pub(crate) struct Line {
    start: Vec3,
    along: Vec3,
    /// Part of the square of its length \[L²\].
    part: f64,
}

impl Line {
    /// The line from one place to another.
    #[inline]
    pub fn through([a, b]: [Vec3; 2]) -> Self {
        let along = b - a;
        Self { start: a, along, part: CLEARLY * along.norm_squared() }
    }

    /// Whether that of another edge may be within a distance \[L\]: edges are no nearer than their lines, so most that are far need no more.
    #[inline]
    pub fn is_near(&self, [c, d]: [Vec3; 2], within: f64) -> bool {
        let other = d - c;
        let across = self.along.cross(&other);
        let (square, way) = (across.norm_squared(), across.dot(&(self.start - c)));
        way * way <= (1.0 + CLEARLY) * within * within * square || square < self.part * other.norm_squared()
    }
}

/// Two edges of a stiffness \[F/L\] within a distance \[L\] of each other, with the product of the squares of their lengths at rest; none where they do not push.
pub(crate) fn crossing([a, b, c, d]: [Vec3; 4], within: f64, stiffness: f64, rest: f64) -> Option<Crossing> {
    let ([s, t], square) = of_segments([a, b], [c, d]);
    if square >= within * within {
        return None;
    }
    let (e, f) = (b - a, d - c);
    let across = e.cross(&f);
    let q = across.norm_squared() / (PARALLEL * rest);
    let (m, slope_of_m) =
        if q < 1.0 { (q * (2.0 - q), 2.0 * (1.0 - q) / (PARALLEL * rest)) } else { (1.0, 0.0) };
    let weights = [1.0 - s, s, t - 1.0, -t];
    let r = a * weights[0] + b * weights[1] + c * weights[2] + d * weights[3];
    let distance = square.sqrt();
    let normal = if distance > 0.0 { r / distance } else { Vec3::zeros() };
    let y = (distance / within).max(THROUGH);
    let (left, ln) = (1.0 - y, log(y));
    let phi = -left * left * ln;
    let slope = 2.0 * left * ln - left * left / y;
    let second = -2.0 * ln + 4.0 * left / y + (left / y) * (left / y);
    let push = -stiffness * within * m * slope;
    // ∂|e × f|²/∂e = 2 f × (e × f), ∂/∂f = −2 e × (e × f).
    let turn = -stiffness * within * within * phi * slope_of_m * 2.0;
    let [of_e, of_f] = [f.cross(&across) * turn, e.cross(&across) * -turn];
    let apart = [-of_e, of_e, -of_f, of_f];
    let forces = std::array::from_fn(|i| normal * (push * weights[i]) + apart[i]);
    let energy = stiffness * within * within * m * phi;
    Some(Crossing { energy, forces, weights, normal, distance, curvature: stiffness * m * second })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Central differences of 1e-6 of an energy of the order of one: 3e-9 measured at most.
    #[test]
    fn forces_of_two_edges_are_the_gradient_of_their_energy_nearly_parallel_ones_too() {
        let (within, stiffness) = (0.5, 3.0);
        let energy = |x: [Vec3; 4]| crossing(x, within, stiffness, 1.0).map_or(0.0, |found| found.energy);
        let mut active = [0, 0];
        for seed in 0..200 {
            let number = |k: usize| libm::sin(1.3 * seed as f64 + 2.1 * k as f64);
            let turned = 0.04 * (seed % 40) as f64;
            let along = Vec3::new(libm::cos(turned), libm::sin(turned), 0.1 * number(0));
            let a = Vec3::new(-0.5 + 0.3 * number(1), 0.3 * number(2), 0.0);
            let c = along * -0.5 + Vec3::new(0.0, 0.0, 0.25 + 0.2 * number(3));
            let x = [a, a + Vec3::x(), c, c + along];
            let Some(found) = crossing(x, within, stiffness, 1.0) else { continue };
            active[usize::from(found.curvature > 0.0 && turned < 0.1)] += 1;
            assert!(found.forces.iter().sum::<Vec3>().norm() < 1e-12 * (1.0 + found.forces[0].norm()));
            let moment: Vec3 = x.iter().zip(&found.forces).map(|(x, f)| x.cross(f)).sum();
            assert!(moment.norm() < 1e-12 * (1.0 + found.forces[0].norm()));
            for i in 0..4 {
                for k in 0..3 {
                    let moved = |by: f64| {
                        let mut x = x;
                        x[i][k] += by;
                        energy(x)
                    };
                    let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                    let error = (slope + found.forces[i][k]).abs() / (1.0 + slope.abs());
                    assert!(error < 1e-8, "{seed} {i} {k}: {slope} {}", found.forces[i][k]);
                }
            }
        }
        assert!(active[0] > 20 && active[1] > 5, "{active:?}");
    }
}
