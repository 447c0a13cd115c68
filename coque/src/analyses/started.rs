//! Equilibria at given levels, each sought from a start that another lattice's equilibria give.

use std::ops::ControlFlow;

use implicit_statics::{Converged, Newton, NewtonOptions};

use super::breaking::at_rest;
use super::path::newton;
use crate::bodies::StaticBody;
use crate::run::Run;
use crate::run::outcome::{Ended, Failure};
use crate::run::record::LevelSummary;
use crate::scene::Static;

/// Numbers of a particle, the last three of which are its director.
const NUMBERS: usize = 6;

/// Levels, with how the state of the body is to change from one to the next before each is balanced.
///
/// A state is that of the level before and the increment of another lattice: what both lattices differ by is carried along, and
/// Newton's method finds the little that it changes by.
pub(super) struct StartedLevels {
    list: Vec<f64>,
    newton: NewtonOptions,
    increments: Vec<Vec<f64>>,
    found: usize,
    solver: Option<Newton>,
}

impl StartedLevels {
    /// At the levels of an analysis, with an increment of position and director of each particle for each of them.
    ///
    /// Each level is begun from a state that is moved, which a factor of the last balance does not serve: none is made for its inertia alone.
    pub fn new(wanted: &Static, increments: Vec<Vec<f64>>) -> Self {
        let newton =
            NewtonOptions { inertia: false, ..newton(wanted.tolerance.get(), wanted.iterations.get()) };
        Self { list: wanted.levels.list(), newton, increments, found: 0, solver: None }
    }

    /// The level last found; zero before the first.
    pub fn last(&self) -> f64 {
        self.found.checked_sub(1).and_then(|last| self.list.get(last)).copied().unwrap_or(0.0)
    }

    /// Finds the next level; `Break` with the last one, or where it is not found.
    pub fn advance(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let unbalanced = |run: &Run<'_>, level, cause| ControlFlow::Break(run.unbalanced(0, level, cause));
        let mut solver = match self.solver.take() {
            Some(solver) => solver,
            None => {
                self.newton.line_search = system.opens_and_closes();
                let mut solver = match Newton::new(&*system, &self.newton) {
                    Ok(solver) => solver,
                    Err(cause) => return unbalanced(run, 0.0, cause),
                };
                match solver.at_level(system, 0.0) {
                    Ok(start) => row(system, run, &start),
                    Err(cause) => return unbalanced(run, 0.0, cause),
                }
                solver
            }
        };
        let (Some(&level), Some(increment)) = (self.list.get(self.found), self.increments.get(self.found))
        else {
            return ControlFlow::Break(Ended::Done);
        };
        if !moved(system, increment) {
            let failure = Failure::Kind { analysis: "static", wanted: "starts of its own particles" };
            return ControlFlow::Break(Ended::Diverged(failure));
        }
        solver.has_moved();
        let before = solver.effort;
        let converged = match solver.at_level(system, level) {
            Ok(converged) => converged,
            Err(cause) => return unbalanced(run, self.last(), cause),
        };
        system.commit();
        row(system, run, &converged);
        let effort = solver.effort.since(&before);
        run.record.newton_iterations += converged.iterations as u64;
        run.record.steps += 1;
        run.record.factorisations += effort.factorisations as u64;
        run.record.solves += effort.solves as u64;
        run.record.levels.push(LevelSummary::balanced(level, Some(converged.inertia), 1));
        (self.found, self.solver) = (self.found + 1, Some(solver));
        let last = self.list.last().copied().unwrap_or(1.0);
        let internal = run.record.energies.internal;
        let flow = run.tell(level / last, run.record.steps, level, internal);
        if self.found == self.list.len() {
            return ControlFlow::Break(Ended::Done);
        }
        if flow.is_break() {
            return ControlFlow::Break(Ended::Interrupted { time: 0.0, level });
        }
        ControlFlow::Continue(())
    }
}

/// Moves a body by an increment of its state, as far as its supports let it; false, and nothing done, if it is that of another.
fn moved(system: &mut dyn StaticBody, increment: &[f64]) -> bool {
    let mut wanted = system.save();
    if wanted.len() != increment.len() {
        return false;
    }
    wanted.iter_mut().zip(increment).for_each(|(number, change)| *number += change);
    for row in wanted.chunks_exact_mut(NUMBERS) {
        let length = row[3..].iter().map(|d| d * d).sum::<f64>().sqrt();
        row[3..].iter_mut().for_each(|d| *d /= length);
    }
    let mut motion = vec![0.0; system.unknowns()];
    let leads = system.motion_to(&wanted, &mut motion);
    if leads {
        system.update(&motion);
    }
    leads
}

/// Reads a row of the curve, at a balance.
fn row(system: &mut dyn StaticBody, run: &mut Run<'_>, found: &Converged) {
    let internal = system.refresh(found.level);
    let mut row = vec![found.level, internal, found.iterations as f64, found.inertia.negative as f64];
    run.read_probes(&mut row, system);
    run.record.energies = at_rest(internal, 0.0, &run.record);
    run.push(row);
}
