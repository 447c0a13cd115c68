//! The neighbours of one particle: found among those of the cells beside it, and handed on four at a time.

use crate::cells::Ranges;
use crate::hidden::Hidden;
use crate::lanes::{LANES, Lanes};
use crate::sorted::Sorted;

/// Room for neighbours between two rounds of pairs.
const ROOM: usize = 512;

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
    at: &[f64],
    reach2: f64,
    hidden: Hidden<'_>,
    room: &mut Room,
    pairs: &mut P,
) {
    let ranges = ranges.filled();
    let Some(&(mut next, _)) = ranges.first() else { return };
    let found = &mut room.0;
    let limit = lanes.splat(reach2);
    let (ax, ay) = (lanes.splat(at[0]), lanes.splat(at[1]));
    let az = lanes.splat(if D == 3 { at[2] } else { 0.0 });
    let (mut count, mut range) = (0, 0);
    loop {
        while range < ranges.len() {
            let to = ranges[range].1;
            while next < to && count <= ROOM - LANES {
                let j = next as usize;
                let dx = lanes.sub(ax, lanes.load(&set.x, j));
                let dy = lanes.sub(ay, lanes.load(&set.y, j));
                let mut square = lanes.add(lanes.mul(dx, dx), lanes.mul(dy, dy));
                if D == 3 {
                    let dz = lanes.sub(az, lanes.load(&set.z, j));
                    square = lanes.add(square, lanes.mul(dz, dz));
                }
                let left = (to - next).min(LANES as u32);
                let near = (lanes.below(square, limit) & ((1_u8 << left) - 1)) as usize & 15;
                let numbers = PICKED[near];
                let room = &mut found[count..count + LANES];
                for lane in 0..LANES {
                    room[lane] = next + numbers[lane];
                }
                count += near.count_ones() as usize;
                next += LANES as u32;
            }
            if next < to {
                break;
            }
            range += 1;
            if range < ranges.len() {
                next = ranges[range].0;
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
        for four in found[..whole].chunks_exact(LANES) {
            let (a, b) = (&set.rows[four[0] as usize], &set.rows[four[1] as usize]);
            let (c, d) = (&set.rows[four[2] as usize], &set.rows[four[3] as usize]);
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
