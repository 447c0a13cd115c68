//! Paths of equilibria under load, displacement and arc-length control, with adaptive steps and restarts.
//!
//! A long step is followed again by arc length from where it began, to see whether it stayed on its branch: following
//! calls itself, so both stand in this file.

use std::ops::ControlFlow;

use crate::apart::apart;
use crate::branch::take_branch;
use crate::breaking::Limit;
use crate::critical::locate_all;
use crate::options::{Control, CriticalOptions, PathOptions};
use crate::path::{CriticalKind, CriticalPoint, End, Passage, Passed, Path, Point, Start};
use crate::stepper::{StepOutcome, Stepper};
use crate::{Equilibrium, EquilibriumError, Increment, Newton};

/// Part of the first step above which a load step that may have strayed is halved.
const STRAY: f64 = 0.1;
/// Part of the first step down to which an arc is halved while it strays.
const FINE: f64 = 1e-3;
/// First step along the branch, as a part of the linear answer to the whole.
const PART: f64 = 0.125;
/// Steps along the branch.
const STEPS: usize = 200;
/// Two states are the same if their distance is below this share of the way between the ends of the step.
const SAME: f64 = 1e-3;
/// Of a system with memory they are then found by other steps up to this share, beyond it on other branches.
const BY_STEPS: f64 = 0.1;

/// Whether a path is kept, so that what reaches its limit on it breaks; or only looked at.
#[derive(Clone, Copy, PartialEq)]
enum Keep {
    Yes,
    No,
}

/// Receives every converged point and the step that led there.
type Observer<'a, E> = dyn FnMut(&Point, Option<&Increment>, &mut E) -> ControlFlow<()> + 'a;

/// Follows equilibria from the present state; the observer sees every converged point and may stop.
///
/// A step that fails is repeated with half the size from the last converged state. All converged points are
/// kept whatever happens later.
pub fn follow<E: Equilibrium + ?Sized>(
    system: &mut E,
    start: &Start,
    options: &PathOptions,
    observer: impl FnMut(&Point, &mut E) -> ControlFlow<()>,
) -> Path {
    match Newton::new(system, &options.newton) {
        Ok(mut newton) => newton.follow(system, start, options, observer),
        Err(error) => Path { end: Err(error), ..Path::new(start) },
    }
}

impl Newton {
    /// As [`follow`], for paths in parts: the analysis of the pattern serves them all, and the factor of the state in which one
    /// ends the next. Newton's own options stand back behind those of the path.
    pub fn follow<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        start: &Start,
        options: &PathOptions,
        mut observer: impl FnMut(&Point, &mut E) -> ControlFlow<()>,
    ) -> Path {
        let mut path = Path::new(start);
        self.options = options.newton.clone();
        path.end = march(self, system, (start, Keep::Yes), options, &mut path, &mut |point, _, system| {
            observer(point, system)
        });
        self.leave(system);
        path
    }
}

fn march<E: Equilibrium + ?Sized>(
    newton: &mut Newton,
    system: &mut E,
    (start, kept): (&Start, Keep),
    options: &PathOptions,
    path: &mut Path,
    observer: &mut Observer<'_, E>,
) -> Result<End, EquilibriumError> {
    options.check(system)?;
    let before = newton.effort;
    let (mut stepper, converged, (mut size, mut first)) = Stepper::new(newton, system, start, options)?;
    let unstable = converged.inertia.negative;
    let mut spent = stepper.newton.effort;
    let effort = spent.since(&before);
    let point = Point { step: 0, converged, size: 0.0, restarts: 0, unstable, effort };
    let stop = observer(&point, None, system);
    path.points.push(point);
    if stop.is_break() {
        return Ok(End::Stopped);
    }
    let mut travelled = 0.0;
    let critical =
        options.critical.as_ref().map(|critical| critical.within(&options.control, kept == Keep::Yes));
    for step in 1..=options.steps {
        stepper.newton.step = step;
        let saved = system.save();
        let mut restarts = 0;
        let (asked, mut limit) = (size, Limit::from(system));
        let (mut made, mut bound) = loop {
            let trial = clip(size, travelled, stepper.level, &options.control);
            match step_within(&mut stepper, system, &saved, trial, &options.control) {
                Ok(done) if !strayed(&done.0, path, trial, first, &options.control) => {
                    match limit.other_size(system, trial) {
                        Some(other) if kept == Keep::Yes => {
                            stepper.newton.go_back(system, &saved);
                            size = other;
                        }
                        _ => break done,
                    }
                }
                Ok(_) => {
                    stepper.newton.go_back(system, &saved);
                    restarts += 1;
                    size = 0.5 * trial;
                }
                Err(cause) => {
                    stepper.newton.go_back(system, &saved);
                    restarts += 1;
                    size = 0.5 * trial;
                    let smallest = options.smallest * first;
                    if size < smallest {
                        let (level, cause) = (stepper.level, Box::new(cause));
                        return Err(EquilibriumError::StepTooSmall { step, level, size, smallest, cause });
                    }
                }
            }
        };
        let mut size_made = stepper.size(&made.increment);
        if let Some(critical) = &critical {
            look_for_critical(&mut stepper, system, (&saved, &made, size_made), critical, options, path);
            let step = (&saved[..], size_made, &options.control);
            if let Some(branch) = take_branch(&mut stepper, system, path, step, critical.branches)? {
                (made, bound) = (branch, false);
                size_made = stepper.size(&made.increment);
                (size, first) = (size_made, size_made);
            }
        }
        travelled += size_made;
        let StepOutcome { converged, increment, unstable, .. } = made;
        let ratio = options.target_iterations as f64 / converged.iterations.max(1) as f64;
        stepper.accept(system, &saved, converged.level, increment);
        // On a path that is only looked at, what `restore` takes back is committed: the history of steps, but no work on bonds.
        if kept == Keep::Yes || system.tangent_is_of_the_step() {
            stepper.newton.keep(system);
        }
        path.restart = stepper.restart();
        let mut effort = stepper.newton.effort.since(&spent);
        spent = stepper.newton.effort;
        let mut point = Point { step, converged, size: size_made, restarts, unstable, effort };
        loop {
            let stop = observer(&point, stepper.last.as_ref(), system);
            path.points.push(point);
            if stop.is_break() {
                return Ok(End::Stopped);
            }
            let gone = if kept == Keep::Yes { stepper.give_way(system)? } else { None };
            let Some((converged, unstable, breach)) = gone else { break };
            stepper.newton.keep(system);
            path.breaches.push(breach);
            path.restart = stepper.restart();
            effort = stepper.newton.effort.since(&spent);
            spent = stepper.newton.effort;
            point = Point { step, converged, size: 0.0, restarts: 0, unstable, effort };
        }
        if bound || reached(travelled, stepper.level, first, &options.control) {
            return Ok(End::Reached);
        }
        // A step that ended where a limit is met says nothing of what the next one may be.
        let base = if limit.cuts() { asked } else { size };
        size = (base * ratio.sqrt().clamp(0.5, 2.0)).min(options.largest * first);
    }
    Ok(End::Steps)
}

/// Whether Newton may have strayed to another branch and a smaller step is to be tried, while it is not yet small: a load
/// step after which several more pivots are negative, since critical points are passed one at a time but for symmetry;
/// an arc far from its tangents.
fn strayed(made: &StepOutcome, path: &Path, size: f64, first: f64, control: &Control) -> bool {
    let before = path.points.last().map_or(0, |point| point.inertia().negative);
    let load = matches!(control, Control::Load { .. });
    let several = load && made.converged.inertia.negative > before + 1 && size > STRAY * first;
    // Arcs that turn back or leave their branch are halved; load and displacement go where they are prescribed.
    let arc = matches!(control, Control::ArcLength { .. });
    several || arc && made.strays && size > FINE * first
}

/// Makes one step; an arc that leaves the range of levels is replaced by a step to the bound.
fn step_within<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    saved: &[f64],
    size: f64,
    control: &Control,
) -> Result<(StepOutcome, bool), EquilibriumError> {
    let made = stepper.advance(system, size)?;
    let Control::ArcLength { range: (low, high), .. } = *control else {
        return Ok((made, false));
    };
    let bound = made.converged.level.clamp(low, high);
    if bound == made.converged.level || made.strays {
        return Ok((made, false)); // one that strayed is made again
    }
    let beyond = system.save();
    stepper.newton.go_back(system, saved);
    match stepper.reach_level(system, bound, &made.increment) {
        Ok(short) => Ok((short, true)),
        Err(_) => {
            stepper.newton.go_back(system, &beyond);
            Ok((made, true))
        }
    }
}

fn clip(size: f64, travelled: f64, level: f64, control: &Control) -> f64 {
    match control {
        Control::Load { until, .. } => size.min((until - level).abs()),
        Control::Displacement { until, .. } => size.min(until.abs() - travelled),
        Control::ArcLength { .. } => size,
    }
}

fn reached(travelled: f64, level: f64, first: f64, control: &Control) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * first;
    match control {
        Control::Load { until, .. } => near(level, *until),
        Control::Displacement { until, .. } => near(travelled, until.abs()),
        Control::ArcLength { range, .. } => level <= range.0 || level >= range.1,
    }
}

/// Looks at a step that is kept, from `saved` to the present state: for critical points where the number of negative
/// pivots changes, and for a change of branch where its tangents do not explain it.
fn look_for_critical<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    (saved, made, size): (&[f64], &StepOutcome, f64),
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
            Leads::BySteps(share) => Some(Passed::Steps(share)),
            Leads::Elsewhere => Some(Passed::Branch),
            Leads::Unknown => Some(Passed::Unproved),
        };
        // What lies on the branch that was left is reported, with the step that left it; pairs that cancel as well.
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

/// Where the branch of an equilibrium goes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Leads {
    /// To the state that the step found.
    There,
    /// Back, before the end of the step, from about this level.
    Back(f64),
    /// To the end of the step, so much of the way beside: the system remembers the steps it was brought there in.
    BySteps(f64),
    /// To the end of the step, in another state.
    Elsewhere,
    /// It could not be followed that far.
    Unknown,
}

/// What was met on the branch.
struct Traced {
    leads: Leads,
    critical: Vec<CriticalPoint>,
    passages: Vec<Passage>,
}

/// Follows the branch through the present state, which balances `level`, to the end of the step `made`; `found` is the
/// state that the step found, `linear` the change of level of the linear answer to it. The state of the system is left elsewhere.
fn trace<E: Equilibrium + ?Sized>(
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
    let start = Start { level, ..Start::default() };
    let mut path = Path::new(&start);
    let mut turned = false;
    let Ok(mut newton) = Newton::new(system, &options.newton) else {
        return Traced { leads: Leads::Unknown, critical: Vec::new(), passages: Vec::new() };
    };
    let end = march(&mut newton, system, (&start, Keep::No), &arc, &mut path, &mut |point, step, _| {
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
        Ok(End::Stopped) => match land(&mut newton, system, &path.restart, target - done, options) {
            Ok(()) => match apart(system, found, &made.motion, &begun) {
                share if share > BY_STEPS || share > SAME && !system.tangent_is_of_the_step() => {
                    Leads::Elsewhere
                }
                share if share > SAME => Leads::BySteps(share),
                _ => Leads::There,
            },
            Err(_) => Leads::Unknown,
        },
        _ => Leads::Unknown,
    };
    Traced { leads, critical: path.critical, passages: path.passages }
}

/// Goes the rest of the way from a point just beyond the end of the step.
fn land<E: Equilibrium + ?Sized>(
    newton: &mut Newton,
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
    let start = Start { level: from.level, ..Start::default() };
    march(newton, system, (&start, Keep::No), &short, &mut Path::new(&start), &mut |_, _, _| {
        ControlFlow::Continue(())
    })
    .map(|_| ())
}
