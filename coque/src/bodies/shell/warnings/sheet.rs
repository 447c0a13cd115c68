//! Cells of a surface in any state: their normals, and the turn from each to its neighbours.

use libm::atan2;
use sph_core::{Cell, Vec3};

/// Cells, and the angles between neighbouring ones.
pub(crate) struct Sheet<'a> {
    pub(crate) cells: &'a [Cell],
    /// Area centroids \[L\].
    pub(crate) centres: Vec<Vec3>,
    /// Unit normals.
    pub(crate) normals: Vec<Vec3>,
    /// Areas \[L²\].
    pub(crate) areas: Vec<f64>,
    /// Angle to the neighbour across each edge, in the order of the corners \[rad\]; zero at the boundary.
    pub(crate) turns: Vec<[f64; 4]>,
}

/// The cell on the other side of each edge, in the order of the corners; `u32::MAX` at the boundary.
pub(crate) fn neighbours(cells: &[Cell], particles: usize) -> Vec<[u32; 4]> {
    let (mut offsets, mut at) = (vec![0_u32; particles + 1], Vec::new());
    for &a in cells.iter().flat_map(Cell::particles) {
        offsets[a as usize + 1] += 1;
    }
    for a in 0..particles {
        offsets[a + 1] += offsets[a];
    }
    at.resize(offsets[particles] as usize, 0_u32);
    let mut next = offsets.clone();
    for (c, cell) in cells.iter().enumerate() {
        for &a in cell.particles() {
            at[next[a as usize] as usize] = c as u32;
            next[a as usize] += 1;
        }
    }
    let other = |c: usize, (a, b): (u32, u32)| {
        let around = &at[offsets[a as usize] as usize..offsets[a as usize + 1] as usize];
        let joined = |&&d: &&u32| d as usize != c && cells[d as usize].particles().contains(&b);
        around.iter().find(joined).copied().unwrap_or(u32::MAX)
    };
    let all = |(c, cell): (usize, &Cell)| {
        let mut out = [u32::MAX; 4];
        out.iter_mut().zip(cell.edges()).for_each(|(place, edge)| *place = other(c, edge));
        out
    };
    cells.iter().enumerate().map(all).collect()
}

impl<'a> Sheet<'a> {
    /// Cells at some positions \[L\], with their neighbours from [`neighbours`].
    pub(crate) fn at(positions: &[Vec3], cells: &'a [Cell], across: &[[u32; 4]]) -> Self {
        let (mut centres, mut normals, mut areas) = (Vec::new(), Vec::new(), Vec::new());
        for cell in cells {
            let geometry = cell.geometry(positions);
            centres.push(geometry.centroid);
            normals.push(geometry.normal);
            areas.push(geometry.area);
        }
        let turn = |c: usize, d: u32| {
            let Some(other) = normals.get(d as usize) else { return 0.0 };
            atan2(normals[c].cross(other).norm(), normals[c].dot(other))
        };
        let turns = across.iter().enumerate().map(|(c, across)| across.map(|d| turn(c, d))).collect();
        Self { cells, centres, normals, areas, turns }
    }

    /// The greatest turn between neighbours \[rad\], the cell at which it is, and the number of edges beyond a bound.
    pub(crate) fn greatest(&self, beyond: f64) -> Option<(f64, usize, usize)> {
        let (mut worst, mut count) = (None, 0);
        for (c, turns) in self.turns.iter().enumerate() {
            for &turn in turns {
                count += usize::from(turn > beyond);
                if worst.is_none_or(|(most, _)| turn > most) {
                    worst = Some((turn, c));
                }
            }
        }
        worst.map(|(turn, c)| (turn, c, count / 2))
    }
}
