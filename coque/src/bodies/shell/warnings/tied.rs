//! Sheets at junctions that are too narrow: cells tied along both sides, and few cells from a junction to an edge.

use std::collections::HashMap;

use sph_core::{Cloud, Vec3};
use sph_shell::Shell;

use super::look::Look;
use super::plural;
use crate::warning::{Warning, WarningKind};

/// Cells from a junction to the opposite edge below which a sheet is too soft in its own plane.
///
/// One point a cell sees no bending in the plane of a cell: 1/n² of the inertia of n cells, 33, 4 and .7 % of the answer of a rib
/// of one, two and four.
const FEW: usize = 3;

/// Cells tied along two opposite edges.
pub(super) fn both_sides(look: &Look<'_>) -> Option<String> {
    both_sides_of(&look.cloud(), &look.across)
}

/// The same of a cloud alone.
pub(super) fn both_sides_of(cloud: &Cloud, across: &[[u32; 4]]) -> Option<String> {
    let tied = Tied::of(cloud, across)?;
    let both = |&&c: &&usize| tied.opposite(c).any(|[here, there]| tied.is(c, here) && tied.is(c, there));
    let all = Vec::from_iter(0..tied.cloud.cells.len());
    let found = Vec::from_iter(all.iter().filter(both));
    let first = tied.centre(**found.first()?);
    Some(format!(
        "{} tied along two opposite edges, the first at {}: a junction does not feel the spin of cells, and one cell between two \
         of them bears no torsion of its own; put two cells and more between junctions. If these are facets of a smooth \
         surface, use cells that turn by less than 30°, or bring its normals with the mesh",
        if found.len() == 1 { "1 cell is".into() } else { format!("{} cells are", found.len()) },
        place(&first)
    ))
}

/// Sheets of one or two cells from a junction to an edge that is free.
pub(super) fn shallow(look: &Look<'_>) -> Option<String> {
    shallow_of(&look.cloud(), &look.across)
}

/// The same of a cloud alone.
pub(super) fn shallow_of(cloud: &Cloud, across: &[[u32; 4]]) -> Option<String> {
    let tied = Tied::of(cloud, across)?;
    let mut worst: Option<(usize, usize)> = None;
    let mut count = 0;
    for c in 0..tied.cloud.cells.len() {
        for [here, there] in tied.opposite(c) {
            let deep = tied.depth(c, here, there);
            if let Some(deep) = deep.filter(|&deep| deep < FEW) {
                count += 1;
                if worst.is_none_or(|(least, _)| deep < least) {
                    worst = Some((deep, c));
                }
            }
        }
    }
    let (deep, at) = worst?;
    let soft = if deep == 1 { 33 } else { 4 };
    Some(format!(
        "a sheet is {} deep from a junction to its free edge (at {}, and along {} of junctions fewer than {FEW}): it bends in its own \
         plane by {soft} % of its share too easily; use four cells, which are within 1 %",
        plural(deep, "cell"),
        place(&tied.centre(at)),
        plural(count, "edge"),
    ))
}

/// Part of the energy that hosts of ties may leave out.
const LOST: f64 = 0.02;

/// Couples that tied edges hand over inside cells of their host, for the forces last evaluated.
pub(crate) fn between_lines(shell: &Shell) -> Option<Warning> {
    let loss = shell.tie_loss().filter(|loss| loss.share > LOST)?;
    let message = format!(
        "edges tied inside cells hand over couples that those do not see, most of them at {}: {:.1} % of the energy is missing, and \
         displacements under loads are so much too small (bound {} %); put a line of the host's particles under the edge, or halve the \
         host's cells",
        place(&shell.rest_position(loss.particle as usize)),
        100.0 * loss.share,
        100.0 * LOST
    );
    Some(Warning::new(WarningKind::TieBetweenLines, message))
}

/// The edges of cells at which their sheet ends at a junction.
pub(super) struct Tied<'a> {
    pub(super) cloud: &'a Cloud,
    pub(super) across: &'a [[u32; 4]],
    /// First particle on the place of each that is joined.
    first: HashMap<u32, u32>,
    /// Cells with an edge between two places, and which of their edges it is.
    pub(super) cells_at: HashMap<(u32, u32), Vec<(usize, usize)>>,
}

impl<'a> Tied<'a> {
    /// None without junctions.
    pub(super) fn of(cloud: &'a Cloud, across: &'a [[u32; 4]]) -> Option<Self> {
        if cloud.joined.is_empty() {
            return None;
        }
        let mut first = HashMap::new();
        for group in &cloud.joined {
            first.extend(group.iter().map(|&a| (a, group[0])));
        }
        let mut tied = Self { cloud, across, first, cells_at: HashMap::new() };
        for (c, cell) in cloud.cells.iter().enumerate() {
            for (i, edge) in cell.edges().enumerate() {
                if let Some(places) = tied.places(edge) {
                    tied.cells_at.entry(places).or_default().push((c, i));
                }
            }
        }
        Some(tied)
    }

    /// Both ends of an edge by their places, if both are joined.
    pub(super) fn places(&self, (a, b): (u32, u32)) -> Option<(u32, u32)> {
        let (a, b) = (*self.first.get(&a)?, *self.first.get(&b)?);
        Some((a.min(b), a.max(b)))
    }

    /// Whether the sheet of a cell ends at a junction at its edge `i`.
    fn is(&self, cell: usize, i: usize) -> bool {
        let edge = self.cloud.cells[cell].edges().nth(i);
        let places = edge.and_then(|edge| self.places(edge));
        self.across[cell][i] == u32::MAX && places.is_some_and(|at| self.cells_at[&at].len() > 1)
    }

    /// Pairs of opposite edges of a quadrangle.
    fn opposite(&self, cell: usize) -> impl Iterator<Item = [usize; 2]> {
        let quadrangle = self.cloud.cells[cell].count == 4;
        [[0, 2], [1, 3], [2, 0], [3, 1]].into_iter().filter(move |_| quadrangle)
    }

    /// Cells from the junction at an edge of a cell straight to a free edge, as far as is counted.
    fn depth(&self, cell: usize, here: usize, there: usize) -> Option<usize> {
        if !self.is(cell, here) {
            return None;
        }
        let (mut cell, mut exit) = (cell, there);
        for deep in 1..FEW {
            let next = self.across[cell][exit] as usize;
            let Some(beyond) = self.cloud.cells.get(next) else {
                return (!self.is(cell, exit)).then_some(deep);
            };
            let back = self.across[next].iter().position(|&c| c as usize == cell)?;
            if beyond.count != 4 {
                return None;
            }
            (cell, exit) = (next, (back + 2) % 4);
        }
        None
    }

    fn centre(&self, cell: usize) -> Vec3 {
        self.cloud.cells[cell].geometry(&self.cloud.positions).centroid
    }
}

pub(super) fn place(x: &Vec3) -> String {
    format!("[{:.4}, {:.4}, {:.4}]", x.x, x.y, x.z)
}
