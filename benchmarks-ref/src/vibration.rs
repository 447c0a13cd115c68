//! The first natural frequency of a slender cantilever.

/// The first root β₁L of cos β cosh β = −1, the frequency equation of a clamped–free beam; without dimension.
pub const FIRST_ROOT: f64 = 1.875_104_068_711_961;

/// The first circular frequency ω₁ = (β₁L)² √(EI/(ρA))/L², in radians per unit of time.
///
/// `bending_stiffness` EI in \[F L²\], `mass_per_length` ρA in \[M/L\], `length` L in \[L\]. Euler–Bernoulli: shear and
/// rotary inertia lower the frequency by a part of order (t/L)². A wide plate with ν ≠ 0 bends stiffer than a beam.
pub fn cantilever_frequency(bending_stiffness: f64, mass_per_length: f64, length: f64) -> f64 {
    FIRST_ROOT * FIRST_ROOT * (bending_stiffness / mass_per_length).sqrt() / (length * length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn the_root_solves_the_frequency_equation() {
        assert_relative_eq!(libm::cos(FIRST_ROOT) * libm::cosh(FIRST_ROOT), -1.0, max_relative = 1e-14);
    }

    #[test]
    fn scales_with_stiffness_mass_and_length() {
        let base = cantilever_frequency(1.0, 1.0, 1.0);
        assert_relative_eq!(base, 3.516_015_268_500_15, max_relative = 1e-13);
        assert_relative_eq!(cantilever_frequency(4.0, 1.0, 1.0), 2.0 * base);
        assert_relative_eq!(cantilever_frequency(1.0, 4.0, 1.0), 0.5 * base);
        assert_relative_eq!(cantilever_frequency(1.0, 1.0, 2.0), 0.25 * base);
    }
}
