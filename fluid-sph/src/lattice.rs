//! What a lattice of particles under pressure resists of shear, which a fluid does not.
//!
//! Under one pressure P the forces `−m 2P/ρ² ∇W` have the energy `P w` a volume, `w = Σ V W(r)` the sum of the kernel at a
//! particle. A fluid keeps its energy where it is sheared at constant volume, w of a lattice does not: `x → x + γy` has
//!
//! ```text
//! G/P = ∂²w/∂γ² = Σ V (F y² + F′ x²y²/r),   F = W′/r
//! ```
//!
//! a shear modulus for any spacing. Square and cubic lattices have two, C₄₄ of shear along their rows and C′ of shear at 45°
//! to them, a stretch along them. Under gravity, P = ρg(H − y), they add to the energy of a standing wave of
//! `φ = cosh ky cos kx` in parts of that of its surface
//!
//! ```text
//! ω²/ω₀² − 1 = (C′/P) (1 + s²) + (C₄₄/P) (1 − s²),   s = kH/sinh kH
//! ```
//!
//! where the lattice stays whole and along the walls: at most twice the greater one, so that its frequency is high by G/P at
//! most. At h = 1.3 Δx, C′/P = .109 gives a basin with kH = 1.18 8.6 %; 5.4 % are found, as parts of the lattice give way.

use crate::kernel::Wendland;

/// Shear moduli over the pressure \[–\] of a square (two dimensions) or a cubic lattice (three) by the smoothing length in
/// spacings: C₄₄ of shear along its rows, and C′ of shear at 45° to them. A fluid has none; a negative one lets the lattice
/// rearrange.
pub fn lattice_moduli(dimensions: usize, smoothing: f64) -> [f64; 2] {
    let kernel = Wendland::new(dimensions, smoothing);
    let reach = libm::ceil(kernel.reach()) as i32;
    let depth = if dimensions == 2 { 0 } else { reach };
    let (mut rows, mut across) = (0.0, 0.0);
    for (i, j) in (-reach..=reach).flat_map(|i| (-reach..=reach).map(move |j| (i, j))) {
        for k in -depth..=depth {
            let square = f64::from(i * i + j * j + k * k);
            if square == 0.0 {
                continue;
            }
            let distance = square.sqrt();
            let (x2, y2) = (f64::from(i * i), f64::from(j * j));
            let (slope, curve) = (kernel.factor(distance), kernel.factor_slope(distance) / distance);
            rows += slope * y2 + curve * x2 * y2;
            // Turned by 45°, y² becomes ½(x² + y²) in the mean and x²y² ¼(x² − y²)².
            across += 0.5 * slope * (x2 + y2) + 0.25 * curve * (x2 - y2) * (x2 - y2);
        }
    }
    [rows, across]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formulation::Formulation;

    /// w of a lattice whose rows lie at an angle to x, sheared by γ along x.
    fn sum(dimensions: usize, smoothing: f64, angle: f64, shear: f64) -> f64 {
        let kernel = Wendland::new(dimensions, smoothing);
        let (cosine, sine) = (libm::cos(angle), libm::sin(angle));
        let depth = if dimensions == 2 { 0 } else { 6 };
        let mut sum = 0.0;
        for (i, j) in (-6_i32..=6).flat_map(|i| (-6_i32..=6).map(move |j| (i, j))) {
            for k in -depth..=depth {
                let [i, j, z] = [i, j, k].map(f64::from);
                let (x, y) = (cosine * i - sine * j, sine * i + cosine * j);
                let x = x + shear * y;
                sum += kernel.value((x * x + y * y + z * z).sqrt());
            }
        }
        sum
    }

    /// The second difference of the kernel's own sum over sheared lattices: its error is of the square of .001.
    #[test]
    fn moduli_are_the_second_derivative_of_the_sum_over_a_sheared_lattice() {
        for dimensions in [2, 3] {
            for smoothing in [1.2, 1.3, 1.55, 2.0] {
                let moduli = lattice_moduli(dimensions, smoothing);
                for (angle, modulus) in [0.0, 0.25 * std::f64::consts::PI].into_iter().zip(moduli) {
                    let [less, none, more] =
                        [-1e-3, 0.0, 1e-3].map(|shear| sum(dimensions, smoothing, angle, shear));
                    let second = (less - 2.0 * none + more) / 1e-6;
                    assert!(
                        (second - modulus).abs() < 1e-4,
                        "{dimensions} {smoothing} {angle}: {second}, {modulus}"
                    );
                }
            }
        }
    }

    /// The default width is one at which lattices hardly resist: −.007, −.007 in a plane, −.011, .008 in space. The width that
    /// was the default before had .109 and .062.
    #[test]
    fn the_default_width_leaves_a_lattice_as_soft_as_a_fluid() {
        for dimensions in [2, 3] {
            for modulus in lattice_moduli(dimensions, Formulation::default().smoothing) {
                assert!(modulus.abs() < 0.012, "{dimensions}: {modulus}");
            }
        }
        let [_, plane] = lattice_moduli(2, 1.3);
        let [_, space] = lattice_moduli(3, 1.3);
        assert!((plane - 0.109).abs() < 1e-3 && (space - 0.062).abs() < 1e-3, "{plane}, {space}");
    }
}
