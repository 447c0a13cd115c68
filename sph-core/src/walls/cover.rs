//! A sheet of points thinned to particles about a spacing apart, without holes.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::Vec3;
use crate::neighbours::CellList;

/// Least distance over the spacing of particles that are laid side by side.
const SIDE_BY_SIDE: f64 = 1.05;
/// Least distance over the spacing of those that fill the holes left.
const IN_HOLES: f64 = 0.7;

/// Of many points, so many that no two are nearer than 0.7 spacings and every point is that near to one, in a fixed
/// order.
///
/// Particles are laid side by side: next comes the point nearest to the two nearest of those laid. What fits between
/// fronts that meet is filled in, the widest hole first.
pub(super) fn cover(points: &[Vec3], spacing: f64) -> Vec<Vec3> {
    let least = SIDE_BY_SIDE * spacing;
    let mut cover = Cover {
        points,
        list: CellList::new(points, 2.0 * least),
        nearest: vec![[2.0 * least; 2]; points.len()],
        chosen: Vec::new(),
        near: Vec::new(),
    };
    for seed in 0..points.len() {
        if cover.nearest[seed][0] >= least {
            let mut front = BinaryHeap::new();
            cover.choose(seed, 2.0 * least, &mut front, least);
            while let Some(Reverse((sum, point))) = front.pop() {
                let [first, second] = cover.nearest[point as usize];
                if first >= least && sum == (first + second).to_bits() {
                    cover.choose(point as usize, 2.0 * least, &mut front, least);
                }
            }
        }
    }
    cover.fill(IN_HOLES * spacing);
    cover.chosen
}

struct Cover<'a> {
    points: &'a [Vec3],
    list: CellList,
    /// Distances of each point from the two nearest chosen ones, as far as they are within twice the least.
    nearest: Vec<[f64; 2]>,
    chosen: Vec<Vec3>,
    near: Vec<u32>,
}

impl Cover<'_> {
    /// Takes a point; those within `reach` that may come next go to the front. Positive numbers are ordered as their
    /// bits.
    fn choose(&mut self, point: usize, reach: f64, front: &mut BinaryHeap<Reverse<(u64, u32)>>, least: f64) {
        let x = self.points[point];
        self.chosen.push(x);
        self.list.within(&x, reach, &mut self.near);
        for &other in &self.near {
            let distance = (self.points[other as usize] - x).norm();
            let [first, second] = &mut self.nearest[other as usize];
            if distance < *first {
                (*first, *second) = (distance, *first);
            } else if distance < *second {
                *second = distance;
            } else {
                continue;
            }
            if *first >= least {
                front.push(Reverse(((*first + *second).to_bits(), other)));
            }
        }
    }

    /// Fills holes, the widest first, until every point is nearer than `least` to a chosen one.
    fn fill(&mut self, least: f64) {
        let open = (0..self.points.len()).filter(|&point| self.nearest[point][0] >= least);
        let mut holes: BinaryHeap<(u64, Reverse<u32>)> =
            open.map(|point| (self.nearest[point][0].to_bits(), Reverse(point as u32))).collect();
        while let Some((width, Reverse(point))) = holes.pop() {
            let now = self.nearest[point as usize][0];
            if now < least {
                continue;
            }
            if now.to_bits() == width {
                self.choose(point as usize, least, &mut BinaryHeap::new(), f64::INFINITY);
            } else {
                holes.push((now.to_bits(), Reverse(point)));
            }
        }
    }
}
