//! Rigid tools that a body may touch.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{FrictionCoefficient, Positive, Rounding};

/// A rigid tool of one shape, smooth unless `friction` is given. It pushes on both faces of a shell, whose mid-surface stands half a thickness off it when they
/// touch, or on the faces of a solid or of the coat of a rigid body.
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
    /// A box along the axes.
    pub block: Option<ToolBlock>,
    /// How far it has moved at level one \[L\]; left out, it stands.
    pub moved: Option<[f64; 3]>,
    /// Angle by which it has turned about its axis at level one, of a plane about its normal through its point, of a capsule from the first of
    /// its ends to the second \[rad\]; with `friction`, and not for balls.
    pub turn: Option<f64>,
    /// What of that a time brings, in transient runs.
    pub amplitude: Option<Amplitude>,
    /// Whether its motion is made in full before the analysis and held: the level counts the other motions.
    #[serde(default)]
    pub preload: bool,
    /// Coefficient of friction μ \[–\]; left out, none.
    pub friction: Option<FrictionCoefficient>,
    /// Factor on the stiffness of contact; left out, 1: the lesser of what the thickness gives, 2E/t, and of what shortens steps in time by
    /// a tenth at most; of a solid E/r, r half of the spacing of bonds and a hundredth of that of a Galerkin solid; of a rigid body that of
    /// its coat.
    pub stiffness: Option<Positive>,
    /// Depth over half of the thickness up to which the force sets in softly \[–\]; left out, .05 in time, where bodies bounce, and 0
    /// without time.
    pub rounding: Option<Rounding>,
    /// Number of the contact whose walls it stands for; none of a tool that the scene names.
    #[serde(skip)]
    pub(crate) of_contact: Option<usize>,
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

/// A box along the axes of space.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolBlock {
    /// Its least coordinates \[L\].
    pub min: [f64; 3],
    /// Its greatest coordinates \[L\].
    pub max: [f64; 3],
}

impl ToolScene {
    /// Whether it moves or turns.
    pub(crate) fn is_driven(&self) -> bool {
        self.moved.is_some_and(|moved| moved != [0.0; 3]) || self.turn.is_some_and(|angle| angle != 0.0)
    }

    /// Whether the level of the analysis moves or turns it.
    pub(crate) fn is_driven_by_level(&self) -> bool {
        self.is_driven() && !self.preload
    }

    /// Whether it has friction.
    pub(crate) fn is_rough(&self) -> bool {
        self.friction.is_some_and(|friction| friction.get() > 0.0)
    }

    /// What it says of a turn where it has no axis.
    pub(crate) fn without_axis(&self) -> Option<&'static str> {
        let ball = self.sphere.map(|_| "none of a ball, which has no axis");
        ball.or(self.block.map(|_| "none of a block, which lies along the axes"))
    }

    /// Keys of the shapes.
    pub(crate) const SHAPES: [&'static str; 5] = ["plane", "sphere", "cylinder", "capsule", "block"];

    /// Shapes that are given; a checked scene has exactly one.
    pub(crate) fn given(&self) -> Vec<&'static str> {
        let ToolScene { plane, sphere, cylinder, capsule, block, .. } = self;
        let round = [sphere.is_some(), cylinder.is_some(), capsule.is_some()];
        let given = [plane.is_some()].into_iter().chain(round).chain([block.is_some()]);
        Self::SHAPES.into_iter().zip(given).filter_map(|(word, given)| given.then_some(word)).collect()
    }
}
