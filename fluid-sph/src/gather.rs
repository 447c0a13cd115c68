//! The neighbours of one particle: found among the candidates of its cell, and handed on four at a time.
//!
//! They are looked for eight at a time in single precision, with a reach that is longer by what single precision may be
//! wrong; a kernel is zero for whoever comes along beyond its own reach.

use sph_core::lanes::{EIGHT, LANES, Lanes};

use crate::candidates::Candidates;
use crate::cells::Ranges;
use crate::hidden::Hidden;
use crate::row::Four;
use crate::sorted::Sorted;

/// Room for neighbours between two rounds of pairs.
const ROOM: usize = 512;
/// Eights of candidates looked at between two looks at the room left.
const PIECE: usize = 32;

/// A sum over the neighbours of a particle.
pub(crate) trait Pairs<L: Lanes> {
    /// Adds four neighbours. One far away or in the place of the particle itself adds nothing.
    fn add(&mut self, lanes: L, four: Four<L>);
}

/// Room for the neighbours of a particle and for the candidates of its cell, kept from one to the next.
pub(crate) struct Room {
    found: [u32; ROOM],
    /// Of its own kind and of the other kind.
    candidates: [Candidates; 2],
}

impl Room {
    /// Empty room.
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
    pub hidden: Hidden<'a>,
}

/// Hands on all within reach.
#[inline(always)]
pub(crate) fn gather<L: Lanes, P: Pairs<L>, const D: usize>(
    lanes: L,
    search: Search<'_>,
    room: &mut Room,
    pairs: &mut P,
) {
    let Search { at, reach, set, other, ranges, hidden } = search;
    let Room { found, candidates } = room;
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
                    pairs.add(lanes, Four::of(lanes, four));
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
        eights: std::ops::Range<usize>,
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
            let Some(room) = found.get_mut(count..count.wrapping_add(EIGHT)) else { return count };
            room.copy_from_slice(&lanes.picked(near, eight.slots));
            count = count.wrapping_add(near.count_ones() as usize);
        }
        count
    }
}

/// Takes out those that are not seen; returns how many are left.
fn seen(found: &mut [u32], count: usize, hidden: Hidden<'_>) -> usize {
    let mut kept = 0;
    for k in 0..count {
        let slot = found[k];
        found[kept] = slot;
        kept += usize::from(hidden.of.get(slot as usize).is_none_or(|faces| faces & hidden.faces == 0));
    }
    kept
}
