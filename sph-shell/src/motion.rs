//! Where the particles of a shell are, and how fast they move.

use sph_core::Vec3;

use crate::packs::Row;
use crate::reference::Reference;

/// Rows of all particles; places from the origin.
pub(crate) struct Moving {
    /// Positions and directors.
    pub state: Vec<Row>,
    /// Positions and directors at the end of a step, before they take the place of the old ones.
    pub next: Vec<Row>,
    /// Their rates.
    pub rates: Vec<Row>,
}

impl Moving {
    /// At rest.
    pub fn new(reference: &Reference) -> Self {
        let state = reference.rest();
        Self { next: vec![[0.0; 6]; state.len()], rates: vec![[0.0; 6]; state.len()], state }
    }

    /// Present position from the origin \[L\].
    pub fn place(&self, particle: usize) -> Vec3 {
        let row = &self.state[particle];
        Vec3::new(row[0], row[1], row[2])
    }

    /// Present director of a particle (unit vector).
    pub fn director(&self, particle: usize) -> Vec3 {
        let row = &self.state[particle];
        Vec3::new(row[3], row[4], row[5])
    }
}

/// Particle of a place by its number, and where the three numbers of the place stand in the row `[x, d]` of that particle.
pub(crate) fn row_of(number: u32, particles: usize) -> (usize, usize) {
    match (number as usize).checked_sub(particles) {
        Some(particle) => (particle, 3),
        None => (number as usize, 0),
    }
}
