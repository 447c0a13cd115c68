//! Who may be a neighbour of the particles of a cell: all that stand in it and beside it, side by side.

use std::ops::Range;

use sph_core::lanes::EIGHT;

use crate::cells::Ranges;
use crate::sorted::Sorted;

/// How many are held at a time, a multiple of eight; a cell in space has some 500 at the usual width of the kernel.
const HELD: usize = 512;

/// A part of the candidates of a cell, and what does not matter behind it up to a multiple of eight.
pub(crate) struct Candidates {
    x: [f32; HELD],
    y: [f32; HELD],
    z: [f32; HELD],
    slots: [u32; HELD],
    count: usize,
    /// Which part is held; none after the cell has changed.
    part: Option<usize>,
    last: bool,
}

/// Eight candidates: places and slots.
pub(crate) struct Eight<'a> {
    pub at: [&'a [f32; EIGHT]; 3],
    pub slots: &'a [u32; EIGHT],
}

impl Candidates {
    /// None.
    pub fn new() -> Self {
        let none = [0.0; HELD];
        Self { x: none, y: none, z: none, slots: [0; HELD], count: 0, part: None, last: true }
    }

    /// Forgets what is held: the cell has changed.
    #[inline(always)]
    pub fn forget(&mut self) {
        self.part = None;
    }

    /// Number of eights held.
    #[inline(always)]
    pub fn eights(&self) -> usize {
        self.count.div_ceil(EIGHT)
    }

    /// Whether no part comes after that which is held.
    #[inline(always)]
    pub fn is_last(&self) -> bool {
        self.last
    }

    /// Some of the eights held.
    #[inline(always)]
    pub fn of(&self, Range { start, end }: Range<usize>) -> impl Iterator<Item = Eight<'_>> {
        let (x, y) = (&self.x.as_chunks::<EIGHT>().0[start..end], &self.y.as_chunks::<EIGHT>().0[start..end]);
        let (z, slots) =
            (&self.z.as_chunks::<EIGHT>().0[start..end], &self.slots.as_chunks::<EIGHT>().0[start..end]);
        x.iter().zip(y).zip(z.iter().zip(slots)).map(|((x, y), (z, slots))| Eight { at: [x, y, z], slots })
    }

    /// Holds a part of all that stand in the ranges.
    #[inline(always)]
    pub fn hold<const D: usize>(&mut self, set: &Sorted, ranges: &Ranges, part: usize) {
        if self.part != Some(part) {
            self.fetch::<D>(set, ranges, part);
        }
    }

    #[inline(never)]
    fn fetch<const D: usize>(&mut self, set: &Sorted, ranges: &Ranges, part: usize) {
        let (mut skip, mut count) = (part * HELD, 0);
        (self.part, self.last) = (Some(part), true);
        for &(from, to) in ranges.filled() {
            let skipped = skip.min((to - from) as usize);
            skip -= skipped;
            let (from, to) = (from as usize + skipped, to as usize);
            let end = count + (to - from).min(HELD - count);
            self.last &= end - count == to - from;
            let fits = from..from + (end - count);
            self.x[count..end].copy_from_slice(&set.x[fits.clone()]);
            self.y[count..end].copy_from_slice(&set.y[fits.clone()]);
            if D == 3 {
                self.z[count..end].copy_from_slice(&set.z[fits.clone()]);
            }
            self.slots[count..end].iter_mut().zip(fits).for_each(|(held, slot)| *held = slot as u32);
            count = end;
        }
        self.count = count;
        // Behind them stands the particle far away; a place that is no number would let it in too, and it adds nothing.
        let end = count.next_multiple_of(EIGHT);
        self.x[count..end].fill(f32::INFINITY);
        self.slots[count..end].fill(set.len() as u32);
    }
}
