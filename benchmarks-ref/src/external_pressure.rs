//! Rings and long cylinders under pressure from outside that stays normal to the surface: when they buckle, and how.

use std::f64::consts::PI;

/// A round shell of revolution about a straight axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// Young's modulus \[F/L²\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Radius of the mid-surface \[L\].
    pub radius: f64,
    /// Thickness \[L\].
    pub thickness: f64,
}

/// The pressure at which a ring of bending stiffness EI buckles into n ≥ 2 waves, `(n² − 1) EI/R³` \[timoshenko1961\] §7.4.
///
/// EI and the pressure are per width, or both whole. The pressure follows the ring; one that keeps its direction and the
/// length on which it acts asks for n² in the place of n² − 1, which is 4 for an oval.
pub fn ring(bending_stiffness: f64, radius: f64, waves: u32) -> f64 {
    (f64::from(waves).powi(2) - 1.0) * bending_stiffness / radius.powi(3)
}

/// The pressure on the mantle at which a cylinder between diaphragms buckles into n ≥ 2 waves around and one along its
/// length L \[F/L²\], von Mises 1914 as \[timoshenko1961\] §11.5 has it:
///
/// ```text
/// p = (Et/R) / [(n² − 1)(1 + n²L²/π²R²)²] + (D/R³) [n² − 1 + (2n² − 1 − ν)/(1 + n²L²/π²R²)]
/// ```
///
/// The ends bear no thrust and the state before buckling is a hoop stress alone.
pub fn cylinder(tube: &Tube, length: f64, waves: u32) -> f64 {
    let Tube { young, poisson, radius, thickness } = *tube;
    let square = f64::from(waves).powi(2);
    let slender = 1.0 + square * (length / (PI * radius)).powi(2);
    let bending = young * thickness.powi(3) / (12.0 * (1.0 - poisson * poisson) * radius.powi(3));
    young * thickness / (radius * (square - 1.0) * slender * slender)
        + bending * (square - 1.0 + (2.0 * square - 1.0 - poisson) / slender)
}

/// The least of [`cylinder`] over the number of waves, and that number.
pub fn least(tube: &Tube, length: f64) -> (f64, u32) {
    (2..100)
        .map(|waves| (cylinder(tube, length, waves), waves))
        .fold((f64::INFINITY, 2), |best, next| if next.0 < best.0 { next } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const TUBE: Tube = Tube { young: 210e3, poisson: 0.3, radius: 100.0, thickness: 1.0 };

    #[test]
    fn an_endless_cylinder_is_a_ring_in_plane_strain() {
        let plate = TUBE.young / (12.0 * (1.0 - 0.09));
        for waves in 2..6 {
            assert_relative_eq!(
                cylinder(&TUBE, 1e6, waves),
                ring(plate, TUBE.radius, waves),
                max_relative = 1e-6
            );
        }
    }

    /// Shallow-shell theory (Batdorf), `p R/Et = (n² + λ²)² t²/(12(1 − ν²) R² n²) + λ⁴/(n² (n² + λ²)²)` with λ = πR/L, leaves
    /// out terms of the order of 1/n² that von Mises has; the thinner the tube, the more waves and the less they differ.
    #[test]
    fn many_waves_are_those_of_shallow_shells() {
        let mut before = 0;
        for thickness in [1.0, 0.1, 0.01] {
            let tube = Tube { thickness, ..TUBE };
            let length = 2.0 * tube.radius;
            let (pressure, waves) = least(&tube, length);
            let (n2, l2) = (f64::from(waves).powi(2), (PI * tube.radius / length).powi(2));
            let slope = thickness.powi(2) / (12.0 * 0.91 * tube.radius.powi(2));
            let shallow = (n2 + l2).powi(2) * slope / n2 + l2 * l2 / (n2 * (n2 + l2).powi(2));
            let found = pressure * tube.radius / (tube.young * thickness);
            assert!(waves > before);
            assert_relative_eq!(found, shallow, max_relative = 1.0 / n2);
            before = waves;
        }
    }

    #[test]
    fn short_cylinders_buckle_into_more_waves() {
        let waves = [2.0, 3.0, 5.0, 9.0, 24.0].map(|times| least(&TUBE, times * TUBE.radius).1);
        assert_eq!(waves, [6, 5, 4, 3, 2]);
    }
}
