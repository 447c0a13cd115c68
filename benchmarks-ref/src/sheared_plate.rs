//! A simply supported orthotropic plate that bends and shears: Navier's solution, in which each product of sines stands alone.
//!
//! ```text
//! w = Σ W sin αx sin βy    ψ₁ = Σ X cos αx sin βy    ψ₂ = Σ Y sin αx cos βy        α = mπ/a, β = nπ/b
//!
//! ⎡ S₁α² + S₂β²   S₁α                  S₂β               ⎤ ⎡W⎤   ⎡p⎤
//! ⎢               D₁₁α² + D₆₆β² + S₁   (D₁₂ + D₆₆)αβ      ⎥ ⎢X⎥ = ⎢0⎥        p = 16 p₀/π²mn of an even pressure, m and n odd
//! ⎣  symmetric                         D₂₂β² + D₆₆α² + S₂⎦ ⎣Y⎦   ⎣0⎦
//! ```
//!
//! from the energy `½ κ·Dκ + ½ γ·Sγ − p w` with `κ = (ψ₁,₁, ψ₂,₂, ψ₁,₂ + ψ₂,₁)` and `γ = ∇w + ψ`; edges carry no moment across themselves and
//! do not turn along themselves.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

/// Terms of the series along each side: the deflection changes by less than 1e-8 beyond, the moments by 1e-6.
const TERMS: usize = 200;

/// The plate.
#[derive(Clone, Copy, Debug)]
pub struct ShearedPlate {
    /// Sides \[L\].
    pub lengths: [f64; 2],
    /// D₁₁, D₂₂, D₁₂, D₆₆ \[F L\].
    pub bending: [f64; 4],
    /// S₁, S₂ \[F/L\].
    pub shear: [f64; 2],
    /// Mass and rotary inertia by area \[M/L², M\].
    pub inertia: [f64; 2],
}

impl ShearedPlate {
    /// Deflection \[L\] and moments 11 and 22 \[F\] at the centre, under an even pressure \[F/L²\].
    ///
    /// # Panics
    /// For stiffnesses that are not positive.
    pub fn centre(&self, pressure: f64) -> [f64; 3] {
        let [d11, d22, d12, _] = self.bending;
        let mut sums = [0.0; 3];
        for (i, j) in (0..TERMS).flat_map(|i| (0..TERMS).map(move |j| (i, j))) {
            let (m, n) = ((2 * i + 1) as f64, (2 * j + 1) as f64);
            let [alpha, beta] = self.wave_numbers(m, n);
            let part = Vector3::new(16.0 * pressure / (PI * PI * m * n), 0.0, 0.0);
            let found = self.stiffness(alpha, beta).cholesky().expect("positive stiffnesses").solve(&part);
            let sign = if (i + j) % 2 == 0 { 1.0 } else { -1.0 };
            let [turn1, turn2] = [alpha * found[1], beta * found[2]];
            let terms = [found[0], -(d11 * turn1 + d12 * turn2), -(d12 * turn1 + d22 * turn2)];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += sign * term);
        }
        sums
    }

    /// The lowest circular frequency of m by n half waves \[1/T\].
    ///
    /// # Panics
    /// For stiffnesses and masses that are not positive.
    pub fn frequency(&self, m: usize, n: usize) -> f64 {
        let [alpha, beta] = self.wave_numbers(m as f64, n as f64);
        let [mass, turning] = self.inertia;
        // The largest eigenvalue of the flexibility, which stands apart: 1/ω² of a motion that bends.
        let root = Matrix3::from_diagonal(&Vector3::new(mass, turning, turning).map(f64::sqrt));
        let soft = self.stiffness(alpha, beta).cholesky().expect("positive stiffnesses").inverse();
        1.0 / (root * soft * root).symmetric_eigenvalues().max().sqrt()
    }

    fn wave_numbers(&self, m: f64, n: f64) -> [f64; 2] {
        [m * PI / self.lengths[0], n * PI / self.lengths[1]]
    }

    fn stiffness(&self, alpha: f64, beta: f64) -> Matrix3<f64> {
        let ([d11, d22, d12, d66], [s1, s2]) = (self.bending, self.shear);
        let mixed = (d12 + d66) * alpha * beta;
        Matrix3::new(
            s1 * alpha * alpha + s2 * beta * beta,
            s1 * alpha,
            s2 * beta,
            s1 * alpha,
            d11 * alpha * alpha + d66 * beta * beta + s1,
            mixed,
            s2 * beta,
            mixed,
            d22 * beta * beta + d66 * alpha * alpha + s2,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(shear: f64) -> ShearedPlate {
        let nu = 0.3;
        ShearedPlate {
            lengths: [1.0; 2],
            bending: [1.0, 1.0, nu, 0.5 * (1.0 - nu)],
            shear: [shear; 2],
            inertia: [1.0, 1e-9],
        }
    }

    /// \[timoshenko1959\], table 8: .00406 p a⁴/D and .0479 p a² of a thin square plate.
    #[test]
    fn a_thin_plate_is_that_of_the_tables() {
        let [w, m1, m2] = square(1e9).centre(1.0);
        assert!((w - 0.00406235).abs() < 1e-8, "{w}");
        assert!((m1 - 0.0478864).abs() < 1e-6 && (m1 - m2).abs() < 1e-12, "{m1}");
        assert!((square(1e9).frequency(2, 1) / (5.0 * PI * PI) - 1.0).abs() < 1e-6);
    }

    /// Shear adds the membrane's deflection under p/S to the thin plate's: .0736713 p a²/S of a square.
    #[test]
    fn shear_adds_its_own_deflection() {
        let added = square(10.0).centre(1.0)[0] - square(1e9).centre(1.0)[0];
        assert!((added / 0.007_367_135 - 1.0).abs() < 1e-5, "{added}");
    }
}
