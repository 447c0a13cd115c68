//! The equation of state: Tait's, with exponent seven \[cole1948\], so that powers are products.

/// A liquid that is compressed a little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Liquid {
    /// Density at zero pressure ρ₀ \[M/L³\].
    pub density: f64,
    /// Speed of sound there c₀ \[L/T\]: about ten times the greatest speed of the flow.
    pub sound_speed: f64,
}

impl Liquid {
    /// `B = ρ₀c₀²/7` \[F/L²\].
    fn modulus(&self) -> f64 {
        self.density * self.sound_speed * self.sound_speed / 7.0
    }

    /// `P = B [(ρ/ρ₀)⁷ − 1]` \[F/L²\].
    #[inline(always)]
    pub fn pressure(&self, density: f64) -> f64 {
        let x = density / self.density;
        let cube = x * x * x;
        self.modulus() * (cube * cube * x - 1.0)
    }

    /// P/ρ² \[L⁵/(M T²)\].
    #[inline(always)]
    pub(crate) fn p_over_rho2(&self, density: f64) -> f64 {
        self.pressure(density) / (density * density)
    }

    /// The density under a pressure \[M/L³\]: the inverse of [`Liquid::pressure`].
    pub fn density_at(&self, pressure: f64) -> f64 {
        self.density * libm::pow((1.0 + pressure / self.modulus()).max(0.0), 1.0 / 7.0)
    }

    /// `c = c₀ (ρ/ρ₀)³` \[L/T\].
    #[inline(always)]
    pub fn sound(&self, density: f64) -> f64 {
        let x = density / self.density;
        self.sound_speed * (x * x * x)
    }

    /// Energy of compression of a unit of mass \[L²/T²\]: `∫ P/ρ² dρ = (B/ρ₀) [(x⁶ − 1)/6 + 1/x − 1]`, `x = ρ/ρ₀`.
    pub fn compression(&self, density: f64) -> f64 {
        let x = density / self.density;
        let cube = x * x * x;
        self.modulus() / self.density * ((cube * cube - 1.0) / 6.0 + 1.0 / x - 1.0)
    }

    /// ρ₀c₀ \[F T/L³\].
    pub fn impedance(&self) -> f64 {
        self.density * self.sound_speed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WATER: Liquid = Liquid { density: 1000.0, sound_speed: 40.0 };

    /// Differences of second order: their error is h²/6 times the third derivative, 1e-8 here.
    #[test]
    fn speed_of_sound_and_energy_are_the_derivatives_they_should_be() {
        let step = 1e-2;
        for density in [980.0, 1000.0, 1031.0] {
            let rise = WATER.pressure(density + step) - WATER.pressure(density - step);
            let sound = WATER.sound(density);
            assert!((rise / (2.0 * step) / (sound * sound) - 1.0).abs() < 1e-8);
            let energy = WATER.compression(density + step) - WATER.compression(density - step);
            let exact = WATER.pressure(density) / (density * density);
            assert!((energy / (2.0 * step) - exact).abs() < 1e-7);
        }
    }

    #[test]
    fn density_at_a_pressure_gives_that_pressure() {
        for pressure in [-500.0, 0.0, 1.0, 4e4] {
            let back = WATER.pressure(WATER.density_at(pressure));
            assert!((back - pressure).abs() < 1e-8 * WATER.modulus(), "{pressure}: {back}");
        }
    }
}
