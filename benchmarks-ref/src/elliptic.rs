//! The two elliptic integrals of the elastica, by Carlson's duplication.
//!
//! Each step halves the distances between the arguments until they are all but equal; the limit has a closed form.
//! Only the real, non-negative arguments that the elastica needs are handled.

/// Arguments within this part of their mean leave a remainder of its cube, 1e-18, below rounding.
const CLOSE: f64 = 1e-6;

/// R_F(x, y, z) = ½ ∫₀^∞ [(t + x)(t + y)(t + z)]^(−1/2) dt [carlson1995, sec. 1].
///
/// At most one argument may be zero, none negative.
pub fn r_f(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    loop {
        let mean = (x + y + z) / 3.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -dx - dy;
        if dx.abs().max(dy.abs()).max(dz.abs()) < CLOSE {
            // the series in E₂, the only term above rounding
            let e2 = dx * dy - dz * dz;
            return (1.0 - e2 / 10.0) / mean.sqrt();
        }
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
}

/// R_D(x, y, z) = (3/2) ∫₀^∞ [(t + x)(t + y)]^(−1/2) (t + z)^(−3/2) dt [carlson1995, sec. 1].
///
/// x and y must not both be zero, z must be positive.
pub fn r_d(mut x: f64, mut y: f64, mut z: f64) -> f64 {
    let (mut sum, mut weight) = (0.0, 1.0);
    loop {
        let mean = (x + y + 3.0 * z) / 5.0;
        let (dx, dy) = (1.0 - x / mean, 1.0 - y / mean);
        let dz = -(dx + dy) / 3.0;
        if dx.abs().max(dy.abs()).max(dz.abs()) < CLOSE {
            let e2 = dx * dy - 6.0 * dz * dz;
            return 3.0 * sum + weight * (1.0 - 3.0 * e2 / 14.0) / (mean * mean.sqrt());
        }
        let lambda = (x * y).sqrt() + (y * z).sqrt() + (z * x).sqrt();
        sum += weight / (z.sqrt() * (z + lambda));
        weight *= 0.25;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Values printed to 14 digits in section 3 of B.C. Carlson, Numerical Algorithms 10 (1995) 13–26.
    #[test]
    fn published_values() {
        assert_relative_eq!(r_f(1.0, 2.0, 0.0), 1.311_028_777_146_1, max_relative = 1e-13);
        assert_relative_eq!(r_f(2.0, 3.0, 4.0), 0.584_082_841_677_15, max_relative = 1e-13);
        assert_relative_eq!(r_d(0.0, 2.0, 1.0), 1.797_210_352_103_4, max_relative = 1e-13);
        assert_relative_eq!(r_d(2.0, 3.0, 4.0), 0.165_105_272_942_61, max_relative = 1e-13);
    }

    /// Legendre's relation E K' + E' K − K K' = π/2 ties both integrals together for every parameter m.
    #[test]
    fn legendre_relation() {
        let k = |m: f64| r_f(0.0, 1.0 - m, 1.0);
        let e = |m: f64| k(m) - m * r_d(0.0, 1.0 - m, 1.0) / 3.0;
        for i in 1..100 {
            let m = f64::from(i) / 100.0;
            let left = e(m) * k(1.0 - m) + e(1.0 - m) * k(m) - k(m) * k(1.0 - m);
            assert_relative_eq!(left, std::f64::consts::FRAC_PI_2, max_relative = 1e-13);
        }
    }
}
