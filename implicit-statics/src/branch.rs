//! Whether a long step stayed on its branch: the branch is followed by arc length from where the step began.

use std::ops::ControlFlow;

use crate::passage::Passage;
use crate::path::{Control, PathOptions, Start, march};
use crate::vectors::{difference, dot};
use crate::{CriticalKind, CriticalPoint, End, Equilibrium, EquilibriumError, Increment, Path};

/// First step along the branch, as a part of the linear answer to the whole.
const PART: f64 = 0.125;
/// Steps along the branch.
const STEPS: usize = 200;
/// Two states are the same if their distance is below this share of the way between the ends of the step.
const SAME: f64 = 1e-3;

/// Where the branch of an equilibrium goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Leads {
    /// To the state that the step found.
    There,
    /// Back, before the end of the step, from about this level.
    Back(f64),
    /// To the end of the step, in another state.
    Elsewhere,
    /// It could not be followed that far.
    Unknown,
}

/// What was met on the branch.
pub(crate) struct Traced {
    pub leads: Leads,
    pub critical: Vec<CriticalPoint>,
    pub passages: Vec<Passage>,
}

/// Follows the branch through the present state, which balances `level`, to the end of the step `made`; `found` is the
/// state that the step found, `linear` the change of level of the linear answer to it. The state of the system is left elsewhere.
pub(crate) fn trace<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    (made, linear): (&Increment, f64),
    found: &[f64],
    options: &PathOptions,
) -> Traced {
    let begun = system.save();
    // The controlled quantity along the branch, and at the end of the step.
    let progress = |increment: &Increment| match &options.control {
        Control::Displacement { functional, .. } => {
            functional.iter().map(|&(unknown, weight)| weight * increment.motion[unknown]).sum::<f64>()
        }
        _ => increment.level,
    };
    let target = progress(made);
    let arc = PathOptions {
        control: Control::ArcLength { first: PART * linear, range: (f64::NEG_INFINITY, f64::INFINITY) },
        steps: STEPS,
        ..options.clone()
    };
    let (mut done, mut highest) = (0.0_f64, level);
    let mut path = Path::new(&Start { level, heading: None });
    let mut turned = false;
    let end = march(system, &Start { level, heading: None }, &arc, &mut path, &mut |point, step, _| {
        let Some(step) = step else { return ControlFlow::Continue(()) };
        let before = done;
        done += progress(step);
        turned = (done - before) * target < 0.0;
        if !turned {
            highest = point.level();
        }
        if turned || done * target >= target * target {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    let limit = path.critical.iter().rfind(|point| point.kind == CriticalKind::Limit);
    let limit = limit.map_or(highest, |point| point.level);
    let leads = match end {
        Ok(End::Stopped) if turned => Leads::Back(limit),
        Ok(End::Stopped) => match land(system, &path.restart, target - done, options) {
            Ok(()) => {
                let (state, way) = (system.save(), difference(found, &begun));
                let rest = difference(&state, found);
                if dot(&rest, &rest) <= SAME * SAME * dot(&way, &way) {
                    Leads::There
                } else {
                    Leads::Elsewhere
                }
            }
            Err(_) => Leads::Unknown,
        },
        _ => Leads::Unknown,
    };
    Traced { leads, critical: path.critical, passages: path.passages }
}

/// Goes the rest of the way from a point just beyond the end of the step.
fn land<E: Equilibrium + ?Sized>(
    system: &mut E,
    from: &Start,
    rest: f64,
    options: &PathOptions,
) -> Result<(), EquilibriumError> {
    if rest == 0.0 {
        return Ok(());
    }
    let control = match &options.control {
        Control::Displacement { functional, .. } => {
            Control::Displacement { functional: functional.clone(), step: rest, until: rest }
        }
        _ => Control::Load { step: rest, until: from.level + rest },
    };
    let short = PathOptions { control, critical: None, ..options.clone() };
    let start = Start { level: from.level, heading: None };
    march(system, &start, &short, &mut Path::new(&start), &mut |_, _, _| ControlFlow::Continue(()))
        .map(|_| ())
}
