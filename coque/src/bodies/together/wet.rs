//! What of a shell at rest is wet: places of its faces with the unknowns that move them.

use std::collections::BTreeMap;

use implicit_statics::Joinable;
use sph_core::Vec3;
use sph_shell::{Shell, StaticShell, WetColumn, Wetting};

use crate::bodies::Body;
use crate::bodies::fluid::parts::rows_deep;
use crate::scene::{FluidScene, ShellScene};

/// The wet surface of a shell whose unknowns are numbered.
pub(in crate::bodies) struct WetSurface {
    pub columns: Vec<WetColumn>,
    /// By column: unknowns, and how fast a unit of each moves the place along its normal.
    pub along: Vec<Vec<(usize, f64)>>,
    /// Half of the thickness \[L\].
    pub half: f64,
    /// Its middle surface, in triangles \[L\]; in a plane lines, from the first corner to the second.
    pub middle: Vec<[Vec3; 3]>,
    /// How wide a strip is \[L\]; none in space.
    pub width: Option<f64>,
}

/// How a shell meets a fluid.
pub(in crate::bodies) fn wetting(shell: &ShellScene, fluid: &FluidScene) -> Wetting {
    Wetting {
        spacing: fluid.geometry.spacing(),
        rows: rows_deep(fluid),
        faces: shell.wet.unwrap_or_default(),
        plane: fluid.dimensions() == 2,
        free_edges: Vec::new(),
    }
}

impl WetSurface {
    /// That of a shell, before its unknowns are numbered.
    pub fn of(shell: &Shell) -> Self {
        let width = shell.wet_width();
        let half = 0.5 * shell.thickness();
        Self { columns: shell.wet_columns(), along: Vec::new(), half, middle: middle(shell, width), width }
    }

    /// The same, of a shell whose first unknown has this number.
    pub fn numbered_from(mut self, first: usize) -> Self {
        self.along.iter_mut().flatten().for_each(|(unknown, _)| *unknown += first);
        self
    }

    /// Finds the unknowns.
    pub fn find_unknowns(&mut self, shell: &StaticShell) {
        let mut ways: BTreeMap<u32, Vec<(usize, [f64; 3])>> = BTreeMap::new();
        let along = |column: &WetColumn| {
            let mut all: BTreeMap<usize, f64> = BTreeMap::new();
            for &(particle, weight) in &column.weights {
                let ways = ways.entry(particle).or_insert_with(|| shell.motion_of(particle));
                for &(unknown, way) in ways.iter() {
                    *all.entry(unknown).or_default() += weight * column.normal.dot(&Vec3::from(way));
                }
            }
            all.into_iter().filter(|&(_, way)| way != 0.0).collect()
        };
        self.along = self.columns.iter().map(along).collect();
    }
}

/// The middle surface of a shell: in a plane all edges of cells that do not stand across it.
fn middle(shell: &Shell, width: Option<f64>) -> Vec<[Vec3; 3]> {
    let configuration = Body::configuration(shell);
    let x = |a: u32| configuration.rest[a as usize];
    let flat = |a: u32| Vec3::new(x(a).x, x(a).y, 0.0);
    let mut all = Vec::new();
    for cell in configuration.cells {
        if let Some(width) = width {
            let lines = cell.edges().map(|(a, b)| [flat(a), flat(b), Vec3::zeros()]);
            all.extend(lines.filter(|line| (line[1] - line[0]).norm() > 1e-9 * width));
        } else {
            let corners = cell.particles();
            all.extend((1..corners.len() - 1).map(|k| [x(corners[0]), x(corners[k]), x(corners[k + 1])]));
        }
    }
    all
}
