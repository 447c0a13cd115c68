//! Diffusion of density between particles of the fluid \[molteni2009\], free of what gravity makes of the density as in
//! \[fourtakas2019\]:
//!
//! ```text
//! dρ_a/dt += δ h c₀ Σ_b 2 ψ_ab (−F r²)/(r² + η²) 2m/(ρ_a + ρ_b),   ψ_ab = ρ_b − ρ_a − (ρ₀/c₀²) g·(r_b − r_a)
//! ```
//!
//! The mean density in the volume makes the exchange of mass antisymmetric.

use sph_core::Vec3;

use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;

/// What the exchange needs beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Diffusion {
    /// 4δhc₀ \[L²/T\]; none at zero.
    pub strength: f64,
    /// Density gradient of rest `(ρ₀/c₀²) g` \[M/L⁴\].
    pub rest: [f64; 3],
}

impl Diffusion {
    /// That of a formulation.
    pub fn new(formulation: &Formulation, liquid: &Liquid, kernel: &Wendland, gravity: &Vec3) -> Self {
        let Liquid { density, sound_speed } = *liquid;
        Self {
            strength: 4.0 * formulation.density_diffusion * kernel.h * sound_speed,
            rest: (gravity * (density / (sound_speed * sound_speed))).into(),
        }
    }
}
