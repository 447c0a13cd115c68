//! Speeds of elastic waves: what cracks and fronts are measured against.

/// Speed of waves along a surface over that of shear waves \[–\], of Rayleigh's equation \[rayleigh1885\].
///
/// With `s = (c/c_s)²` and `q = (c_s/c_p)²`: `(2 − s)⁴ = 16 (1 − s)(1 − q s)`. In plane stress the pressure wave is that of
/// a plate, `c_p² = E/(ρ(1 − ν²))`.
pub fn rayleigh_over_shear(shear_over_pressure_squared: f64) -> f64 {
    let q = shear_over_pressure_squared;
    let miss = |s: f64| (2.0 - s).powi(4) - 16.0 * (1.0 - s) * (1.0 - q * s);
    // Negative just above zero, one at s = 1, with one root between.
    let (mut low, mut high) = (1e-3, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if miss(middle) < 0.0 { low = middle } else { high = middle }
    }
    (0.5 * (low + high)).sqrt()
}

/// Speed of surface waves of a plate in plane stress \[L/T\], from E \[F/L²\], ν and ρ.
pub fn rayleigh_in_plane_stress(young: f64, poisson: f64, density: f64) -> f64 {
    let shear = (young / (2.0 * (1.0 + poisson)) / density).sqrt();
    shear * rayleigh_over_shear(0.5 * (1.0 - poisson))
}

/// Speed of waves along a slender bar, `√(E/ρ)` \[L/T\].
pub fn bar(young: f64, density: f64) -> f64 {
    (young / density).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn surface_waves_of_poissons_solid_run_at_0_9194() {
        // ν = ¼: s = 2 − 2/√3.
        let exact = (2.0 - 2.0 / 3.0_f64.sqrt()).sqrt();
        assert_relative_eq!(rayleigh_over_shear(1.0 / 3.0), exact, max_relative = 1e-14);
    }

    #[test]
    fn a_bar_of_steel_carries_five_kilometres_a_second() {
        assert_relative_eq!(bar(210e9, 7850.0), 5172.194, max_relative = 1e-6);
    }
}
