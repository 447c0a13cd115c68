//! From slot to slot of sorted particles, with the cells beside them.

use crate::cells::{Grid, Ranges};
use crate::gather::{Room, Search};
use crate::hidden::Hidden;
use crate::sorted::Sorted;

/// A way along the slots of a chunk, which looks for the cells beside anew whenever the cell changes.
pub(crate) struct Walk<'a> {
    grid: &'a Grid,
    of: &'a Sorted,
    /// Those looked for: of their own kind if they count, and of the other kind.
    sets: [Option<&'a Sorted>; 2],
    reach: f32,
    cell: usize,
    near: [Ranges; 2],
}

impl<'a> Walk<'a> {
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
        let mut walk = Self { grid, of, sets, reach, cell, near: [Ranges::default(); 2] };
        walk.look();
        walk
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
    pub fn go(&mut self, slot: usize, room: &mut Room) {
        if self.of.starts[self.cell + 1] as usize <= slot {
            while self.of.starts[self.cell + 1] as usize <= slot {
                self.cell += 1;
            }
            self.look();
            room.forget();
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
        Some(self.search(slot, set, true, self.of.hidden_faces(slot, set)))
    }

    #[inline(always)]
    fn search<'b>(&'b self, slot: usize, set: &'b Sorted, other: bool, hidden: Hidden<'b>) -> Search<'b> {
        let ranges = &self.near[usize::from(other)];
        Search { at: self.of.single(slot), reach: self.reach, set, other, ranges, hidden }
    }
}
