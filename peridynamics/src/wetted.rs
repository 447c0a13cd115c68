//! The wet surface of a solid: its nodes are the points of the boundary, and bear the load as it comes.
//!
//! All nodes are points, so that faces which a crack opens are wet without a word. Between two loads of the fluid nodes that
//! are **outermost** against the load resist what they move, along its direction n, beyond what the fluid saw:
//!
//! ```text
//! f = −ρ₀c₀A [(v − v_seen)·n] n        A: a face of the node's own cell of the lattice
//! ```
//!
//! A node is outermost if no node that lay beside it at rest stands before it on the side that the load comes from. Rows
//! further in bear load as well, since a fluid sees several rows of a wall; they do not count again.

use explicit_dynamics::BoundaryLoad;
use explicit_dynamics::{BoundaryLayout, BoundaryState};
use sph_core::{Block, CellList, Vec3};

use crate::bonds::network::Row;

/// Distance at rest, over the spacing, within which nodes lie beside each other: along a diagonal of a plane lattice, and of
/// two faces of one in space.
const BESIDE: f64 = 1.5;
/// A node stands before another if it is more than this part of a cell ahead, and less than the next one off the line.
const AHEAD: f64 = 0.5;
const OFF_LINE: f64 = 0.75;

/// The boundary of a solid.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    pub layout: BoundaryLayout,
    /// Width of a cell of each node \[L\].
    cells: Vec<f64>,
    /// Thickness in a plane \[L\].
    thickness: Option<f64>,
    /// Where the neighbours of each node end in the list of all; they lay beside it at rest.
    ends: Vec<u32>,
    beside: Vec<u32>,
    /// Force on each node \[F\].
    forces: Vec<Vec3>,
    /// Nodes that resist, with ρ₀c₀A \[F T/L\], the direction of the load, and the velocity that the fluid saw \[L/T\].
    resisting: Vec<(u32, f64, Vec3, Vec3)>,
}

impl Surface {
    /// The boundary of a block of nodes.
    pub fn new(block: &Block) -> Self {
        let reach = BESIDE * block.greatest_spacing();
        let list = CellList::new(&block.positions, reach);
        let (mut ends, mut beside, mut near) = (Vec::new(), Vec::new(), Vec::new());
        for (node, x) in block.positions.iter().enumerate() {
            list.within(x, reach, &mut near);
            beside.extend(near.iter().copied().filter(|&other| other as usize != node));
            ends.push(beside.len() as u32);
        }
        let cells: Vec<f64> = block.positions.iter().map(|x| list.nearest(x, 2)).collect();
        let area = |cell: &f64| if block.dimensions == 2 { *cell } else { cell * cell };
        let layout =
            BoundaryLayout { points: block.len(), areas: cells.iter().map(area).collect(), thin: None };
        Self {
            layout,
            cells,
            thickness: (block.dimensions == 2).then_some(block.spacing[2]),
            ends,
            beside,
            forces: vec![Vec3::zeros(); block.len()],
            resisting: Vec::new(),
        }
    }

    /// Where the nodes are.
    pub fn places(&self, rows: &[Row], out: &mut BoundaryState) {
        out.points.clear();
        out.points.extend(rows[..self.cells.len()].iter().map(|row| [row[0], row[1], row[2]]));
        out.middle.clear();
        out.normals.clear();
    }

    /// Takes up a load on nodes at such places.
    pub fn take(&mut self, rows: &[Row], load: &BoundaryLoad<'_>) {
        let width = self.thickness.unwrap_or(1.0);
        for (force, new) in self.forces.iter_mut().zip(load.forces) {
            *force = Vec3::from(*new) * width;
        }
        self.resisting.clear();
        if load.impedance == 0.0 {
            return;
        }
        for (node, found) in load.found.iter().enumerate() {
            let Some(n) = Vec3::from(*found).try_normalize(0.0) else { continue };
            if self.is_outermost(node, &n, rows) {
                let resistance = load.impedance * self.layout.areas[node] * width;
                self.resisting.push((node as u32, resistance, n, load.seen[node].into()));
            }
        }
    }

    /// Adds the load to the forces on the rows.
    pub fn add(&self, rates: &[Row], forces: &mut [Vec3]) {
        for (force, load) in forces.iter_mut().zip(&self.forces) {
            *force += load;
        }
        for (node, force) in self.resistances(rates) {
            forces[node] += force;
        }
    }

    /// Adds to the impulses of the nodes what they resist over a span.
    pub fn impedance_impulses(&self, rates: &[Row], span: f64, impulses: &mut [[f64; 3]]) {
        let part = span / self.thickness.unwrap_or(1.0);
        for (node, force) in self.resistances(rates) {
            (0..3).for_each(|k| impulses[node][k] += part * force[k]);
        }
    }

    /// Nodes that resist, with their forces.
    fn resistances(&self, rates: &[Row]) -> impl Iterator<Item = (usize, Vec3)> {
        self.resisting.iter().map(|&(node, resistance, n, seen)| {
            let rate = &rates[node as usize];
            let along = (Vec3::new(rate[0], rate[1], rate[2]) - seen).dot(&n);
            (node as usize, n * (-resistance * along))
        })
    }

    /// Whether nothing that lay beside a node stands before it, where a load along n comes from.
    fn is_outermost(&self, node: usize, n: &Vec3, rows: &[Row]) -> bool {
        let place = |node: usize| Vec3::new(rows[node][0], rows[node][1], rows[node][2]);
        let start = node.checked_sub(1).map_or(0, |before| self.ends[before]) as usize;
        let (x, cell) = (place(node), self.cells[node]);
        !self.beside[start..self.ends[node] as usize].iter().any(|&other| {
            let apart = place(other as usize) - x;
            let ahead = -apart.dot(n);
            ahead > AHEAD * cell && ahead < 2.0 * cell && (apart + n * ahead).norm() < OFF_LINE * cell
        })
    }

    /// Bytes of all lists.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.layout.areas[..])
            + size_of_val(&self.cells[..])
            + size_of_val(&self.ends[..])
            + size_of_val(&self.beside[..])
            + size_of_val(&self.forces[..])
            + size_of_val(&self.resisting[..])
    }
}
