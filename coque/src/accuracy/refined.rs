//! The same scene on a coarser or finer lattice.

use crate::scene::bounded::Positive;
use crate::scene::error::SceneError;
use crate::scene::{BodyScene, Checked, Geometry, PerAxis, Scene, SolidGeometry};

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
        let refined = match scene.bodies.values_mut().next() {
            Some(BodyScene::Shell(shell)) => refine_shell(&mut shell.geometry, fineness),
            Some(BodyScene::Solid(solid)) => Some(refine_solid(&mut solid.geometry, fineness)),
            _ => return refused("bodies", "a fluid"),
        };
        match refined {
            Some((spacing, lattice)) => Ok(Refined { scene: scene.check()?, spacing, lattice }),
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

/// Cells along each direction; none of scattered particles.
fn cells(scene: &Scene) -> Vec<f64> {
    match scene.bodies.values().next() {
        Some(BodyScene::Shell(shell)) => {
            let particles = shell.geometry.particles();
            particles.map_or(Vec::new(), |particles| particles.map(|n| (n - 1) as f64).to_vec())
        }
        Some(BodyScene::Solid(solid)) => cells_of(&solid.geometry),
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
fn step(cells: usize) -> usize {
    if cells.is_multiple_of(2) { 2 } else { 1 }
}

/// So many cells for `cells`; even for even, at least one, for even at least two.
fn whole(cells: usize, fineness: f64) -> usize {
    let step = step(cells);
    let wanted = cells as f64 * fineness / step as f64;
    step * (wanted.round() as usize).max(1)
}

/// Changes the lattice; tells the spacing over the former one, along the direction of most cells, and what it is in words.
fn refine_shell(geometry: &mut Geometry, fineness: f64) -> Option<(f64, String)> {
    let (particles, scattered) = geometry.placing_mut()?;
    if let Some(scattered) = scattered {
        scattered.spacing = Positive::new(scattered.spacing.get() / fineness).ok()?;
        return Some((1.0 / fineness, format!("scattered at {:.4}", scattered.spacing)));
    }
    let particles = particles.as_mut()?;
    let before = particles.map(|n| n - 1);
    let after = before.map(|cells| whole(cells, fineness));
    *particles = after.map(|cells| cells + 1);
    let along = if before[0] >= before[1] { 0 } else { 1 };
    let [n1, n2] = *particles;
    Some((before[along] as f64 / after[along] as f64, format!("{n1}×{n2}")))
}

fn refine_solid(geometry: &mut SolidGeometry, fineness: f64) -> (f64, String) {
    let before: Vec<usize> = cells_of(geometry).into_iter().map(|cells| cells as usize).collect();
    let after: Vec<usize> = before.iter().map(|&cells| whole(cells, fineness)).collect();
    if let Some(arc) = &mut geometry.arc {
        arc.cells.copy_from_slice(&after);
    }
    if let Some(block) = &mut geometry.block {
        let spacing = block.lengths.iter().zip(&after).map(|(length, &cells)| length.get() / cells as f64);
        block.spacing = PerAxis::Each(spacing.collect());
    }
    let most = (0..before.len()).max_by_key(|&axis| before[axis]).unwrap_or(0);
    let cells: Vec<String> = after.iter().map(ToString::to_string).collect();
    (before[most] as f64 / after[most] as f64, format!("{} cells", cells.join("×")))
}
