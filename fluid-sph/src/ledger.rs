//! What is recorded between two kicks, for the clock asks for work and losses at kicks only; and what particles add to it.

use sph_core::Vec3;

use crate::liquid::Liquid;

/// What was recorded so far, and what the next kick hands over.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Ledger {
    pub viscous: f64,
    pub diffusion: f64,
    /// Work of boundaries and, of a predictor and corrector, of gravity since the last kick.
    pub external: f64,
    /// Losses since the last kick.
    pub dissipated: f64,
    /// Greatest |ρ/ρ₀ − 1| so far.
    pub density_error: f64,
}

/// Sums over the particles of a chunk.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sums {
    /// Of means of old and new velocities.
    pub velocity: Vec3,
    /// Of their squares.
    pub square: f64,
    /// Square of the greatest new velocity.
    pub fastest: f64,
    /// What diffusion took a unit of mass.
    pub loss: f64,
    /// Greatest |ρ/ρ₀ − 1|.
    pub error: f64,
}

impl Sums {
    /// Puts a new velocity, and counts it.
    #[inline(always)]
    pub fn kick(&mut self, velocity: &mut Vec3, new: Vec3) {
        let mean = (*velocity + new) * 0.5;
        self.velocity += mean;
        self.square += mean.norm_squared();
        self.fastest = self.fastest.max(new.norm_squared());
        *velocity = new;
    }

    /// Changes a density by its rate and by what diffusion exchanges, over a time \[T\], and counts it.
    #[inline(always)]
    pub fn compress(&mut self, liquid: &Liquid, density: &mut f64, [rate, exchange]: [f64; 2], dt: f64) {
        let old = *density;
        self.densify(liquid, density, dt * (rate + exchange));
        if exchange != 0.0 {
            self.loss -= 0.5 * dt * exchange * (liquid.p_over_rho2(old) + liquid.p_over_rho2(*density));
        }
    }

    /// Changes a density by so much.
    #[inline(always)]
    pub fn densify(&mut self, liquid: &Liquid, density: &mut f64, change: f64) {
        *density += change;
        self.error = self.error.max((*density / liquid.density - 1.0).abs());
    }

    /// Of all chunks, in their order.
    pub fn total(sums: &[Self]) -> Self {
        sums.iter().fold(Self::default(), |all, chunk| Self {
            velocity: all.velocity + chunk.velocity,
            square: all.square + chunk.square,
            fastest: all.fastest.max(chunk.fastest),
            loss: all.loss + chunk.loss,
            error: all.error.max(chunk.error),
        })
    }
}
