//! Supports, prescribed motions and loads, each on a named set of particles.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// A support: exactly one of its conditions is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Support {
    /// Particle set.
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
    /// Course of a prescribed displacement in time, in transient runs.
    pub amplitude: Option<Amplitude>,
}

/// A condition without options: `{}`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fixed {}

/// Mirror plane: neither displacement nor director along its normal.
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
}

/// No displacement along some directions, no turn of the director out of a plane; at least one of the two is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Held {
    /// Directions of no displacement, none to three, no two parallel; their length does not matter.
    #[serde(default)]
    pub displacement: Vec<[f64; 3]>,
    /// Normal of the plane in which the director stays, none or one; its length does not matter.
    #[serde(default)]
    pub director: Vec<[f64; 3]>,
}

/// Displacement `by × level`, in a transient run `by × amplitude`, along a direction; the others stay free.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Moved {
    /// Direction; its length does not matter.
    pub direction: [f64; 3],
    /// Displacement at level one \[L\].
    pub by: f64,
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
}

impl Support {
    /// Keys of the conditions.
    pub const WORDS: [&'static str; 6] = ["clamped", "hinged", "symmetry", "diaphragm", "held", "moved"];

    /// Every condition that is given, with its key; a checked scene has exactly one.
    pub fn kinds(&self) -> Vec<(&'static str, SupportKind)> {
        [
            self.clamped.map(|_| SupportKind::Clamped),
            self.hinged.map(|_| SupportKind::Hinged),
            self.symmetry.map(SupportKind::Symmetry),
            self.diaphragm.map(SupportKind::Diaphragm),
            self.held.clone().map(SupportKind::Held),
            self.moved.map(SupportKind::Moved),
        ]
        .into_iter()
        .zip(Self::WORDS)
        .filter_map(|(kind, word)| kind.map(|kind| (word, kind)))
        .collect()
    }
}

/// A load: exactly one kind is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Particle set.
    pub on: String,
    /// Dead force, shared by the set.
    pub force: Option<Force>,
    /// Couple on an edge, about a fixed axis or about the moving edge.
    pub couple: Option<Couple>,
    /// Pressure along the normal, dead or following the surface.
    pub pressure: Option<Pressure>,
    /// Weight: an acceleration of the mass of the set.
    pub gravity: Option<Gravity>,
    /// Variation in time, in transient runs.
    pub amplitude: Option<Amplitude>,
}

/// Dead force shared by the set: by tributary length on an edge, else equally.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Force {
    /// Resultant \[F\].
    pub total: [f64; 3],
}

/// Couple on an edge.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Couple {
    /// Moment of the whole edge \[F L\].
    pub moment: f64,
    /// Axis about which it turns.
    pub axis: Axis,
}

/// Axis of a couple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// Fixed in space; its length does not matter.
    Fixed([f64; 3]),
    /// The current direction of the edge: along growing u or v, on the boundary of a mesh with the surface to the left.
    Edge,
}

/// Pressure.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pressure {
    /// Along the normal of the surface \[F/L²\].
    pub value: f64,
    /// Whether it follows the deformed surface.
    #[serde(default)]
    pub follower: bool,
}

/// Weight.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gravity {
    /// Acceleration \[L/T²\].
    pub acceleration: [f64; 3],
}

/// Variation of a load in time.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Amplitude {
    /// One throughout.
    #[default]
    Constant,
    /// Linear from zero to one over this time \[T\].
    Ramp(f64),
    /// Quintic from zero to one over this time, without velocity and acceleration at its ends \[T\].
    Smooth(f64),
    /// Straight lines between `[time, factor]`.
    Table(Vec<[f64; 2]>),
    /// Sine of time.
    Sine {
        /// Period \[T\].
        period: f64,
    },
}

/// The one kind of a [`Load`].
#[derive(Clone, Copy, Debug)]
pub enum LoadKind {
    /// See [`Load::force`].
    Force(Force),
    /// See [`Load::couple`].
    Couple(Couple),
    /// See [`Load::pressure`].
    Pressure(Pressure),
    /// See [`Load::gravity`].
    Gravity(Gravity),
}

impl Load {
    /// Keys of the kinds.
    pub const WORDS: [&'static str; 4] = ["force", "couple", "pressure", "gravity"];

    /// Every kind that is given, with its key; a checked scene has exactly one.
    pub fn kinds(&self) -> Vec<(&'static str, LoadKind)> {
        [
            self.force.map(LoadKind::Force),
            self.couple.map(LoadKind::Couple),
            self.pressure.map(LoadKind::Pressure),
            self.gravity.map(LoadKind::Gravity),
        ]
        .into_iter()
        .zip(Self::WORDS)
        .filter_map(|(kind, word)| kind.map(|kind| (word, kind)))
        .collect()
    }
}

impl<'de> Deserialize<'de> for Axis {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct WordOrVector;
        impl<'de> Visitor<'de> for WordOrVector {
            type Value = Axis;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"edge\" or a vector of three numbers")
            }

            fn visit_str<E: Error>(self, word: &str) -> Result<Axis, E> {
                match word {
                    "edge" => Ok(Axis::Edge),
                    _ => Err(E::unknown_variant(word, &["edge"])),
                }
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Axis, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Axis::Fixed)
            }
        }
        deserializer.deserialize_any(WordOrVector)
    }
}

impl JsonSchema for Axis {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Axis".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Axis of a couple: fixed in space, or the current direction of the edge.",
            "oneOf": [
                { "const": "edge" },
                { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }
            ]
        })
    }
}
