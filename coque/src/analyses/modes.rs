//! Analyses that give modes: free vibration and linearised buckling of the unloaded shell.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use implicit_statics::{
    BucklingOptions, Counted, Effort, Equilibrium, EquilibriumError, Prebuckling, Sign, Spectrum,
    linear_buckling, natural_modes,
};
use sph_core::Vec3;
use sph_shell::{Shell, StaticShell};

use crate::analyses::march::reference_step;
use crate::results::summary::CountSummary;
use crate::run::{Ended, Failure, Findings, Progress, ProgressReport};
use crate::scene::{self, Buckling, LevelSign};
use crate::{Doubt, Warning};

/// Largest displacement of a shape of free size in units of the extent.
const SCALE: f64 = 0.1;
/// Shifts below zero where rigid motions are free, in units of the largest ω², the next where the one before does not
/// converge: bending of a thin shell is some 1e-8 of that. A smaller shift tells modes better apart; rounding, 1e-16 over the
/// shift, puts rigid motions into every solve, and a larger shift keeps more digits.
const SHIFTS: [f64; 3] = [1e-8, 1e-6, 1e-10];

/// Finds the lowest modes of vibration.
pub(crate) fn modal(count: usize, mut shell: Shell, found: &mut Findings<'_>, progress: &mut dyn Progress) {
    found.stable_step = reference_step(&mut shell);
    let fastest = 2.0 / found.stable_step;
    let mut system = StaticShell::new(shell);
    let mut watch = watch(progress);
    let mut spectrum = natural_modes(&mut system, 0.0, count, 0.0, &mut watch);
    if matches!(spectrum, Err(EquilibriumError::Mechanism { .. } | EquilibriumError::Singular { .. })) {
        for shift in SHIFTS {
            spectrum = natural_modes(&mut system, 0.0, count, -shift * fastest * fastest, &mut watch);
            if !matches!(spectrum, Err(EquilibriumError::Modes { .. })) {
                break;
            }
        }
    }
    let Some(modes) = taken(spectrum, count, "frequencies squared", found) else { return };
    for (number, mode) in modes.iter().enumerate() {
        let omega = mode.circular_frequency();
        found.curve.rows.push(vec![number as f64 + 1.0, omega, omega / TAU, mode.residual]);
        if keep(&mut system, &mode.shape, omega / TAU, found).is_break() {
            return;
        }
    }
}

/// Finds the buckling levels nearest to zero.
pub(crate) fn buckling(
    wanted: &Buckling,
    shell: Shell,
    found: &mut Findings<'_>,
    progress: &mut dyn Progress,
) {
    let mut system = StaticShell::new(shell);
    found.warn_of_skew_loads(&system);
    let options = BucklingOptions {
        count: wanted.modes,
        sign: match wanted.sign {
            LevelSign::Positive => Sign::Positive,
            LevelSign::Negative => Sign::Negative,
            LevelSign::Either => Sign::Either,
        },
        prebuckling: match wanted.prebuckling {
            scene::Prebuckling::Rotations => Prebuckling::Rotations,
            scene::Prebuckling::Stress => Prebuckling::Stress,
        },
    };
    let spectrum = linear_buckling(&mut system, 0.0, &options, &mut watch(progress));
    let Some(modes) = taken(spectrum, wanted.modes, "levels", found) else { return };
    for (number, mode) in modes.iter().enumerate() {
        found.curve.rows.push(vec![number as f64 + 1.0, mode.level, mode.residual]);
        if keep(&mut system, &mode.shape, mode.level, found).is_break() {
            return;
        }
    }
}

/// Asks the progress between two solves whether to go on.
fn watch(progress: &mut dyn Progress) -> impl FnMut(&Effort) -> ControlFlow<()> + '_ {
    |effort| progress.update(&ProgressReport { steps: effort.solves as u64, ..ProgressReport::default() })
}

/// The modes of a spectrum, with its count and a warning if there are fewer than wanted; none where it failed.
fn taken<M>(
    spectrum: Result<Spectrum<M>, EquilibriumError>,
    wanted: usize,
    what: &str,
    found: &mut Findings<'_>,
) -> Option<Vec<M>> {
    let Spectrum { modes, counted, effort } = match spectrum {
        Ok(spectrum) => spectrum,
        Err(EquilibriumError::Stopped { .. }) => {
            found.ended = Ended::Interrupted { time: 0.0, level: 0.0 };
            return None;
        }
        Err(cause) => {
            found.ended = Ended::Diverged(Failure::Balance { points: 0, level: 0.0, cause, unit: None });
            return None;
        }
    };
    let Counted { from, to, number } = counted;
    if modes.len() < wanted {
        let message = format!(
            "{} of {wanted} modes: inertia counts no more {what} from {from:.3e} to {to:.3e}; ask for fewer `modes`",
            modes.len()
        );
        found.warnings.push(Warning::new(Doubt::FewerModes, message));
    }
    found.counted = Some(CountSummary {
        from: from.is_finite().then_some(from),
        to,
        number,
        factorisations: effort.factorisations,
        solves: effort.solves,
    });
    Some(modes)
}

/// Counts a mode, keeps its shape about the unloaded one and offers it as a frame, scaled for the eye.
fn keep(system: &mut StaticShell, mode: &[f64], level: f64, found: &mut Findings<'_>) -> ControlFlow<()> {
    let factor = keep_shape(system, mode, level, found);
    show(system, &scaled(mode, factor), level, found)
}

/// Counts a mode or a linear answer and keeps its shape about the unloaded one; returns the factor on its motion there.
pub(crate) fn keep_shape(
    system: &mut StaticShell,
    mode: &[f64],
    level: f64,
    found: &mut Findings<'_>,
) -> f64 {
    let rest = system.save();
    system.update(mode);
    let shell = system.shell();
    let motion: Vec<Vec3> = (0..shell.len()).map(|a| shell.displacement(a)).collect();
    system.restore(&rest);
    let start = &system.shell().reference().cloud.positions;
    let corner = |pick: fn(f64, f64) -> f64| start.iter().copied().reduce(|a, b| a.zip_map(&b, pick));
    let (low, high) = (corner(f64::min).unwrap_or_default(), corner(f64::max).unwrap_or_default());
    let largest = motion.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let factor = if largest > 0.0 { SCALE * (high - low).norm() / largest } else { 0.0 };
    let positions = start.iter().zip(&motion).map(|(x, u)| x + u * factor).collect();
    found.steps += 1;
    found.keep_positions(positions, 0.0, level);
    factor
}

/// Offers the shell moved by `motion` as a frame, if frames are wanted, and moves it back.
fn show(system: &mut StaticShell, motion: &[f64], level: f64, found: &mut Findings<'_>) -> ControlFlow<()> {
    let Some(frames) = &mut found.frames else { return ControlFlow::Continue(()) };
    let rest = system.save();
    system.update(motion);
    let flow = frames.offer(system.shell(), 0.0, level);
    system.restore(&rest);
    flow
}

/// A motion times a factor.
pub(crate) fn scaled(motion: &[f64], factor: f64) -> Vec<f64> {
    motion.iter().map(|q| factor * q).collect()
}
