//! Energies.

use sph_core::Vec3;

use crate::fluid::Fluid;

/// Energies of a fluid \[F L; F in a plane\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Kinetic.
    pub kinetic: f64,
    /// Of compression.
    pub compression: f64,
    /// `−Σ m g·r`, without the components of gravity along periodic axes.
    pub potential: f64,
    /// Taken by friction so far.
    pub viscous: f64,
    /// Taken by the diffusion of density so far.
    pub diffusion: f64,
}

impl Fluid {
    /// The energies at present.
    pub fn energies(&self) -> Energies {
        let kinetic: f64 = self.velocities().iter().map(|v| v.norm_squared()).sum();
        let gravity = self.gravity_across();
        let here = self.positions().iter().enumerate().filter(|(i, _)| self.is_here(*i));
        let weight: f64 = here.map(|(_, r)| gravity.dot(r)).sum();
        Energies {
            kinetic: 0.5 * self.mass * kinetic,
            compression: self.compression(),
            potential: -self.mass * weight,
            viscous: self.ledger.viscous,
            diffusion: self.ledger.diffusion,
        }
    }

    /// Energy of compression \[F L; F in a plane\].
    pub(crate) fn compression(&self) -> f64 {
        self.mass * self.densities().iter().map(|&density| self.liquid.compression(density)).sum::<f64>()
    }

    /// Sum of the momenta \[F T\].
    pub fn momentum(&self) -> Vec3 {
        self.velocities().iter().sum::<Vec3>() * self.mass
    }

    /// Greatest |ρ/ρ₀ − 1| of a particle so far.
    pub fn greatest_density_error(&self) -> f64 {
        self.ledger.density_error
    }
}
