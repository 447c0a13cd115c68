//! What a run will cost, before it runs: steps from the stable step, seconds from a few steps that are timed.

use std::time::{Duration, Instant};

use explicit_dynamics::{Instant as Moment, Step};
use implicit_statics::{SymmetricSolver, linear_response};

use super::linear::solved;
use super::march::reference_step;
use crate::bodies::{DynamicBody, Model, Ready, StaticBody};
use crate::scene::{Analysis, Explicit, Harmonic, LevelSign, Linear, LinearSolver};

/// How long steps are timed: rounds enough for a median, too short to be waited for.
const TIMED: Duration = Duration::from_millis(24);
/// Rounds of as many steps each.
const ROUNDS: u32 = 8;
/// Part of a period that the shortest hold takes: two looks of twenty a period.
const SHORTEST_HOLD: f64 = 0.1;
/// Newton iterations of a level: few where the load path is smooth, the default bound where it is not.
const ITERATIONS: [f64; 2] = [3.0, 30.0];

/// What a run will cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Greatest stable step of the unloaded body \[T\]; zero without time.
    pub stable_step: f64,
    /// Steps, without time factorisations: least and most; a path by arc length tells neither beforehand.
    pub steps: Option<[f64; 2]>,
    /// Wall time of one of them \[s\], as timed just now with the threads of the model.
    pub seconds_a_step: f64,
    /// Solves that modes and load cases take beside their factorisations: least and most; none for other analyses.
    pub solves: Option<[f64; 2]>,
    /// Wall time of the run \[s\]: least and most.
    pub seconds: Option<[f64; 2]>,
    /// Memory that a step in time touches \[bytes\]; factors of a tangent come on top.
    pub bytes: f64,
}

impl Model {
    /// Times a few steps, or the first factorisation, of the body at rest.
    pub fn estimate(self) -> Estimate {
        let Self { mut body, task, description, threads, cases, .. } = self;
        let cases = cases.map_or(0, |scene| scene.cases().len());
        let bytes = description.bytes_per_particle * description.particles as f64;
        match (&mut body, &task.analysis) {
            (Ready::Dynamic(body), Analysis::Explicit(explicit)) => {
                of_march(explicit, body.as_mut(), threads, bytes)
            }
            (Ready::Dynamic(_), _) => Estimate { bytes, ..Estimate::default() },
            // In time estimates choose the steps, which nothing tells beforehand.
            (Ready::Heat(_), analysis) => {
                let steps = (!analysis.kind().passes_time).then_some([1.0; 2]);
                Estimate { steps, bytes, ..Estimate::default() }
            }
            (Ready::Static(body), analysis) => of_balance(analysis, cases, body.as_mut(), bytes),
        }
    }
}

fn of_march(explicit: &Explicit, body: &mut dyn DynamicBody, threads: usize, bytes: f64) -> Estimate {
    let stable_step = reference_step(body);
    let dt = explicit.safety.get() * stable_step;
    let seconds_a_step = match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) if threads > 1 => pool.install(|| time_steps(body, dt)),
        _ => time_steps(body, dt),
    };
    let steps = steps(explicit, body, dt);
    let seconds = steps.map(|steps| steps.map(|count| count * seconds_a_step));
    Estimate { stable_step, steps, seconds_a_step, seconds, bytes, ..Estimate::default() }
}

/// Of an analysis with so many load cases, none of a scene without.
fn of_balance(analysis: &Analysis, cases: usize, body: &mut dyn StaticBody, bytes: f64) -> Estimate {
    let steps = match analysis {
        Analysis::Modal(wanted) => return Work::of_vibration(wanted.modes.get()).estimate(body, bytes),
        Analysis::Buckling(wanted) => {
            let sides = if wanted.sign == LevelSign::Either { 2.0 } else { 1.0 };
            return Work::of_buckling(wanted.modes.get(), sides).estimate(body, bytes);
        }
        Analysis::Harmonic(Harmonic { modes: Some(modes), .. }) => {
            return Work::of_bases(modes.get(), 1).estimate(body, bytes);
        }
        Analysis::ResponseSpectrum(wanted) => {
            return Work::of_bases(wanted.modes.get(), wanted.base.len()).estimate(body, bytes);
        }
        Analysis::RandomVibration(wanted) => {
            let sources = wanted.base.len() + usize::from(wanted.loads.is_some());
            return Work::of_bases(wanted.modes.get(), sources).estimate(body, bytes);
        }
        Analysis::Harmonic(wanted) => {
            let count = wanted.frequencies.list().len() as f64;
            let work = Work::of_frequencies(count, wanted.damping.is_some());
            return Estimate { steps: Some([count; 2]), solves: None, ..work.estimate(body, bytes) };
        }
        Analysis::Linear(Linear { solver: LinearSolver::Direct, .. }) if cases > 0 => {
            return Work::of_cases(cases).estimate(body, bytes);
        }
        Analysis::Static(path) => Some(ITERATIONS.map(|each| each * path.levels.list().len() as f64)),
        // A path by arc length tells nothing beforehand; a relaxation takes no factors.
        Analysis::ArcLength(_) | Analysis::Relaxation(_) => None,
        _ => Some([1.0; 2]),
    };
    let wanted = if let Analysis::Linear(wanted) = analysis { wanted.clone() } else { Linear::default() };
    let begun = Instant::now();
    // A tangent that cannot be solved says so when the scene is run; its time counts all the same.
    let _ = solved(&wanted, body);
    let seconds_a_step = begun.elapsed().as_secs_f64();
    // Iterations are those of each load case anew.
    let each = cases.max(1) as f64;
    let seconds = steps.map(|steps| steps.map(|count| each * count * seconds_a_step));
    let solves = (cases > 0).then_some([each; 2]);
    Estimate { steps, seconds_a_step, solves, seconds, bytes, ..Estimate::default() }
}

/// What modes and load cases take: tangents, factorisations, solves; least and most.
struct Work {
    tangents: [f64; 2],
    factorisations: [f64; 2],
    solves: [f64; 2],
}

impl Work {
    /// One factor for all load cases, a solve for each; combinations take none.
    fn of_cases(cases: usize) -> Self {
        Self { tangents: [1.0; 2], factorisations: [1.0; 2], solves: [cases as f64; 2] }
    }

    /// Modes far apart, and modes so close that some are missed at first.
    fn of_vibration(modes: usize) -> Self {
        let modes = modes as f64;
        Self {
            tangents: [1.0; 2],
            factorisations: [2.0, 6.0],
            solves: [12.0 + 2.0 * modes, 60.0 + 12.0 * modes],
        }
    }

    /// Modes, and the shape that stands for all others under each of so many loads.
    fn of_bases(modes: usize, loads: usize) -> Self {
        let Self { tangents, factorisations, solves } = Self::of_vibration(modes);
        let more = loads as f64;
        Self {
            tangents: tangents.map(|count| count + more),
            factorisations: factorisations.map(|count| count + more),
            solves: solves.map(|count| count + more),
        }
    }

    /// A factor at each frequency, of both parts of the unknowns where the body is damped: eight times the multiplications, and as many again where
    /// its pivots have to be exchanged.
    fn of_frequencies(count: f64, damped: bool) -> Self {
        let each = if damped { [8.0, 16.0] } else { [1.0, 2.0] };
        Self {
            tangents: [1.0; 2],
            factorisations: each.map(|each| 1.0 + each * count),
            solves: each.map(|each| 0.5 * each * count),
        }
    }

    /// Levels far apart, and a dense spectrum of which a crowd lies below the shift; the tangent is differentiated.
    fn of_buckling(modes: usize, sides: f64) -> Self {
        let modes = modes as f64;
        Self {
            tangents: [5.0, 9.0],
            factorisations: [2.0, 6.0].map(|count| sides * count),
            solves: [12.0 + 2.0 * modes, 600.0 + 24.0 * modes].map(|count| sides * count),
        }
    }

    /// Times each of the three once.
    fn estimate(&self, system: &mut dyn StaticBody, bytes: f64) -> Estimate {
        let timed = |begun: Instant| begun.elapsed().as_secs_f64();
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        let begun = Instant::now();
        system.tangent(0.0, &mut values);
        let tangent = timed(begun);
        let begun = Instant::now();
        // A tangent that cannot be factorised says so when the scene is run; its time counts all the same.
        let mut solver = SymmetricSolver::new(system.unknowns(), &pattern).ok();
        let _ = solver.as_mut().map(|solver| solver.factor(&values));
        let factorisation = timed(begun);
        let begun = Instant::now();
        let _ = solver.as_mut().map(|solver| solver.solve(&mut vec![1.0; system.unknowns()]));
        let solve = timed(begun);
        let Self { tangents, factorisations, solves } = self;
        let seconds =
            [0, 1].map(|i| tangents[i] * tangent + factorisations[i] * factorisation + solves[i] * solve);
        Estimate {
            stable_step: 0.0,
            steps: Some(*factorisations),
            seconds_a_step: factorisation,
            solves: Some(*solves),
            seconds: Some(seconds),
            bytes,
        }
    }
}

/// Steps of a run: every hold at its shortest, every hold at its longest; unknown where nothing tells the period.
fn steps(explicit: &Explicit, body: &mut dyn DynamicBody, dt: f64) -> Option<[f64; 2]> {
    if let Some(path) = &explicit.quasi_static {
        let levels = path.levels.list().len() as f64;
        let period = path.period.as_deref().copied().or_else(|| period_of_deflection(body))?;
        return Some(
            [SHORTEST_HOLD, path.hold.get()].map(|hold| levels * (path.ramp.get() + hold) * period / dt),
        );
    }
    let duration = explicit.transient.as_ref().map_or(0.0, |run| run.duration.get());
    Some([duration / dt; 2])
}

/// Rayleigh's period of the linear answer u to the loads: `ω² = u·p / u·Mu`; none without a tangent or a load.
fn period_of_deflection(body: &mut dyn DynamicBody) -> Option<f64> {
    let mut system = body.at_rest()?;
    let answer = linear_response(&mut *system, 0.0).ok()?;
    let mut load = vec![0.0; answer.len()];
    system.load_rate(0.0, &mut load);
    let work: f64 = answer.iter().zip(&load).map(|(u, p)| u * p).sum();
    let inertia: f64 = answer.iter().zip(system.masses()).map(|(u, mass)| mass * u * u).sum();
    (work > 0.0).then(|| std::f64::consts::TAU * (inertia / work).sqrt())
}

/// Seconds a step, without load: nothing moves and the work is the same. The median of some rounds, of a step each where steps are long.
fn time_steps(body: &mut dyn DynamicBody, dt: f64) -> f64 {
    let at = |time| Moment { time, level: 0.0 };
    let step = Step { from: at(0.0), to: at(dt), kick: dt, damping: 0.0 };
    let mut timed = |count: u32| {
        let begun = Instant::now();
        for _ in 0..count {
            body.advance(&step);
        }
        begun.elapsed() / count
    };
    // The first step finds nothing in the caches; the second tells how many make a round.
    timed(1);
    let begun = Instant::now();
    let count = (TIMED / ROUNDS).div_duration_f64(timed(1).max(Duration::from_nanos(100))) as u32;
    let mut rounds = vec![timed(count.max(1))];
    while begun.elapsed() < TIMED {
        rounds.push(timed(count.max(1)));
    }
    rounds.sort_unstable();
    rounds[rounds.len() / 2].as_secs_f64()
}
