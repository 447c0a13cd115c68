//! Supports and prescribed motions, each on a named set of particles.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;
use sph_core::Vec3;

use crate::scene::bounded::Positive;

/// A support: exactly one of its conditions is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Particle set, or a list of sets: the union of them.
    pub on: String,
    /// Neither position nor director moves.
    pub clamped: Option<Fixed>,
    /// The position does not move; the director is free.
    pub hinged: Option<Fixed>,
    /// Mirror plane.
    pub symmetry: Option<Symmetry>,
    /// Rigid in its plane, free along its axis.
    pub diaphragm: Option<Diaphragm>,
    /// Any directions of displacement and one turn of the director: the general support.
    pub held: Option<Held>,
    /// Prescribed displacement in one direction.
    pub moved: Option<Moved>,
    /// Prescribed rotation of the directors about an axis.
    pub rotated: Option<Rotated>,
    /// Prescribed turn of the set as one body, positions and directors together.
    pub turned: Option<Turned>,
    /// Springs along a direction to the ground or another set, or against turning.
    pub spring: Option<Spring>,
    /// Load case to which its motion belongs, in a linear analysis; in the others the set stands still.
    pub case: Option<String>,
    /// Course of a prescribed motion in time, in transient runs.
    pub amplitude: Option<Amplitude>,
    /// Whether its motion is made in full before the analysis and held: the level counts the other motions.
    #[serde(default)]
    pub preload: bool,
}

/// A condition without options: `{}`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {}

/// Mirror plane: neither displacement nor director along its normal. On a solid of bonds it is a whole face, across which bonds reach to
/// the images of the nodes.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Symmetry {
    /// Normal of the plane; its length does not matter.
    pub normal: [f64; 3],
}

/// Rigid diaphragm: no displacement across its axis.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Diaphragm {
    /// Normal of the diaphragm, along which particles are free; its length does not matter.
    pub axis: [f64; 3],
    /// Whether it holds the whole section, not its middle alone: the director leans along the axis and does not turn in the diaphragm's plane.
    #[serde(default, rename = "whole-section")]
    pub whole_section: bool,
}

/// No displacement along some directions, no turn of the director out of a plane; at least one of the two is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Held {
    /// Directions of no displacement, none to three, no two parallel; their length does not matter.
    #[serde(default)]
    pub displacement: Vec<[f64; 3]>,
    /// Normal of the plane in which the director stays, none or one, on plates of two sheets up to two; its length does not
    /// matter.
    #[serde(default)]
    pub director: Vec<[f64; 3]>,
}

/// Displacement `by × level`, in a transient run `by × amplitude`, along a direction; the others stay free.
///
/// Where it acts on one particle and drives a linear, static, arc-length or buckling analysis alone, the force along it is
/// sought, and is the level of the last two.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Moved {
    /// Direction; its length does not matter.
    pub direction: [f64; 3],
    /// Displacement at level one \[L\].
    pub by: f64,
}

/// Directors turn about an axis by `by × level`, in a transient run by `by × amplitude`; positions stay free.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rotated {
    /// Axis; its length does not matter.
    pub axis: [f64; 3],
    /// Angle at level one, right-handed \[degrees\].
    pub by: f64,
}

/// The set turns as one body about an axis through a point by `by × level`, in a transient run by `by × amplitude`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Turned {
    /// Axis; its length does not matter.
    pub axis: [f64; 3],
    /// A point of the axis \[L\].
    #[serde(default)]
    pub point: [f64; 3],
    /// Angle at level one, right-handed, of any size \[degrees\].
    pub by: f64,
}

/// Springs along a direction or against turning about an axis, exactly one of them, spread evenly over the set: over its area if it is made up
/// of whole cells, along its lines if it follows edges of cells, rocking on either as on an even bed, else equally. No level scales them.
///
/// Along a direction they act on the particles of a set, against turning on their directors, of a rigid set on its rotation.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spring {
    /// Direction of the displacement that is resisted, fixed in space; its length does not matter.
    pub direction: Option<[f64; 3]>,
    /// Axis of the turn from rest that is resisted, below half a turn; its length does not matter.
    pub axis: Option<[f64; 3]>,
    /// Stiffness of the whole set: force by displacement along a direction, moment by radian about an axis \[F/L, F L\].
    pub stiffness: Positive,
    /// The set, or list of sets, at the other end of springs along a direction, of as many places, each paired with the nearest one; two rigid sets are joined at
    /// their reference points. Left out, the ground. A set of another body, `NAME.set`, joins the two: the pairs then share the stiffness
    /// equally.
    pub to: Option<String>,
}

/// The one condition of a [`Support`].
#[derive(Clone, Debug)]
pub enum SupportKind {
    /// See [`Support::clamped`].
    Clamped,
    /// See [`Support::hinged`].
    Hinged,
    /// See [`Support::symmetry`].
    Symmetry(Symmetry),
    /// See [`Support::diaphragm`].
    Diaphragm(Diaphragm),
    /// See [`Support::held`].
    Held(Held),
    /// See [`Support::moved`].
    Moved(Moved),
    /// See [`Support::rotated`].
    Rotated(Rotated),
    /// See [`Support::turned`].
    Turned(Turned),
    /// See [`Support::spring`].
    Spring(Spring),
}

/// What a condition is on nodes, none of which turns by itself; directors are those of plates of two sheets.
#[derive(Clone, Debug)]
pub(crate) enum OnNodes {
    /// Directions that do not move, and planes in which directors stay.
    Held(Held),
    /// A mirror plane.
    Symmetry(Symmetry),
    /// A prescribed motion.
    Moved(Moved),
    /// A prescribed turn of the set.
    Turned(Turned),
}

const AXES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl SupportKind {
    /// Its vectors that have a direction, with their keys.
    pub(crate) fn vectors(&self) -> Vec<(String, [f64; 3])> {
        let numbered = |key: &str, list: &[[f64; 3]]| {
            list.iter().enumerate().map(|(i, &v)| (format!("{key}[{i}]"), v)).collect::<Vec<_>>()
        };
        match self {
            Self::Clamped | Self::Hinged => Vec::new(),
            Self::Symmetry(plane) => vec![("normal".into(), plane.normal)],
            Self::Diaphragm(plane) => vec![("axis".into(), plane.axis)],
            Self::Held(Held { displacement, director }) => {
                [numbered("displacement", displacement), numbered("director", director)].concat()
            }
            Self::Moved(moved) => vec![("direction".into(), moved.direction)],
            Self::Rotated(rotated) => vec![("axis".into(), rotated.axis)],
            Self::Turned(turned) => vec![("axis".into(), turned.axis)],
            Self::Spring(spring) => {
                let direction = spring.direction.map(|direction| ("direction".into(), direction));
                direction.into_iter().chain(spring.axis.map(|axis| ("axis".into(), axis))).collect()
            }
        }
    }

    /// What it is on the nodes of a solid; none of what turns or leaves a director alone.
    pub(crate) fn on_nodes(&self) -> Option<OnNodes> {
        match self {
            Self::Clamped => {
                let (displacement, director) = (AXES.to_vec(), AXES[..2].to_vec());
                Some(OnNodes::Held(Held { displacement, director }))
            }
            Self::Symmetry(plane) => Some(OnNodes::Symmetry(*plane)),
            Self::Held(held) => Some(OnNodes::Held(held.clone())),
            Self::Moved(moved) => Some(OnNodes::Moved(*moved)),
            Self::Turned(turned) => Some(OnNodes::Turned(*turned)),
            Self::Hinged | Self::Diaphragm(_) | Self::Rotated(_) | Self::Spring(_) => None,
        }
    }

    /// Directions along which it keeps a place from going.
    pub(crate) fn keeps(&self) -> Vec<Vec3> {
        match self {
            Self::Clamped | Self::Hinged | Self::Turned(_) => AXES.map(Vec3::from).to_vec(),
            Self::Symmetry(plane) => vec![plane.normal.into()],
            Self::Diaphragm(plane) => {
                let axis = Vec3::from(plane.axis);
                let across = axis.cross(&Vec3::ith(axis.iamin(), 1.0));
                vec![across, axis.cross(&across)]
            }
            Self::Held(held) => held.displacement.iter().map(|&v| v.into()).collect(),
            Self::Moved(moved) => vec![moved.direction.into()],
            Self::Rotated(_) => Vec::new(),
            Self::Spring(spring) => spring.direction.iter().map(|&v| v.into()).collect(),
        }
    }
}

impl Support {
    /// Keys of the conditions.
    pub const WORDS: [&'static str; 9] =
        ["clamped", "hinged", "symmetry", "diaphragm", "held", "moved", "rotated", "turned", "spring"];

    /// Every condition that is given, with its key; a checked scene has exactly one.
    pub fn kinds(&self) -> Vec<(&'static str, SupportKind)> {
        [
            self.clamped.map(|_| SupportKind::Clamped),
            self.hinged.map(|_| SupportKind::Hinged),
            self.symmetry.map(SupportKind::Symmetry),
            self.diaphragm.map(SupportKind::Diaphragm),
            self.held.clone().map(SupportKind::Held),
            self.moved.map(SupportKind::Moved),
            self.rotated.map(SupportKind::Rotated),
            self.turned.map(SupportKind::Turned),
            self.spring.clone().map(SupportKind::Spring),
        ]
        .into_iter()
        .zip(Self::WORDS)
        .filter_map(|(kind, word)| kind.map(|kind| (word, kind)))
        .collect()
    }

    /// Names of the sets on which it acts.
    pub(crate) fn sets_mut(&mut self) -> impl Iterator<Item = &mut String> {
        let other = self.spring.as_mut().and_then(|spring| spring.to.as_mut());
        std::iter::once(&mut self.on).chain(other)
    }

    /// Its prescribed motion, if it is one: key, and size at level one \[L, degrees\].
    pub fn motion(&self) -> Option<(&'static str, f64)> {
        let moved = self.moved.map(|moved| ("moved", moved.by));
        let rotated = self.rotated.map(|rotated| ("rotated", rotated.by));
        moved.or(rotated).or(self.turned.map(|turned| ("turned", turned.by)))
    }
}
