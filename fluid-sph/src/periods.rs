//! Periodic sides: a particle that leaves the box of the fluid by one comes in by the opposite one, and both see each other's neighbours.
//!
//! Particles within the reach of the kernel from a side have copies beyond the opposite one, a period away. Copies stand among the
//! neighbours of the particles that are marched, have their velocities, densities and pressures, and are not marched themselves: what a pair
//! across a side exerts is found from either end, so that momentum is kept to rounding. Along two or three axes copies have copies.

use sph_core::Vec3;

use crate::cells::NOWHERE;
use crate::error::FluidError;

/// Least period in widths of cells: no particle may see another twice, nor itself.
const LEAST: f64 = 2.0;

/// A box of which opposite sides are one, along some axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// Least coordinates of the box \[L\]; along other axes of no meaning.
    pub low: Vec3,
    /// Its edges \[L\]: the periods; zero along axes that are not periodic.
    pub lengths: Vec3,
}

impl Periods {
    /// Refuses periods shorter than two cells, which are as wide as the kernel reaches \[L\], and those across a plane.
    pub(crate) fn check(&self, dimensions: usize, width: f64) -> Result<(), FluidError> {
        let Self { low, lengths } = self;
        if let Some(index) = (0..3).find(|&k| !(low[k].is_finite() && lengths[k].is_finite())) {
            return Err(FluidError::NotFinite { what: "periodic side", index });
        }
        let short = |k: &usize| lengths[*k] != 0.0 && (*k >= dimensions || lengths[*k] < LEAST * width);
        match (0..3).find(short) {
            Some(axis) => {
                let (period, least) = (lengths[axis], LEAST * width);
                Err(FluidError::Period { axis: ["x", "y", "z"][axis], period, least })
            }
            None => Ok(()),
        }
    }

    /// How many periods a place lies beyond the box along each axis.
    pub(crate) fn beyond(&self, at: &Vec3) -> [f64; 3] {
        std::array::from_fn(|k| match self.lengths[k] {
            0.0 => 0.0,
            length => libm::floor((at[k] - self.low[k]) / length),
        })
    }

    /// The way to the place in the box that a place is.
    pub(crate) fn back(&self, at: &Vec3) -> Vec3 {
        let beyond = self.beyond(at);
        Vec3::from([0, 1, 2].map(|k| if beyond[k] == 0.0 { 0.0 } else { -beyond[k] * self.lengths[k] }))
    }

    /// The shortest of the ways that a way is.
    pub(crate) fn shortest(&self, way: Vec3) -> Vec3 {
        let along = |k: usize| match self.lengths[k] {
            0.0 => way[k],
            length => way[k] - length * libm::round(way[k] / length),
        };
        Vec3::from([0, 1, 2].map(along))
    }

    /// A vector without its components along periodic axes.
    pub(crate) fn across(&self, v: &Vec3) -> Vec3 {
        Vec3::from([0, 1, 2].map(|k| if self.lengths[k] == 0.0 { v[k] } else { 0.0 }))
    }
}

/// Periodic sides of a fluid, and how often each particle has gone through them.
#[derive(Clone, Debug)]
pub(crate) struct Periodic {
    pub periods: Periods,
    /// By particle: periods that it has gone along each axis.
    pub gone: Vec<[f64; 3]>,
}

/// A particle that stands for another, or for itself, somewhere else.
#[derive(Clone, Copy, Debug)]
struct Copied {
    of: u32,
    by: Vec3,
}

/// Where particles stand for the sweeps: themselves first, in the box, then their copies; empty without periodic sides.
#[derive(Clone, Debug, Default)]
pub(crate) struct Copies(Vec<Copied>);

impl Copies {
    /// Finds the copies of so many particles within a width of periodic sides \[L\].
    pub fn find(&mut self, periods: &Periods, count: usize, width: f64, at: impl Fn(usize) -> Vec3) {
        let Self(list) = self;
        list.clear();
        list.extend((0..count).map(|i| Copied { of: i as u32, by: periods.back(&at(i)) }));
        for axis in 0..3 {
            let length = periods.lengths[axis];
            if length == 0.0 {
                continue;
            }
            let (first, last) = (periods.low[axis] + width, periods.low[axis] + length - width);
            for number in 0..list.len() {
                let Copied { of, by } = list[number];
                let x = at(of as usize)[axis] + by[axis];
                for (near, way) in [(x < first, length), (x > last, -length)] {
                    if near {
                        let mut by = by;
                        by[axis] += way;
                        list.push(Copied { of, by });
                    }
                }
            }
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Number of particles and copies, of so many particles.
    pub fn all(&self, count: usize) -> usize {
        count.max(self.0.len())
    }

    /// Of which particle a number is.
    #[inline(always)]
    pub fn source(&self, number: usize) -> usize {
        self.0.get(number).map_or(number, |copy| copy.of as usize)
    }

    /// Where a number stands, from the place of a particle.
    #[inline(always)]
    pub fn place(&self, number: usize, at: impl Fn(usize) -> Vec3) -> Vec3 {
        self.0.get(number).map_or_else(|| at(number), |copy| at(copy.of as usize) + copy.by)
    }

    /// Calls with the slot of each copy and of its particle, of so many particles.
    pub fn each(&self, count: usize, slots: &[u32], mut call: impl FnMut(usize, usize)) {
        for (copy, &slot) in self.0.iter().zip(slots).skip(count) {
            let source = slots[copy.of as usize];
            if slot != NOWHERE && source != NOWHERE {
                call(slot as usize, source as usize);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places and ways of a box whose periods are powers of two: exact.
    #[test]
    fn places_come_back_and_ways_are_the_shortest() {
        let periods = Periods { low: Vec3::new(-1.0, 0.0, 0.0), lengths: Vec3::new(4.0, 0.0, 0.5) };
        let at = Vec3::new(-1.25, 7.0, 1.125);
        assert_eq!(at + periods.back(&at), Vec3::new(2.75, 7.0, 0.125));
        assert_eq!(periods.shortest(Vec3::new(3.0, 3.0, -0.375)), Vec3::new(-1.0, 3.0, 0.125));
        assert_eq!(periods.across(&at), Vec3::new(0.0, 7.0, 0.0));
    }

    /// A particle in a corner of two periodic axes has three copies, one in the middle none.
    #[test]
    fn copies_stand_beyond_the_opposite_sides() {
        let periods = Periods { low: Vec3::zeros(), lengths: Vec3::new(4.0, 4.0, 0.0) };
        let places = [Vec3::new(0.5, 3.75, 0.0), Vec3::new(2.0, 2.0, 0.0), Vec3::new(4.5, 2.0, 0.0)];
        let mut copies = Copies::default();
        copies.find(&periods, 3, 1.0, |i| places[i]);
        let mut found: Vec<(usize, [f64; 3])> = (0..copies.all(3))
            .map(|number| (copies.source(number), copies.place(number, |i| places[i]).into()))
            .collect();
        found.sort_by(|a, b| a.partial_cmp(b).unwrap());
        let expected = [
            (0, [0.5, -0.25, 0.0]),
            (0, [0.5, 3.75, 0.0]),
            (0, [4.5, -0.25, 0.0]),
            (0, [4.5, 3.75, 0.0]),
            (1, [2.0, 2.0, 0.0]),
            (2, [0.5, 2.0, 0.0]),
            (2, [4.5, 2.0, 0.0]),
        ];
        assert_eq!(found, expected);
    }
}
