//! Analyses along a path of equilibria: at given levels, or by arc length.

use std::ops::ControlFlow;

use implicit_statics::{
    Control, CriticalOptions, End, EquilibriumError, Increment, Newton, NewtonOptions, Path, PathOptions,
    Point, Start, follow, linear_response,
};

use super::breaking::{at_rest, note_breaches};
use super::criticality::{Follows, note};
use crate::bodies::{PrescribedPoint, StaticBody};
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::{Ended, Failure};
use crate::run::record::{Energies, LevelSummary};
use crate::scene::{ArcLength, Measured, Static};

/// Width of the bracket of a critical point in units of the step: within it the eigenvalue is interpolated, which
/// leaves the square of this.
const BRACKET: f64 = 1e-3;

const MORE: &str = "allow more `steps`, or a larger `radius`";
const CLOSER: &str = "use [analysis.arc-length], or more `iterations`";

/// Equilibria at given levels, found one after the other, by way of others where Newton's method does not reach one at once.
pub(super) struct Levels {
    list: Vec<f64>,
    newton: NewtonOptions,
    /// Levels found.
    found: usize,
    start: Start,
    /// None before it has begun: one analysis of the pattern serves all levels, and the factor of each the next.
    solver: Option<Newton>,
}

impl Levels {
    /// From the start, or from where an earlier run stood.
    pub fn new(wanted: &Static, from: Option<Stage>) -> Self {
        let (found, start) = match from {
            Some(Stage::Levels { found, level, heading, stiffness }) => {
                let heading = heading.map(|(motion, level)| Increment { motion, level });
                (found, Start { level, heading, stiffness })
            }
            _ => (0, Start::default()),
        };
        let newton = newton(wanted.tolerance.get(), wanted.iterations.get());
        Self { list: wanted.levels.list(), newton, found, start, solver: None }
    }

    /// The level last found; zero before the first.
    pub fn last(&self) -> f64 {
        self.found.checked_sub(1).and_then(|last| self.list.get(last)).copied().unwrap_or(0.0)
    }

    /// Finds the next level; `Break` with the last one, or where it is not found.
    pub fn advance(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let mut solver = match self.solver.take() {
            Some(solver) => solver,
            None => {
                run.warn_of_skew_loads(system.skew_load_share());
                if self.found == 0 {
                    keep(run, 0, &self.start, system);
                }
                self.newton.line_search = system.opens_and_closes();
                match Newton::new(&*system, &self.newton) {
                    Ok(solver) => solver,
                    Err(cause) => return ControlFlow::Break(run.unbalanced(0, 0.0, cause)),
                }
            }
        };
        let Some(&level) = self.list.get(self.found) else { return ControlFlow::Break(Ended::Done) };
        let flow = self.find(level, &mut solver, system, run);
        self.solver = Some(solver);
        flow
    }

    fn find(
        &mut self,
        level: f64,
        solver: &mut Newton,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> ControlFlow<Ended> {
        let (before, number, unit) = (self.last(), self.found, run.force_unit.clone());
        let share = number as f64 / self.list.len() as f64;
        let control = match run.driven {
            None => Control::Load { step: level - before, until: level },
            Some(driven) => {
                let rest = driven.by * level - driven.displacement(system);
                Control::Displacement { functional: functional(system, &driven), step: rest, until: rest }
            }
        };
        let mut iterations = 0;
        let mut row = Vec::new();
        let options = options(system, control, &self.newton);
        let path = solver.follow(system, &self.start, &options, |point, system| {
            iterations += if point.step > 0 { point.converged.iterations } else { 0 };
            // Every point is read: rotations are counted on from one reading to the next.
            row = read(run, system, point, iterations);
            if point.step == 0 && number == 0 {
                run.push(row.clone());
                if run.keep_shape(system, 0.0, 0.0).is_break() {
                    return ControlFlow::Break(());
                }
            }
            run.tell(share, run.record.steps, before, row[1])
        });
        count(&path, run);
        note_breaches(&path.breaches, unit.as_deref(), &mut run.record);
        note(&path, Follows::Levels, unit.as_deref(), &mut run.record);
        ControlFlow::Break(match path.end {
            Ok(End::Reached) => return self.reached(level, path, row, system, run),
            Ok(End::Stopped) => Ended::Interrupted { time: 0.0, level: before },
            Ok(End::Steps) => {
                let steps = path.points.len() - 1;
                Ended::Diverged(Failure::Steps { steps, level: before, repair: CLOSER })
            }
            Err(cause) => {
                let points = run.record.steps;
                Ended::Diverged(Failure::Balance { points, level: before, cause, unit })
            }
        })
    }

    /// Takes over the level that a path has reached, with the row of its last point.
    fn reached(
        &mut self,
        level: f64,
        path: Path,
        mut row: Vec<f64>,
        system: &mut dyn StaticBody,
        run: &mut Run<'_>,
    ) -> ControlFlow<Ended> {
        row[0] = level;
        let internal = row[1];
        run.record.energies = at_rest(internal, 0.0, &run.record);
        run.push(row);
        // Under a prescribed motion the pivots are those of the force that brings it about.
        let inertia = path.points.last().filter(|_| run.driven.is_none()).map(Point::inertia);
        let effort = path.effort();
        run.record.levels.push(LevelSummary {
            factorisations: Some(effort.factorisations as u64),
            solves: Some(effort.solves as u64),
            ..LevelSummary::balanced(level, inertia, path.points.len() as u64 - 1)
        });
        // The search for critical points may have been elsewhere since the point was read.
        system.refresh(loaded(run, path.restart.level));
        if run.keep_shape(system, 0.0, level).is_break() {
            return ControlFlow::Break(Ended::Done);
        }
        (self.start, self.found) = (path.restart, self.found + 1);
        let share = self.found as f64 / self.list.len() as f64;
        let flow = run.tell(share, run.record.steps, level, internal);
        keep(run, self.found, &self.start, system);
        if self.found == self.list.len() {
            return ControlFlow::Break(Ended::Done);
        }
        if flow.is_break() {
            return ControlFlow::Break(Ended::Interrupted { time: 0.0, level });
        }
        ControlFlow::Continue(())
    }
}

/// Keeps a checkpoint where so many levels are found, if the run writes any.
fn keep(run: &mut Run<'_>, levels: usize, start: &Start, system: &dyn StaticBody) {
    if run.checkpoints.is_some() {
        let heading = start.heading.as_ref().map(|heading| (heading.motion.clone(), heading.level));
        let Start { level, stiffness, .. } = start.clone();
        run.keep_checkpoint(&Stage::Levels { found: levels, level, heading, stiffness }, system);
    }
}

/// Follows the path by arc length to its end, over limit and turning points.
pub(super) fn arc_length(wanted: &ArcLength, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Ended {
    run.warn_of_skew_loads(system.skew_load_share());
    let first = match run.driven.map(|driven| (driven, stiffness(system, &driven))) {
        None => wanted.radius.get(),
        Some((driven, Ok(stiffness))) => wanted.radius.get() * driven.by * stiffness,
        Some((_, Err(cause))) => return run.unbalanced(0, 0.0, cause),
    };
    let stop = wanted.stop.as_ref().and_then(|stop| {
        let at = run.curve.columns.iter().position(|column| column.name == stop.column)?;
        Some((at, stop.above))
    });
    let until = wanted.until.map_or(f64::INFINITY, |until| until.get());
    let control = Control::ArcLength { first, range: (f64::NEG_INFINITY, until) };
    let mut options = options(&*system, control, &newton(wanted.tolerance.get(), wanted.iterations.get()));
    options.steps = wanted.steps.get();
    options.critical.iter_mut().for_each(|critical| critical.branches = wanted.branches);
    let unit = run.force_unit.clone();
    let mut interrupted = false;
    let path = follow(system, &Start::default(), &options, |point, system| {
        let row = read(run, system, point, point.converged.iterations);
        let done = (point.level() / until).max(point.step as f64 / wanted.steps.get() as f64);
        let reported = run.tell(done.clamp(0.0, 1.0), point.step as u64, point.level(), row[1]);
        interrupted = reported.is_break();
        run.record.energies = Energies::at_rest(row[1]);
        let reached = stop.is_some_and(|(at, above)| row[at] > above);
        run.push(row);
        let flow = run.keep_shape(system, 0.0, point.level());
        if reached || interrupted { ControlFlow::Break(()) } else { flow }
    });
    count(&path, run);
    note_breaches(&path.breaches, unit.as_deref(), &mut run.record);
    if path.points.len() > 1 {
        run.record.energies = at_rest(run.record.energies.internal, 0.0, &run.record);
    }
    note(&path, Follows::Arc, unit.as_deref(), &mut run.record);
    let level = path.restart.level;
    match path.end {
        Ok(End::Stopped) if interrupted => Ended::Interrupted { time: 0.0, level },
        Ok(End::Reached | End::Stopped) => Ended::Done,
        Ok(End::Steps) => Ended::Diverged(Failure::Steps { steps: wanted.steps.get(), level, repair: MORE }),
        Err(cause) => Ended::Diverged(Failure::Balance { points: run.record.steps, level, cause, unit }),
    }
}

/// Full steps, and smaller load steps where they fail.
///
/// In bending a line search on the residual answers to the membrane stiffness and holds back steps that are right:
/// the thin ring (t/L = 1/120) takes 96 iterations in 8 levels without it, 2611 in 432 cut-back steps with it. Where contacts open and
/// close it is needed.
pub(super) fn newton(tolerance: f64, iterations: usize) -> NewtonOptions {
    NewtonOptions { tolerance, iterations, line_search: false, ..NewtonOptions::default() }
}

/// Critical points are looked for along a path, but where friction slips: there the tangents at its two ends do not lead along it.
pub(super) fn options(system: &dyn StaticBody, control: Control, newton: &NewtonOptions) -> PathOptions {
    let mut options = PathOptions::new(control);
    options.newton = newton.clone();
    options.critical =
        (!system.slips()).then(|| CriticalOptions { tolerance: BRACKET, ..CriticalOptions::default() });
    options
}

impl PrescribedPoint {
    /// Displacement along the prescribed motion within a motion of the unknowns \[L\].
    pub(crate) fn moved(&self, system: &dyn StaticBody, motion: &[f64]) -> f64 {
        functional(system, self).into_iter().map(|(i, weight)| weight * motion[i]).sum()
    }

    /// Present displacement along the prescribed motion \[L\].
    fn displacement(&self, system: &dyn StaticBody) -> f64 {
        system.read(Measured::Displacement, self.particle as usize, &self.direction)
    }
}

/// The displacement along the prescribed motion, by unknowns and weights.
fn functional(system: &dyn StaticBody, driven: &PrescribedPoint) -> Vec<(usize, f64)> {
    let weights = system.functional(driven.particle as usize, driven.direction);
    weights.into_iter().enumerate().filter(|&(_, weight)| weight != 0.0).collect()
}

/// Force along the prescribed motion for a unit of displacement, linear at the present state \[F/L\].
fn stiffness(system: &mut dyn StaticBody, driven: &PrescribedPoint) -> Result<f64, EquilibriumError> {
    let response = linear_response(system, 0.0)?;
    Ok(1.0 / driven.moved(system, &response))
}

/// Counts what a path took.
fn count(path: &Path, run: &mut Run<'_>) {
    let made = path.points.iter().skip(1);
    run.record.newton_iterations += made.clone().map(|point| point.converged.iterations as u64).sum::<u64>();
    run.record.steps += made.count() as u64;
    let effort = path.effort();
    run.record.factorisations += effort.factorisations as u64;
    run.record.solves += effort.solves as u64;
}

/// The level of the loads: the force that brings a prescribed motion about is the reaction that is sought, not a load.
pub(crate) fn loaded(run: &Run<'_>, level: f64) -> f64 {
    if run.driven.is_some() { 0.0 } else { level }
}

/// A row of the curve, of a point of a path.
pub(super) fn read(
    run: &mut Run<'_>,
    system: &mut dyn StaticBody,
    point: &Point,
    iterations: usize,
) -> Vec<f64> {
    let internal = system.refresh(loaded(run, point.level()));
    let negative = point.inertia().negative;
    let mut row = vec![point.level(), internal, iterations as f64, negative as f64];
    run.read_probes(&mut row, system);
    row
}
