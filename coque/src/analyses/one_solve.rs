//! Levels led to by one linear answer each, without iterations for balance, and how far off each is.

use std::ops::ControlFlow;

use implicit_statics::OneSolve;

use super::path::loaded;
use crate::WarningKind;
use crate::bodies::{StaticBody, extent};
use crate::run::Run;
use crate::run::checkpoint::Stage;
use crate::run::outcome::Ended;
use crate::run::record::{Energies, LevelSummary};
use crate::scene::Static;

/// Way left over displacement up to which a level counts as settled \[–\].
const SETTLED: f64 = 0.01;

/// Levels of one solve each, made one after the other.
pub(super) struct OneSolveLevels {
    list: Vec<f64>,
    /// Levels made.
    made: usize,
    /// None before it has begun.
    scheme: Option<OneSolve>,
}

impl OneSolveLevels {
    /// From the start, or from where an earlier run stood.
    pub fn new(wanted: &Static, from: Option<Stage>) -> Self {
        let made = if let Some(Stage::Levels { found, .. }) = from { found } else { 0 };
        Self { list: wanted.levels.list(), made, scheme: None }
    }

    /// The level last made; zero before the first.
    pub fn last(&self) -> f64 {
        self.made.checked_sub(1).and_then(|at| self.list.get(at)).copied().unwrap_or(0.0)
    }

    /// Leads a body to the next level; `Break` with the last one, or where it fails. At the end it tells how far off the levels are.
    pub fn advance(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let flow = self.step(system, run);
        if matches!(flow, ControlFlow::Break(Ended::Done | Ended::Diverged(_))) {
            warn(run);
        }
        flow
    }

    fn step(&mut self, system: &mut dyn StaticBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        if self.scheme.is_none() {
            run.warn_of_skew_loads(system.skew_load_share());
            match OneSolve::new(&*system) {
                Ok(scheme) => self.scheme = Some(scheme),
                Err(cause) => return ControlFlow::Break(run.unbalanced(0, 0.0, cause)),
            }
            if self.made == 0 {
                keep(run, 0, 0.0, system);
                let internal = system.refresh(0.0);
                push(run, system, [0.0, internal, 0.0, 0.0, 0.0, 0.0]);
                if run.keep_shape(system, 0.0, 0.0).is_break() {
                    return ControlFlow::Break(Ended::Done);
                }
            }
        }
        let (number, before) = (self.made, self.last());
        let (Some(&level), Some(scheme)) = (self.list.get(number), &mut self.scheme) else {
            return ControlFlow::Break(Ended::Done);
        };
        let made = scheme.step(system, (before, level)).and_then(|unbalanced| {
            let way = remaining_displacement(scheme, system, level)?;
            Ok((unbalanced, way))
        });
        let (unbalanced, way) = match made {
            Ok(made) => made,
            Err(cause) => return ControlFlow::Break(run.unbalanced(run.record.steps, before, cause)),
        };
        let negative = scheme.inertia().negative;
        let internal = system.refresh(loaded(run, level));
        push(run, system, [level, internal, 1.0, negative as f64, unbalanced, way]);
        run.record.energies = Energies::at_rest(internal);
        run.record.newton_iterations += 1;
        run.record.steps += 1;
        run.record.solves += 2;
        run.record.factorisations += 1 + u64::from(number == 0);
        run.record.levels.push(LevelSummary {
            settled: way <= SETTLED,
            out_of_balance: unbalanced,
            remaining_displacement: way,
            ..LevelSummary::balanced(level, Some(scheme.inertia()), 1)
        });
        if run.keep_shape(system, 0.0, level).is_break() {
            return ControlFlow::Break(Ended::Done);
        }
        self.made += 1;
        let last = self.list.last().copied().unwrap_or(1.0);
        let flow = run.tell(level / last, run.record.steps, level, internal);
        keep(run, self.made, level, system);
        if self.made == self.list.len() {
            return ControlFlow::Break(Ended::Done);
        }
        if flow.is_break() {
            return ControlFlow::Break(Ended::Interrupted { time: 0.0, level });
        }
        ControlFlow::Continue(())
    }
}

/// Adds a row of the curve.
fn push(run: &mut Run<'_>, system: &mut dyn StaticBody, figures: [f64; 6]) {
    let mut row = figures.to_vec();
    run.read_probes(&mut row, system);
    run.push(row);
}

/// Keeps a checkpoint where so many levels are made, if the run writes any.
fn keep(run: &mut Run<'_>, found: usize, level: f64, system: &dyn StaticBody) {
    if run.checkpoints.is_some() {
        run.keep_checkpoint(&Stage::Levels { found, level, heading: None, stiffness: None }, system);
    }
}

/// What one more solve would move, over what moved so far: the largest displacements of particles.
fn remaining_displacement(
    scheme: &mut OneSolve,
    system: &mut dyn StaticBody,
    level: f64,
) -> Result<f64, implicit_statics::EquilibriumError> {
    let motion = scheme.remaining_displacement(system, level)?;
    let (here, state) = (system.configuration().present, system.save());
    system.update(motion);
    let configuration = system.configuration();
    let largest = |pairs: &mut dyn Iterator<Item = f64>| pairs.fold(0.0, f64::max);
    let way = largest(&mut configuration.present.iter().zip(&here).map(|(a, b)| (a - b).norm()));
    let moved = largest(&mut here.iter().zip(configuration.rest).map(|(a, b)| (a - b).norm()));
    let share = if moved > 0.0 { way / moved } else { way / extent(configuration.rest) };
    system.restore(&state);
    Ok(share)
}

/// Warns of levels that are far from their equilibria.
fn warn(run: &mut Run<'_>) {
    let of = |level: &LevelSummary| (level.level, level.remaining_displacement);
    let far = |a: &(f64, f64), b: &(f64, f64)| a.1.total_cmp(&b.1);
    let (worst, last) = (run.record.levels.iter().map(of).max_by(far), run.record.levels.last().map(of));
    let (Some((level, way)), Some((_, end))) = (worst, last) else { return };
    if way > SETTLED {
        let message = format!(
            "one solve a step leaves forces out of balance: one more solve would move the body by {:.2} % of its displacement at level {level} \
             and by {:.2} % at the last level (column remaining_displacement); make more levels, or leave `one_solve` out",
            100.0 * way,
            100.0 * end,
        );
        run.record.warn(WarningKind::NotSettled, message);
    }
}
