//! Analyses that give modes: free vibration and linearised buckling, of the unloaded or the preloaded body.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use implicit_statics::{
    AddedMass, BucklingMode, BucklingOptions, Counted, Effort, EquilibriumError, Mode, Prebuckling, Sign,
    Spectrum, linear_buckling, natural_modes, natural_modes_with,
};
use sph_core::Vec3;

use super::frozen::{of_buckling, of_vibration};
use crate::WarningKind;
use crate::bodies::{InStillWater, StaticBody, extent};
use crate::run::Run;
use crate::run::outcome::Ended;
use crate::run::progress::ProgressReport;
use crate::run::record::CountSummary;
use crate::scene::Buckling;

/// Largest displacement of a shape of free size in units of the extent.
const SCALE: f64 = 0.1;
/// Shifts below zero where rigid motions are free, in units of the largest ω², the next where the one before does not
/// converge: bending of a thin shell is some 1e-8 of that. A smaller shift tells modes better apart; rounding, 1e-16 over the
/// shift, puts rigid motions into every solve, and a larger shift keeps more digits.
const SHIFTS: [f64; 3] = [1e-8, 1e-6, 1e-10];
/// Part of the greatest ω² below which an ω² is zero, a rigid motion that springs leave free: they come out as 1e-14 of it on either side of
/// zero, and the least bending of a thin shell is some 1e-8.
const ROUNDED: f64 = 1e-12;
/// Part of the square of a frequency that gravity may add or take before that is said: 1 % of the frequency.
const WAVES: f64 = 0.02;
/// Relative difference of a mode's level by the two linearisations beyond which the change of shape before buckling counts: a
/// clamped cap has .18 and its path ends a fifth below the level, plates, columns and deep beams have .004 at most.
const CHANGED: f64 = 0.1;
/// Displacement before buckling over the least extent beyond which a level linearised in fixed directions is doubtful: a bar of 2×1×1
/// under a transverse force "buckles" when it has moved by .2, a column of ten widths by .02.
const MOVED: f64 = 0.05;

/// Finds the lowest modes of vibration.
pub(crate) fn modal(
    count: usize,
    mut water: Option<&mut Box<InStillWater>>,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Ended {
    let Vibration { modes, unstable, .. } =
        match vibration_in(count, water.as_deref_mut().map(|water| &mut water.added), system, run) {
            Ok(found) => found,
            Err(ended) => return *ended,
        };
    if let Some(message) = water.and_then(|water| making_waves(&modes, water)) {
        run.record.warn(WarningKind::SurfaceWaves, message);
    }
    if unstable > 0 {
        let message = format!(
            "the state that vibrates is not stable: of the modes found {unstable} have a square of the frequency below zero, least {:.3e}, and \
             stand in the curve with the frequency 0; lower the stress or the preload, or look for the critical one with [analysis.buckling]",
            modes.iter().map(|mode| mode.eigenvalue).fold(0.0, f64::min)
        );
        run.record.warn(WarningKind::Unstable, message);
    }
    let shapes: Vec<&[f64]> = modes.iter().map(|mode| &mode.shape[..]).collect();
    if let Some(message) = of_vibration(system, &shapes) {
        run.record.warn(WarningKind::FrozenContact, message);
    }
    for (number, mode) in modes.iter().enumerate() {
        let omega = mode.circular_frequency();
        run.curve.rows.push(vec![number as f64 + 1.0, omega, omega / TAU, mode.residual]);
        if keep(system, &mode.shape, omega / TAU, run).is_break() {
            break;
        }
    }
    Ended::Done
}

/// The lowest modes of vibration about a state.
pub(super) struct Vibration {
    pub modes: Vec<Mode>,
    /// The shift about which they were found \[1/T²\]: zero, or below where rigid motions are free.
    pub shift: f64,
    /// How many have a square of the frequency below zero, where all rigid motions are held.
    pub unstable: usize,
}

/// The lowest modes of vibration about the present state.
///
/// # Errors
/// How the run ends where they are not found.
pub(super) fn vibration(
    count: usize,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Result<Vibration, Box<Ended>> {
    vibration_in(count, None, system, run)
}

/// The same with the mass that a medium adds.
fn vibration_in(
    count: usize,
    mut added: Option<&mut AddedMass>,
    system: &mut dyn StaticBody,
    run: &mut Run<'_>,
) -> Result<Vibration, Box<Ended>> {
    run.record.stable_step = system.stable_step();
    freeze_contact(system, run);
    if run.record.preload.is_some() {
        run.record.warnings.extend(system.doubtful_modes(count));
    }
    let fastest = 2.0 / run.record.stable_step;
    let (mut watch, mut shift) = (watch(run), 0.0);
    let mut find = |system: &mut dyn StaticBody, shift: f64| match &mut added {
        Some(added) => natural_modes_with(system, 0.0, added, (count, shift), &mut watch),
        None => natural_modes(system, 0.0, count, shift, &mut watch),
    };
    let mut spectrum = find(system, 0.0);
    let floats =
        matches!(spectrum, Err(EquilibriumError::Mechanism { .. } | EquilibriumError::Singular { .. }));
    if floats {
        for below in SHIFTS {
            shift = -below * fastest * fastest;
            spectrum = find(system, shift);
            if !matches!(spectrum, Err(EquilibriumError::Modes { .. })) {
                break;
            }
        }
    }
    drop(watch);
    let modes = taken(spectrum, count, "frequencies squared", run)?;
    let unstable = if floats { 0 } else { below_zero(modes.iter().map(|mode| mode.eigenvalue), fastest) };
    Ok(Vibration { modes, shift, unstable })
}

/// What is doubtful about modes in still water that gravity has a part in.
fn making_waves(modes: &[Mode], water: &mut InStillWater) -> Option<String> {
    let mut most: Option<(usize, f64)> = None;
    let mut numbers = Vec::new();
    for (number, mode) in modes.iter().enumerate().filter(|(_, mode)| mode.eigenvalue > 0.0) {
        let share = water.share_of_gravity(&mode.shape, mode.eigenvalue).ok()?;
        if share.abs() > WAVES {
            numbers.push((number + 1).to_string());
            if most.is_none_or(|(_, greatest)| share.abs() > f64::abs(greatest)) {
                most = Some((number + 1, share));
            }
        }
    }
    let (number, share) = most?;
    let what = if share.abs() >= 1.0 {
        format!(
            "mode {number} swings by gravity as much as by the stiffness of the shell: its frequency here is none of it"
        )
    } else {
        let way = if share > 0.0 { "higher" } else { "lower" };
        format!(
            "that of mode {number} may be {:.1} % {way}, or mixed with that of the waves",
            50.0 * share.abs()
        )
    };
    Some(format!(
        "modes in still water leave out gravity, on waves of its free surface and on faces that move in its pressure at rest; it has more than {WAVES} of \
         the energy of modes {}: {what}. March it by [analysis.explicit.transient]",
        numbers.join(", "),
    ))
}

/// Freezes what touches as the preload left it, and notes what that is.
fn freeze_contact(system: &mut dyn StaticBody, run: &mut Run<'_>) {
    system.freeze_contact(0.0);
    run.contact.note(&*system, [0.0, 0.0], &mut run.record);
}

/// How many squares of frequencies are below zero by more than rounding puts there; `fastest` is the greatest frequency \[1/T\].
fn below_zero(squares: impl Iterator<Item = f64>, fastest: f64) -> usize {
    squares.filter(|&square| square < -ROUNDED * fastest * fastest).count()
}

/// Finds the buckling levels nearest to zero.
pub(crate) fn buckling(wanted: &Buckling, system: &mut dyn StaticBody, run: &mut Run<'_>) -> Ended {
    run.warn_of_skew_loads(system.skew_load_share());
    freeze_contact(system, run);
    let options =
        BucklingOptions { count: wanted.modes.get(), sign: wanted.sign, prebuckling: wanted.prebuckling };
    let spectrum = linear_buckling(system, 0.0, &options, &mut watch(run));
    let modes = match taken(spectrum, wanted.modes.get(), "levels", run) {
        Ok(modes) => modes,
        Err(ended) => return *ended,
    };
    let counted = run.record.counted.as_ref();
    let side =
        counted.and_then(|counted| match (counted.from.is_some_and(|from| from < 0.0), counted.to > 0.0) {
            (true, true) => None,
            (below, _) => Some(if below { "positive" } else { "negative" }),
        });
    if let (Sign::Either, Some(side)) = (wanted.sign, side) {
        let message = format!(
            "{side} levels were not found to within rounding, and none is in the curve, though one may be nearer than those that are; ask \
             for fewer `modes`, or for sign = \"{side}\" alone to see what ended the search"
        );
        run.record.warn(WarningKind::FewerModes, message);
    }
    if let Some(message) =
        modes.first().and_then(|lowest| changed_shape(lowest, options.prebuckling, system.linear_reach()))
    {
        run.record.warn(WarningKind::ChangedShape, message);
    }
    if let Some(message) = of_buckling(system, &modes) {
        run.record.warn(WarningKind::FrozenContact, message);
    }
    for (number, mode) in modes.iter().enumerate() {
        run.curve.rows.push(vec![number as f64 + 1.0, mode.level, mode.residual]);
        if keep(system, &mode.shape, mode.level, run).is_break() {
            break;
        }
    }
    Ended::Done
}

/// What is doubtful about a level that hangs on the linearisation; `reach` the least extent of the body.
fn changed_shape(mode: &BucklingMode, kind: Prebuckling, reach: f64) -> Option<String> {
    let BucklingMode { level, otherwise, .. } = *mode;
    let before = mode.before.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    let Some(otherwise) = otherwise else {
        return (before > MOVED * reach).then(|| {
            format!(
                "the body moves by {before:.4} before it buckles at {level:.4}, more than {MOVED} times its least extent of \
                 {reach:.4}: the level is linearised in directions that do not turn with it, and may be far too low. Follow the \
                 path, by [analysis.arc-length] or by levels of [analysis.static]"
            )
        });
    };
    if (otherwise / level - 1.0).abs() <= CHANGED {
        return None;
    }
    let [here, there] = match kind {
        Prebuckling::Rotations => ["the change of shape before buckling", "the stresses alone"],
        Prebuckling::Stress => ["the stresses alone", "the change of shape before buckling"],
    };
    Some(format!(
        "the level {level:.4} counts {here}; the same mode with {there} has {otherwise:.4}: the structure changes its shape \
         before it buckles, and may do so at another level or not at all. Follow its path, by [analysis.arc-length] or by levels \
         of [analysis.static]"
    ))
}

/// Asks the progress between two solves whether to go on.
pub(super) fn watch<'a>(run: &'a mut Run<'_>) -> impl FnMut(&Effort) -> ControlFlow<()> + 'a {
    |effort| run.update(&ProgressReport { steps: effort.solves as u64, ..ProgressReport::default() })
}

/// The modes of a spectrum, with its count and a warning if there are fewer than wanted.
///
/// # Errors
/// How the run ends where there are none.
fn taken<M>(
    spectrum: Result<Spectrum<M>, EquilibriumError>,
    wanted: usize,
    what: &str,
    run: &mut Run<'_>,
) -> Result<Vec<M>, Box<Ended>> {
    let Spectrum { modes, counted, effort } = spectrum.map_err(|cause| {
        Box::new(match cause {
            EquilibriumError::Stopped { .. } => Ended::Interrupted { time: 0.0, level: 0.0 },
            cause => run.unbalanced(0, 0.0, cause),
        })
    })?;
    let Counted { from, to, number } = counted;
    if modes.len() < wanted {
        let message = format!(
            "{} of {wanted} modes: inertia counts no more {what} from {from:.3e} to {to:.3e}; ask for fewer `modes`",
            modes.len()
        );
        run.record.warn(WarningKind::FewerModes, message);
    }
    run.record.counted = Some(CountSummary {
        from: from.is_finite().then_some(from),
        to,
        number,
        factorisations: effort.factorisations,
        solves: effort.solves,
    });
    Ok(modes)
}

/// Counts a mode, keeps its shape about the state that vibrates or buckles and offers it as a frame, scaled for the eye.
pub(super) fn keep(
    system: &mut dyn StaticBody,
    mode: &[f64],
    level: f64,
    run: &mut Run<'_>,
) -> ControlFlow<()> {
    let rest = system.save();
    let start = system.configuration().present;
    system.update(mode);
    let factor = keep_enlarged(&start, &system.configuration().present, level, run);
    system.restore(&rest);
    if run.frames.is_none() {
        return ControlFlow::Continue(());
    }
    system.update(&scaled(mode, factor));
    let flow = run.offer(system, 0.0, level);
    system.restore(&rest);
    flow
}

/// Counts a mode or a linear answer and keeps its shape, enlarged for the eye; returns the factor on its motion.
pub(crate) fn keep_enlarged(start: &[Vec3], present: &[Vec3], level: f64, run: &mut Run<'_>) -> f64 {
    let motion: Vec<Vec3> = start.iter().zip(present).map(|(from, to)| to - from).collect();
    let largest = motion.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let factor = if largest > 0.0 { SCALE * extent(start) / largest } else { 0.0 };
    let positions = start.iter().zip(&motion).map(|(x, u)| x + u * factor).collect();
    run.record.steps += 1;
    run.keep_positions(positions, 0.0, level);
    factor
}

/// A motion times a factor.
pub(crate) fn scaled(motion: &[f64], factor: f64) -> Vec<f64> {
    motion.iter().map(|q| factor * q).collect()
}

#[cfg(test)]
mod tests {
    use super::below_zero;

    /// A square of steel on springs, ω² of 1850 and more, ω up to 2.1e5: −4e-4 is rounding; a square of −1 is not.
    #[test]
    fn rigid_motions_on_springs_are_not_unstable() {
        assert_eq!(below_zero([-4e-4, 3e-5, 1850.0].into_iter(), 2.1e5), 0);
        assert_eq!(below_zero([-1.0, 1850.0].into_iter(), 2.1e5), 1);
    }
}
