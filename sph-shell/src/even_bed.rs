//! What is spread evenly over a line or an area and grows with the motion there: stiffnesses of springs.
//!
//! Shared by lengths, a line of n intervals has `1 + 2/n²` of its second moment about its middle, and resists rocking as much more; shared equally,
//! `1 + 2/n`. With the motion linear between neighbours the bed on an interval of length h is the consistent one,
//!
//! ```text
//! ∫ u² ds = h/3 (u_a² + u_a u_b + u_b²) = h/2 (u_a² + u_b²) − h/6 (u_a − u_b)²
//! ∫ u² dA = A/3 Σ u_a² − A/12 Σ (u_a − u_b)²          a triangle, over its three sides
//! ```
//!
//! the shares by lengths and areas less what pairs of neighbours have too much. A quadrangle is cut along both diagonals, and is their mean. Any linear motion meets
//! the stiffness and the moments of zeroth, first and second order of an even bed, on any cells; under one motion everywhere each particle bears
//! what its length or area would, so that a uniform state stays one. Of a motion `sin qs` a part of `(qh)²/6` is missing.

use std::collections::BTreeMap;

use sph_core::{Cell, Cloud};

/// An even bed of stiffness one, `Σ shares u_a² − Σ pairs (u_a − u_b)²`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvenBed {
    /// Particles and the share of each, ascending; they sum to one.
    pub shares: Vec<(u32, f64)>,
    /// Pairs of neighbours and what they have too much, ascending; none on single particles.
    pub pairs: Vec<([u32; 2], f64)>,
}

/// Shares and pairs as they are found.
#[derive(Default)]
struct Found {
    shares: BTreeMap<u32, f64>,
    pairs: BTreeMap<[u32; 2], f64>,
}

impl Found {
    /// Adds a line between two particles, or one side of a triangle of which a part counts.
    fn add(&mut self, [a, b]: [u32; 2], share: f64, pair: f64) {
        *self.shares.entry(a).or_default() += share;
        *self.shares.entry(b).or_default() += share;
        if a != b {
            *self.pairs.entry([a.min(b), a.max(b)]).or_default() += pair;
        }
    }
}

/// Spreads a bed over a set of particles: over the area of cells if every particle belongs to a cell whose corners all are in the set, along
/// lines if the particles follow edges of cells, those of the boundary or others, and else over its places, to each the same.
///
/// Of particles that a junction ties the first stands for all.
pub fn even_bed(cloud: &Cloud, particles: &[u32]) -> EvenBed {
    let mut inside = vec![false; cloud.len()];
    particles.iter().for_each(|&a| inside[a as usize] = true);
    let found = over_cells(cloud, particles, &inside)
        .or_else(|| along_lines(cloud, particles, &inside, true))
        .or_else(|| along_lines(cloud, particles, &inside, false))
        .unwrap_or_else(|| Found {
            shares: particles.iter().map(|&a| (a, 1.0)).collect(),
            ..Found::default()
        });
    let mut first: BTreeMap<u32, u32> = BTreeMap::new();
    for group in &cloud.joined {
        first.extend(group.iter().map(|&a| (a, group[0])));
    }
    let place = |a: u32| first.get(&a).copied().unwrap_or(a);
    let mut merged = Found::default();
    if found.pairs.is_empty() {
        merged.shares.extend(found.shares.iter().map(|(&a, _)| (place(a), 1.0)));
    } else {
        for (&a, share) in &found.shares {
            *merged.shares.entry(place(a)).or_default() += share;
        }
        for (pair, part) in found.pairs {
            merged.add(pair.map(place), 0.0, part);
        }
    }
    let whole: f64 = merged.shares.values().sum();
    EvenBed {
        shares: merged.shares.into_iter().map(|(a, share)| (a, share / whole)).collect(),
        pairs: merged.pairs.into_iter().map(|(pair, part)| (pair, part / whole)).collect(),
    }
}

/// By areas \[L²\].
fn over_cells(cloud: &Cloud, particles: &[u32], inside: &[bool]) -> Option<Found> {
    let mut found = Found::default();
    let whole = |cell: &&Cell| cell.particles().iter().all(|&b| inside[b as usize]);
    for cell in cloud.cells.iter().filter(whole) {
        let corners = cell.particles();
        let (cuts, part): (&[[usize; 3]], f64) = if corners.len() == 3 {
            (&[[0, 1, 2]], 1.0)
        } else {
            (&[[0, 1, 2], [0, 2, 3], [1, 2, 3], [1, 3, 0]], 0.5)
        };
        for cut in cuts {
            let [a, b, c] = cut.map(|k| corners[k]);
            let [x, y, z] = [a, b, c].map(|k| cloud.positions[k as usize]);
            let area = 0.5 * part * (y - x).cross(&(z - x)).norm();
            [[a, b], [b, c], [c, a]].into_iter().for_each(|side| found.add(side, area / 6.0, area / 12.0));
        }
    }
    particles.iter().all(|a| found.shares.get(a).is_some_and(|area| *area > 0.0)).then_some(found)
}

/// By lengths \[L\]; `boundary` keeps to edges of one cell.
fn along_lines(cloud: &Cloud, particles: &[u32], inside: &[bool], boundary: bool) -> Option<Found> {
    let mut cells_at: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for (a, b) in cloud.cells.iter().flat_map(Cell::edges) {
        if inside[a as usize] && inside[b as usize] {
            *cells_at.entry([a.min(b), a.max(b)]).or_default() += 1;
        }
    }
    let mut neighbours: BTreeMap<u32, usize> = BTreeMap::new();
    let mut found = Found::default();
    for (&[a, b], _) in cells_at.iter().filter(|(_, count)| !boundary || **count == 1) {
        let length = (cloud.positions[b as usize] - cloud.positions[a as usize]).norm();
        found.add([a, b], 0.5 * length, length / 6.0);
        [a, b].into_iter().for_each(|end| *neighbours.entry(end).or_default() += 1);
    }
    let of_a_line = |a: &u32| {
        matches!(neighbours.get(a), Some(1 | 2)) && found.shares.get(a).is_some_and(|length| *length > 0.0)
    };
    particles.iter().all(of_a_line).then_some(found)
}
