//! What others may run into of a body: its cells, or its particles alone.

use std::ops::Range;

use sph_core::Cell;

/// A body as others may run into it.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Its name in a scene of several bodies; none of a body that is alone.
    pub name: Option<String>,
    /// Its particles, by the numbers of [`super::Body::configuration`].
    pub particles: Range<usize>,
    /// Its cells by its own numbers, of one corner each where it has particles only.
    pub cells: Vec<Cell>,
    /// Half of its thickness, or the radius of a particle \[L\].
    pub half: f64,
    /// Whether it is a sheet, which may meet itself.
    pub sheet: bool,
}

impl Outline {
    /// Of a body that is alone, with cells between its particles.
    pub fn of_cells(particles: usize, cells: Vec<Cell>, half: f64, sheet: bool) -> Self {
        Self { name: None, particles: 0..particles, cells, half, sheet }
    }

    /// Of a body that is alone, whose particles are balls.
    pub fn of_particles(particles: usize, radius: f64) -> Self {
        let cells = (0..particles as u32).map(|a| Cell { corners: [a; 4], count: 1 }).collect();
        Self { name: None, particles: 0..particles, cells, half: radius, sheet: false }
    }

    /// The same as one of several bodies, whose first particle has a number among all of theirs.
    pub fn named(self, name: &str, first: usize) -> Self {
        let particles = self.particles.start + first..self.particles.end + first;
        Self { name: Some(name.into()), particles, ..self }
    }
}
