//! What a stress says whatever its axes: von Mises, principal stresses with their axes, Tresca; in a surface and in space.

use nalgebra::Matrix3;
use sph_core::Vec3;

/// Sweeps of rotations after which nothing is left to turn: each squares what is left.
const SWEEPS: usize = 12;

/// `√(σ11² + σ22² − σ11 σ22 + 3 σ12²)`, plane stress \[F/L²\].
pub(crate) fn von_mises([s11, s22, s12]: [f64; 3]) -> f64 {
    (s11 * s11 + s22 * s22 - s11 * s22 + 3.0 * s12 * s12).sqrt()
}

/// Principal stresses of plane stress, the greatest first \[F/L²\], and the angle of its axis from the first, from −π/2 to π/2 \[rad\]; zero where all are
/// alike.
pub(crate) fn principal([s11, s22, s12]: [f64; 3]) -> ([f64; 2], f64) {
    let (mean, half) = (0.5 * (s11 + s22), 0.5 * (s11 - s22));
    let radius = libm::hypot(half, s12);
    ([mean + radius, mean - radius], 0.5 * libm::atan2(s12, half))
}

/// Tresca's stress of principal ones of plane stress, the greatest first: the greatest difference of these and zero \[F/L²\].
pub(crate) fn tresca([greatest, least]: [f64; 2]) -> f64 {
    greatest.max(0.0) - least.min(0.0)
}

/// `√(½[(xx − yy)² + (yy − zz)² + (zz − xx)²] + 3[xy² + yz² + zx²])` \[F/L²\].
pub(in crate::bodies) fn von_mises_in_space([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> f64 {
    let square = |x: f64| x * x;
    let normal = square(xx - yy) + square(yy - zz) + square(zz - xx);
    (0.5 * normal + 3.0 * (square(xy) + square(yz) + square(zx))).sqrt()
}

/// Principal stresses in space, the greatest first, with their axes.
#[derive(Clone, Copy, Debug)]
pub(in crate::bodies) struct Principal {
    /// \[F/L²\]
    pub stresses: [f64; 3],
    /// Unit vectors; their sign says nothing.
    pub axes: [Vec3; 3],
}

impl Principal {
    /// Of `xx, yy, zz, xy, yz, zx`, by Jacobi's rotations.
    pub fn of([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> Self {
        let mut matrix = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
        let mut axes = Matrix3::<f64>::identity();
        for (p, q) in std::iter::repeat_n([(0, 1), (0, 2), (1, 2)], SWEEPS).flatten() {
            let off = matrix[(p, q)];
            if off == 0.0 {
                continue;
            }
            let ratio = (matrix[(q, q)] - matrix[(p, p)]) / (2.0 * off);
            let tangent = ratio.signum() / (ratio.abs() + (ratio * ratio + 1.0).sqrt());
            let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
            let sine = tangent * cosine;
            let mut turn = Matrix3::identity();
            (turn[(p, p)], turn[(q, q)], turn[(p, q)], turn[(q, p)]) = (cosine, cosine, sine, -sine);
            matrix = turn.transpose() * matrix * turn;
            (matrix[(p, q)], matrix[(q, p)]) = (0.0, 0.0);
            axes *= turn;
        }
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| matrix[(j, j)].total_cmp(&matrix[(i, i)]));
        Self { stresses: order.map(|i| matrix[(i, i)]), axes: order.map(|i| axes.column(i).into_owned()) }
    }

    /// The greatest difference \[F/L²\].
    pub fn tresca(&self) -> f64 {
        self.stresses[0] - self.stresses[2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn von_mises_of_tension_and_of_shear() {
        assert!((von_mises([-2.0, 0.0, 0.0]) - 2.0).abs() < 1e-15);
        // Pure shear τ, as itself and as ±τ at 45°: √3 τ.
        assert!((von_mises([0.0, 0.0, 1.0]) - 3.0_f64.sqrt()).abs() < 1e-15);
        assert!((von_mises([1.0, -1.0, 0.0]) - 3.0_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn one_stress_alone_is_its_own_and_pressure_is_none() {
        assert_eq!(von_mises_in_space([-2.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 2.0);
        assert_eq!(von_mises_in_space([5.0, 5.0, 5.0, 0.0, 0.0, 0.0]), 0.0);
        assert_eq!(von_mises_in_space([0.0, 0.0, 0.0, 1.0, 0.0, 0.0]), 3.0_f64.sqrt());
    }

    /// σ = Σ σ_i n_i ⊗ n_i, and the sums that no turn changes: trace, and von Mises from the differences.
    #[test]
    fn principal_stresses_make_the_stress_again() {
        let some = [
            [3.0, -1.0, 0.5, 2.0, -0.7, 1.1],
            [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
            [2.0, 2.0, -1.0, 0.0, 0.0, 1e-9],
            [0.0, 0.0, 0.0, 5.0, 0.0, 0.0],
            [1e9, -2e9, 1.0, 3e8, 2.0, -1e9],
        ];
        for stress in some {
            let [xx, yy, zz, xy, yz, zx] = stress;
            let found = Principal::of(stress);
            let again: Matrix3<f64> =
                found.stresses.iter().zip(&found.axes).map(|(s, n)| n * n.transpose() * *s).sum();
            let given = Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz);
            // Rounding of a few dozen products.
            assert!((again - given).norm() <= 1e-14 * given.norm(), "{again} {given}");
            let [a, b, c] = found.stresses;
            assert!(a >= b && b >= c && (found.tresca() - (a - c)).abs() == 0.0);
            let mises = (0.5 * ((a - b).powi(2) + (b - c).powi(2) + (c - a).powi(2))).sqrt();
            assert!((mises - von_mises_in_space(stress)).abs() <= 1e-14 * given.norm());
        }
    }

    /// Of a stress in a surface both ways agree, zero across it among them.
    #[test]
    fn plane_stress_is_one_in_space() {
        for stress in
            [[3.0, 1.0, 0.5], [-3.0, 1.0, 0.5], [-3.0, -1.0, 2.5], [1.0, 2.0, 0.0], [0.0, 0.0, -2.0]]
        {
            let [s11, s22, s12] = stress;
            let ([first, second], angle) = principal(stress);
            let space = Principal::of([s11, s22, 0.0, s12, 0.0, 0.0]);
            assert!((tresca([first, second]) - space.tresca()).abs() < 1e-14);
            let (s, c) = libm::sincos(angle);
            assert!((c * c * s11 + s * s * s22 + 2.0 * s * c * s12 - first).abs() < 1e-14);
            assert!((first + second - s11 - s22).abs() < 1e-14 && angle.abs() <= std::f64::consts::FRAC_PI_2);
        }
    }
}
