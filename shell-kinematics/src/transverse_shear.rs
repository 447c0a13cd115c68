//! How much of the sum of the plies' shear stiffnesses a section has: the shear stress of bending in place of an even strain.
//!
//! A section that is bent by a moment growing along it carries the shear stress that balances its membrane stresses, `τ = Q g/D` with
//!
//! ```text
//! g(z) = ∫_bottom^z E (ζ − z₀) dζ     D = ∫ E (z − z₀)² dz     z₀ = ∫ E z dz / ∫ E dz
//! ```
//!
//! and the energy `½ ∫ τ²/G dz = ½ Q²/S` makes its stiffness `1/S = ∫ g²/G dz / D²`: ⅚ G t of one material (Reissner), next to `G t (1 + t_f/t)²` of a
//! soft core of thickness t and modulus G between thin faces t_f each. E and G are those of a ply's mean direction, so that the factor `S/∫ G dz` knows no
//! axes.

use crate::section::SHEAR_CORRECTION;

/// A ply as far as transverse shear goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sheared {
    /// E, in its plane \[F/L²\].
    pub stretch: f64,
    /// G, across it \[F/L²\].
    pub shear: f64,
    /// Thickness \[L\].
    pub thickness: f64,
}

/// `S/∫ G dz` \[–\]; Reissner's factor to the bit where all plies are alike.
pub(crate) fn shear_correction(plies: &[Sheared]) -> f64 {
    let alike = |pair: &[Sheared]| [pair[0].stretch, pair[0].shear] == [pair[1].stretch, pair[1].shear];
    if plies.windows(2).all(alike) {
        return SHEAR_CORRECTION;
    }
    let sum = |of: &dyn Fn(&Sheared, f64) -> f64| {
        let mut bottom = 0.0;
        let mut sum = 0.0;
        for ply in plies {
            sum += of(ply, bottom);
            bottom += ply.thickness;
        }
        sum
    };
    let stretch = sum(&|ply, _| ply.stretch * ply.thickness);
    let middle = sum(&|ply, bottom| ply.stretch * ply.thickness * (bottom + 0.5 * ply.thickness)) / stretch;
    let bending = sum(&|ply, bottom| {
        let (t, z) = (ply.thickness, bottom + 0.5 * ply.thickness - middle);
        ply.stretch * t * (z * z + t * t / 12.0)
    });
    let shear = sum(&|ply, _| ply.shear * ply.thickness);
    let (mut below, mut bottom, mut soft) = (0.0, -middle, 0.0);
    for ply in plies {
        // g² has the degree 4 in z: three Gauss points are exact.
        let to = |z: f64| below + 0.5 * ply.stretch * (z - bottom) * (z + bottom);
        let place = 0.5 * 0.6_f64.sqrt();
        for (at, weight) in [(0.5 - place, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + place, 5.0 / 18.0)] {
            let g = to(bottom + at * ply.thickness);
            soft += weight * ply.thickness * g * g / ply.shear;
        }
        below = to(bottom + ply.thickness);
        bottom += ply.thickness;
    }
    bending * bending / (soft * shear)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ply(stretch: f64, shear: f64, thickness: f64) -> Sheared {
        Sheared { stretch, shear, thickness }
    }

    #[test]
    fn plies_of_one_material_have_reissners_factor() {
        assert_eq!(shear_correction(&[ply(3.0, 1.1, 0.2), ply(3.0, 1.1, 0.7)]), SHEAR_CORRECTION);
        // By the integral: a ply whose modulus differs in its last digit.
        let nearly = [ply(3.0, 1.1, 0.2), ply(3.0_f64.next_up(), 1.1, 0.7), ply(3.0, 1.1, 0.1)];
        assert!((shear_correction(&nearly) / SHEAR_CORRECTION - 1.0).abs() < 1e-14);
    }

    /// Between faces much stiffer than the core, and thin, shear runs evenly through the core over the distance of the faces' middles.
    #[test]
    fn a_soft_core_carries_the_shear_of_a_sandwich() {
        let [core, face] = [10.0, 0.01];
        let plies = [ply(1e6, 4e5, face), ply(1.0, 0.4, core), ply(1e6, 4e5, face)];
        let whole = 2.0 * 4e5 * face + 0.4 * core;
        let stiffness = shear_correction(&plies) * whole;
        let sandwich = 0.4 * (core + face) * (core + face) / core;
        println!("{:.1e}", stiffness / sandwich - 1.0);
        // 3e-4 of it: the bending of the core itself, of 1e-6/.006 of the faces' stiffness, and of each face.
        assert!((stiffness / sandwich - 1.0).abs() < 1e-3, "{stiffness} {sandwich}");
    }

    #[test]
    fn the_order_of_plies_and_units_do_not_matter() {
        let plies = [ply(2.0, 0.5, 0.3), ply(9.0, 0.2, 0.1), ply(1.0, 3.0, 0.4)];
        let mut turned = plies;
        turned.reverse();
        let units = plies.map(|own| ply(own.stretch * 1e9, own.shear * 1e9, own.thickness * 1e-3));
        let wanted = shear_correction(&plies);
        for other in [turned, units] {
            assert!((shear_correction(&other) / wanted - 1.0).abs() < 1e-13);
        }
    }
}
