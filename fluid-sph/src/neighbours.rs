//! The neighbours of each particle: from slot to slot of sorted particles, with all that stand in the cells beside as
//! candidates, of whom those within reach are handed on four at a time.
//!
//! They are looked for eight at a time in single precision, with a reach that is longer by what single precision may be
//! wrong; a kernel is zero for whoever comes along beyond its own reach.

use std::ops::Range;

use lanes::{EIGHT, LANES, Lanes};

use crate::cells::{Grid, Ranges};
use crate::pair::Four;
use crate::sorted::{Sorted, Visibility};

/// A way along the slots of a chunk, which looks for the cells beside anew whenever the cell changes.
pub(crate) struct CellCursor<'a> {
    grid: &'a Grid,
    of: &'a Sorted,
    /// Those looked for: of their own kind if they count, and of the other kind.
    sets: [Option<&'a Sorted>; 2],
    reach: f32,
    cell: usize,
    near: [Ranges; 2],
}

impl<'a> CellCursor<'a> {
    /// From a slot on, within a reach \[L\].
    #[inline(always)]
    pub fn new(
        grid: &'a Grid,
        of: &'a Sorted,
        first: usize,
        sets: [Option<&'a Sorted>; 2],
        reach: f64,
    ) -> Self {
        let cell = of.cell(first);
        let reach = grid.longer(reach);
        let mut cursor = Self { grid, of, sets, reach, cell, near: [Ranges::default(); 2] };
        cursor.look();
        cursor
    }

    #[inline(never)]
    fn look(&mut self) {
        for (near, set) in self.near.iter_mut().zip(self.sets) {
            let filled = set.filter(|set| set.len() > 0);
            *near =
                filled.map_or_else(Ranges::default, |set| self.grid.beside(self.cell as u32, &set.starts));
        }
    }

    /// Goes on to a slot, not before the last.
    #[inline(always)]
    pub fn go(&mut self, slot: usize, scratch: &mut Scratch) {
        if self.of.starts[self.cell + 1] as usize <= slot {
            while self.of.starts[self.cell + 1] as usize <= slot {
                self.cell += 1;
            }
            self.look();
            scratch.forget();
        }
    }

    /// The search from a slot among its own kind; none if that does not count.
    #[inline(always)]
    pub fn own(&self, slot: usize) -> Option<Search<'_>> {
        let set = self.sets[0]?;
        Some(self.search(slot, set, false, set.hidden_sides(slot)))
    }

    /// The search from a slot among the other kind; none if none is near.
    #[inline(always)]
    pub fn other(&self, slot: usize) -> Option<Search<'_>> {
        let set = self.sets[1].filter(|_| !self.near[1].filled().is_empty())?;
        Some(self.search(slot, set, true, self.of.hidden_faces(slot, &set.faces)))
    }

    #[inline(always)]
    fn search<'b>(&'b self, slot: usize, set: &'b Sorted, other: bool, hidden: Visibility<'b>) -> Search<'b> {
        let ranges = &self.near[usize::from(other)];
        Search { at: self.of.single(slot), reach: self.reach, set, other, ranges, hidden }
    }
}

/// Scratch for neighbours between two rounds of pairs.
const ROOM: usize = 512;
/// Eights of candidates looked at between two looks at the room left.
const PIECE: usize = 32;

/// A sum over the neighbours of a particle.
pub(crate) trait Pairs<L: Lanes, const D: usize> {
    /// Adds four neighbours. One far away or in the place of the particle itself adds nothing.
    fn add(&mut self, four: Four<L, D>);
}

/// Scratch for the neighbours of a particle and for the candidates of its cell, kept from one to the next.
pub(crate) struct Scratch {
    found: [u32; ROOM],
    /// Of its own kind and of the other kind.
    candidates: [Candidates; 2],
}

impl Scratch {
    /// Empty scratch.
    #[inline(always)]
    pub fn new() -> Self {
        Self { found: [0; ROOM], candidates: [Candidates::new(), Candidates::new()] }
    }

    /// Forgets the candidates: the cell has changed.
    pub fn forget(&mut self) {
        self.candidates.iter_mut().for_each(Candidates::forget);
    }
}

/// Where a particle looks for neighbours.
pub(crate) struct Search<'a> {
    /// Its place and the reach, as the particles sorted have theirs.
    pub at: [f32; 3],
    pub reach: f32,
    pub set: &'a Sorted,
    /// Whether that is the other kind.
    pub other: bool,
    /// All that stand in the cells beside, of which the candidates hold a part.
    pub ranges: &'a Ranges,
    pub hidden: Visibility<'a>,
}

/// Hands on all within reach.
#[inline(always)]
pub(crate) fn gather<L: Lanes, P: Pairs<L, D>, const D: usize>(
    lanes: L,
    search: Search<'_>,
    scratch: &mut Scratch,
    pairs: &mut P,
) {
    let Search { at, reach, set, other, ranges, hidden } = search;
    let Scratch { found, candidates } = scratch;
    let candidates = &mut candidates[usize::from(other)];
    let near = Near::<L> { at: at.map(|x| lanes.splat_eight(x)), square: lanes.splat_eight(reach * reach) };
    let (mut count, mut part) = (0, 0);
    loop {
        candidates.hold::<D>(set, ranges, part);
        let eights = candidates.eights();
        let (mut first, last) = (0, candidates.is_last());
        while first < eights {
            let to = (first + PIECE).min(eights);
            count = near.find::<D>(lanes, candidates, first..to, found, count);
            first = to;
            if hidden.faces != 0 {
                count = seen(found, count, hidden);
            }
            let all = last && first == eights;
            if all {
                // Four more at least fit: the rows beyond the last add nothing.
                found[count..count + LANES].fill(set.len() as u32);
                count = count.next_multiple_of(LANES);
            }
            let whole = count / LANES * LANES;
            if all || count > ROOM - PIECE * EIGHT - 2 * EIGHT {
                let rows = &set.rows[..];
                for &[a, b, c, d] in found[..whole].as_chunks::<LANES>().0 {
                    let four = [&rows[a as usize], &rows[b as usize], &rows[c as usize], &rows[d as usize]];
                    pairs.add(Four::of(lanes, four));
                }
                found.copy_within(whole..count, 0);
                count -= whole;
            }
        }
        if last {
            return;
        }
        part += 1;
    }
}

/// A place, and the square of a reach about it.
struct Near<L: Lanes> {
    at: [L::Eight; 3],
    square: L::Eight,
}

impl<L: Lanes> Near<L> {
    /// Writes those of some eights that are near behind the first `count`; returns how many there are then.
    #[inline(always)]
    fn find<const D: usize>(
        &self,
        lanes: L,
        candidates: &Candidates,
        eights: Range<usize>,
        found: &mut [u32; ROOM],
        mut count: usize,
    ) -> usize {
        for eight in candidates.of(eights) {
            let dx = lanes.sub_eight(self.at[0], lanes.load_eight(eight.at[0]));
            let dy = lanes.sub_eight(self.at[1], lanes.load_eight(eight.at[1]));
            let mut square = lanes.add_eight(lanes.mul_eight(dx, dx), lanes.mul_eight(dy, dy));
            if D == 3 {
                let dz = lanes.sub_eight(self.at[2], lanes.load_eight(eight.at[2]));
                square = lanes.add_eight(square, lanes.mul_eight(dz, dz));
            }
            let near = lanes.not_above(square, self.square);
            // There is always room for eight more.
            let Some(scratch) = found.get_mut(count..count.wrapping_add(EIGHT)) else { return count };
            scratch.copy_from_slice(&lanes.picked(near, eight.slots));
            count = count.wrapping_add(near.count_ones() as usize);
        }
        count
    }
}

/// Takes out those that are not seen; returns how many are left.
fn seen(found: &mut [u32], count: usize, hidden: Visibility<'_>) -> usize {
    let mut kept = 0;
    for k in 0..count {
        let slot = found[k];
        found[kept] = slot;
        kept += usize::from(hidden.of.get(slot as usize).is_none_or(|faces| faces & hidden.faces == 0));
    }
    kept
}

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
