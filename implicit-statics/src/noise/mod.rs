//! Steady random vibration: how strong a response to noise is, and how often it crosses zero.
//!
//! ```text
//! G_y(f) = Σ |H_y(f)|² G(f) over sources that know nothing of each other        σ² = ∫ G_y df        ν₀ = σ_ẏ/(2πσ_y)  [rice1944]
//! ```

mod density;
mod panels;

pub use density::PowerDensity;
pub use panels::frequencies as noise_frequencies;

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;

    fn white(from: f64, to: f64) -> PowerDensity {
        PowerDensity { points: vec![[from, 2.0], [to, 2.0]] }
    }

    /// `∫₀^r dx/((1 − x²)² + 4ζ²x²)`, by partial fractions.
    fn to(r: f64, zeta: f64) -> f64 {
        let s = (1.0 - zeta * zeta).sqrt();
        let log = libm::log((1.0 + r * r + 2.0 * s * r) / (1.0 + r * r - 2.0 * s * r));
        libm::atan2(2.0 * zeta * r, 1.0 - r * r) / (4.0 * zeta) + log / (8.0 * s)
    }

    /// Displacement of one degree of freedom under white noise between two frequencies, in closed form; over all of them `G/(8ζω³)`.
    #[test]
    fn one_degree_under_white_noise_is_its_closed_form() {
        for (natural, zeta) in [(10.0, 0.02), (10.0, 1e-4), (300.0, 0.3), (0.5, 0.01)] {
            let density = white(2.0, 100.0);
            let omega = TAU * natural;
            let square = |f: f64| {
                let w = TAU * f;
                1.0 / ((omega * omega - w * w).powi(2) + (2.0 * zeta * omega * w).powi(2))
            };
            let sum: f64 = noise_frequencies(&[&density], &[[natural, zeta * natural]])
                .into_iter()
                .map(|[f, weight]| weight * square(f) * density.at(f))
                .sum();
            let exact = 2.0 * (to(100.0 / natural, zeta) - to(2.0 / natural, zeta)) / (TAU * omega.powi(3));
            assert!((sum / exact - 1.0).abs() < 1e-11, "{natural} {zeta} {sum} {exact}");
        }
        assert!((to(1e9, 0.02) * 4.0 * 0.02 / PI - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_mean_square_of_a_density_is_its_integral() {
        let density =
            PowerDensity { points: vec![[20.0, 0.01], [80.0, 0.04], [350.0, 0.04], [2000.0, 0.007]] };
        let sum: f64 =
            noise_frequencies(&[&density], &[]).into_iter().map(|[f, weight]| weight * density.at(f)).sum();
        assert!((sum / density.mean_square() - 1.0).abs() < 1e-13);
        assert_eq!((density.at(19.0), density.at(2001.0), density.at(20.0)), (0.0, 0.0, 0.01));
        // 1/f: g₀ f₀ ln(f₁/f₀).
        let pink = PowerDensity { points: vec![[1.0, 8.0], [8.0, 1.0]] };
        assert!((pink.mean_square() / (8.0 * libm::log(8.0)) - 1.0).abs() < 1e-14);
    }
}
