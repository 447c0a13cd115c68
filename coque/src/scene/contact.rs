//! Surfaces that may touch each other, or themselves.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{FrictionCoefficient, Positive, Rounding};

/// A contact, smooth unless `friction` is given: of the surfaces of two bodies, shells, solids or rigid bodies, of a shell with walls of a fluid, or
/// of a shell with itself.
/// Mid-surfaces of shells stand half of both thicknesses apart when faces touch.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ContactScene {
    /// The two bodies that touch, shells, solids or one of them a rigid body or walls, whichever first; the same twice for a shell with itself;
    /// left out, the one body touches itself.
    pub between: Option<[String; 2]>,
    /// Coefficient of friction μ \[–\]; left out, none.
    pub friction: Option<FrictionCoefficient>,
    /// Factor on the stiffness of contact; left out, 1: the lesser of what the thickness gives, E/t, and of what shortens steps in time by
    /// a tenth at most; of a solid of bonds t is the spacing of its nodes, of a Galerkin solid a fifth of that; on a rigid body twice as much.
    pub stiffness: Option<Positive>,
    /// Depth over the thickness up to which the force sets in softly \[–\]; left out, .05 in time, where bodies bounce, and 0 without time.
    pub rounding: Option<Rounding>,
}

impl ContactScene {
    /// Whether it has friction.
    pub(crate) fn is_rough(&self) -> bool {
        self.friction.is_some_and(|friction| friction.get() > 0.0)
    }

    /// The two bodies that touch, where they are two.
    pub(crate) fn pair(&self) -> Option<&[String; 2]> {
        self.between.as_ref().filter(|between| between[0] != between[1])
    }

    /// The other one of the two bodies that touch, where this is one of them.
    pub(crate) fn other(&self, body: &str) -> Option<&str> {
        let [a, b] = self.pair()?;
        if a == body { Some(b) } else { Some(a.as_str()).filter(|_| b == body) }
    }

    /// Whether it is that of a body with itself.
    pub(crate) fn is_of_itself(&self, body: &str) -> bool {
        self.between.as_ref().is_none_or(|between| between.iter().all(|name| name == body))
    }

    /// Whether it is one of a body.
    pub(crate) fn is_of(&self, body: &str) -> bool {
        self.between.as_ref().is_none_or(|between| between.iter().any(|name| name == body))
    }
}
