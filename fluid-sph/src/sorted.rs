//! Particles in the order of their cells: what the sweeps read.

use sph_core::Vec3;

use crate::cells::{Grid, NOWHERE};
use crate::hidden::{Hidden, opposite};
use crate::lanes::{Halves, LANES};
use crate::parallel::{chunks, chunks_of_two};

/// What a sweep reads of a particle, a cache line.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(crate) struct Row {
    /// Place \[L\] and density \[M/L³\].
    pub place: Halves,
    /// Velocity \[L/T\] and P/ρ² \[L⁵/(M T²)\].
    pub motion: Halves,
}

impl Row {
    /// The row of a particle.
    pub fn new(place: Vec3, density: f64, velocity: Vec3, share: f64) -> Self {
        Self {
            place: [[place.x, place.y], [place.z, density]],
            motion: [[velocity.x, velocity.y], [velocity.z, share]],
        }
    }

    /// Its place.
    #[inline(always)]
    pub fn at(&self) -> [f64; 3] {
        [self.place[0][0], self.place[0][1], self.place[1][0]]
    }

    /// Its density.
    #[inline(always)]
    pub fn density(&self) -> f64 {
        self.place[1][1]
    }
}

/// Particles of a kind, sorted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sorted {
    /// By particle: its cell.
    cells: Vec<u32>,
    /// By cell: where its particles begin.
    pub starts: Vec<u32>,
    /// By slot: the particle.
    pub order: Vec<u32>,
    /// By particle: its slot; [`NOWHERE`] where no fluid can be near.
    pub slots: Vec<u32>,
    /// By slot, and of a particle far away beyond the last: what it is.
    pub rows: Vec<Row>,
    /// By slot, padded: places along the axes; none along the third in a plane.
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    pub z: Vec<f64>,
    /// By slot: faces of thin structures that it belongs to; empty where there are none.
    pub faces: Vec<u32>,
    /// By slot: the same where the other side cannot be seen past an edge; empty for boundaries.
    pub sides: Vec<u32>,
}

impl Sorted {
    /// Number of particles that stand in cells.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// The cell of a slot.
    #[inline(always)]
    pub fn cell(&self, slot: usize) -> u32 {
        self.cells[self.order[slot] as usize]
    }

    /// Sorts particles by cells, those of one cell by their numbers; what they are comes with [`Sorted::fill`].
    pub fn sort(
        &mut self,
        threads: usize,
        grid: &Grid,
        count: usize,
        position: impl Fn(usize) -> [f64; 3] + Sync,
    ) {
        self.cells.resize(count, 0);
        chunks(threads, &mut self.cells, |first, cells| {
            for (i, cell) in cells.iter_mut().enumerate() {
                *cell = grid.cell(&position(first + i));
            }
        });
        self.starts.clear();
        self.starts.resize(grid.len() + 2, 0);
        for &cell in self.cells.iter().filter(|&&cell| cell != NOWHERE) {
            self.starts[cell as usize + 2] += 1;
        }
        for cell in 2..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let inside = self.starts[grid.len() + 1] as usize;
        self.order.resize(inside, 0);
        self.slots.resize(count, NOWHERE);
        for (i, (&cell, slot)) in self.cells.iter().zip(&mut self.slots).enumerate() {
            *slot = NOWHERE;
            if cell != NOWHERE {
                let next = &mut self.starts[cell as usize + 1];
                self.order[*next as usize] = i as u32;
                *slot = *next;
                *next += 1;
            }
        }
    }

    /// Fills the rows; the one beyond the last is far away from all, so that it adds nothing to any sum.
    pub fn fill(&mut self, threads: usize, dimensions: usize, far: Row, row: impl Fn(usize) -> Row + Sync) {
        let count = self.len();
        self.rows.resize(count + 1, far);
        self.rows[count] = far;
        self.x.resize(count + LANES, 0.0);
        self.y.resize(count + LANES, 0.0);
        let order = &self.order;
        chunks(threads, &mut self.rows[..count], |first, rows| {
            for (s, slot) in rows.iter_mut().enumerate() {
                *slot = row(order[first + s] as usize);
            }
        });
        let rows = &self.rows;
        chunks_of_two(threads, &mut self.x[..count], &mut self.y[..count], |first, x, y| {
            for (s, (x, y)) in x.iter_mut().zip(y).enumerate() {
                (*x, *y) = rows[first + s].place[0].into();
            }
        });
        if dimensions == 3 {
            self.z.resize(count + LANES, 0.0);
            chunks(threads, &mut self.z[..count], |first, z| {
                for (s, z) in z.iter_mut().enumerate() {
                    *z = rows[first + s].place[1][0];
                }
            });
        }
    }

    /// What a particle of the fluid does not see of its own kind: those on the other side of a thin structure.
    #[inline(always)]
    pub fn hidden_sides(&self, slot: usize) -> Hidden<'_> {
        self.sides.get(slot).map_or(Hidden::NONE, |&side| Hidden { faces: opposite(side), of: &self.sides })
    }

    /// What a particle does not see of the other kind: a point of a face the fluid that faces the other, and the fluid the
    /// points of the other face.
    #[inline(always)]
    pub fn hidden_faces<'a>(&self, slot: usize, other: &'a Self) -> Hidden<'a> {
        self.faces.get(slot).map_or(Hidden::NONE, |&face| Hidden { faces: opposite(face), of: &other.faces })
    }

    /// Bytes held for each of so many particles.
    pub fn bytes(&self) -> usize {
        let words = self.cells.len() + self.starts.len() + self.order.len() + self.slots.len();
        let numbers = self.x.len() + self.y.len() + self.z.len();
        4 * (words + self.faces.len() + self.sides.len()) + 8 * numbers + size_of::<Row>() * self.rows.len()
    }
}
