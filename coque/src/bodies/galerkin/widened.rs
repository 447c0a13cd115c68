//! Supports in which nodes determine the basis at every point.

use sph_core::{ShapeError, Support};
use sr_galerkin::{Galerkin, GalerkinError};

/// Part by which a support is widened at a time.
const STEP: f64 = 0.05;
/// Times that it is: to twice as wide.
const MOST: usize = 20;

/// The solid on the narrowest support, the one asked for widened along all axes alike, in which nodes determine the basis at every
/// point, and the factor. Spacings of an arc grow with its radius, and outside they may be too wide for what suits its middle. One
/// factor for the whole solid: shape functions stay continuous.
///
/// # Errors
/// [`GalerkinError`], of the support asked for where none is wide enough.
pub(super) fn wide_enough(
    support: &Support,
    build: impl Fn(Support) -> Result<Galerkin, GalerkinError>,
) -> Result<(Galerkin, f64), GalerkinError> {
    let scaled = |factor: f64| Support { radii: support.radii.map(|radius| factor * radius), ..*support };
    let mut first = None;
    for step in 0..=MOST {
        let factor = 1.0 + STEP * step as f64;
        match build(scaled(factor)) {
            Ok(solid) => return Ok((solid, factor)),
            Err(error) => {
                let narrow = matches!(
                    error,
                    GalerkinError::Shape(ShapeError::TooFew { .. } | ShapeError::Condition { .. })
                );
                let error = first.take().unwrap_or(error);
                if !narrow || step == MOST {
                    return Err(error);
                }
                first = Some(error);
            }
        }
    }
    unreachable!("the last width returns")
}
