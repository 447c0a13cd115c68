//! Rigid tools that a body may touch.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{FrictionCoefficient, Positive, Rounding};

/// A rigid tool of one shape, smooth unless `friction` is given. It pushes on both faces of a shell, whose mid-surface stands half a thickness off it when they
/// touch, or on the faces of a solid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct ToolScene {
    /// What it is called in messages and columns.
    pub name: String,
    /// A half space behind a plane.
    pub plane: Option<ToolPlane>,
    /// A ball.
    pub sphere: Option<ToolSphere>,
    /// A cylinder without ends.
    pub cylinder: Option<ToolCylinder>,
    /// A cylinder with round ends.
    pub capsule: Option<ToolCapsule>,
    /// How far it has moved at level one \[L\]; left out, it stands.
    pub moved: Option<[f64; 3]>,
    /// Angle by which it has turned about its axis at level one, of a plane about its normal through its point, of a capsule from the first of
    /// its ends to the second \[rad\]; with `friction`, and not for balls.
    pub turn: Option<f64>,
    /// What of that a time brings, in transient runs.
    pub amplitude: Option<Amplitude>,
    /// Coefficient of friction μ \[–\], on shells; left out, none.
    pub friction: Option<FrictionCoefficient>,
    /// Factor on the stiffness of contact; left out, 1: the lesser of what the thickness gives, 2E/t, and of what shortens steps in time by
    /// a tenth at most; of a solid E/r, r half of the spacing of bonds and a tenth of that of a Galerkin solid.
    pub stiffness: Option<Positive>,
    /// Depth over half of the thickness up to which the force sets in softly \[–\]; left out, .05 in time, where bodies bounce, and 0
    /// without time.
    pub rounding: Option<Rounding>,
}

/// A half space; bodies are on the side of its normal.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolPlane {
    /// A point of the plane \[L\].
    pub point: [f64; 3],
    /// Normal away from the tool; its length does not matter.
    pub normal: [f64; 3],
}

/// A ball.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolSphere {
    /// Its centre \[L\].
    pub centre: [f64; 3],
    /// Its radius \[L\].
    pub radius: Positive,
}

/// A cylinder without ends.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolCylinder {
    /// A point of its axis \[L\].
    pub point: [f64; 3],
    /// Direction of its axis; its length does not matter.
    pub axis: [f64; 3],
    /// Its radius \[L\].
    pub radius: Positive,
}

/// A cylinder with round ends.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolCapsule {
    /// Ends of its axis \[L\].
    pub ends: [[f64; 3]; 2],
    /// Its radius \[L\].
    pub radius: Positive,
}

impl ToolScene {
    /// Whether it moves or turns.
    pub(crate) fn is_driven(&self) -> bool {
        self.moved.is_some_and(|moved| moved != [0.0; 3]) || self.turn.is_some_and(|angle| angle != 0.0)
    }

    /// Whether it has friction.
    pub(crate) fn is_rough(&self) -> bool {
        self.friction.is_some_and(|friction| friction.get() > 0.0)
    }

    /// Keys of the shapes.
    pub(crate) const SHAPES: [&'static str; 4] = ["plane", "sphere", "cylinder", "capsule"];

    /// Shapes that are given; a checked scene has exactly one.
    pub(crate) fn given(&self) -> Vec<&'static str> {
        let given =
            [self.plane.is_some(), self.sphere.is_some(), self.cylinder.is_some(), self.capsule.is_some()];
        Self::SHAPES.into_iter().zip(given).filter_map(|(word, given)| given.then_some(word)).collect()
    }
}
