//! What is cut out of a block: balls, cylinders, boxes, prisms.

use super::Block;
use crate::Vec3;
use crate::surface::cell::Cell;

/// A part of space that holds no nodes; what lies on its border is cut out too.
#[derive(Clone, Debug, PartialEq)]
pub enum CutOut {
    /// A ball; in a plane a disc.
    Ball {
        /// Centre \[L\].
        centre: Vec3,
        /// Radius \[L\].
        radius: f64,
    },
    /// A cylinder without ends.
    Cylinder {
        /// A point of its axis \[L\].
        point: Vec3,
        /// Unit vector along its axis.
        axis: Vec3,
        /// Radius \[L\].
        radius: f64,
    },
    /// A box along the axes.
    Box {
        /// Least coordinates \[L\].
        min: Vec3,
        /// Greatest coordinates \[L\].
        max: Vec3,
    },
    /// A prism along z over a polygon, its corners in order.
    Prism(Vec<[f64; 2]>),
}

impl CutOut {
    /// Whether a point lies in it.
    pub fn holds(&self, x: &Vec3) -> bool {
        match self {
            Self::Ball { centre, radius } => (x - centre).norm() <= *radius,
            Self::Cylinder { point, axis, radius } => {
                let across = x - point;
                (across - axis * axis.dot(&across)).norm() <= *radius
            }
            Self::Box { min, max } => (0..3).all(|axis| min[axis] <= x[axis] && x[axis] <= max[axis]),
            Self::Prism(corners) => inside(corners, [x.x, x.y]),
        }
    }
}

/// Whether a point lies in a polygon: a ray along x crosses its border an odd number of times.
fn inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let before = corners.iter().cycle().skip(corners.len().saturating_sub(1));
    let crossings = corners.iter().zip(before).filter(|(a, b)| {
        let crosses = (a[1] > y) != (b[1] > y);
        crosses && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossings.count() % 2 == 1
}

impl Block {
    /// The block without the nodes in any of the cut-outs.
    ///
    /// A node goes or stays with its whole volume and its share of the faces, as its place says: cut surfaces are as
    /// smooth as the lattice. Cells stay where all their corners do.
    pub fn without(self, cut_outs: &[CutOut]) -> Self {
        if cut_outs.is_empty() {
            return self;
        }
        let stays = |x: &Vec3| !cut_outs.iter().any(|cut_out| cut_out.holds(x));
        let mut count = 0;
        let numbers: Vec<Option<u32>> = self
            .positions
            .iter()
            .map(|x| {
                stays(x).then(|| {
                    count += 1;
                    count - 1
                })
            })
            .collect();
        let number = |node: u32| numbers[node as usize];
        let kept = |list: Vec<(u32, f64)>| {
            list.into_iter().filter_map(|(node, area)| Some((number(node)?, area))).collect()
        };
        let cell = |cell: &Cell| {
            let mut corners = cell.corners;
            for corner in &mut corners {
                *corner = number(*corner)?;
            }
            Some(Cell { corners, ..*cell })
        };
        let of_kept = |node: &usize| numbers[*node].is_some();
        Self {
            dimensions: self.dimensions,
            spacing: self.spacing,
            positions: (0..self.len()).filter(of_kept).map(|node| self.positions[node]).collect(),
            volumes: (0..self.len()).filter(of_kept).map(|node| self.volumes[node]).collect(),
            cells: self.cells.iter().filter_map(cell).collect(),
            faces: self.faces.map(kept),
        }
    }
}
