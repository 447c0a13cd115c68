//! A number for all axes, or one for each.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// A number for all axes, or one for each.
#[derive(Clone, Debug, PartialEq)]
pub enum PerAxis {
    /// The same along all axes.
    Same(f64),
    /// One for each axis.
    Each(Vec<f64>),
}

impl PerAxis {
    /// The number of an axis; zero beyond the list.
    pub fn along(&self, axis: usize) -> f64 {
        match self {
            Self::Same(number) => *number,
            Self::Each(list) => list.get(axis).copied().unwrap_or(0.0),
        }
    }
}

impl<'de> Deserialize<'de> for PerAxis {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberOrList;
        impl<'de> Visitor<'de> for NumberOrList {
            type Value = PerAxis;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number, or a list of one for each axis")
            }

            fn visit_f64<E: Error>(self, number: f64) -> Result<PerAxis, E> {
                Ok(PerAxis::Same(number))
            }

            fn visit_i64<E: Error>(self, number: i64) -> Result<PerAxis, E> {
                Ok(PerAxis::Same(number as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<PerAxis, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(PerAxis::Each)
            }
        }
        deserializer.deserialize_any(NumberOrList)
    }
}

impl JsonSchema for PerAxis {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "PerAxis".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "One number for all axes, or one for each.",
            "oneOf": [
                { "type": "number" },
                { "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 3 }
            ]
        })
    }
}
