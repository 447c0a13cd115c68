//! How late artificial viscosity makes water that runs over a dry bed.

use fluid_sph::Fluid;

use crate::warning::{Warning, WarningKind};

/// Part of the time of arrival above which it is warned of.
const LATE: f64 = 0.03;

/// Depth of a fluid at rest along gravity \[L\]; zero without gravity.
fn depth(fluid: &Fluid) -> f64 {
    let Some(up) = fluid.gravity_across().try_normalize(0.0) else { return 0.0 };
    let heights = fluid.rest().iter().map(|place| place.dot(&up));
    let (low, high) =
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
    (high - low + fluid.spacing()).max(0.0)
}

/// Speed of a long wave on a fluid at rest, √(gH) \[L/T\]; infinite without gravity, where nothing falls.
pub(super) fn wave(fluid: &Fluid) -> f64 {
    let square = fluid.gravity_across().norm() * depth(fluid);
    if square > 0.0 { square.sqrt() } else { f64::INFINITY }
}

/// Part of its time by which the front of a dam break comes late at a Reynolds number.
///
/// Measured at `wall-impact` against its experiment, artificial viscosity .005 to .1, 15 to 60 particles a height, speeds of sound 10 to
/// 40 √(gH): what came out depends on the number alone (docs/fluids.md). A layer along the bed brakes by its root, the sheet itself by its
/// inverse.
fn lateness(reynolds: f64) -> f64 {
    16.5 / reynolds + 0.85 / reynolds.sqrt()
}

/// The warning of water that ran, if its artificial viscosity brakes it so much.
///
/// α acts on particles that approach like a kinematic viscosity `ν = α c₀ h/(2(d + 2))` \[L²/T\] on all \[monaghan2005\]; the number is
/// `√(gH) H/ν` by the depth H at rest.
pub(super) fn warning(fluid: &Fluid) -> Option<Warning> {
    let method = fluid.formulation();
    let sound = fluid.liquid().sound_speed;
    let like =
        method.viscosity * sound * fluid.smoothing_length() / (2.0 * (fluid.dimensions() as f64 + 2.0));
    let depth = depth(fluid);
    let reynolds = wave(fluid) * depth / like;
    let late = lateness(reynolds);
    let message = || {
        format!(
            "water ran, and its artificial viscosity of {} acts like a kinematic one of {like:.3e}, a Reynolds number of {reynolds:.0} by \
             its depth at rest: fronts of thin sheets may come {:.0} % too late, as those of a dam break do against its experiment; use a \
             narrower spacing, or a smaller `viscosity`",
            method.viscosity,
            100.0 * late
        )
    };
    (late > LATE).then(|| Warning::new(WarningKind::LateFront, message()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fronts_are_as_late_as_was_measured() {
        // Percent against the experiment, by Reynolds number; the particles that meet the wall are .5 to 2 % of the way.
        for (reynolds, percent) in
            [(155.0, 17.5), (194.0, 15.9), (310.0, 10.7), (387.0, 8.8), (774.0, 5.2), (1548.0, 3.6)]
        {
            let found = 100.0 * lateness(reynolds);
            assert!((found - percent).abs() < 1.5, "{reynolds}: {found}");
        }
    }
}
