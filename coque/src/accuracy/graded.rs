//! A scene on a finer lattice or mesh, refined all over or where its strains ask for it.
//!
//! Cells are marked in the order of η² = indicator² A (bodies/shell/indicator.rs) until they hold a given share of its sum \[doerfler1996\], and are cut
//! into four; those beside them are divided to fit. A lattice becomes a mesh, its new particles on its own surface.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use mesh_io::{FieldError, Sheet};
use sph_core::{Cell, Vec3};

use super::companions::placed;
use super::meshes::surface;
use crate::analyses::RunOptions;
use crate::fields::{FieldSink, Frame};
use crate::mesh::{Arrays, Surface};
use crate::run::outcome::Ended;
use crate::run::progress::Progress;
use crate::scene::error::SceneError;
use crate::scene::{Checked, ErrorBars, Output, Placing, Scene, ShellScene};

/// Half a lattice spacing, the finest a node is placed on.
const HALVES: usize = 2;

/// A refined surface of a scene.
#[derive(Clone, Debug)]
pub struct Graded {
    /// The surface, in the unit of its file.
    pub arrays: Arrays,
    /// Nodes before.
    pub nodes: usize,
    /// Cells before, and those of them that were cut into four.
    pub marked: [usize; 2],
    /// Estimated error of the strains in the norm of the energy, over the strains themselves \[–\]; none where no run was made.
    pub error: Option<f64>,
}

impl Checked {
    /// The surface of its shell refined all over, or, with a share of the estimated error, where that is: the scene is run for it.
    ///
    /// # Errors
    /// In words, with what to do: scenes without one shell that has cells, meshes that cannot be refined, a run that does not come to its end.
    pub fn graded(
        &self,
        by: Option<f64>,
        threads: usize,
        progress: &mut dyn Progress,
    ) -> Result<Graded, String> {
        let shell = self.as_shell().filter(|_| self.bodies.len() == 1);
        let shell = shell.ok_or("one shell alone is refined; give other bodies finer lattices")?;
        let (surface, fine) = match surface(self)? {
            Some((_, surface)) => (surface, None),
            None if by.is_none() => {
                return Err("a lattice has no faces to cut; take one of half its spacing, or a share of its error for a mesh".into());
            }
            None => of_lattice(self, shell, threads)?,
        };
        let (marks, error) = match by {
            None => (vec![true; surface.faces.len()], None),
            Some(share) => {
                let scale = shell.geometry.mesh().map_or(1.0, |mesh| mesh.scale.get());
                let found = indicated(self, threads, progress)?;
                (found.marks(&surface, scale, share)?, Some(found.error()))
            }
        };
        let finer = surface.refined_at(&marks);
        let mut arrays = finer.arrays;
        if let Some(fine) = &fine {
            let new = arrays.points.iter_mut().skip(surface.positions.len());
            for (point, parents) in new.zip(&finer.parents) {
                *point = fine.middle(parents).into();
            }
        }
        let marked = [surface.faces.len(), marks.iter().filter(|mark| **mark).count()];
        Ok(Graded { arrays, nodes: surface.positions.len(), marked, error })
    }
}

/// Particles of a lattice of half the spacing.
struct Fine {
    /// Particles of the lattice itself along u and v.
    particles: [usize; 2],
    rest: Vec<Vec3>,
}

impl Fine {
    /// The particle in the middle of some of the lattice.
    fn middle(&self, parents: &[u32]) -> Vec3 {
        let [_, across] = self.particles;
        let sum = |axis: &dyn Fn(usize) -> usize| -> usize {
            parents.iter().map(|&parent| axis(parent as usize)).sum::<usize>() * HALVES / parents.len()
        };
        let (i, j) = (sum(&|a| a / across), sum(&|a| a % across));
        self.rest[i * (HALVES * (across - 1) + 1) + j]
    }
}

/// A lattice as a mesh with the sets that its scene names, and the particles of half its spacing.
fn of_lattice(
    scene: &Checked,
    shell: &ShellScene,
    threads: usize,
) -> Result<(Surface, Option<Fine>), String> {
    let placing = shell.geometry.placing();
    let Placing { particles: Some(particles), disorder: None, grading: None, .. } = placing else {
        return Err(
            "scattered, disordered and graded particles are not refined; give a lattice or a mesh".into()
        );
    };
    if shell.orientation.is_some() || shell.placed.is_some() {
        return Err("a lattice that is turned or placed is not refined; give its mesh in its place".into());
    }
    let refused = |error: SceneError| format!("the scene is refused: {error}");
    let (rest, own) = placed(scene, threads).map_err(refused)?;
    let fine = scene.refined(HALVES as f64).and_then(|fine| placed(&fine.scene, threads)).map_err(refused)?.0;
    let [n, m] = particles.map(|n| n as u32);
    if rest.len() != (n * m) as usize || fine.len() != ((2 * n - 1) * (2 * m - 1)) as usize {
        return Err("a lattice that closes on itself is not refined; give its mesh in its place".into());
    }
    let at = |i: u32, j: u32| i * m + j;
    let faces = (0..n - 1)
        .flat_map(|i| (0..m - 1).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    let declared = |name: &String| name == "all" || scene.sets.contains_key(name);
    let sets: BTreeMap<String, Vec<u32>> = own.into_iter().filter(|(name, _)| !declared(name)).collect();
    let points = rest.iter().map(|&x| x.into()).collect();
    let arrays = Arrays { points, faces: faces.collect(), sets, face_sets: BTreeMap::new() };
    let surface = arrays.surface("the lattice", false).map_err(|error| error.to_string())?;
    if surface.positions != rest {
        return Err("a lattice whose particles coincide is not refined; give its mesh in its place".into());
    }
    Ok((surface, Some(Fine { particles, rest: fine })))
}

/// What a run tells of its cells.
struct Indicated {
    rest: Vec<Vec3>,
    cells: Vec<Cell>,
    /// η² of each cell over the mean of the strains' energy by area \[L²\].
    squares: Vec<f64>,
    areas: Vec<f64>,
}

impl Indicated {
    /// Error of the strains over the strains, in the norm of the energy \[–\].
    fn error(&self) -> f64 {
        (self.squares.iter().sum::<f64>() / self.areas.iter().sum::<f64>()).sqrt()
    }

    /// Whether each face of a surface lies in a cell that is to be cut; `scale` is the unit of the surface.
    fn marks(&self, surface: &Surface, scale: f64, share: f64) -> Result<Vec<bool>, String> {
        let key = |x: Vec3| [x.x, x.y, x.z].map(|x| (x + 0.0).to_bits());
        let mut nodes: HashMap<[u64; 3], Vec<usize>> = HashMap::new();
        for (node, position) in self.rest.iter().enumerate() {
            nodes.entry(key(*position)).or_default().push(node);
        }
        let mut order: Vec<usize> = (0..self.squares.len()).collect();
        order.sort_by(|&a, &b| self.squares[b].total_cmp(&self.squares[a]).then(a.cmp(&b)));
        let (mut left, mut cut) = (share * self.squares.iter().sum::<f64>(), BTreeSet::new());
        for cell in order {
            if left <= 0.0 {
                break;
            }
            left -= self.squares[cell];
            cut.insert(cell);
        }
        let mut of_node: Vec<Vec<usize>> = vec![Vec::new(); self.rest.len()];
        for &cell in &cut {
            self.cells[cell].particles().iter().for_each(|&a| of_node[a as usize].push(cell));
        }
        let face = |face: &Cell| -> Result<bool, String> {
            let corners = face.particles().iter().map(|&node| {
                let at = nodes.get(&key(surface.positions[node as usize] * scale));
                let at = at.ok_or("the particles of the run are not the nodes of the mesh")?;
                Ok(at.iter().flat_map(|&a| of_node[a].iter().copied()).collect::<BTreeSet<usize>>())
            });
            let cells: Vec<BTreeSet<usize>> = corners.collect::<Result<_, String>>()?;
            Ok(cells[0].iter().any(|cell| cells.iter().all(|other| other.contains(cell))))
        };
        surface.faces.iter().map(face).collect()
    }
}

/// Runs a scene to its end; the indicator of its last frame.
fn indicated(scene: &Checked, threads: usize, progress: &mut dyn Progress) -> Result<Indicated, String> {
    let refused = |error: SceneError| format!("the scene is refused: {error}");
    // Where errors are asked for, frames show the indicator.
    let mut asked = Scene::clone(scene);
    asked.error = Some(ErrorBars::default());
    asked.output = Output::default();
    let model = asked.check().and_then(|scene| scene.build(threads)).map_err(refused)?;
    let configuration = model.body.body().configuration();
    let (rest, cells) = (configuration.rest.to_vec(), configuration.cells.to_vec());
    let mut last = Last(None);
    let options = RunOptions { progress, checkpoints: None, fields: Some(&mut last), from: None };
    let outcome = model.run_with(options).map_err(|error| error.to_string())?;
    if outcome.ended != Ended::Done {
        return Err(format!("the run did not reach its end: {}", outcome.ended));
    }
    let sheet = last.0.ok_or("the run has no frame")?;
    let found = sheet.cell_data.get(INDICATOR).ok_or(
        "strains of this method or analysis are at no cells: there is no indicator; leave `--by` out",
    )?;
    let corners = |cell: &Cell| -> Vec<Vec3> { cell.particles().iter().map(|&a| rest[a as usize]).collect() };
    let area = |cell: &Cell| {
        let at = corners(cell);
        0.5 * (at[2] - at[0]).cross(&(at[at.len() - 1] - at[1])).norm()
    };
    let areas: Vec<f64> = cells.iter().map(area).collect();
    let squares =
        areas.iter().zip(&found.numbers).map(|(area, indicator)| area * indicator * indicator).collect();
    Ok(Indicated { rest, cells, squares, areas })
}

/// The field of the indicator.
const INDICATOR: &str = "error_indicator";

/// Keeps the last frame.
struct Last(Option<Sheet>);

impl FieldSink for Last {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        self.0 = Some(frame.sheet(false)?);
        Ok(())
    }
}
