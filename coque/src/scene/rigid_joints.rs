//! Hinges, sliders and ball joints of rigid bodies.

use schemars::JsonSchema;
use serde::Deserialize;

/// A joint of a rigid body to another one or to the ground, an exact constraint in time: exactly one of its kinds is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointScene {
    /// Its name, by which columns take its force and moment.
    pub name: Option<String>,
    /// The rigid body, by its name.
    pub on: String,
    /// The other rigid body; left out, the ground.
    pub to: Option<String>,
    /// Where it is at rest, on the bodies or beside them \[L\].
    pub at: [f64; 3],
    /// It leaves all turns about its place free.
    pub ball: Option<BallJoint>,
    /// It leaves turns about an axis through its place free, which goes with both bodies.
    pub hinge: Option<AlongAxis>,
    /// It leaves ways along an axis through its place free, which goes with the body that `to` names.
    pub slider: Option<AlongAxis>,
}

/// A joint without options: `{}`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BallJoint {}

/// The axis of a joint.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AlongAxis {
    /// Axis at rest; its length does not matter.
    pub axis: [f64; 3],
}

impl JointScene {
    /// Keys of its kinds.
    pub const WORDS: [&'static str; 3] = ["ball", "hinge", "slider"];

    /// The kinds that are given; a checked scene has exactly one.
    pub(crate) fn given(&self) -> Vec<&'static str> {
        let there = [self.ball.is_some(), self.hinge.is_some(), self.slider.is_some()];
        Self::WORDS.into_iter().zip(there).filter_map(|(word, there)| there.then_some(word)).collect()
    }

    /// Whether it is on a body or joins it to another one.
    pub(crate) fn is_of(&self, body: &str) -> bool {
        self.on == body || self.to.as_deref() == Some(body)
    }

    /// Its axis, if it has one.
    pub(crate) fn axis(&self) -> Option<[f64; 3]> {
        self.hinge.or(self.slider).map(|own| own.axis)
    }
}
