//! Which cells become nodes, and who has what is inside of the others.
//!
//! A cell that is half full at least is a node. One that has less would be a light node on a few bonds, whose horizon is mostly empty: it
//! bounds the stable step and moves with its neighbours anyhow. What is inside of it and its part of the surface go to the nearest nodes, those
//! across a face if there are any, else across an edge, and so on, by what these have themselves: volume, first moments and area of the
//! whole stay.

use super::clip::{Cut, Point};
use super::closed::SurfaceFault;
use crate::Vec3;

/// Part of a cell from which it is a node of its own; a half is one, whatever rounding did to it.
pub(super) const NODE: f64 = 0.5 - 1e-9;
/// How far a cell that is none may be from a node along each axis \[cells\]: tips of wedges and needles.
const REACH: i64 = 3;
/// How far the centre of a cell may be from that of the node that takes it, squared, before what it holds has moved away \[cells²\].
pub(super) const BESIDE: i64 = 3;
/// Part of a cell below which it is empty or full but for rounding.
pub(super) const ROUNDING: f64 = 1e-12;
/// Part of a cell that may lie inside twice, or less than not at all, by rounding.
pub(super) const TWICE: f64 = 1e-9;

/// A node, in units of cells.
pub(super) struct Node {
    pub place: Point,
    pub volume: f64,
}

/// The nodes, and what of the pieces of the surface each bears: node, number of the piece, part of it.
pub(super) struct Shared {
    pub nodes: Vec<Node>,
    pub borne: Vec<(u32, usize, f64)>,
    /// What of the volume went farther than to a cell beside its own \[cells\], and where most of one cell lay.
    pub away: Option<(f64, Point)>,
}

/// A fault at a place in units of cells.
pub(super) enum Misfit {
    Overlap(Point),
    Thin(Point),
}

impl Misfit {
    /// The fault where the place is in space.
    pub fn at(self, place: impl Fn(Point) -> Vec3) -> SurfaceFault {
        match self {
            Self::Overlap(cell) => SurfaceFault::Overlap { place: place(cell) },
            Self::Thin(cell) => SurfaceFault::Thin { place: place(cell) },
        }
    }
}

/// Makes nodes of what is inside.
pub(super) fn share_out(cut: &Cut) -> Result<Shared, Misfit> {
    let steps = steps();
    let is_node = |cell: usize| cut.inside[cell][0] >= NODE;
    let mut numbers = vec![u32::MAX; cut.inside.len()];
    let mut sums = Vec::new();
    for (cell, inside) in cut.inside.iter().enumerate() {
        if !(-TWICE..=1.0 + TWICE).contains(&inside[0]) {
            return Err(Misfit::Overlap(centre(cut, cell)));
        }
        if is_node(cell) {
            numbers[cell] = sums.len() as u32;
            sums.push((cell, *inside));
        }
    }
    let mut bears = vec![false; cut.inside.len()];
    cut.pieces.iter().for_each(|piece| bears[piece.cell] = true);
    let (mut away, mut most) = (0.0, None);
    let little = |cell: usize| !is_node(cell) && (bears[cell] || cut.inside[cell][0].abs() > ROUNDING);
    for cell in (0..cut.inside.len()).filter(|&cell| little(cell)) {
        let inside = cut.inside[cell];
        let nearest = nearest(cut, cell, &numbers, &steps)?;
        if nearest.square > BESIDE {
            away += inside[0];
            if most.is_none_or(|(volume, _)| inside[0] > volume) {
                most = Some((inside[0], centre(cut, cell)));
            }
        }
        for (to, part) in nearest.parts {
            let (own, sum) = &mut sums[numbers[to] as usize];
            let [from, at] = [centre(cut, cell), centre(cut, *own)];
            sum[0] += part * inside[0];
            (0..3).for_each(|k| sum[k + 1] += part * (inside[k + 1] + inside[0] * (from[k] - at[k])));
        }
    }
    let mut borne = Vec::with_capacity(cut.pieces.len());
    for (number, piece) in cut.pieces.iter().enumerate() {
        match numbers[piece.cell] {
            u32::MAX => {
                let parts = nearest(cut, piece.cell, &numbers, &steps)?.parts.into_iter();
                borne.extend(parts.map(|(to, part)| (numbers[to], number, part)));
            }
            node => borne.push((node, number, 1.0)),
        }
    }
    let node = |(cell, [volume, moments @ ..]): (usize, [f64; 4])| {
        let at = centre(cut, cell);
        if (volume - 1.0).abs() < ROUNDING && moments.iter().all(|moment| moment.abs() < ROUNDING) {
            return Node { place: at, volume: 1.0 };
        }
        Node { place: [0, 1, 2].map(|k| at[k] + moments[k] / volume), volume }
    };
    let away = most.map(|(_, place)| (away, place));
    Ok(Shared { nodes: sums.into_iter().map(node).collect(), borne, away })
}

pub(super) fn centre(cut: &Cut, cell: usize) -> Point {
    cut.place(cell).map(|n| n as f64 + 0.5)
}

/// The nodes that are nearest to a cell that is none.
pub(super) struct Nearest {
    /// Cells of the nodes, and the part of it that each takes.
    pub parts: Vec<(usize, f64)>,
    /// Square of the distance between the centres of the cells \[cells²\].
    pub square: i64,
}

/// The nodes nearest to a cell that is none; `numbers` has `u32::MAX` for such cells.
pub(super) fn nearest(cut: &Cut, cell: usize, numbers: &[u32], steps: &[Step]) -> Result<Nearest, Misfit> {
    let at = cut.place(cell).map(|n| n as i64);
    let node = |step: &Step| {
        let to = [0, 1, 2].map(|k| usize::try_from(at[k] + step.by[k]).ok().filter(|&n| n < cut.counts[k]));
        let [Some(i), Some(j), Some(k)] = to else { return None };
        Some(cut.number([i, j, k])).filter(|&to| numbers[to] != u32::MAX)
    };
    let first = steps.iter().find(|step| node(step).is_some()).ok_or(Misfit::Thin(centre(cut, cell)))?;
    let alike = steps.iter().filter(|step| step.square == first.square);
    let mut parts: Vec<(usize, f64)> = alike.filter_map(node).map(|to| (to, cut.inside[to][0])).collect();
    let whole: f64 = parts.iter().map(|(_, inside)| inside).sum();
    parts.iter_mut().for_each(|(_, part)| *part /= whole);
    Ok(Nearest { parts, square: first.square })
}

/// The way from a cell to another one, with the square of its length \[cells\].
pub(super) struct Step {
    by: [i64; 3],
    square: i64,
}

/// All within reach, the shortest first.
pub(super) fn steps() -> Vec<Step> {
    let reach = || -REACH..=REACH;
    let all = reach().flat_map(|i| reach().flat_map(move |j| reach().map(move |k| [i, j, k])));
    let mut all: Vec<Step> = all
        .map(|by| Step { by, square: by.iter().map(|n| n * n).sum() })
        .filter(|step| step.square > 0)
        .collect();
    all.sort_by_key(|step| step.square);
    all
}
