//! Places of two shells that touch: their numbers, where they are, how they move.

use contact::{Moving, Node};
use explicit_dynamics::Places;
use sph_core::Vec3;

/// Places that move.
pub(super) struct MovingPlaces<'a> {
    pub numbers: &'a [Vec<u32>; 2],
    pub now: &'a Places<'a>,
}

impl Moving for MovingPlaces<'_> {
    fn mass(&self, node: Node) -> f64 {
        self.now.masses[number(self.numbers, node)]
    }

    fn velocity(&self, node: Node) -> Vec3 {
        place(self.numbers, self.now.velocities, node)
    }

    fn greatest_speed(&self) -> f64 {
        let all = || self.now.velocities.iter().map(|&v| Vec3::from(v));
        let mean = all().sum::<Vec3>() / self.now.velocities.len().max(1) as f64;
        all().map(|v| (v - mean).norm_squared()).fold(0.0, f64::max).sqrt()
    }
}

/// Number of a node among the places.
pub(super) fn number(numbers: &[Vec<u32>; 2], (side, a): Node) -> usize {
    numbers[side][a as usize] as usize
}

pub(super) fn place(numbers: &[Vec<u32>; 2], places: &[[f64; 3]], node: Node) -> Vec3 {
    Vec3::from(places[number(numbers, node)])
}
