//! Sheets that tension alone holds: patterns of the cells among the modes.

use std::f64::consts::PI;

use sph_shell::{Formulation, Reach, Shell};

use super::look::Look;
use super::method::unevenness;
use crate::scene::Analysis;
use crate::warning::{Warning, WarningKind};

/// c of the frequency of patterns on even cells \[–\]: 9 to 15 measured.
const PATTERNS: f64 = 10.0;
/// N h²/D above which uneven cells have patterns among the lowest modes: of scattered particles 25 modes are right at 51, 11 at 102, 3 at 244,
/// 2 at 500 and more.
const UNEVEN: f64 = 100.0;
/// Mean difference of the areas of neighbouring cells over their sum above which cells are not even. A jitter of ±j of the
/// spacing has .8 σ with σ = j/√3, by the variance of the areas: .02 at j = .045.
const EVEN: f64 = 0.02;

/// The pattern (1, −1, 1, −1) of a cell has no gradient in its middle, so that no tension acts on it there; its control is of the size of bending.
/// Patterns that swell and fade over a sheet of even cells of the spacing h swing at
///
/// ```text
/// ω_p² = c √(N D)/(ρ t h³)        N the tension, D the bending stiffness, h/t from 200 to 800, N/Et from 1e-4 to 1e-2
/// ```
///
/// The m-th mode of a sheet of area A has `k² = 4πm/A` (Weyl) and `ρ t ω² = N k² + D k⁴`. Where patterns are lower, they are among the modes.
pub(super) fn among_modes(look: &Look<'_>) -> Option<String> {
    let Analysis::Modal(modal) = &look.scene?.analysis else { return None };
    reported(look, modal.modes.get())
}

/// The same of the state that a preload left.
pub(crate) fn among_preloaded_modes(shell: &Shell, wanted: usize) -> Option<Warning> {
    let message = reported(&Look::at(shell), wanted)?;
    Some(Warning::new(WarningKind::PatternModes, format!("after the preload {message}")))
}

fn reported(look: &Look<'_>, wanted: usize) -> Option<String> {
    let Formulation::StressPoint(Reach::Cell) = look.shell.formulation() else { return None };
    let [tension, bending] = look.shell.mean_tension()?;
    let cloud = &look.shell.reference().cloud;
    let (spacing, area) = (look.spacing, cloud.areas.iter().sum::<f64>());
    let held = "the sheet is held by its tension more than by its stiffness";
    if cloud.lattice.is_none() || unevenness(look) > EVEN {
        let ratio = tension * spacing * spacing / bending;
        return (ratio > UNEVEN).then(|| {
            format!(
                "{held}, N h²/D is {ratio:.0}: on uneven cells patterns of single ones would be among the lowest modes above {UNEVEN}; \
                 use an even lattice of `particles`"
            )
        });
    }
    let waves = |modes: usize| 4.0 * PI * modes as f64 / area;
    if tension <= bending * waves(1) {
        return None;
    }
    let square = |modes: usize| {
        PATTERNS * (tension * bending).sqrt()
            / spacing.powi(3)
            / (waves(modes) * (tension + bending * waves(modes)))
    };
    let last = square(wanted);
    (last < 1.0).then(|| {
        let sound = (1..wanted).rev().find(|&modes| square(modes) >= 1.0).unwrap_or(0);
        format!(
            "{held}: patterns of single cells swing at {:.2} of the frequency of mode {}, and would be among the modes from about number {} on; \
             above 1 they are none of those asked for. Make the spacing {:.2} of what it is, or ask for {} modes",
            last.sqrt(),
            wanted,
            sound + 1,
            libm::cbrt(last),
            sound.max(1),
        )
    })
}
