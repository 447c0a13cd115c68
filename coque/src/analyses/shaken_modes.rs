//! A body in its modes, under what excites them one by one: bases that are shaken, and its loads.

use std::f64::consts::TAU;

use implicit_statics::{HarmonicDamping, Mode, ReducedResponse};
use sph_core::Vec3;

use super::harmonic::warnings::unstable;
use super::modes::{Vibration, keep_enlarged, scaled, vibration};
use super::swinging::{Driver, Reader, Slopes};
use crate::WarningKind;
use crate::bodies::{Ready, StaticBody};
use crate::run::Run;
use crate::run::outcome::{Ended, Failure};
use crate::run::vibration_summary::{BaseSummary, ExcitedMode, SwingingMode};
use crate::scene::{Checked, LoadSet};

/// Part of the mass that modes should move: what codes of practice ask for.
const ENOUGH: f64 = 0.9;

/// Modes with what is read along each, and all that excites them.
pub(super) struct ShakenModes {
    pub reader: Reader,
    /// Along each mode.
    pub slopes: Vec<Slopes>,
    /// Circular frequencies \[1/T\].
    pub natural: Vec<f64>,
    pub sources: Vec<Source>,
}

/// What excites modes.
pub(super) struct Source {
    /// The modes, and the shape that stands for what they leave out of it.
    pub reduced: ReducedResponse,
    pub driver: Driver,
    /// Along that shape; none where nothing is left out.
    pub rest: Option<Slopes>,
    /// The acceleration that level one is; none of loads.
    pub shakes: Option<Shaking>,
    /// The load, of a load case; empty of others.
    pub load: Vec<f64>,
}

/// A base that shakes.
pub(super) struct Shaking {
    /// Size of its acceleration \[L/T²\].
    pub size: f64,
    /// Where it goes.
    pub direction: [f64; 3],
    /// Mass that moves against it, `−p·r/size` of its load p and a unit r of its motion \[M\].
    mass: f64,
    /// Of each mode `φᵀMr`.
    along: Vec<f64>,
}

impl Shaking {
    /// By the rigid motion of a body that tells it. Others have the load `p = −Mr`, of which `−M⁻¹p` is the motion; that of a shell is lumped otherwise than
    /// its masses in modes are.
    fn of(vector: &Vec3, system: &mut dyn StaticBody, reduced: &ReducedResponse, modes: &[Mode]) -> Self {
        let (size, direction) = (vector.norm(), vector.normalize());
        let mut load = vec![0.0; system.unknowns()];
        system.load_rate(0.0, &mut load);
        let Some(rigid) = system.rigid_motions() else {
            let along = reduced.loads().take(modes.len()).map(|load| -load / size).collect();
            return Self {
                size,
                direction: direction.into(),
                mass: reduced.carried() / (size * size),
                along,
            };
        };
        let unit: Vec<f64> =
            rigid.iter().map(|[x, y, z, ..]| x * direction.x + y * direction.y + z * direction.z).collect();
        let mass = load.iter().zip(&unit).map(|(p, r)| -p * r).sum::<f64>() / size;
        let moved: Vec<f64> = reduced.masses().iter().zip(&unit).map(|(m, r)| m * r).collect();
        let along = |mode: &Mode| mode.shape.iter().zip(&moved).map(|(x, m)| x * m).sum();
        Self { size, direction: direction.into(), mass, along: modes.iter().map(along).collect() }
    }
}

/// What is sought.
pub(super) struct Wanted<'a> {
    pub modes: usize,
    pub damping: HarmonicDamping,
    /// Accelerations of the bases, in the axes of the body.
    pub bases: Vec<[f64; 3]>,
    /// Load cases and combinations of them in one phase, a source each behind the bases.
    pub sets: Vec<LoadSet>,
    /// Whether the loads of the scene are the last source.
    pub loads: bool,
    pub scene: &'a Checked,
    pub threads: usize,
}

impl ShakenModes {
    /// Finds the modes about the present state and what excites them.
    ///
    /// # Errors
    /// How the run ends where they are not found.
    pub fn find(
        wanted: &Wanted<'_>,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> Result<Self, Box<Ended>> {
        let reader = Reader::new(system, run, run.frames.is_some());
        let Vibration { modes, shift, unstable: negative } = vibration(wanted.modes, system, run)?;
        unstable(negative, run);
        let slopes: Vec<Slopes> = modes.iter().map(|mode| reader.slopes(&mode.shape, system, run)).collect();
        let natural = modes.iter().map(Mode::circular_frequency).collect();
        let mut all = Self { reader, slopes, natural, sources: Vec::new() };
        let state = system.save();
        for (number, &acceleration) in wanted.bases.iter().enumerate() {
            let name = format!("base {}", number + 1);
            let mut body = built(&wanted.scene.shaken_by(number), wanted.threads, &name)?;
            body.restore(&state);
            let mut source = all.source(body.as_mut(), (&modes, shift), wanted.damping, run)?;
            let vector = Vec3::from(acceleration);
            source.driver.base = vector;
            source.driver.acceleration_in_space = true;
            source.shakes = Some(Shaking::of(&vector, body.as_mut(), &source.reduced, &modes));
            all.sources.push(source);
        }
        for set in &wanted.sets {
            let mut body = built(&wanted.scene.under(set), wanted.threads, &set.name)?;
            body.restore(&state);
            let mut source = all.source(body.as_mut(), (&modes, shift), wanted.damping, run)?;
            source.load = vec![0.0; body.unknowns()];
            body.load_rate(0.0, &mut source.load);
            all.sources.push(source);
        }
        if wanted.loads {
            let source = all.source(system, (&modes, shift), wanted.damping, run)?;
            all.sources.push(source);
        }
        Ok(all)
    }

    /// Of the loads of a system in the state that vibrates.
    fn source(
        &self,
        system: &mut dyn StaticBody,
        (modes, shift): (&[Mode], f64),
        damping: HarmonicDamping,
        run: &mut Run<'_>,
    ) -> Result<Source, Box<Ended>> {
        let reduced = ReducedResponse::new(system, 0.0, modes.to_vec(), shift, damping)
            .map_err(|cause| Box::new(run.unbalanced(0, 0.0, cause)))?;
        let driver = self.reader.driver(system, run);
        let rest = reduced.shapes().nth(modes.len()).map(|shape| self.reader.slopes(shape, system, run));
        Ok(Source { reduced, driver, rest, shakes: None, load: Vec::new() })
    }

    /// Circular frequency \[1/T\] and part of the critical damping \[–\] of each mode; zeros of one that is not stable.
    pub fn swings(&self, damping: HarmonicDamping) -> Vec<[f64; 2]> {
        let ratio = |omega: f64| if omega > 0.0 { damping.ratio(omega) } else { 0.0 };
        self.natural.iter().map(|&omega| [omega, ratio(omega)]).collect()
    }

    /// The same for the summary.
    pub fn modes(&self, damping: HarmonicDamping) -> Vec<SwingingMode> {
        let one = |[omega, damping]: [f64; 2]| SwingingMode { frequency: omega / TAU, damping };
        self.swings(damping).into_iter().map(one).collect()
    }

    /// What each base excites, for the summary; warns where the modes move less than nine tenths of the mass.
    pub fn bases(&self, run: &mut Run<'_>) -> Vec<BaseSummary> {
        let count = self.natural.len();
        let mut all = Vec::new();
        for (number, source) in self.sources.iter().enumerate() {
            let Some(Shaking { size, direction, mass, along }) = &source.shakes else { continue };
            let one = |(load, along): (f64, &f64)| {
                let participation = -load / size;
                let effective_mass = participation * along;
                ExcitedMode { participation, effective_mass, acceleration: None, columns: Vec::new() }
            };
            let loads = source.reduced.loads().take(count);
            let modes: Vec<ExcitedMode> = loads.zip(along).map(one).collect();
            let (mass, direction) = (*mass, *direction);
            let moved: f64 = modes.iter().map(|mode| mode.effective_mass).sum();
            // Where all is held along a base nothing moves, and nothing is missing.
            let share = if mass > 0.0 { moved / mass } else { 1.0 };
            if share < ENOUGH {
                let message = format!(
                    "the {count} modes move {:.1} % of the mass along base {}, less than the {:.0} % that are usual: what the others do is one shape more in the \
                     answer, or nothing; ask for more `modes`",
                    100.0 * share,
                    number + 1,
                    100.0 * ENOUGH
                );
                run.record.warn(WarningKind::TruncatedModes, message);
            }
            all.push(BaseSummary { direction, mass, share, ground: None, modes, missing_mass: Vec::new() });
        }
        all
    }
}

/// The body of a scene under one of what excites it, by its name.
///
/// # Errors
/// How the run ends where it cannot be built.
pub(super) fn built(scene: &Checked, threads: usize, name: &str) -> Result<Box<dyn StaticBody>, Box<Ended>> {
    let failed = |cause: String| Box::new(Ended::Diverged(Failure::Case { name: name.to_string(), cause }));
    let model = scene.build(threads).map_err(|error| failed(error.to_string()))?;
    match model.body {
        Ready::Static(body) => Ok(body),
        _ => Err(failed("it marches".into())),
    }
}

impl Source {
    /// Along each of its shapes.
    pub fn slopes<'s>(&'s self, modes: &'s [Slopes]) -> impl Iterator<Item = &'s Slopes> {
        modes.iter().chain(&self.rest)
    }
}

/// Shows numbers that are each the greatest, or the root mean square, of their own: a motion of all unknowns, and forces of fields.
pub(super) fn show(
    motion: &[f64],
    forces: &[f64],
    number: f64,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) {
    let (rest, start) = (system.save(), system.configuration().present);
    system.update(&scaled(motion, 1.0));
    keep_enlarged(&start, &system.configuration().present, number, run);
    if let Some(frames) = &mut run.frames {
        frames.offer_linear(system, forces, None);
    }
    system.restore(&rest);
}
