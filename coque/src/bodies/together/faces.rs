//! The surface of a body to which others are glued: faces between its particles, and how stiff glue on it is.

use std::collections::{BTreeMap, BTreeSet};

use peridynamics::Solid;
use rigid_body::RigidBody;
use sph_core::{Block, Cell, Vec3};
use sph_shell::Shell;

use super::directors::Directors;
use super::sides::young;
use crate::bodies::body::Body;
use crate::bodies::galerkin::solid::GalerkinSolid;
use crate::scene::SolidScene;

/// Stiffness of glue on a cell over that of the cell where it is pulled: what it gives way by does not show beside ten cells.
const OVER_CELL: f64 = 400.0;

/// Faces of a body.
#[derive(Clone, Debug)]
pub(super) struct Faces {
    /// The faces, by particles of the body.
    pub cells: Vec<Cell>,
    /// Stiffness of glue at rest by area \[F/L³\]; on a rigid body infinite.
    pub stiffness: f64,
    /// How far particles lie behind the face of the body \[L\].
    pub half: f64,
    /// Mean distance of particles \[L\]; of a rigid body zero.
    pub spacing: f64,
    /// Area of a particle, where all have the same \[L²\].
    area: Option<f64>,
    /// Directors of a shell.
    pub directors: Option<Directors>,
}

impl Faces {
    /// Those of a shell, its cells; a cell is as stiff as the least membrane of all sections.
    pub fn of_shell(shell: &Shell) -> Self {
        let spacing = shell.reference().cloud.spacing();
        let half = shell.least_half_thickness().unwrap_or(0.0);
        let stiffness = OVER_CELL * shell.least_membrane_stiffness() / (spacing * spacing);
        let directors = Some(Directors::of(shell, OVER_CELL));
        Self { cells: shell.configuration().cells.to_vec(), stiffness, half, spacing, area: None, directors }
    }

    /// Those of a solid of bonds: quadrangles between its outermost nodes. Half a spacing of the body lies before them that has no bonds of its own,
    /// and glue takes it to be rigid, as far as that makes up for the bonds that nodes behind it lack.
    pub fn of_bonds(body: &SolidScene, solid: &Solid) -> Self {
        let block = solid.block();
        let spacing = block.spacing.iter().copied().fold(f64::INFINITY, f64::min);
        let stiffness = OVER_CELL * young(body) / spacing;
        let volume = block.volumes.iter().sum::<f64>() / block.len() as f64;
        let area = Some(volume / spacing);
        let half = 0.5 * block.greatest_spacing();
        Self { cells: outermost(block), stiffness, half, spacing, area, directors: None }
    }

    /// Those of a Galerkin solid.
    pub fn of_galerkin(body: &SolidScene, solid: &GalerkinSolid, spacing: f64) -> Self {
        let stiffness = OVER_CELL * young(body) / spacing;
        let cells = solid.configuration().cells.to_vec();
        Self { cells, stiffness, half: 0.0, spacing, area: None, directors: None }
    }

    /// Those of a rigid body.
    pub fn of_rigid(body: &RigidBody) -> Self {
        let stiffness = f64::INFINITY;
        Self { cells: body.cells().to_vec(), stiffness, half: 0.0, spacing: 0.0, area: None, directors: None }
    }

    /// Areas for which some particles at rest stand \[L²\]: their parts of the faces between them, or of all faces at those that have none of these.
    pub fn areas(&self, particles: &[u32], rest: &[Vec3]) -> Vec<f64> {
        if let Some(area) = self.area {
            return vec![area; particles.len()];
        }
        let set: BTreeSet<u32> = particles.iter().copied().collect();
        let (mut between, mut all) = (BTreeMap::<u32, f64>::new(), BTreeMap::<u32, f64>::new());
        for cell in &self.cells {
            let corners = &cell.corners[..usize::from(cell.count)];
            let part = cell.geometry(rest).area / corners.len() as f64;
            let inside = corners.iter().all(|a| set.contains(a));
            for &a in corners.iter().filter(|a| set.contains(a)) {
                *all.entry(a).or_default() += part;
                if inside {
                    *between.entry(a).or_default() += part;
                }
            }
        }
        let of = |a: &u32| between.get(a).or(all.get(a)).copied().unwrap_or(0.0);
        particles.iter().map(of).collect()
    }
}

/// Quadrangles between the nodes of each side of a lattice; where a cut-out took one away there is none.
fn outermost(block: &Block) -> Vec<Cell> {
    let low = block.positions.iter().copied().reduce(|a, b| a.zip_map(&b, f64::min)).unwrap_or_default();
    let place = |a: u32| -> [i64; 3] {
        let x = block.positions[a as usize] - low;
        std::array::from_fn(|k| libm::round(x[k] / block.spacing[k]) as i64)
    };
    let mut cells = Vec::new();
    for (side, nodes) in block.faces.iter().enumerate() {
        let axis = side / 2;
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        let known: BTreeMap<[i64; 3], u32> = nodes.iter().map(|&(a, _)| (place(a), a)).collect();
        for (&at, &a) in &known {
            let next = |du: i64, dv: i64| {
                let mut to = at;
                (to[u], to[v]) = (to[u] + du, to[v] + dv);
                known.get(&to).copied()
            };
            if let [Some(b), Some(c), Some(d)] = [next(1, 0), next(1, 1), next(0, 1)] {
                cells.push(Cell::quadrangle([a, b, c, d]));
            }
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use sph_core::{BlockLattice, NodePlaces, Vec3};

    use super::outermost;

    /// A block of 2 × 3 × 4 nodes: 2·(1·2 + 2·3 + 1·3) quadrangles, each on one side.
    #[test]
    fn quadrangles_lie_on_the_sides_of_a_block() {
        let lattice = BlockLattice {
            dimensions: 3,
            lengths: [2.0, 3.0, 4.0],
            spacing: [1.0; 3],
            origin: Vec3::new(7.0, 0.0, 0.0),
            nodes: NodePlaces::Centres,
            grading: [1.0; 3],
            disorder: 0.0,
            seed: 0,
        };
        let block = lattice.block().unwrap();
        let cells = outermost(&block);
        assert_eq!(cells.len(), 22);
        for cell in &cells {
            let at = cell.corners.map(|a| block.positions[a as usize]);
            assert!((0..3).any(|k| at.iter().all(|x| x[k] == at[0][k])));
            assert!(((at[1] - at[0]).cross(&(at[3] - at[0])).norm() - 1.0).abs() < 1e-12);
        }
    }
}
