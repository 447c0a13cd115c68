//! What the numbers of a coupled body mean: particles of the fluid, of the structures, of the walls, and places beyond them.
//!
//! Particles are numbered through: the fluid, the structures in their order, the walls. Behind them come the parts of the
//! boundary on which forces are read (each piece of walls, each structure), and behind those the gauges.

use std::ops::Range;

use sph_core::Vec3;

use super::gauges::Gauge;

/// How the bodies lie one behind the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Layout {
    /// Names of the bodies: the fluid, the structures, the walls.
    pub names: Vec<String>,
    /// Particles of the fluid.
    pub fluid: usize,
    /// Particles of each structure.
    pub structures: Vec<Range<usize>>,
    /// Particles of each piece of walls, in the order of the fluid's walls.
    pub pieces: Vec<Range<usize>>,
    /// By piece: what of forces on single particles it has besides, or has not.
    pub shares: Vec<Vec<Share>>,
    /// Pieces of each body of walls.
    pub walls: Vec<Range<usize>>,
    /// Which of the interactions of structures are contacts.
    pub contacts: Range<usize>,
    /// Which of them are links.
    pub links: Range<usize>,
    /// Gauges: pressures, levels and fluxes are read there.
    pub gauges: Vec<Gauge>,
}

/// Parts of the force on a particle in the corner of a basin that count for a piece beyond those of its own particles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Share {
    /// The piece that has the particle, and its number there.
    pub piece: usize,
    pub particle: usize,
    /// The parts, by component \[–\].
    pub part: Vec3,
}

/// What a number stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Place {
    /// A particle of the fluid.
    Fluid(usize),
    /// A structure, and a particle of it.
    Structure(usize, usize),
    /// A piece of walls, and a particle of it.
    Wall(usize, usize),
    /// All of a piece of walls.
    Piece(usize),
    /// All of a structure.
    Whole(usize),
    /// A gauge.
    Gauge(usize),
}

impl Layout {
    /// Particles of all bodies.
    pub fn particles(&self) -> usize {
        let last = self.pieces.last().or(self.structures.last());
        last.map_or(self.fluid, |last| last.end)
    }

    /// The number on which the force on a piece of walls is read.
    pub fn piece(&self, piece: usize) -> u32 {
        (self.particles() + piece) as u32
    }

    /// The number on which the force on a structure is read.
    pub fn whole(&self, structure: usize) -> u32 {
        (self.particles() + self.pieces.len() + structure) as u32
    }

    /// The number of a gauge.
    pub fn gauge(&self, gauge: usize) -> u32 {
        (self.particles() + self.pieces.len() + self.structures.len() + gauge) as u32
    }

    /// What a number stands for.
    pub fn place(&self, number: usize) -> Place {
        let within = |ranges: &[Range<usize>]| {
            let found = ranges.partition_point(|range| range.end <= number);
            let range = ranges.get(found).filter(|range| range.contains(&number))?;
            Some((found, number - range.start))
        };
        if number < self.fluid {
            return Place::Fluid(number);
        }
        if let Some((structure, particle)) = within(&self.structures) {
            return Place::Structure(structure, particle);
        }
        if let Some((piece, particle)) = within(&self.pieces) {
            return Place::Wall(piece, particle);
        }
        let beyond = number - self.particles();
        let (pieces, structures) = (self.pieces.len(), self.structures.len());
        match beyond {
            _ if beyond < pieces => Place::Piece(beyond),
            _ if beyond < pieces + structures => Place::Whole(beyond - pieces),
            _ => Place::Gauge(beyond - pieces - structures),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_stands_for_one_place() {
        let layout = Layout {
            fluid: 3,
            structures: vec![3..5, 5..6],
            pieces: vec![6..8, 8..8, 8..9],
            gauges: vec![Gauge::InSpace(Vec3::zeros())],
            ..Layout::default()
        };
        let places: Vec<Place> = (0..15).map(|number| layout.place(number)).collect();
        use Place::{Fluid, Piece, Structure, Wall, Whole};
        let expected = [
            Fluid(0),
            Fluid(1),
            Fluid(2),
            Structure(0, 0),
            Structure(0, 1),
            Structure(1, 0),
            Wall(0, 0),
            Wall(0, 1),
            Wall(2, 0),
            Piece(0),
            Piece(1),
            Piece(2),
            Whole(0),
            Whole(1),
            Place::Gauge(0),
        ];
        assert_eq!(places, expected);
        assert_eq!([layout.piece(2), layout.whole(1), layout.gauge(0)], [11, 13, 14]);
    }
}
