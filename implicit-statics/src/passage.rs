//! What a step of a path went over: critical points located or bracketed, and changes of branch.

use crate::Equilibrium;
use crate::branch::{Leads, trace};
use crate::critical::{CriticalOptions, CriticalPoint, locate_all};
use crate::path::{Control, Path, PathOptions};
use crate::stepper::{Made, Stepper};

/// A part of a path over which something critical was passed that no [`CriticalPoint`] tells of.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The path's step.
    pub step: usize,
    /// Levels at its ends \[–\].
    pub levels: (f64, f64),
    /// Negative pivots at its ends.
    pub negative: (usize, usize),
    /// What was passed.
    pub what: Passed,
}

/// What a [`Passage`] went over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passed {
    /// Critical points that were bracketed but not located: the number of negative pivots changes.
    Pivots,
    /// The branch of the first end turns back at about this level; the other end lies on another.
    Turn(f64),
    /// The branch of the first end goes on to another state; the second lies on another branch.
    Branch,
    /// The step is far from its tangents, and the branch of its first end could not be followed: the other end may lie
    /// on another.
    Unproved,
}

/// Looks at a step that is kept, from `saved` to the present state: for critical points where the number of negative
/// pivots changes, and for a change of branch where its tangents do not explain it.
pub(crate) fn look_for_critical<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    (saved, made, size): (&[f64], &Made, f64),
    critical: &CriticalOptions,
    options: &PathOptions,
    path: &mut Path,
) {
    let before = path.points.last().map_or(0, |point| point.inertia().negative);
    let negative = (before, made.converged.inertia.negative);
    let leaps = made.strays;
    if !leaps && negative.0 == negative.1 {
        return;
    }
    let (step, levels) = (stepper.newton.step, (stepper.level, made.converged.level));
    let here = system.save();
    stepper.newton.go_back(system, saved);
    let mut same = true;
    if leaps {
        let arc = matches!(options.control, Control::ArcLength { .. });
        let traced =
            (!arc).then(|| trace(system, levels.0, (&made.increment, made.predicted), &here, options));
        let what = match traced.as_ref().map_or(Leads::Unknown, |traced| traced.leads) {
            Leads::There => None,
            Leads::Back(level) => Some(Passed::Turn(level)),
            Leads::Elsewhere => Some(Passed::Branch),
            Leads::Unknown => Some(Passed::Unproved),
        };
        // What lies on the branch that was left is told, with the step that left it; pairs that cancel as well.
        if let Some(traced) = traced.filter(|_| what.is_some() || negative.0 == negative.1) {
            path.critical.extend(traced.critical.into_iter().map(|point| CriticalPoint { step, ..point }));
            path.passages.extend(traced.passages.into_iter().map(|passage| Passage { step, ..passage }));
        }
        same = what.is_none();
        path.passages.extend(what.map(|what| Passage { step, levels, negative, what }));
    }
    if same && negative.0 != negative.1 {
        stepper.newton.go_back(system, saved);
        let (points, passages) =
            locate_all(stepper, system, (&made.converged, &here), negative.0, size, critical);
        path.critical.extend(points);
        path.passages.extend(passages);
    }
    stepper.newton.go_back(system, &here);
}
