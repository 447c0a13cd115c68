//! Places of two bodies that move, as their contact asks for them.

use contact::{Moving, Node};
use explicit_dynamics::Places;
use sph_core::Vec3;

use super::skin::Skin;

/// Places that move.
pub(super) struct MovingPlaces<'a> {
    /// How they carry both surfaces.
    pub skin: &'a Skin,
    /// The places now.
    pub now: &'a Places<'a>,
}

impl Moving for MovingPlaces<'_> {
    fn mass(&self, node: Node) -> f64 {
        self.skin.mass(self.now.masses, node)
    }

    fn velocity(&self, node: Node) -> Vec3 {
        self.skin.place(self.now.velocities, node)
    }

    fn greatest_speed(&self) -> f64 {
        let all = || self.now.velocities.iter().map(|&v| Vec3::from(v));
        let mean = all().sum::<Vec3>() / self.now.velocities.len().max(1) as f64;
        all().map(|v| (v - mean).norm_squared()).fold(0.0, f64::max).sqrt()
    }
}
