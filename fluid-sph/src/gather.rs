//! The neighbours of one particle: found among those of the cells beside it, and handed on four at a time.

use crate::cells::Ranges;
use crate::hidden::Hidden;
use crate::lanes::{LANES, Lanes, Pack};
use crate::sorted::Sorted;

/// Room for neighbours between two rounds of pairs.
const ROOM: usize = 512;

/// Particles looked at between two looks at the room left.
const PIECE: u32 = 256;
/// By number of particles left: the lanes that hold one.
const VALID: [usize; LANES] = [0, 1, 3, 7];
/// By pattern of lanes: how many are set.
const COUNT: [u8; 16] = [0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4];

/// By pattern of lanes within reach: their numbers, first.
const PICKED: [[u32; LANES]; 16] = picked();

const fn picked() -> [[u32; LANES]; 16] {
    let mut all = [[0; LANES]; 16];
    let mut pattern = 0;
    while pattern < 16 {
        let (mut lane, mut place) = (0, 0);
        while lane < LANES {
            if pattern >> lane & 1 == 1 {
                all[pattern][place] = lane as u32;
                place += 1;
            }
            lane += 1;
        }
        pattern += 1;
    }
    all
}

/// A sum over the neighbours of a particle.
pub(crate) trait Pairs<L: Lanes> {
    /// Adds four neighbours: places and densities, velocities and P/ρ², as a `Row` has them. One far away or in
    /// the place of the particle itself adds nothing.
    fn add(&mut self, lanes: L, place: [L::Four; 4], motion: [L::Four; 4]);
}

/// Room for the neighbours of a particle, kept from one to the next.
pub(crate) struct Room([u32; ROOM]);

impl Room {
    /// Empty room.
    pub fn new() -> Self {
        Self([0; ROOM])
    }
}

/// Hands on all within the reach of a place.
#[inline(always)]
pub(crate) fn gather<L: Lanes, P: Pairs<L>, const D: usize>(
    lanes: L,
    set: &Sorted,
    ranges: &Ranges,
    at: [f64; 3],
    reach2: f64,
    hidden: Hidden<'_>,
    room: &mut Room,
    pairs: &mut P,
) {
    let ranges = ranges.filled();
    let Some(&(mut next, _)) = ranges.first() else { return };
    let found = &mut room.0;
    let rows = &set.rows[..];
    let near = Near { at: lanes.splats(&[[at[0], at[1]], [at[2], reach2]]) };
    let (mut count, mut range) = (0, 0);
    loop {
        while range < ranges.len() {
            let to = ranges[range].1.min(next + PIECE);
            if count > ROOM - PIECE as usize - LANES {
                break;
            }
            count = near.find::<D>(lanes, set, next, to, found, count);
            next = to;
            if to == ranges[range].1 {
                range += 1;
                next = ranges.get(range).map_or(0, |range| range.0);
            }
        }
        if hidden.faces != 0 {
            count = seen(found, count, hidden);
        }
        let all = range == ranges.len();
        while all && !count.is_multiple_of(LANES) {
            found[count] = set.len() as u32;
            count += 1;
        }
        let whole = count / LANES * LANES;
        for four in found[..whole].as_chunks::<LANES>().0 {
            let (a, b) = (&rows[four[0] as usize], &rows[four[1] as usize]);
            let (c, d) = (&rows[four[2] as usize], &rows[four[3] as usize]);
            let place = lanes.columns([&a.place, &b.place, &c.place, &d.place]);
            let motion = lanes.columns([&a.motion, &b.motion, &c.motion, &d.motion]);
            pairs.add(lanes, place, motion);
        }
        if all {
            return;
        }
        found.copy_within(whole..count, 0);
        count -= whole;
    }
}

/// A place, and the square of a reach about it.
struct Near<L: Lanes> {
    at: [L::Four; 4],
}

impl<L: Lanes> Near<L> {
    /// Writes those of `from..to` that are near behind the first `count`; returns how many there are then.
    #[inline(always)]
    fn find<const D: usize>(
        &self,
        lanes: L,
        set: &Sorted,
        from: u32,
        to: u32,
        found: &mut [u32; ROOM],
        mut count: usize,
    ) -> usize {
        let (first, end) = (from as usize, to as usize + LANES - 1);
        let (xs, ys) = (set.x[first..end].as_chunks::<LANES>().0, set.y[first..end].as_chunks::<LANES>().0);
        let zs = if D == 3 { set.z[first..end].as_chunks::<LANES>().0 } else { xs };
        let whole = (to as usize - first) / LANES;
        let mut next = from;
        for ((x, y), z) in xs[..whole].iter().zip(&ys[..whole]).zip(&zs[..whole]) {
            let near = self.near::<D>(lanes, x, y, z);
            count = list(found, count, next, near);
            next = next.wrapping_add(LANES as u32);
        }
        // Those of the last four that come after the range are not of the cells asked for.
        if let (Some(x), Some(y), Some(z)) = (xs.get(whole), ys.get(whole), zs.get(whole)) {
            let valid = VALID[(to as usize - first) % LANES];
            count = list(found, count, next, self.near::<D>(lanes, x, y, z) & valid);
        }
        count
    }

    /// The pattern of those near of four.
    #[inline(always)]
    fn near<const D: usize>(&self, lanes: L, x: &Pack, y: &Pack, z: &Pack) -> usize {
        let dx = lanes.sub(self.at[0], lanes.load(x));
        let dy = lanes.sub(self.at[1], lanes.load(y));
        let mut square = lanes.add(lanes.mul(dx, dx), lanes.mul(dy, dy));
        if D == 3 {
            let dz = lanes.sub(self.at[2], lanes.load(z));
            square = lanes.add(square, lanes.mul(dz, dz));
        }
        lanes.below(square, self.at[3]) as usize
    }
}

/// Writes those of a pattern behind the first `count`; returns how many there are then. There is always room for four more.
#[inline(always)]
fn list(found: &mut [u32; ROOM], count: usize, next: u32, near: usize) -> usize {
    let numbers = &PICKED[near & 15];
    let Some(room) = found.get_mut(count..count.wrapping_add(LANES)) else { return count };
    room[0] = next.wrapping_add(numbers[0]);
    room[1] = next.wrapping_add(numbers[1]);
    room[2] = next.wrapping_add(numbers[2]);
    room[3] = next.wrapping_add(numbers[3]);
    count.wrapping_add(COUNT[near & 15] as usize)
}

/// Takes out those that are not seen; returns how many are left.
fn seen(found: &mut [u32], count: usize, hidden: Hidden<'_>) -> usize {
    let mut kept = 0;
    for k in 0..count {
        let slot = found[k];
        found[kept] = slot;
        kept += usize::from(hidden.of[slot as usize] & hidden.faces == 0);
    }
    kept
}
