//! What follows from the strains of a shell at some of its points: stresses, section forces, energy.

use super::invariants::{principal, tresca, von_mises};
use super::plies::{OfPlies, Plies};
use super::point_numbers::POINT_NUMBERS;
use super::recovered::Share;
use crate::scene::{Measured, ShellFace};

/// What is known of a point at rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointAtRest {
    /// The direction of the column in the frame of the point, a unit vector where it has one.
    pub along: [f64; 2],
    /// Thickness, and height of its middle over the particles \[L\].
    pub section: [f64; 2],
    /// Area \[L²\].
    pub area: f64,
    /// Resultants of the unstrained point, as in [`sph_shell::PointSection`].
    pub initial: [f64; 6],
}

/// Points at which a column is measured.
#[derive(Clone, Debug)]
pub(crate) struct Sampled {
    pub of: Measured,
    pub face: Option<ShellFace>,
    pub points: Vec<PointAtRest>,
    /// Of values at particles what the cells that are read give to each, by their places among those; empty where points are cells.
    pub recovered: Vec<Vec<(usize, Share)>>,
    /// Plies at the same points, of what follows from theirs.
    pub plies: Option<(Plies, OfPlies)>,
}

impl Sampled {
    /// The value at each point.
    pub fn values(&self, numbers: &[[f64; POINT_NUMBERS]]) -> Vec<f64> {
        if let Some((plies, of)) = &self.plies {
            return (0..).zip(numbers).map(|(point, numbers)| plies.value(point, *of, numbers)).collect();
        }
        if !self.recovered.is_empty() {
            let at_particles = self.points.iter().zip(&self.recovered);
            return at_particles
                .map(|(point, shares)| self.value(point, &resultants(shares, numbers)))
                .collect();
        }
        self.points.iter().zip(numbers).map(|(point, numbers)| self.value(point, numbers)).collect()
    }

    fn value(&self, point: &PointAtRest, numbers: &[f64; POINT_NUMBERS]) -> f64 {
        let PointAtRest { along: [a, b], section, area, initial } = *point;
        let three = |first: usize| [numbers[first], numbers[first + 1], numbers[first + 2]];
        let (force, moment) = (three(8), three(11));
        let along = |[t11, t22, t12]: [f64; 3]| a * a * t11 + b * b * t22 + 2.0 * a * b * t12;
        let stress = |face: ShellFace| face_stress([force, moment], section, face);
        // The worse of both faces where none is named.
        let worst = |of: &dyn Fn([f64; 3]) -> f64| match self.face {
            Some(face) => of(stress(face)),
            None => of(stress(ShellFace::Top)).max(of(stress(ShellFace::Bottom))),
        };
        match (self.of, self.face) {
            (Measured::VonMises, _) => worst(&von_mises),
            (Measured::Tresca, _) => worst(&|stress| tresca(principal(stress).0)),
            (Measured::MaxPrincipal, _) => worst(&|stress| principal(stress).0[0]),
            (Measured::MinPrincipal, _) => -worst(&|stress| -principal(stress).0[1]),
            (Measured::PrincipalAngle, face) => {
                let ([first, second], angle) = principal(stress(face.unwrap_or(ShellFace::Top)));
                if first == second {
                    return 0.0;
                }
                // Axes half a turn apart are one.
                let (s, c) = libm::sincos(2.0 * (angle - libm::atan2(b, a)));
                0.5 * libm::atan2(s, c)
            }
            (Measured::Stress, face) => along(stress(face.unwrap_or(ShellFace::Top))),
            (Measured::MembraneForce, _) => along(force),
            (Measured::BendingMoment, _) => along(moment),
            (Measured::ShearForce, _) => a * numbers[14] + b * numbers[15],
            // N₀·e + M₀·κ and half of what the others do; counted from the unstrained point.
            _ => {
                let work: f64 = (0..8).map(|i| numbers[i] * numbers[8 + i]).sum();
                let more: f64 = (0..6).map(|i| numbers[i] * initial[i]).sum();
                0.5 * area * (work + more)
            }
        }
    }
}

/// Resultants at a particle, in a row of numbers whose strains are zero.
fn resultants(shares: &[(usize, Share)], numbers: &[[f64; POINT_NUMBERS]]) -> [f64; POINT_NUMBERS] {
    let mut all = [0.0; POINT_NUMBERS];
    for (cell, share) in shares {
        let own = &numbers[*cell];
        let [force, moment] = [8, 11].map(|first| share.tensor([own[first], own[first + 1], own[first + 2]]));
        let shear = share.vector([own[14], own[15]]);
        let row = force.into_iter().chain(moment).chain(shear);
        all[8..].iter_mut().zip(row).for_each(|(sum, part)| *sum += part);
    }
    all
}

/// `σ11, σ22, σ12` \[F/L²\] at a face, from membrane forces and moments: `σ = N/t ± 6(M − eN)/t²`, the linear course of a
/// homogeneous elastic section of the thickness t whose middle lies at the height e over the particles; `N/t` in the middle.
///
/// Components along the frame of the point, per reference area; membrane strains are assumed small.
pub(crate) fn face_stress(
    [force, moment]: [[f64; 3]; 2],
    [thickness, height]: [f64; 2],
    face: ShellFace,
) -> [f64; 3] {
    let side = match face {
        ShellFace::Top => 1.0,
        ShellFace::Bottom => -1.0,
        ShellFace::Middle => return force.map(|force| force / thickness),
    };
    let bending = side * 6.0 / (thickness * thickness);
    std::array::from_fn(|i| force[i] / thickness + bending * (moment[i] - height * force[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_integrate_back_to_the_resultants() {
        let (n, m, t, e) = ([3.0, -1.0, 0.5], [0.2, 0.4, -0.1], 0.3, 0.7);
        let [top, bottom] = [ShellFace::Top, ShellFace::Bottom].map(|face| face_stress([n, m], [t, e], face));
        for i in 0..3 {
            // N = t (σ_top + σ_bottom)/2 and M = t² (σ_top − σ_bottom)/12 + e N for a linear course.
            assert!((t * (top[i] + bottom[i]) / 2.0 - n[i]).abs() < 1e-14);
            assert!((t * t * (top[i] - bottom[i]) / 12.0 + e * n[i] - m[i]).abs() < 1e-14);
        }
    }
}
