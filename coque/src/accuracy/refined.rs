//! The same scene on a coarser or finer lattice.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::bounded::Positive;
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, Checked, FluidGeometry, Geometry, PerAxis, Scene, SolidGeometry, SolidScene};

/// Fewest cells along the direction that has most, and along the one that has fewest, of a coarse lattice.
const LEAST: [f64; 2] = [8.0, 2.0];
/// The same for layers of nodes joined by bonds.
const LEAST_LAYERS: [f64; 2] = [8.0, 3.0];

/// A scene on another lattice than its own.
#[derive(Clone, Debug)]
pub struct Refined {
    /// The scene.
    pub scene: Checked,
    /// Spacing over that of the scene as it was given \[–\].
    pub spacing: f64,
    /// The lattice in words, such as `21×21`.
    pub lattice: String,
}

impl Refined {
    /// What makes the scene as it was given this one, as paths and values (`--set`); none of a mesh.
    pub fn overrides(&self) -> Option<Vec<(String, String)>> {
        let bodies = self.scene.bodies_in_scene().ok()?;
        let changed =
            bodies.iter().filter(|body| !matches!(body.body, BodyScene::Walls(_) | BodyScene::Rigid(_)));
        let pair = |scene: &BodyInScene<'_>| {
            let (key, value) = spaced(scene.body)?;
            Some((scene.body_scope().path(&format!("geometry.{key}")), value))
        };
        changed.map(pair).collect()
    }
}

/// The key below its geometry that spaces the particles of a body, and its value; none of a mesh and of walls.
fn spaced(body: &BodyScene) -> Option<(String, String)> {
    Some(match body {
        BodyScene::Shell(shell) => {
            let (word, placing) = (shell.geometry.word(), shell.geometry.placing());
            match (placing.particles, placing.scattered) {
                (_, Some(scattered)) => {
                    (format!("{word}.scattered.spacing"), format!("{:?}", scattered.spacing.get()))
                }
                (Some(particles), None) => (format!("{word}.particles"), format!("{particles:?}")),
                (None, None) => return None,
            }
        }
        BodyScene::Solid(SolidScene { geometry: SolidGeometry { filled: Some(filled), .. }, .. }) => {
            ("filled.spacing".into(), format!("{:?}", filled.spacing.get()))
        }
        BodyScene::Solid(solid) => match (&solid.geometry.block, &solid.geometry.arc) {
            (Some(block), _) => {
                let axes = 0..block.lengths.len();
                let spacing: Vec<f64> = axes.map(|axis| block.spacing.along(axis)).collect();
                ("block.spacing".into(), format!("{spacing:?}"))
            }
            (None, arc) => ("arc.cells".into(), format!("{:?}", arc.as_ref()?.cells)),
        },
        BodyScene::Fluid(fluid) => {
            (format!("{}.spacing", fluid.geometry.word()), format!("{:?}", fluid.geometry.spacing()))
        }
        BodyScene::Walls(_) | BodyScene::Rigid(_) => return None,
    })
}

impl Checked {
    /// The scene with its spacing divided by `fineness`, as nearly as whole numbers of cells allow; even numbers stay even,
    /// so that a particle in the middle stays there.
    ///
    /// # Errors
    /// [`SceneError::Choice`] for what has no lattice to refine: a surface from a file, a fluid, several bodies; what the checks
    /// refuse of the finer lattice.
    pub fn refined(&self, fineness: f64) -> Result<Refined, SceneError> {
        let mut scene = Scene::clone(self);
        let repair =
            "compare runs of your own with `coque sweep`, or give meshes of several spacings in turn";
        let refused = |path: &str, value: &str| {
            let bound = "one shell on a lattice or one solid, whose spacing can be changed";
            Err(SceneError::Choice(self.source.fault(path, value, bound, repair)))
        };
        if scene.bodies.len() > 1 {
            return refused("bodies", "several bodies");
        }
        let body = scene.bodies.values_mut().next();
        if matches!(body, Some(BodyScene::Rigid(_))) {
            return refused("bodies", "a rigid body");
        }
        let Some(body) = body.filter(|body| !matches!(body, BodyScene::Fluid(_) | BodyScene::Walls(_)))
        else {
            return refused("bodies", "a fluid");
        };
        match refine(body, fineness, &|_, cells| step(cells)) {
            Some(Change { spacings, along, lattice }) => {
                Ok(Refined { scene: scene.check()?, spacing: spacings[along], lattice })
            }
            None => Err(SceneError::Choice(self.first_body()?.body_scope().fault(
                "geometry.mesh",
                "a surface from a file",
                "one shell on a lattice or one solid, whose spacing can be changed",
                repair,
            ))),
        }
    }
}

/// Fineness of the coarsest lattice on which answers are worth comparing, at most one.
pub(super) fn coarsest(scene: &Scene) -> f64 {
    let cells = cells(scene);
    if cells.is_empty() {
        // Scattered particles: the checks have kept the spacing well below the extent.
        return 0.5;
    }
    let bonds = scene.as_solid().is_some_and(|solid| solid.galerkin().is_none());
    let [most, fewest] = if bonds { LEAST_LAYERS } else { LEAST };
    let greatest = cells.iter().copied().fold(1.0, f64::max);
    let least = cells.iter().copied().fold(f64::INFINITY, f64::min).max(1.0);
    (most / greatest).max(fewest / least).min(1.0)
}

/// A fineness above another by √2, or as near to it as the direction of fewest cells allows: lattices whose cells keep their
/// shape converge as a power of the spacing. Fewer than four cells there are too few to follow.
pub(super) fn finer(scene: &Scene, fineness: f64) -> f64 {
    let wanted = std::f64::consts::SQRT_2 * fineness;
    let fewest = cells(scene).into_iter().fold(f64::INFINITY, f64::min);
    if !(4.0..1e9).contains(&fewest) {
        return wanted;
    }
    let step = step(fewest as usize) as f64;
    let now = (fewest * fineness / step).round();
    let next = (fewest * wanted / step).round().max(now + 1.0);
    step * next / fewest
}

/// Cells along each direction of the one body, of several the first by name; none of scattered particles and of nodes in a surface.
pub(super) fn cells(scene: &Scene) -> Vec<f64> {
    match scene.bodies.values().next() {
        Some(BodyScene::Shell(shell)) => {
            let particles = shell.geometry.particles();
            particles.map_or(Vec::new(), |particles| particles.map(|n| (n - 1) as f64).to_vec())
        }
        Some(BodyScene::Solid(solid)) if solid.geometry.filled.is_none() => cells_of(&solid.geometry),
        _ => Vec::new(),
    }
}

/// Dimensions in which a lattice grows as it is refined.
pub(super) fn dimensions(scene: &Scene) -> f64 {
    scene.as_solid().map_or(2.0, |solid| solid.dimensions() as f64)
}

/// Cells along each axis.
fn cells_of(geometry: &SolidGeometry) -> Vec<f64> {
    match (&geometry.block, &geometry.arc) {
        (Some(block), _) => {
            let cells = |(axis, length): (usize, &Positive)| {
                (length.get() / block.spacing.along(axis)).round().max(1.0)
            };
            block.lengths.iter().enumerate().map(cells).collect()
        }
        (None, Some(arc)) => arc.cells.map(|n| n as f64).to_vec(),
        (None, None) => vec![1.0],
    }
}

/// What numbers of cells grow by: two, where they are even and stay so.
pub(super) fn step(cells: usize) -> usize {
    if cells.is_multiple_of(2) { 2 } else { 1 }
}

/// So many cells for `cells`, a multiple of a step and at least one.
fn whole(cells: usize, fineness: f64, step: usize) -> usize {
    let wanted = cells as f64 * fineness / step as f64;
    step * (wanted.round() as usize).max(1)
}

/// What became of the lattice of a body.
pub(super) struct Change {
    /// Spacing over the former one along each direction \[–\].
    pub spacings: Vec<f64>,
    /// The direction that had most cells.
    pub along: usize,
    /// The lattice in words.
    pub lattice: String,
}

/// What numbers of cells along a direction that has so many are multiples of.
pub(super) type Steps<'a> = &'a dyn Fn(usize, usize) -> usize;

/// Changes the lattice of a body; none of a surface from a file, which has none. Walls stand as they are.
pub(super) fn refine(body: &mut BodyScene, fineness: f64, steps: Steps<'_>) -> Option<Change> {
    match body {
        BodyScene::Shell(shell) => refine_shell(&mut shell.geometry, fineness, steps),
        BodyScene::Solid(solid) => match &mut solid.geometry.filled {
            Some(filled) => {
                filled.spacing = Positive::new(filled.spacing.get() / fineness).ok()?;
                let lattice = format!("nodes at {:.4}", filled.spacing);
                Some(Change { spacings: vec![1.0 / fineness], along: 0, lattice })
            }
            None => Some(refine_solid(&mut solid.geometry, fineness, steps)),
        },
        BodyScene::Fluid(fluid) => refine_fluid(&mut fluid.geometry, fineness),
        BodyScene::Walls(_) | BodyScene::Rigid(_) => {
            Some(Change { spacings: Vec::new(), along: 0, lattice: String::new() })
        }
    }
}

/// From so many cells along each direction to others.
fn change(before: &[usize], after: &[usize], lattice: String) -> Change {
    let spacings = before.iter().zip(after).map(|(&before, &after)| before as f64 / after as f64).collect();
    // Of equal ones the first.
    let along = (0..before.len()).rev().max_by_key(|&axis| before[axis]).unwrap_or(0);
    Change { spacings, along, lattice }
}

fn refine_shell(geometry: &mut Geometry, fineness: f64, steps: Steps<'_>) -> Option<Change> {
    let (particles, scattered) = geometry.placing_mut()?;
    if let Some(scattered) = scattered {
        scattered.spacing = Positive::new(scattered.spacing.get() / fineness).ok()?;
        let lattice = format!("scattered at {:.4}", scattered.spacing);
        return Some(Change { spacings: vec![1.0 / fineness], along: 0, lattice });
    }
    let particles = particles.as_mut()?;
    let before = particles.map(|n| n - 1);
    let after = [0, 1].map(|axis| whole(before[axis], fineness, steps(axis, before[axis])));
    *particles = after.map(|cells| cells + 1);
    let [n1, n2] = *particles;
    Some(change(&before, &after, format!("{n1}×{n2}")))
}

fn refine_solid(geometry: &mut SolidGeometry, fineness: f64, steps: Steps<'_>) -> Change {
    let before: Vec<usize> = cells_of(geometry).into_iter().map(|cells| cells as usize).collect();
    let after: Vec<usize> =
        (0..before.len()).map(|axis| whole(before[axis], fineness, steps(axis, before[axis]))).collect();
    if let Some(arc) = &mut geometry.arc {
        arc.cells.copy_from_slice(&after);
    }
    if let Some(block) = &mut geometry.block {
        let spacing = block.lengths.iter().zip(&after).map(|(length, &cells)| length.get() / cells as f64);
        block.spacing = PerAxis::Each(spacing.collect());
    }
    let cells: Vec<String> = after.iter().map(ToString::to_string).collect();
    change(&before, &after, format!("{} cells", cells.join("×")))
}

fn refine_fluid(geometry: &mut FluidGeometry, fineness: f64) -> Option<Change> {
    let spacing = geometry.spacing_mut();
    *spacing = Positive::new(spacing.get() / fineness).ok()?;
    let lattice = format!("fluid at {:.4}", spacing);
    Some(Change { spacings: vec![1.0 / fineness], along: 0, lattice })
}
