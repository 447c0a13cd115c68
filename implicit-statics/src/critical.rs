//! Critical points: located between converged points, and distinguished.

use crate::branch::leaves;
use crate::options::CriticalOptions;
use crate::path::{CriticalKind, CriticalPoint, Passage, Passed};
use crate::stepper::Stepper;
use crate::vectors::dot;
use crate::{Converged, Equilibrium, EquilibriumError, Newton};

/// Where a bracket is cut: in its middle, or elsewhere if no equilibrium is found there.
const PARTS: [f64; 5] = [0.5, 0.37, 0.63, 0.21, 0.79];
/// Distance of a cut from where the eigenvalue is expected to vanish, in widths of the last bracket: cuts on both sides end it.
const ASIDE: f64 = 0.4;
/// Cuts in a row that leave more than half of the bracket after which its middle is taken.
const SLOW: usize = 2;

/// One end of a bracket.
#[derive(Clone)]
struct Edge {
    size: f64,
    level: f64,
    negative: usize,
    state: Vec<f64>,
    /// The eigenvalue of least magnitude of the scaled tangent, where it was found.
    weakest: f64,
}

/// Every change of the number of negative pivots within one step of the given size, by bisection of the size, a bracket
/// where that fails; up to the bifurcation at which the path is left, if it is.
///
/// The state stands where the step begins and is left elsewhere; `converged` and `state` are its end. Pairs of changes
/// that cancel within one step are not seen.
pub(crate) fn locate_all<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    (converged, state): (&Converged, &[f64]),
    negative: usize,
    size: f64,
    options: &CriticalOptions,
) -> (Vec<CriticalPoint>, Vec<Passage>) {
    let saved = system.save();
    let last = Edge {
        size,
        level: converged.level,
        negative: converged.inertia.negative,
        state: state.into(),
        weakest: f64::NAN,
    };
    let mut low = Edge { size: 0.0, level: stepper.level, negative, state: saved.clone(), weakest: f64::NAN };
    let (mut found, mut passages) = (Vec::new(), Vec::new());
    while low.negative != last.negative {
        let high = narrow(stepper, system, &saved, &mut low, &last, options.tolerance * size);
        let narrowed = high.size - low.size <= options.tolerance * size;
        let point = if narrowed { tell(stepper, system, &low, &high, options).ok() } else { None };
        match point {
            Some(point) => {
                let left = leaves(options.branches, &point);
                found.push(point);
                if left {
                    break;
                }
            }
            None => passages.push(Passage {
                step: stepper.newton.step,
                levels: (low.level, high.level),
                negative: (low.negative, high.negative),
                what: Passed::Pivots,
            }),
        }
        low = high;
    }
    (found, passages)
}

/// Cuts towards the first change of the number of negative pivots between `low`, which moves, and `last`, until the
/// bracket is as wide as `width`, or no trial within it is an equilibrium of this branch; the upper end.
///
/// Cuts are made beside the place where the line through the weakest eigenvalues of the last two trials vanishes, on the side
/// of the farther end, and in the middle as long as that does not narrow the bracket.
fn narrow<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    saved: &[f64],
    low: &mut Edge,
    last: &Edge,
    width: f64,
) -> Edge {
    let mut high = last.clone();
    let (mut before, mut latest) = ((f64::NAN, f64::NAN), (f64::NAN, f64::NAN));
    let mut slow = 0;
    while high.size - low.size > width {
        let wide = high.size - low.size;
        let between = |part: f64| low.size + part * wide;
        let ((s, e), (t, f)) = (before, latest);
        let vanishes = t - f * (t - s) / (f - e);
        let aside = if vanishes < between(0.5) { ASIDE * width } else { -ASIDE * width };
        let cut = Some(vanishes + aside).filter(|cut| slow < SLOW && low.size < *cut && *cut < high.size);
        let mut trials = cut.into_iter().chain(PARTS.into_iter().map(between));
        let Some(middle) = trials.find_map(|trial| probe(stepper, system, saved, trial).ok().flatten())
        else {
            break;
        };
        (before, latest) = (latest, (middle.size, middle.weakest));
        let left =
            if middle.negative == low.negative { high.size - middle.size } else { middle.size - low.size };
        slow = if left > 0.5 * wide && slow < SLOW { slow + 1 } else { 0 };
        if middle.negative == low.negative {
            *low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// What kind of critical point lies in a narrow bracket, and where.
fn tell<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    low: &Edge,
    high: &Edge,
    options: &CriticalOptions,
) -> Result<CriticalPoint, EquilibriumError> {
    stepper.newton.go_back(system, &low.state);
    stepper.newton.tangent(system, low.level)?;
    let mode = stepper.newton.solver.weakest_direction();
    let below = stepper.newton.solver.quadratic(&mode);
    let participation = participation(stepper.newton, system, low.level, &mode);
    stepper.newton.go_back(system, &high.state);
    stepper.newton.tangent(system, high.level)?;
    let above = stepper.newton.solver.quadratic(&mode);
    let share = below / (below - above);
    let share = if (0.0..=1.0).contains(&share) { share } else { 0.5 };
    let level = low.level + share * (high.level - low.level);
    let kind =
        if participation > options.participation { CriticalKind::Limit } else { CriticalKind::Bifurcation };
    let largest = mode.iter().fold(0.0, |best: f64, &m| if m.abs() > best.abs() { m } else { best });
    let point = CriticalPoint {
        step: stepper.newton.step,
        level,
        kind,
        participation,
        mode: mode.iter().map(|m| m / largest).collect(),
        negative: (low.negative, high.negative),
        state: low.state.clone(),
        state_level: low.level,
        left: false,
    };
    Ok(point)
}

/// The equilibrium of a step of another size; none if it lies on another branch.
fn probe<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    saved: &[f64],
    size: f64,
) -> Result<Option<Edge>, EquilibriumError> {
    stepper.newton.go_back(system, saved);
    let made = stepper.advance(system, size)?;
    if made.strays {
        return Ok(None);
    }
    let (level, negative) = (made.converged.level, made.converged.inertia.negative);
    // The comparison with the tangents, where it was made, has left the factor of this state.
    stepper.newton.tangent(system, level)?;
    let mode = stepper.newton.solver.weakest_direction();
    let weakest = stepper.newton.solver.quadratic(&mode);
    Ok(Some(Edge { size, level, negative, state: system.save(), weakest }))
}

/// Share of the load in a mode at the state whose tangent was factorised last.
fn participation<E: Equilibrium + ?Sized>(newton: &Newton, system: &mut E, level: f64, mode: &[f64]) -> f64 {
    let mut rate = vec![0.0; mode.len()];
    system.load_rate(level, &mut rate);
    let scale = newton.solver.scale();
    let load: f64 = (0..mode.len()).map(|i| (rate[i] * scale[i]).powi(2)).sum();
    let motion: f64 = (0..mode.len()).map(|i| (mode[i] / scale[i]).powi(2)).sum();
    if load > 0.0 { dot(&rate, mode).abs() / (load * motion).sqrt() } else { 0.0 }
}
