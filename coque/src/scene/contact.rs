//! Surfaces that may touch each other, or themselves.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{Positive, Rounding};

/// A contact without friction: of the surfaces of two bodies, shells or solids, or of that of a shell with itself. Mid-surfaces of shells stand half
/// of both thicknesses apart when faces touch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ContactScene {
    /// The two bodies that touch, shells or solids, whichever first; left out, the one body touches itself.
    pub between: Option<[String; 2]>,
    /// Factor on the stiffness of contact; left out, 1: the lesser of what the thickness gives, E/t, and of what shortens steps in time by
    /// a tenth at most; of a solid of bonds t is the spacing of its nodes, of a Galerkin solid a fifth of that.
    pub stiffness: Option<Positive>,
    /// Depth over the thickness up to which the force sets in softly \[–\]; left out, .05 in time, where bodies bounce, and 0 without time.
    pub rounding: Option<Rounding>,
}
