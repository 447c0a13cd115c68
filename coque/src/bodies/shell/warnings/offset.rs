//! What diagonal masses make of motions: of sections high over their particles, and of bodies that turn as a whole.

use std::f64::consts::PI;

use sph_shell::BarForce;

use super::look::Look;
use crate::bodies::shell::bars::bar_of;
use crate::scene::Analysis;
use crate::scene::bounded::Modes;

/// Relative error of a frequency above which it is reported.
const OFF: f64 = 0.02;

/// Relative error of a rotary inertia above which it is reported: half of it is that of a frequency or of the time of a turn.
const TURNS: f64 = 0.01;

/// Masses at the corners of n cells a side and directors of the size of a cell turn with `1 + 3/n²` of the inertia of a thin plate in a march; what
/// that is for the rigid motions that supports leave free is found from the cells.
pub(super) fn scaled(look: &Look<'_>) -> Option<String> {
    if !look.scene?.analysis.moves_in_time() {
        return None;
    }
    let off = look.shell.turning_inertia()?.free? - 1.0;
    (off.abs() > TURNS).then(|| {
        format!(
            "the body is free to turn, and in time it does so with {:.1} % more rotary inertia than it has, at most {:.0} % are let pass: masses stand \
             at the corners of cells and directors turn as if they were as thick as a cell is wide; take finer cells (the error falls as the \
             square), or make what does not deform a rigid set, which has its own inertia",
            100.0 * off,
            100.0 * TURNS
        )
    })
}

/// A section whose middle lies e over its particles has, besides what masses hold, the kinetic energy `ρ t e u̇·ḋ`.
///
/// In a wave `w = W sin kx` directors turn by `−w′` and particles go to and fro by `u = e w′`, so that the middle does not stretch. What is
/// left out is `−ρ t e² ẇ′²`, the part `−2 (ke)²` of `½ ρ t ẇ²`: frequencies come out `(ke)²` too low. The m-th mode of a sheet of area A
/// has `k² = 4πm/A` (Weyl), of a strip of length L `k = mπ/L`; the lesser counts. Of parts their share of the area times e² does.
pub(super) fn inertia(look: &Look<'_>) -> Option<String> {
    let modes = match &look.scene?.analysis {
        Analysis::Modal(modal) => modal.modes.get(),
        Analysis::Harmonic(wanted) => wanted.modes.map_or(1, Modes::get),
        Analysis::ResponseSpectrum(wanted) => wanted.modes.get(),
        Analysis::RandomVibration(wanted) => wanted.modes.get(),
        Analysis::Explicit(_) => 1,
        _ => return None,
    };
    let bars = &look.scene?.shell.stiffeners;
    if !look.shell.has_regions() && bars.is_empty() {
        return None;
    }
    let reference = look.shell.reference();
    let (mut area, mut moment) = (0.0, 0.0);
    for (point, sampled) in reference.operator.points.iter().enumerate() {
        area += sampled.weight;
        moment += sampled.weight * look.shell.section_at(point).height.powi(2);
    }
    let places = &reference.cloud.positions;
    let low = places.iter().copied().reduce(|a, b| a.inf(&b))?;
    let high = places.iter().copied().reduce(|a, b| a.sup(&b))?;
    let m = modes as f64;
    let square = (4.0 * PI * m / area).min((m * PI / (high - low).norm()).powi(2));
    let height = (moment / area + of_bars(look)?).sqrt();
    let off = square * height * height;
    (off > OFF).then(|| {
        format!(
            "sections and stiffeners lie {height:.3e} over their particles in the mean, and masses leave out what that couples of velocities and rates of \
             directors: the frequency of mode {modes} would be some {:.0} % too low, at most {:.0} % are let pass; put the particles into the \
             middle of the sections that bear most of the mass",
            100.0 * off,
            100.0 * OFF
        )
    })
}

/// Mean of the square of the height of stiffeners over all mass \[L²\].
fn of_bars(look: &Look<'_>) -> Option<f64> {
    let shell = look.scene?.shell;
    if shell.stiffeners.is_empty() {
        return Some(0.0);
    }
    let rest = look.shell.rest_positions();
    let bars: Vec<_> = shell.stiffeners.iter().map(|own| bar_of(own, shell)).collect();
    let moment = |piece: BarForce| {
        let length = (rest[piece.ends[1] as usize] - rest[piece.ends[0] as usize]).norm();
        let bar = bars.get(piece.stiffener).and_then(Option::as_ref);
        bar.map_or(0.0, |bar| bar.mass * length * bar.height * bar.height)
    };
    let whole: f64 = look.shell.moving_masses()[0].iter().sum();
    Some(look.shell.bar_forces().map(moment).sum::<f64>() / whole)
}
