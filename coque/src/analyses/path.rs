//! Analyses along a path of equilibria: at given levels, or by arc length.

use std::ops::ControlFlow;

use implicit_statics::{
    Control, CriticalOptions, End, EquilibriumError, Increment, NewtonOptions, Path, PathOptions, Point,
    Start, follow, linear_response,
};
use sph_shell::StaticShell;

use crate::analyses::criticality::{Follows, note};
use crate::bodies::probe::Gauge;
use crate::bodies::shell::build::PrescribedPoint;
use crate::results::summary::{Energies, LevelSummary};
use crate::run::checkpoint::Place;
use crate::run::{Ended, Failure, Findings, Progress, ProgressReport, RunOptions};
use crate::scene::{ArcLength, Static};

/// Width of the bracket of a critical point in units of the step: within it the eigenvalue is interpolated, which
/// leaves the square of this.
const BRACKET: f64 = 1e-3;

const MORE: &str = "allow more `steps`, or a larger `radius`";
const CLOSER: &str = "use [analysis.arc-length], or more `iterations`";

/// Finds the equilibrium at every level, by way of others where Newton's method does not reach it in one; from the
/// start or from where an earlier run stood.
pub(crate) fn levels(
    wanted: &Static,
    system: &mut StaticShell,
    driven: Option<PrescribedPoint>,
    gauges: Vec<Gauge>,
    found: &mut Findings<'_>,
    (run, from): (&mut RunOptions<'_>, Option<Place>),
) {
    let newton = newton(wanted.tolerance, wanted.iterations);
    let unit = found.force_unit.clone();
    let mut reader = Reader { driven, gauges };
    let list = wanted.levels.list();
    let last = list.last().copied().unwrap_or(1.0);
    let (first, mut start) = match from {
        Some(Place::Levels { found, level, heading }) => {
            let heading = heading.map(|(motion, level)| Increment { motion, level });
            (found, Start { level, heading })
        }
        _ => (0, Start::default()),
    };
    if first == 0 {
        keep(run, 0, &start, system, &reader, found);
    }
    let mut before = first.checked_sub(1).and_then(|last| list.get(last)).copied().unwrap_or(0.0);
    for (number, &level) in list.iter().enumerate().skip(first) {
        let control = match driven {
            None => Control::Load { step: level - before, until: level },
            Some(driven) => {
                let moved = system.shell().displacement(driven.particle as usize).dot(&driven.direction);
                let rest = driven.by * level - moved;
                Control::Displacement { functional: functional(system, &driven), step: rest, until: rest }
            }
        };
        let mut iterations = 0;
        let mut row = Vec::new();
        let path = follow(system, &start, &options(control, &newton), |point, system| {
            iterations += if point.step > 0 { point.converged.iterations } else { 0 };
            // Every point is read: rotations are counted on from one reading to the next.
            row = reader.row(system, point, iterations);
            if point.step == 0 && number == 0 {
                found.curve.rows.push(row.clone());
                run.progress.recorded(&found.curve);
                if found.keep_shape(system.shell(), 0.0, 0.0).is_break() {
                    return ControlFlow::Break(());
                }
            }
            let news = ProgressReport { done: before / last, ..news(found.steps, before, row[1]) };
            run.progress.update(&news)
        });
        count(&path, found);
        note(&path, Follows::Levels, unit.as_deref(), found);
        if path.end == Ok(End::Stopped) {
            found.ended = Ended::Interrupted { time: 0.0, level: before };
            return;
        }
        if let Err(cause) = path.end {
            found.ended =
                Ended::Diverged(Failure::Balance { points: found.steps, level: before, cause, unit });
            return;
        }
        if path.end != Ok(End::Reached) {
            found.ended = Ended::Diverged(Failure::Steps {
                steps: path.points.len() - 1,
                level: before,
                repair: CLOSER,
            });
            return;
        }
        row[0] = level;
        let news = ProgressReport { done: level / last, ..news(found.steps, level, row[1]) };
        found.energies = energies(row[1]);
        found.curve.rows.push(row);
        run.progress.recorded(&found.curve);
        let steps = path.points.len() as u64 - 1;
        found.levels.push(LevelSummary {
            level,
            settled: true,
            kinetic_over_internal: 0.0,
            out_of_balance: 0.0,
            way_left: 0.0,
            // Under a prescribed motion the pivots are those of the force that brings it about.
            negative_pivots: path
                .points
                .last()
                .filter(|_| driven.is_none())
                .map(|point| point.inertia().negative),
            steps,
        });
        if found.frames.is_some() {
            // The search for critical points may have been elsewhere since the point was read.
            reader.evaluate(system, path.restart.level);
        }
        if found.keep_shape(system.shell(), 0.0, level).is_break() {
            return;
        }
        (start, before) = (path.restart, level);
        let flow = run.progress.update(&news);
        keep(run, number + 1, &start, system, &reader, found);
        if flow.is_break() && number + 1 < list.len() {
            found.ended = Ended::Interrupted { time: 0.0, level };
            return;
        }
    }
}

/// Keeps a checkpoint where so many levels are found, if the run writes any.
fn keep(
    run: &mut RunOptions<'_>,
    levels: usize,
    start: &Start,
    system: &StaticShell,
    reader: &Reader,
    found: &Findings<'_>,
) {
    let Some(checkpoints) = &mut run.checkpoints else { return };
    let heading = start.heading.as_ref().map(|heading| (heading.motion.clone(), heading.level));
    let place = Place::Levels { found: levels, level: start.level, heading };
    if let Err(error) = checkpoints.write(&place, system.shell().motion(), &reader.gauges, found) {
        run.progress.warn(&error.to_string());
    }
}

/// Follows the path by arc length to its end, over limit and turning points.
pub(crate) fn arc_length(
    wanted: &ArcLength,
    system: &mut StaticShell,
    driven: Option<PrescribedPoint>,
    gauges: Vec<Gauge>,
    found: &mut Findings<'_>,
    progress: &mut dyn Progress,
) {
    let first = match driven.map(|driven| (driven, stiffness(system, &driven))) {
        None => wanted.radius,
        Some((driven, Ok(stiffness))) => wanted.radius * driven.by * stiffness,
        Some((_, Err(cause))) => {
            found.ended = Ended::Diverged(Failure::Balance { points: 0, level: 0.0, cause, unit: None });
            return;
        }
    };
    let stop = wanted.stop.as_ref().and_then(|stop| {
        let at = found.curve.columns.iter().position(|column| column.name == stop.column)?;
        Some((at, stop.above))
    });
    let until = wanted.until.unwrap_or(f64::INFINITY);
    let control = Control::ArcLength { first, range: (f64::NEG_INFINITY, until) };
    let mut options = options(control, &newton(wanted.tolerance, wanted.iterations));
    options.steps = wanted.steps;
    let unit = found.force_unit.clone();
    let mut reader = Reader { driven, gauges };
    let mut interrupted = false;
    let path = follow(system, &Start::default(), &options, |point, system| {
        let row = reader.row(system, point, point.converged.iterations);
        let done = (point.level() / until).max(point.step as f64 / wanted.steps as f64);
        let news =
            ProgressReport { done: done.clamp(0.0, 1.0), ..news(point.step as u64, point.level(), row[1]) };
        interrupted = progress.update(&news).is_break();
        found.energies = energies(row[1]);
        let reached = stop.is_some_and(|(at, above)| row[at] > above);
        found.curve.rows.push(row);
        progress.recorded(&found.curve);
        let flow = found.keep_shape(system.shell(), 0.0, point.level());
        if reached || interrupted { ControlFlow::Break(()) } else { flow }
    });
    count(&path, found);
    note(&path, Follows::Arc, unit.as_deref(), found);
    let level = path.restart.level;
    found.ended = match path.end {
        Ok(End::Stopped) if interrupted => Ended::Interrupted { time: 0.0, level },
        Ok(End::Reached | End::Stopped) => Ended::Done,
        Ok(End::Steps) => Ended::Diverged(Failure::Steps { steps: wanted.steps, level, repair: MORE }),
        Err(cause) => Ended::Diverged(Failure::Balance { points: found.steps, level, cause, unit }),
    };
}

/// Full steps, and smaller load steps where they fail.
///
/// In bending a line search on the residual answers to the membrane stiffness and holds back steps that are right:
/// the thin ring (t/L = 1/120) takes 96 iterations in 8 levels without it, 2611 in 432 cut-back steps with it.
fn newton(tolerance: f64, iterations: usize) -> NewtonOptions {
    NewtonOptions { tolerance, iterations, line_search: false }
}

fn options(control: Control, newton: &NewtonOptions) -> PathOptions {
    let mut options = PathOptions::new(control);
    options.newton = newton.clone();
    options.critical = Some(CriticalOptions { tolerance: BRACKET, ..CriticalOptions::default() });
    options
}

impl PrescribedPoint {
    /// Displacement along the prescribed motion within a motion of the unknowns \[L\].
    pub(crate) fn moved(&self, system: &StaticShell, motion: &[f64]) -> f64 {
        functional(system, self).into_iter().map(|(i, weight)| weight * motion[i]).sum()
    }
}

/// The displacement along the prescribed motion, by unknowns and weights.
fn functional(system: &StaticShell, driven: &PrescribedPoint) -> Vec<(usize, f64)> {
    let weights = system.functional(&[driven.particle], driven.direction);
    weights.into_iter().enumerate().filter(|&(_, weight)| weight != 0.0).collect()
}

/// Force along the prescribed motion for a unit of displacement, linear at the present state \[F/L\].
fn stiffness(system: &mut StaticShell, driven: &PrescribedPoint) -> Result<f64, EquilibriumError> {
    let response = linear_response(system, 0.0)?;
    Ok(1.0 / driven.moved(system, &response))
}

/// Counts what a path took.
fn count(path: &Path, found: &mut Findings<'_>) {
    let made = path.points.iter().skip(1);
    found.newton_iterations += made.clone().map(|point| point.converged.iterations as u64).sum::<u64>();
    found.steps += made.count() as u64;
}

/// Reads rows of the curve.
struct Reader {
    driven: Option<PrescribedPoint>,
    gauges: Vec<Gauge>,
}

impl Reader {
    /// Forces and energy of the present state at a level.
    fn evaluate(&self, system: &mut StaticShell, level: f64) {
        // The force that brings a prescribed motion about is the reaction that is sought, not a load.
        system.evaluate(if self.driven.is_some() { 0.0 } else { level });
    }

    fn row(&mut self, system: &mut StaticShell, point: &Point, iterations: usize) -> Vec<f64> {
        self.evaluate(system, point.level());
        let shell = system.shell();
        let negative = point.inertia().negative;
        let mut row = vec![point.level(), shell.stored_energy(), iterations as f64, negative as f64];
        row.extend(self.gauges.iter_mut().map(|gauge| gauge.read(shell)));
        row
    }
}

/// Along equilibria that start unloaded the work of the loads is the internal energy.
pub(crate) fn energies(internal: f64) -> Energies {
    Energies { internal, external: internal, ..Energies::default() }
}

fn news(steps: u64, level: f64, internal: f64) -> ProgressReport {
    ProgressReport { level, steps, internal, ..ProgressReport::default() }
}
