//! The ring of slots in which the forces of cells wait for their particles.

use shell_kinematics::LANES;

use crate::gather::Place;
use crate::packs::{Packs, PointPack, Row};

/// Packs that are swept at once where registers hold most.
const MOST: usize = 2;

/// Slots of the packs under way: room for a number of packs that is a power of two, and a slot of zeros behind.
#[derive(Clone, Debug)]
pub(crate) struct Ring {
    rows: Vec<Row>,
    /// Slots of the widest pack.
    stride: usize,
    /// The pack from which the others are counted.
    first: usize,
    /// Packs less one.
    mask: usize,
}

impl Ring {
    /// Space for at least so many packs, counted from number `first` on.
    pub fn new(packs: &Packs, first: usize, room: usize) -> Self {
        let stride = packs.points.iter().map(PointPack::slot_count).max().unwrap_or(0);
        let room = room.next_power_of_two().max(MOST);
        Self { rows: vec![[0.0; 6]; room * stride + 1], stride, first, mask: room - 1 }
    }

    /// The slot of a place.
    pub fn slot(&self, (pack, entry, lane): Place) -> usize {
        self.place(pack as usize) + usize::from(entry) * LANES + usize::from(lane)
    }

    /// The slot of zeros.
    pub fn zero(&self) -> usize {
        self.rows.len() - 1
    }

    /// All slots.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The first slot of a pack.
    #[inline(always)]
    fn place(&self, pack: usize) -> usize {
        ((pack - self.first) & self.mask) * self.stride
    }

    /// Whether this is the first of `count` packs whose slots are not parted by the end of the ring.
    #[inline(always)]
    pub fn begins(&self, pack: usize, count: usize) -> bool {
        (pack - self.first).is_multiple_of(count)
    }

    /// The slots of `count` packs.
    #[inline(always)]
    pub fn of(&mut self, pack: usize, count: usize) -> &mut [[Row; LANES]] {
        let first = self.place(pack);
        groups(&mut self.rows[first..first + count * self.stride])
    }

    /// Bytes of the ring.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.rows[..])
    }
}

/// Slots, four particles a group.
#[inline(always)]
pub(crate) fn groups(slots: &mut [Row]) -> &mut [[Row; LANES]] {
    slots.as_chunks_mut().0
}
