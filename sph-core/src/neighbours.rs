//! Neighbour search: particles sorted into cubic boxes, found by binary search of box columns.

use crate::Vec3;

/// Particles sorted by the cubic box they lie in.
///
/// Boxes are ordered by (x, y, z) index; only occupied ones are stored, so a sheet costs memory for its area and not
/// for the volume around it. Answers do not depend on the order in which particles were sorted.
#[derive(Clone, Debug)]
pub struct CellList {
    size: f64,
    /// Occupied boxes, ascending.
    boxes: Vec<[i64; 3]>,
    /// First entry of each box in `particles`, and the end.
    starts: Vec<u32>,
    particles: Vec<u32>,
    positions: Vec<Vec3>,
}

impl CellList {
    /// Sorts `positions` `[L]` into boxes of edge `cell_size` `[L]`.
    ///
    /// Queries are fastest with radii near `cell_size`, but any radius is answered. A size that is not a positive
    /// number puts everything in one box.
    pub fn new(positions: &[Vec3], cell_size: f64) -> CellList {
        let size = if cell_size > 0.0 { cell_size } else { f64::INFINITY };
        let mut keyed: Vec<([i64; 3], u32)> =
            positions.iter().enumerate().map(|(a, x)| (box_of(x, size), a as u32)).collect();
        keyed.sort_unstable();
        let mut boxes = Vec::new();
        let mut starts = Vec::new();
        for (entry, (key, _)) in keyed.iter().enumerate() {
            if boxes.last() != Some(key) {
                boxes.push(*key);
                starts.push(entry as u32);
            }
        }
        starts.push(keyed.len() as u32);
        let particles: Vec<u32> = keyed.iter().map(|(_, a)| *a).collect();
        let positions = particles.iter().map(|&a| positions[a as usize]).collect();
        CellList { size, boxes, starts, particles, positions }
    }

    /// Writes to `out` the particles no farther than `radius` `[L]` from `centre`, ascending; `out` is cleared first.
    pub fn within(&self, centre: &Vec3, radius: f64, out: &mut Vec<u32>) {
        out.clear();
        self.visit(centre, radius, |particle, _| out.push(particle));
        out.sort_unstable();
    }

    /// Distance `[L]` from `centre` to its `k`-th nearest particle, a particle at `centre` itself included.
    ///
    /// Infinite when there are fewer than `k` particles.
    pub fn nearest(&self, centre: &Vec3, k: usize) -> f64 {
        if k == 0 {
            return 0.0;
        }
        if self.particles.len() < k {
            return f64::INFINITY;
        }
        let mut squares = Vec::new();
        let mut radius = self.size;
        loop {
            squares.clear();
            self.visit(centre, radius, |_, square| squares.push(square));
            if squares.len() >= k {
                squares.sort_unstable_by(f64::total_cmp);
                return squares[k - 1].sqrt();
            }
            if radius == f64::INFINITY {
                return f64::INFINITY; // particles at NaN positions are near to nothing
            }
            radius *= 2.0;
        }
    }

    /// The particle nearest to `centre`, of several as near the first; none where there is none.
    pub fn nearest_particle(&self, centre: &Vec3) -> Option<u32> {
        let mut radius = self.size;
        loop {
            let mut best: Option<(f64, u32)> = None;
            self.visit(centre, radius, |particle, square| {
                let nearer =
                    |(least, other): (f64, u32)| square < least || square == least && particle < other;
                if best.is_none_or(nearer) {
                    best = Some((square, particle));
                }
            });
            if best.is_some() || self.particles.is_empty() || radius == f64::INFINITY {
                return best.map(|own| own.1);
            }
            radius *= 2.0;
        }
    }

    /// Calls `found(particle, squared distance)` for everything within `radius`.
    fn visit(&self, centre: &Vec3, radius: f64, mut found: impl FnMut(u32, f64)) {
        let reach = Vec3::repeat(radius);
        let low = box_of(&(centre - reach), self.size);
        let high = box_of(&(centre + reach), self.size);
        let mut test = |entries: std::ops::Range<usize>| {
            for entry in entries {
                let square = (self.positions[entry] - centre).norm_squared();
                if square <= radius * radius {
                    found(self.particles[entry], square);
                }
            }
        };
        let across = |axis: usize| high[axis] as f64 - low[axis] as f64 + 1.0;
        if across(0) * across(1) > self.boxes.len() as f64 {
            test(0..self.particles.len());
            return;
        }
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                let first = self.boxes.partition_point(|key| *key < [x, y, low[2]]);
                let count = self.boxes[first..].iter().take_while(|key| **key <= [x, y, high[2]]).count();
                test(self.starts[first] as usize..self.starts[first + count] as usize);
            }
        }
    }
}

/// Index of the box of edge `size` that holds `x` (saturating far out).
fn box_of(x: &Vec3, size: f64) -> [i64; 3] {
    [(x.x / size).floor() as i64, (x.y / size).floor() as i64, (x.z / size).floor() as i64]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    fn brute(positions: &[Vec3], centre: &Vec3, radius: f64) -> Vec<u32> {
        (0..positions.len() as u32)
            .filter(|&a| (positions[a as usize] - centre).norm_squared() <= radius * radius)
            .collect()
    }

    proptest! {
        #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn finds_what_brute_force_finds(
            points in prop::collection::vec(prop::array::uniform3(-3.0..3.0f64), 0..120),
            centre in prop::array::uniform3(-4.0..4.0f64),
            radius in 0.0..5.0f64,
            size in 0.05..4.0f64,
            k in 0usize..12,
        ) {
            let positions: Vec<Vec3> = points.into_iter().map(Vec3::from).collect();
            let centre = Vec3::from(centre);
            let list = CellList::new(&positions, size);
            let mut found = vec![99];
            list.within(&centre, radius, &mut found);
            prop_assert_eq!(found, brute(&positions, &centre, radius));

            let mut distances: Vec<f64> = positions.iter().map(|x| (x - centre).norm()).collect();
            distances.sort_by(f64::total_cmp);
            let expected = match k {
                0 => 0.0,
                _ => distances.get(k - 1).copied().unwrap_or(f64::INFINITY),
            };
            prop_assert!(list.nearest(&centre, k) == expected);
        }
    }

    #[test]
    fn odd_sizes_and_places_are_answered() {
        let positions = [Vec3::zeros(), Vec3::new(1.0, 0.0, 0.0), Vec3::repeat(f64::NAN)];
        for size in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-12, 1.0] {
            let list = CellList::new(&positions, size);
            let mut found = Vec::new();
            list.within(&Vec3::zeros(), 2.0, &mut found);
            assert_eq!(found, [0, 1], "size {size}");
            list.within(&Vec3::zeros(), f64::INFINITY, &mut found);
            assert_eq!(found, [0, 1], "size {size}");
            assert_eq!(list.nearest(&Vec3::zeros(), 2), 1.0);
            assert_eq!(list.nearest(&Vec3::zeros(), 3), f64::INFINITY);
        }
    }
}
