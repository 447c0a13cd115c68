//! Sections high over their particles: what diagonal masses leave out of their motion.

use std::f64::consts::PI;

use crate::scene::Analysis;

use super::look::Look;

/// Relative error of a frequency above which it is told.
const OFF: f64 = 0.02;

/// A section whose middle lies e over its particles has, besides what masses hold, the kinetic energy `ρ t e u̇·ḋ`.
///
/// In a wave `w = W sin kx` directors turn by `−w′` and particles go to and fro by `u = e w′`, so that the middle does not stretch. What is
/// left out is `−ρ t e² ẇ′²`, the part `−2 (ke)²` of `½ ρ t ẇ²`: frequencies come out `(ke)²` too low. The m-th mode of a sheet of area A
/// has `k² = 4πm/A` (Weyl), of a strip of length L `k = mπ/L`; the lesser counts. Of parts their share of the area times e² does.
pub(super) fn inertia(look: &Look<'_>) -> Option<String> {
    let modes = match &look.scene?.analysis {
        Analysis::Modal(modal) => modal.modes,
        Analysis::Explicit(_) => 1,
        _ => return None,
    };
    if !look.shell.has_regions() {
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
    let height = (moment / area).sqrt();
    let off = square * height * height;
    (off > OFF).then(|| {
        format!(
            "sections lie {height:.3e} over their particles in the mean, and masses leave out what that couples of velocities and rates of \
             directors: the frequency of mode {modes} would be some {:.0} % too low, at most {:.0} % are let pass; put the particles into the \
             middle of the sections that bear most of the mass",
            100.0 * off,
            100.0 * OFF
        )
    })
}
