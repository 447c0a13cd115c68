//! Loads, each on a named set of particles.

use explicit_dynamics::Amplitude;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use crate::scene::bounded::Positive;

/// A load: exactly one kind is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Particle set.
    pub on: String,
    /// Dead force, shared by the set.
    pub force: Option<Force>,
    /// Couple on directors, about a fixed axis or about the moving edge.
    pub couple: Option<Couple>,
    /// Pressure along the normal of a shell or of some of its cells, dead or following it; on faces of a Galerkin solid against
    /// their normal, following them.
    pub pressure: Option<Pressure>,
    /// Weight: an acceleration of the mass of the set.
    pub gravity: Option<Gravity>,
    /// Dead force by area on a face of a solid, or on cells of a shell.
    pub traction: Option<Traction>,
    /// Variation in time, in transient runs.
    pub amplitude: Option<Amplitude>,
    /// Whether it is applied in full before the analysis and held: the level counts the other loads.
    #[serde(default)]
    pub preload: bool,
}

/// Dead force shared by the set: by tributary length on an edge, of a solid by volume, by area where that is asked for, else
/// equally.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Force {
    /// Resultant \[F\].
    pub total: [f64; 3],
    /// Whether it is spread by area over the cells of the set, of a shell.
    #[serde(default)]
    pub by_area: bool,
}

/// Couple on the directors of a set, by tributary length on an edge, else equally; what would turn them about themselves is lost.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Couple {
    /// Moment of the whole set \[F L\].
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
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pressure {
    /// Along the normal of a shell; on the face of a solid against its outward normal \[F/L²\]. May be left out, as one, beside `values`.
    pub value: Option<f64>,
    /// Name of an array in memory with a number for each particle of a shell, which multiplies `value` there; Python brings such arrays.
    pub values: Option<String>,
    /// Whether it follows the deformed surface.
    #[serde(default)]
    pub follower: bool,
}

impl Pressure {
    /// Its value \[F/L²\], which numbers by particle may multiply.
    pub fn value(&self) -> f64 {
        self.value.unwrap_or(1.0)
    }
}

/// Weight.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gravity {
    /// Acceleration \[L/T²\].
    pub acceleration: [f64; 3],
}

/// Dead force by area of a face, or of cells of a shell, at rest.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Traction {
    /// Force by area \[F/L²\].
    pub value: [f64; 3],
    /// Depth of the layer under the face over which it is spread by volume, of nodes with bonds \[L\]; left out, it acts on the
    /// outermost nodes.
    pub depth: Option<Positive>,
}

/// The one kind of a [`Load`].
#[derive(Clone, Debug)]
pub enum LoadKind {
    /// See [`Load::force`].
    Force(Force),
    /// See [`Load::couple`].
    Couple(Couple),
    /// See [`Load::pressure`].
    Pressure(Pressure),
    /// See [`Load::gravity`].
    Gravity(Gravity),
    /// See [`Load::traction`].
    Traction(Traction),
}

impl Load {
    /// Keys of the kinds.
    pub const WORDS: [&'static str; 5] = ["force", "couple", "pressure", "gravity", "traction"];

    /// Whether it acts on the cells of its set, of a shell: its particles do not say on which area. Pressure and gravity on all
    /// of a shell ask for no set.
    pub fn acts_on_cells(&self) -> bool {
        let by_area = self.traction.is_some() || self.force.is_some_and(|force| force.by_area);
        let uneven = self.pressure.as_ref().is_some_and(|pressure| pressure.values.is_some());
        by_area || uneven || (self.on != "all" && (self.pressure.is_some() || self.gravity.is_some()))
    }

    /// Every kind that is given, with its key; a checked scene has exactly one.
    pub fn kinds(&self) -> Vec<(&'static str, LoadKind)> {
        [
            self.force.map(LoadKind::Force),
            self.couple.map(LoadKind::Couple),
            self.pressure.clone().map(LoadKind::Pressure),
            self.gravity.map(LoadKind::Gravity),
            self.traction.map(LoadKind::Traction),
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
