//! Particles in the order of their cells: what the sweeps read.

use lanes::EIGHT;
use parallel::chunks;

use crate::cells::{Grid, NOWHERE};
use crate::pair::Row;

/// Particles of a kind, sorted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sorted {
    /// By cell: where its particles begin.
    pub starts: Vec<u32>,
    /// By slot: the particle.
    pub order: Vec<u32>,
    /// By particle: its slot; [`NOWHERE`] where no fluid can be near.
    pub slots: Vec<u32>,
    /// By particle: its slot in the sort before.
    pub before: Vec<u32>,
    /// By slot, and of a particle far away beyond the last: what it is.
    pub rows: Vec<Row>,
    /// By slot, padded: places along the axes from the origin of the grid on; none along the third in a plane.
    pub x: Vec<f32>,
    pub y: Vec<f32>,
    pub z: Vec<f32>,
    /// By slot: faces of thin structures that it belongs to; empty where there are none.
    pub faces: Vec<u32>,
    /// By slot: the same where the other side cannot be seen past an edge; empty for boundaries.
    pub sides: Vec<u32>,
    /// By slot: whether sweeps leave it to others who march the fluid; empty where they take all.
    pub left: Vec<bool>,
}

impl Sorted {
    /// Number of particles that stand in cells.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Whether sweeps leave a slot to others.
    #[inline(always)]
    pub fn is_left(&self, slot: usize) -> bool {
        self.left.get(slot).is_some_and(|left| *left)
    }

    /// The place of a slot from the origin of the grid on.
    #[inline(always)]
    pub fn single(&self, slot: usize) -> [f32; 3] {
        [self.x[slot], self.y[slot], self.z.get(slot).map_or(0.0, |z| *z)]
    }

    /// The cell of a slot.
    pub fn cell(&self, slot: usize) -> usize {
        self.starts.partition_point(|&start| start as usize <= slot) - 1
    }

    /// Sorts particles by cells, those of one cell by their numbers; what they are comes with [`Sorted::fill`]. Places may be
    /// found by the slots before; those without a place stand nowhere.
    pub fn sort(
        &mut self,
        threads: usize,
        grid: &Grid,
        count: usize,
        position: impl Fn(usize, &[u32]) -> Option<[f64; 3]> + Sync,
    ) {
        std::mem::swap(&mut self.slots, &mut self.before);
        // Cells take the place of slots until those are known.
        self.slots.resize(count, NOWHERE);
        let before = &self.before[..];
        chunks(threads, &mut self.slots[..], |first, cells: &mut [u32]| {
            for (i, cell) in cells.iter_mut().enumerate() {
                *cell = position(first + i, before).map_or(NOWHERE, |at| grid.cell(&at));
            }
        });
        self.starts.clear();
        self.starts.resize(grid.len() + 2, 0);
        for &cell in self.slots.iter().filter(|&&cell| cell != NOWHERE) {
            self.starts[cell as usize + 2] += 1;
        }
        for cell in 2..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        let inside = self.starts[grid.len() + 1] as usize;
        self.order.resize(inside, 0);
        for (i, slot) in self.slots.iter_mut().enumerate() {
            if *slot != NOWHERE {
                let next = &mut self.starts[*slot as usize + 1];
                *slot = *next;
                self.order[*next as usize] = i as u32;
                *next += 1;
            }
        }
    }

    /// Fills the rows, from the particle, its slot, the slots of all before the last sort and the row that was there; the one beyond
    /// the last is far away from all, so that it adds nothing to any sum.
    pub fn fill(
        &mut self,
        threads: usize,
        dimensions: usize,
        grid: &Grid,
        far: Row,
        row: impl Fn(usize, usize, &[u32], &Row) -> Row + Sync,
    ) {
        let count = self.len();
        self.rows.resize(count + 1, far);
        self.rows[count] = far;
        let (order, before, depth) = (&self.order, &self.before[..], if dimensions == 3 { count } else { 0 });
        for (axis, length) in [(&mut self.x, count), (&mut self.y, count), (&mut self.z, depth)] {
            axis.resize(if length == 0 { 0 } else { length + EIGHT }, 0.0);
        }
        let lists = (&mut self.rows[..count], (&mut self.x[..count], &mut self.y[..count]));
        chunks(threads, lists, |first, (rows, (x, y))| {
            for (s, ((slot, x), y)) in rows.iter_mut().zip(x).zip(y).enumerate() {
                *slot = row(order[first + s] as usize, first + s, before, slot);
                [*x, *y, _] = grid.single(&slot.at());
            }
        });
        let rows = &self.rows;
        chunks(threads, &mut self.z[..depth], |first, z: &mut [f32]| {
            for (s, z) in z.iter_mut().enumerate() {
                *z = grid.single(&rows[first + s].at())[2];
            }
        });
    }

    /// Makes room for so many, so that no sort needs more.
    pub fn reserve(&mut self, count: usize) {
        self.order.reserve(count);
        self.slots.reserve(count);
        self.before.reserve(count);
        self.left.reserve(count);
        self.rows.reserve(count + 1);
        for axis in [&mut self.x, &mut self.y, &mut self.z] {
            axis.reserve(count + EIGHT);
        }
    }

    /// What a particle of the fluid does not see of its own kind: those on the other side of a thin structure.
    #[inline(always)]
    pub fn hidden_sides(&self, slot: usize) -> Visibility<'_> {
        self.sides
            .get(slot)
            .map_or(Visibility::ALL, |&side| Visibility { faces: opposite(side), of: &self.sides })
    }

    /// What a particle does not see of the other kind, by the faces of these: a point of a face the fluid that faces the other, and the
    /// fluid the points of the other face.
    #[inline(always)]
    pub fn hidden_faces<'a>(&self, slot: usize, of: &'a [u32]) -> Visibility<'a> {
        self.faces.get(slot).map_or(Visibility::ALL, |&face| Visibility { faces: opposite(face), of })
    }

    /// Bytes held for each of so many particles.
    pub fn bytes(&self) -> usize {
        let words = self.starts.len() + self.order.len() + self.slots.len() + self.before.len();
        let places = self.x.len() + self.y.len() + self.z.len();
        4 * (words + places + self.faces.len() + self.sides.len())
            + self.left.len()
            + size_of::<Row>() * self.rows.len()
    }
}

/// Which neighbours a particle does not see though they are near: those on the other side of a thin structure.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Visibility<'a> {
    /// Faces that it does not see.
    pub faces: u32,
    /// By slot of the neighbours: faces that they belong to.
    pub of: &'a [u32],
}

impl Visibility<'_> {
    /// All are seen.
    pub const ALL: Self = Self { faces: 0, of: &[] };
}

/// The other face of each structure: faces of a structure are two bits next to each other.
#[inline(always)]
pub(crate) fn opposite(faces: u32) -> u32 {
    (faces & 0x5555_5555) << 1 | (faces & 0xAAAA_AAAA) >> 1
}
