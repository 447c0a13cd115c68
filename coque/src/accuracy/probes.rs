//! What other lattices do not show: the same scene with one number of its method changed, and what that changes of its answers.

use std::time::Instant;

use super::found::{Found, Quiet, rows};
use super::pairing::key;
use super::refined::Refined;
use crate::results::error_bars::{Probed, ProbedColumn};
use crate::run::outcome::Ended;
use crate::run::progress::Progress;
use crate::scene::bounded::{Bound, Bounded};
use crate::scene::{
    Analysis, BodyScene, ErrorProbe, FluidFormulation, FluidMaterial, FluidScene, GalerkinSupport, PerAxis,
    Scene, SolidFormulation,
};

/// Factors on what is changed: half a step, a tenth of what may be missing, half the way between points or records, a horizon and a support that
/// hold a spacing more or so, a sound speed whose compressibility is half, a smoothing length that holds a quarter more neighbours.
const HALF: f64 = 0.5;
const TENTH: f64 = 0.1;
const LONGER_HORIZON: f64 = 4.0 / 3.0;
const WIDER_SUPPORT: f64 = 1.2;
const FASTER_SOUND: f64 = std::f64::consts::SQRT_2;
const SMOOTHER: f64 = 1.1;

/// The scene with one number of its method changed, and what that is in words; none where it has no such number, or where bounds forbid it.
pub(super) fn changed(scene: &Scene, probe: ErrorProbe) -> Option<(Scene, String)> {
    let mut changed = scene.clone();
    let words = match probe {
        ErrorProbe::Step => {
            let Analysis::Explicit(explicit) = &mut changed.analysis else { return None };
            explicit.safety = times(explicit.safety, HALF)?;
            for fluid in fluids(&mut changed) {
                let FluidFormulation::WeaklyCompressible(options) = &mut fluid.formulation;
                options.courant = Some(Bounded::new(HALF * options.courant()).ok()?);
            }
            "half the time step"
        }
        ErrorProbe::Rest => match &mut changed.analysis {
            Analysis::Explicit(explicit) => {
                let path = explicit.quasi_static.as_mut()?;
                (path.accuracy, path.tolerance) =
                    (times(path.accuracy, TENTH)?, times(path.tolerance, TENTH)?);
                "a tenth of what may be missing from rest"
            }
            Analysis::Relaxation(relaxation) => {
                relaxation.tolerance = times(relaxation.tolerance, TENTH)?;
                "a tenth of what may be missing from rest"
            }
            _ => return None,
        },
        ErrorProbe::Arc => {
            let Analysis::ArcLength(path) = &mut changed.analysis else { return None };
            path.radius = times(path.radius, HALF)?;
            "half the first arc"
        }
        ErrorProbe::Records => {
            let Analysis::Explicit(explicit) = &mut changed.analysis else { return None };
            let run = explicit.transient.as_mut()?;
            run.record_every = times(run.record_every, HALF)?;
            "twice the records"
        }
        ErrorProbe::Horizon => {
            let longer = |formulation: &mut SolidFormulation| -> Option<bool> {
                match formulation {
                    SolidFormulation::BondBased(bonds) | SolidFormulation::StateBased(bonds) => {
                        bonds.horizon = times(bonds.horizon, LONGER_HORIZON)?;
                    }
                    SolidFormulation::TwoSheets(sheets) => {
                        sheets.horizon = times(sheets.horizon, LONGER_HORIZON)?;
                    }
                    SolidFormulation::Galerkin(_) => return Some(false),
                }
                Some(true)
            };
            each_solid(&mut changed, longer)?;
            "a horizon of a third more spacings"
        }
        ErrorProbe::Support => {
            each_solid(&mut changed, |formulation| {
                let SolidFormulation::Galerkin(galerkin) = formulation else { return Some(false) };
                galerkin.support = Some(wider(galerkin.support()));
                Some(true)
            })?;
            "shape functions of a fifth more support"
        }
        ErrorProbe::SoundSpeed => {
            let FluidMaterial::Liquid(liquid) = &mut fluids(&mut changed).next()?.material;
            liquid.sound_speed = times(liquid.sound_speed, FASTER_SOUND)?;
            "a sound speed 1.41 times as high"
        }
        ErrorProbe::Smoothing => {
            let fluid = fluids(&mut changed).next()?;
            let FluidFormulation::WeaklyCompressible(options) = &mut fluid.formulation;
            options.smoothing = Some(Bounded::new(SMOOTHER * options.smoothing()).ok()?);
            "a smoothing length a tenth larger"
        }
    };
    Some((changed, words.into()))
}

/// A bounded number times a factor; none where that is out of bounds.
fn times<B: Bound<Number = f64>>(number: Bounded<B>, factor: f64) -> Option<Bounded<B>> {
    Bounded::new(factor * number.get()).ok()
}

/// Changes the formulation of every solid that it concerns; none where there is no such solid, or where one refuses.
fn each_solid(
    scene: &mut Scene,
    mut change: impl FnMut(&mut SolidFormulation) -> Option<bool>,
) -> Option<()> {
    let mut any = false;
    for body in scene.bodies.values_mut() {
        if let BodyScene::Solid(solid) = body {
            any |= change(&mut solid.formulation)?;
        }
    }
    any.then_some(())
}

/// The fluids of a scene.
fn fluids(scene: &mut Scene) -> impl Iterator<Item = &mut FluidScene> {
    scene.bodies.values_mut().filter_map(|body| match body {
        BodyScene::Fluid(fluid) => Some(fluid),
        _ => None,
    })
}

/// A support that is wider in every direction.
fn wider(support: GalerkinSupport) -> GalerkinSupport {
    let radii = |radii: PerAxis| match radii {
        PerAxis::Same(radius) => PerAxis::Same(WIDER_SUPPORT * radius),
        PerAxis::Each(list) => PerAxis::Each(list.into_iter().map(|radius| WIDER_SUPPORT * radius).collect()),
    };
    match support {
        GalerkinSupport::Sphere(radius) => GalerkinSupport::Sphere(WIDER_SUPPORT * radius),
        GalerkinSupport::Ellipsoid(given) => GalerkinSupport::Ellipsoid(radii(given)),
        GalerkinSupport::Tensor(given) => GalerkinSupport::Tensor(radii(given)),
    }
}

/// Runs a probe on a lattice whose answers are known, and compares; `columns` are those that have errors.
///
/// # Errors
/// In words: a scene that has no such number, that is refused with it, or whose run does not come to an end.
pub(super) fn probed(
    on: &Refined,
    known: &Found,
    probe: ErrorProbe,
    columns: &[&str],
    threads: usize,
    progress: &mut dyn Progress,
) -> Result<Probed, String> {
    let (scene, changed) = changed(&on.scene, probe).ok_or_else(|| {
        format!("the scene has nothing for the probe `{}`, or no room for it", probe.word())
    })?;
    let refused = |why: String| format!("{changed}: {why}");
    let begun = Instant::now();
    let model = scene.check().and_then(|scene| scene.build(threads));
    let model = model.map_err(|error| refused(error.to_string()))?;
    let analysis = model.task.analysis.clone();
    let rest = model.body.body().configuration().rest.to_vec();
    let outcome = model.run(&mut Quiet(progress));
    if outcome.ended != Ended::Done {
        return Err(refused(outcome.ended.to_string()));
    }
    let found = Found::of(on.spacing, rest, &outcome);
    let key = key(&analysis, &[&known.curve, &found.curve]).map_err(refused)?;
    let paired = rows(known, &found, &key);
    let column = |name: &&str| {
        let at = known.curve.columns.iter().position(|column| column.name == **name)?;
        let change = |(row, other): (&Vec<f64>, &Option<Vec<f64>>)| Some(other.as_ref()?[at] - row[at]);
        let changes: Vec<Option<f64>> = known.curve.rows.iter().zip(&paired).map(change).collect();
        let greatest = changes.iter().flatten().fold(0.0, |most: f64, change| most.max(change.abs()));
        let unit = known.curve.columns[at].unit.clone();
        Some(ProbedColumn { name: (*name).into(), unit, last: *changes.last()?, greatest })
    };
    let columns = columns.iter().filter_map(column).collect();
    Ok(Probed { changed, lattice: on.lattice.clone(), seconds: begun.elapsed().as_secs_f64(), columns })
}
