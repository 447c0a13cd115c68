//! What a run will cost, before it runs: steps from the stable step, seconds from a few steps that are timed.

use std::time::{Duration, Instant};

use explicit_dynamics::{Dynamics, Instant as Moment, Step};
use implicit_statics::linear_response;
use sph_shell::{Shell, StaticShell};

use crate::build::Model;
use crate::march::reference_step;
use crate::scene::{Analysis, Explicit};

/// How long steps are timed.
const TIMED: Duration = Duration::from_millis(300);
/// Part of a period that the shortest hold takes: two looks of twenty a period.
const SHORTEST_HOLD: f64 = 0.1;
/// Newton iterations of a level: few where the load path is smooth, the default bound where it is not.
const ITERATIONS: [f64; 2] = [3.0, 30.0];

/// What a run will cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Greatest stable step of the unloaded shell \[T\]; nought without time.
    pub stable_step: f64,
    /// Steps, without time factorisations: least and most; a path by arc length tells neither beforehand.
    pub steps: Option<[f64; 2]>,
    /// Wall time of one of them \[s\], as timed just now with the threads of the model.
    pub seconds_a_step: f64,
    /// Memory that a step in time touches \[bytes\]; factors of a tangent come on top.
    pub bytes: f64,
}

impl Model {
    /// Times a few steps, or the first factorisation, of the shell at rest.
    pub fn estimate(self) -> Estimate {
        let Self { mut shell, scene, threads, .. } = self;
        let bytes = shell.bytes_per_particle() * shell.len() as f64;
        if let Analysis::Explicit(explicit) = &scene.analysis {
            let stable_step = reference_step(&mut shell);
            let dt = explicit.safety * stable_step;
            let seconds_a_step = match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
                Ok(pool) if threads > 1 => pool.install(|| time_steps(&mut shell, dt)),
                _ => time_steps(&mut shell, dt),
            };
            return Estimate { stable_step, steps: Some(steps(explicit, dt)), seconds_a_step, bytes };
        }
        let steps = match &scene.analysis {
            Analysis::Static(path) => Some(ITERATIONS.map(|each| each * path.levels.list().len() as f64)),
            Analysis::ArcLength(_) => None,
            _ => Some([1.0; 2]),
        };
        let begun = Instant::now();
        // A tangent that cannot be factorised says so when the scene is run; its time counts all the same.
        let _ = linear_response(&mut StaticShell::new(shell), 0.0);
        Estimate { stable_step: 0.0, steps, seconds_a_step: begun.elapsed().as_secs_f64(), bytes }
    }
}

/// Steps of a run: every hold at its shortest, every hold at its longest.
fn steps(explicit: &Explicit, dt: f64) -> [f64; 2] {
    if let Some(path) = &explicit.quasi_static {
        let levels = path.levels.list().len() as f64;
        return [SHORTEST_HOLD, path.hold].map(|hold| levels * (path.ramp + hold) * path.period / dt);
    }
    let duration = explicit.transient.map_or(0.0, |run| run.duration);
    [duration / dt; 2]
}

/// Seconds a step, without load: nothing moves and the work is the same.
fn time_steps(shell: &mut Shell, dt: f64) -> f64 {
    let at = |time| Moment { time, level: 0.0 };
    let step = Step { from: at(0.0), to: at(dt), kick: dt, damping: 0.0 };
    shell.advance(&step);
    let begun = Instant::now();
    let mut count = 0;
    while begun.elapsed() < TIMED {
        shell.advance(&step);
        count += 1;
    }
    begun.elapsed().as_secs_f64() / f64::from(count)
}
