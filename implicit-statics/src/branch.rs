//! Branches that leave a bifurcation: when a path goes over to one, and the first point on it.

use crate::newton::Constraint;
use crate::options::{Branches, Control, NewtonOptions};
use crate::path::{CriticalKind, CriticalPoint, Path, Start};
use crate::stepper::{StepOutcome, Stepper, arc_weights};
use crate::vectors::{dot, sign_of_greatest};
use crate::{Converged, Equilibrium, EquilibriumError, Increment, Newton};

/// Part of the first step along a branch that may lie beside the mode: more, and it is another branch.
const BESIDE: f64 = 0.5;
/// First steps along a branch that are tried, each half of the one before, until one is found.
const HALVES: i32 = 10;
/// How many times it is doubled at most: slender columns bend a million times as far as they are pressed.
const DOUBLES: i32 = 40;

/// Whether a path is left at a critical point: a bifurcation in which a stable path loses its stability, in one mode.
pub(crate) fn leaves(branches: Branches, point: &CriticalPoint) -> bool {
    branches != Branches::Primary && point.kind == CriticalKind::Bifurcation && point.negative == (0, 1)
}

/// Goes over to the branch that leaves the bifurcation of the step just made, of the given arc length, if the path is left there;
/// the first step on it. The system then stands on the branch, or after a failure in the saved state where the step began.
///
/// The first step is as long as the one that passed the bifurcation, or doubled until it changes the level by `Δλ₀²/λ_c`, Δλ₀ the first
/// change of level of the path: on a branch whose level goes by the square of the amplitude it is the same part of the amplitude that doubles the
/// level as Δλ₀ is of the level.
///
/// # Errors
/// [`EquilibriumError::NoBranch`] where no first step finds an equilibrium beside the path.
pub(crate) fn take_branch<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    path: &mut Path,
    (saved, size, control): (&[f64], f64, &Control),
    branches: Branches,
) -> Result<Option<StepOutcome>, EquilibriumError> {
    let Control::ArcLength { first, range } = *control else { return Ok(None) };
    let last = path.critical.last_mut().filter(|point| point.step == stepper.newton.step);
    let Some(point) = last.filter(|point| leaves(branches, point)) else { return Ok(None) };
    let side = if branches == Branches::StableReversed { -1.0 } else { 1.0 };
    let unit = stepper.length(&Increment { motion: point.mode.clone(), level: 0.0 });
    let mut amplitude = side * sign(&arc_weights(system), &point.mode) * size / unit;
    let mut found = try_aside(stepper, system, point, (amplitude, range));
    for _ in 0..HALVES {
        if found.is_ok() {
            break;
        }
        amplitude *= 0.5;
        found = try_aside(stepper, system, point, (amplitude, range));
    }
    let mut made = match found {
        Ok(made) => made,
        Err(cause) => {
            stepper.newton.go_back(system, saved);
            return Err(EquilibriumError::NoBranch { step: point.step, level: point.level, cause });
        }
    };
    let asked = first * first / point.level.abs().max(first.abs());
    let mut state = system.save();
    for _ in 0..DOUBLES {
        if (made.converged.level - point.level).abs() >= asked {
            break;
        }
        amplitude *= 2.0;
        let Ok(farther) = try_aside(stepper, system, point, (amplitude, range)) else { break };
        (made, state) = (farther, system.save());
    }
    stepper.newton.go_back(system, &state);
    point.left = true;
    Ok(Some(made))
}

/// A step aside that ends on the branch within the range of levels; else why not, if Newton's method tells.
fn try_aside<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    point: &CriticalPoint,
    (amplitude, range): (f64, (f64, f64)),
) -> Result<StepOutcome, Option<Box<EquilibriumError>>> {
    let (converged, increment) =
        step_aside(stepper.newton, system, point, amplitude).map_err(|cause| Some(Box::new(cause)))?;
    let motion = increment.motion.iter().zip(&point.mode).map(|(q, m)| q - amplitude * m).collect();
    let beside = Increment { motion, level: increment.level };
    let near = stepper.length(&beside) <= BESIDE * stepper.length(&increment);
    if !near || !(range.0..=range.1).contains(&converged.level) {
        return Err(None);
    }
    let (unstable, predicted) = (converged.inertia.negative, increment.level);
    Ok(StepOutcome { converged, increment, strays: false, unstable, predicted })
}

/// Leaves a bifurcation along its mode: from its state, moves `amplitude` times the mode and finds the
/// equilibrium and level with that much of the mode in the motion \[wagner1988\].
///
/// The system then stands on the branch, from which the returned start continues by arc length. The sign of
/// the amplitude chooses the side. A small amplitude may be lost in rounding: a thousandth of a typical size
/// of the structure is a good first choice. [`Branches`] has a path do this by itself.
///
/// # Errors
/// What [`Newton`] meets; the state is then that at the near end of the bracket.
pub fn switch_branch<E: Equilibrium + ?Sized>(
    system: &mut E,
    point: &CriticalPoint,
    amplitude: f64,
    options: &NewtonOptions,
) -> Result<Start, EquilibriumError> {
    let mut newton = Newton::new(system, options)?;
    newton.step = point.step;
    match step_aside(&mut newton, system, point, amplitude) {
        Ok((converged, increment)) => {
            system.commit();
            Ok(Start { level: converged.level, heading: Some(increment), stiffness: None })
        }
        Err(error) => {
            newton.go_back(system, &point.state);
            Err(error)
        }
    }
}

/// The equilibrium with `amplitude` times the mode φ in its motion from the near end of the bracket, `φ·MΔq = amplitude φ·Mφ`.
fn step_aside<E: Equilibrium + ?Sized>(
    newton: &mut Newton,
    system: &mut E,
    point: &CriticalPoint,
    amplitude: f64,
) -> Result<(Converged, Increment), EquilibriumError> {
    newton.go_back(system, &point.state);
    let motion: Vec<f64> = point.mode.iter().map(|m| amplitude * m).collect();
    let momenta: Vec<f64> = point.mode.iter().zip(arc_weights(system)).map(|(m, w)| w * m).collect();
    let square = dot(&momenta, &point.mode);
    let weights: Vec<f64> = momenta.iter().map(|m| m / square).collect();
    let mut increment = Increment { motion, level: point.level - point.state_level };
    newton.advance(system, &increment.motion);
    let constraint = Constraint::Functional { weights: &weights, target: amplitude };
    let converged = newton.correct(system, point.level, &mut increment, &constraint, false)?;
    Ok((converged, increment))
}

/// The sign of the first of the greatest entries of a mode, each times the root of its mass, and so the same in any unit.
fn sign(weights: &[f64], mode: &[f64]) -> f64 {
    sign_of_greatest(mode.iter().zip(weights).map(|(q, w)| q * w.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::sign;

    #[test]
    fn the_side_is_the_same_in_any_unit() {
        // A rotation in another unit of length: its mass goes by the square of that.
        assert_eq!(sign(&[9.0, 1.0, 1e-4], &[-1.0, 0.5, 100.0]), -1.0);
        assert_eq!(sign(&[9.0, 1.0, 1.0], &[-1.0, 0.5, 1.0]), -1.0);
    }
}
