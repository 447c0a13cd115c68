//! The lattices beside that of a scene on which it is run for an error bar.
//!
//! Wanted are two that are √2 and 2 times as coarse along every direction, of marches whose time falls with the third power of the spacing
//! 1.5 and 2.25 times: .30 and .09 of the time of the run. Where a direction has too few cells for that, finer ones take their
//! place, and where but one is to be had, the order of the method has to be believed. Fluids keep whole numbers of particles along every length.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use sph_core::Vec3;

use super::kept::{KeptSet, greatest_common_divisor, kept, least_common_multiple};
use super::meshes;
use super::refined::{Change, Refined, cells, refine, step};
use crate::scene::error::SceneError;
use crate::scene::{Analysis, BodyScene, Checked, Fields, Output, Scene};

/// The lattices beside a scene's own.
pub struct Companions {
    /// Those it is run on; one at least. They write no results of their own.
    pub lattices: Vec<Refined>,
    /// Names of sets that are on no particles there, with which no column has a bar.
    pub moved: Vec<String>,
    /// Places at rest on the scene's own lattice.
    pub rest: Vec<Vec3>,
}

/// Spacings that are tried first in marches of surfaces and in a plane, over that of the scene.
const MARCHED: &[f64] = &[1.5, 2.25];
/// Spacings that are tried, over that of the scene, the cheapest first.
const WANTED: [&[f64]; 7] = [
    &[SQRT_2, 2.0],
    &[2.0, FRAC_1_SQRT_2],
    &[SQRT_2, FRAC_1_SQRT_2],
    &[FRAC_1_SQRT_2, 0.5],
    &[2.0],
    &[FRAC_1_SQRT_2],
    &[0.5],
];
/// By how much a spacing may differ from the one wanted, and the directions from each other, as a factor.
const NEAR: f64 = 1.2;
const ALIKE: f64 = 1.13;
/// Fewest cells along a direction, and of bonds.
const FEWEST: usize = 2;
const FEWEST_LAYERS: usize = 3;

impl Checked {
    /// Lattices on which the scene can be run beside its own: coarser by √2 and 2 in every direction where they are to be had, with every
    /// set that it names on particles.
    ///
    /// # Errors
    /// In words, with what to do: a scene that has none.
    pub fn companions(&self, threads: usize) -> Result<Companions, String> {
        companions(self, threads)
    }
}

/// The lattice of about half the spacing, by which numbers are sharpened.
///
/// # Errors
/// In words: analyses whose numbers are not sharpened, a scene that has no such lattice.
pub(super) fn finest(scene: &Checked, threads: usize) -> Result<Refined, String> {
    let timeless = matches!(
        scene.analysis,
        Analysis::Linear(_) | Analysis::Static(_) | Analysis::Modal(_) | Analysis::Buckling(_)
    );
    if !timeless {
        return Err("that is done of linear answers, of levels without time and of modes".into());
    }
    alike(scene, 0.5, threads)
}

/// The lattice of all bodies alike whose spacing is nearest to so many of the scene's, sets of a lone body kept.
///
/// # Errors
/// In words: a scene that has no such lattice.
pub(super) fn alike(scene: &Checked, spacing: f64, threads: usize) -> Result<Refined, String> {
    let refused = |error: SceneError| format!("the scene is refused: {error}");
    let (rest, own) = placed(scene, threads).map_err(refused)?;
    let sets = if scene.bodies.len() == 1 { kept(scene, &rest, &own) } else { Vec::new() };
    let all: Vec<&KeptSet> = sets.iter().collect();
    let alone = alone(scene);
    let found = nearest(&alone, spacing, &all, true).or_else(|| nearest(&alone, spacing, &all, false));
    found.ok_or_else(|| format!("the scene has no lattice of about {spacing:.2} of its spacing"))
}

/// Places at rest, and the particles of sets by name.
pub(super) type Places = (Vec<Vec3>, BTreeMap<String, Vec<u32>>);

/// Places at rest and the sets of the one body.
pub(super) fn placed(scene: &Checked, threads: usize) -> Result<Places, SceneError> {
    // Sets are kept where fields are asked for.
    let fields = Fields::MOTION;
    let shown = Scene { output: Output { fields: Some(fields), ..Output::default() }, ..alone(scene) };
    let model = shown.check()?.build(threads)?;
    let rest = model.body.body().configuration().rest.to_vec();
    Ok((rest, model.sets.into_values().next().unwrap_or_default()))
}

fn companions(scene: &Checked, threads: usize) -> Result<Companions, String> {
    let refused = |error: SceneError| format!("the scene is refused: {error}");
    let alone = alone(scene);
    let (rest, own) = placed(scene, threads).map_err(refused)?;
    if scene.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some()) && scene.bodies.len() == 1 {
        let lattices = meshes::finer(scene, &alone)?;
        return Ok(Companions { lattices, moved: Vec::new(), rest });
    }
    let sets = if scene.bodies.len() == 1 { kept(scene, &rest, &own) } else { Vec::new() };
    let (read, acting): (Vec<&KeptSet>, Vec<&KeptSet>) = sets.iter().partition(|set| set.read_only);
    let all: Vec<&KeptSet> = sets.iter().collect();
    // Three lattices with all sets kept, then two, then three without those that are only read.
    let three = || marched(scene).into_iter().chain(WANTED.into_iter().take(4));
    let mut tries: Vec<(&[f64], &[&KeptSet], bool)> = Vec::new();
    tries.extend(three().flat_map(|wanted| [(wanted, &all[..], true), (wanted, &all[..], false)]));
    tries.extend(WANTED.into_iter().skip(4).map(|wanted| (wanted, &all[..], false)));
    tries.extend(three().map(|wanted| (wanted, &acting[..], false)));
    for (wanted, sets, even) in tries {
        if let Some(lattices) = lattices(&alone, wanted, sets, even) {
            let dropped = sets.len() < all.len();
            let moved = read.iter().filter(|_| dropped).map(|set| set.name.clone()).collect();
            return Ok(Companions { lattices, moved, rest });
        }
    }
    Err(why(scene, &sets))
}

/// What is tried first of a march whose particles grow as those of a surface: its steps grow with them.
fn marched(scene: &Checked) -> Option<&'static [f64]> {
    let of_body = |body: &BodyScene| match body {
        BodyScene::Fluid(fluid) => fluid.dimensions(),
        BodyScene::Solid(solid) => solid.dimensions(),
        BodyScene::Shell(_) | BodyScene::Walls(_) | BodyScene::Rigid(_) => 2,
    };
    let plane = scene.bodies.values().all(|body| of_body(body) == 2);
    (plane && matches!(scene.analysis, Analysis::Explicit(_))).then_some(MARCHED)
}

/// Why a scene has no other lattice, and what to do.
fn why(scene: &Checked, sets: &[KeptSet]) -> String {
    if let Some(set) = sets.iter().max_by_key(|set| set.multiples.iter().copied().max()) {
        return format!(
            "no lattice coarser or finer by √2 to 2 has a particle where the set `{}` has its own; choose numbers of cells that its place divides, \
             such as even ones for a middle",
            set.name
        );
    }
    match scene.fluid() {
        Some((name, _)) => format!(
            "the lengths of `{name}` share no number of particles that can be made coarser or finer in the same proportion; choose lengths with a \
             common divisor of several spacings"
        ),
        None => {
            "no lattice coarser or finer in every direction alike passes the checks; use more cells".into()
        }
    }
}

/// The scene without results that are written on the way, and without a wish for bars.
fn alone(scene: &Checked) -> Scene {
    Scene { output: Output::default(), error: None, ..Scene::clone(scene) }
}

/// Lattices with the spacings wanted, if all are to be had.
fn lattices(scene: &Scene, wanted: &[f64], sets: &[&KeptSet], even: bool) -> Option<Vec<Refined>> {
    wanted.iter().map(|&spacing| nearest(scene, spacing, sets, even)).collect()
}

/// The lattice whose spacing is nearest to the one wanted and whose directions are alike.
fn nearest(scene: &Scene, wanted: f64, sets: &[&KeptSet], even: bool) -> Option<Refined> {
    let alone = scene.bodies.len() == 1;
    let multiple = |axis: usize, cells: usize| {
        let held = sets
            .iter()
            .filter_map(|set| set.multiples.get(axis))
            .fold(1, |a, &b| least_common_multiple(a, b));
        if even || !alone { least_common_multiple(held, step(cells)) } else { held }
    };
    let mut found: Vec<(f64, Refined)> = Vec::new();
    for fineness in finenesses(scene, wanted) {
        let mut refined = scene.clone();
        let changes: Option<Vec<Change>> =
            refined.bodies.values_mut().map(|body| refine(body, fineness, &multiple)).collect();
        let spacings: Vec<f64> =
            changes.iter().flatten().flat_map(|change| change.spacings.clone()).collect();
        let (Some(changes), false) = (changes, spacings.is_empty()) else { return None };
        let logs: Vec<f64> = spacings.iter().map(|&spacing| libm::log(spacing)).collect();
        let mean = logs.iter().sum::<f64>() / logs.len() as f64;
        let apart = logs.iter().map(|log| (log - mean).abs()).fold(0.0, f64::max);
        let off = (mean - libm::log(wanted)).abs();
        let few = alone && cells(&refined).iter().any(|&cells| (cells as usize) < fewest(scene));
        if apart > libm::log(ALIKE) || off > libm::log(NEAR) || few {
            continue;
        }
        let words = changes.into_iter().map(|change| change.lattice).filter(|words| !words.is_empty());
        let lattice = words.collect::<Vec<_>>().join(", ");
        // Words are rounded; the same whole numbers of cells give the same spacing.
        let spacing = libm::exp(mean);
        if found.iter().any(|(_, other)| other.lattice == lattice && other.spacing == spacing) {
            continue;
        }
        if let Ok(scene) = refined.check() {
            found.push((off + apart, Refined { scene, spacing, lattice }));
        }
    }
    found.into_iter().min_by(|(a, _), (b, _)| a.total_cmp(b)).map(|(_, companion)| companion)
}

/// Fewest cells that a direction may have.
fn fewest(scene: &Scene) -> usize {
    let bonds = scene.as_solid().is_some_and(|solid| solid.galerkin().is_none());
    if bonds { FEWEST_LAYERS } else { FEWEST }
}

/// Steps of the search for a fineness.
const TRIED: i32 = 24;

/// Numbers of cells over those of the scene that are tried for a spacing.
fn finenesses(scene: &Scene, wanted: f64) -> Vec<f64> {
    let Some((_, fluid)) = scene.fluid() else {
        return (-TRIED..=TRIED).map(|k| libm::pow(NEAR, f64::from(k) / f64::from(TRIED)) / wanted).collect();
    };
    // Every length stays a whole number of particles.
    let spacing = fluid.geometry.spacing();
    let rows = |length: f64| libm::round(length / spacing) as usize;
    let shared = match fluid.geometry.rings() {
        Some(rings) => rows(rings.outer.get() - rings.inner.get()),
        None => {
            let boxes = fluid.geometry.boxes();
            let lengths =
                boxes.iter().flat_map(|(_, lengths, _)| lengths.iter().map(|length| rows(length.get())));
            lengths.fold(0, greatest_common_divisor)
        }
    };
    let of = |cells: usize| cells as f64 / shared.max(1) as f64;
    let [low, high] = [1.0 / (NEAR * wanted), NEAR / wanted];
    (1..=3 * shared.max(1)).map(of).filter(|fineness| (low..=high).contains(fineness)).collect()
}
