//! The nodes of a solid: a box in rows, and what is cut out of it.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// The nodes of a solid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidGeometry {
    /// A box of nodes along the axes.
    pub block: Block,
    /// What is cut out of it: a node goes where its place lies in one of these.
    #[serde(default)]
    pub cut_outs: Vec<CutOut>,
}

/// A box of nodes; with two lengths it lies in the plane z = const.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Edges along x, y and, in space, z \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub lengths: Vec<f64>,
    /// Distance between nodes, one for all axes or one for each \[L\]; the nearest that divides the lengths is taken.
    pub spacing: Spacing,
    /// The corner of least coordinates \[L\]; left out, the origin.
    #[schemars(length(min = 2, max = 3))]
    pub origin: Option<Vec<f64>>,
    /// Thickness across the plane of a block of two lengths \[L\]; left out, 1. A plate of two sheets must give it.
    pub thickness: Option<f64>,
    /// Where the nodes stand; left out, `centres`, of a plate of two sheets `edges`.
    pub nodes: Option<NodePlaces>,
    /// Last over first spacing along each axis; 1 is even.
    #[schemars(length(min = 2, max = 3))]
    pub grading: Option<Vec<f64>>,
    /// Moves nodes at random.
    pub disorder: Option<NodeDisorder>,
}

/// Distance between nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Spacing {
    /// The same along all axes.
    Same(f64),
    /// One for each axis.
    Each(Vec<f64>),
}

/// Where nodes stand in the cells into which their spacing divides a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum NodePlaces {
    /// At their centres: faces lie half a spacing outside the outermost nodes.
    Centres,
    /// At their corners: the outermost nodes lie on the faces, with half a volume, on an edge a quarter.
    Edges,
}

/// Random displacement of nodes; those on a face slide in it. Volumes stay those of the lattice.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NodeDisorder {
    /// Greatest displacement along each axis, in spacings.
    pub fraction: f64,
    /// Seed of the random numbers: the same seed gives the same block everywhere.
    pub seed: u64,
}

/// What is cut out of a block.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum CutOut {
    /// A disc of a plane block, a ball of one in space.
    Ball(Ball),
    /// A cylinder without ends, in space.
    Cylinder(RoundHole),
    /// A box along the axes.
    Box(Cuboid),
    /// What lies over and under a polygon of the plane of x and y.
    Polygon(Polygon),
}

/// A ball; in a plane a disc.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ball {
    /// Centre \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub centre: Vec<f64>,
    /// Radius \[L\].
    pub radius: f64,
}

/// A cylinder without ends.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoundHole {
    /// A point of its axis \[L\].
    pub point: [f64; 3],
    /// Its axis; the length does not matter.
    pub axis: [f64; 3],
    /// Radius \[L\].
    pub radius: f64,
}

/// A box along the axes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cuboid {
    /// Least coordinates \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub min: Vec<f64>,
    /// Greatest coordinates \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub max: Vec<f64>,
}

/// A polygon.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polygon {
    /// Its corners in order \[L\].
    pub corners: Vec<[f64; 2]>,
}

impl Spacing {
    /// The spacing along an axis \[L\].
    pub fn along(&self, axis: usize) -> f64 {
        match self {
            Self::Same(spacing) => *spacing,
            Self::Each(list) => list.get(axis).copied().unwrap_or(0.0),
        }
    }
}

impl CutOut {
    /// Key of its kind.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Ball(_) => "ball",
            Self::Cylinder(_) => "cylinder",
            Self::Box(_) => "box",
            Self::Polygon(_) => "polygon",
        }
    }
}

impl<'de> Deserialize<'de> for Spacing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberOrList;
        impl<'de> Visitor<'de> for NumberOrList {
            type Value = Spacing;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, or a list of one for each axis")
            }

            fn visit_f64<E: Error>(self, spacing: f64) -> Result<Spacing, E> {
                Ok(Spacing::Same(spacing))
            }

            fn visit_i64<E: Error>(self, spacing: i64) -> Result<Spacing, E> {
                Ok(Spacing::Same(spacing as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Spacing, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Spacing::Each)
            }
        }
        deserializer.deserialize_any(NumberOrList)
    }
}

impl JsonSchema for Spacing {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Spacing".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Distance between nodes: one for all axes, or one for each.",
            "oneOf": [
                { "type": "number" },
                { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 3 }
            ]
        })
    }
}
