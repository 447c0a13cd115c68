//! Load levels: so many equal ones, or a list.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, SeqAccess, Visitor};

/// Load levels.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// This many equal steps up to one.
    Equal(u64),
    /// These levels, in order.
    List(Vec<f64>),
}

impl Levels {
    /// The levels, written out.
    pub fn list(&self) -> Vec<f64> {
        match self {
            Self::Equal(count) => (1..=*count).map(|i| i as f64 / *count as f64).collect(),
            Self::List(levels) => levels.clone(),
        }
    }
}

impl<'de> Deserialize<'de> for Levels {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct CountOrList;
        impl<'de> Visitor<'de> for CountOrList {
            type Value = Levels;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a number of equal levels, or a list such as [0.25, 0.5, 1.0]")
            }

            fn visit_i64<E: serde::de::Error>(self, count: i64) -> Result<Levels, E> {
                u64::try_from(count).map(Levels::Equal).map_err(|_| {
                    E::invalid_value(serde::de::Unexpected::Signed(count), &"a positive number of levels")
                })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Levels, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(seq)).map(Levels::List)
            }
        }
        deserializer.deserialize_any(CountOrList)
    }
}

impl JsonSchema for Levels {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Levels".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Load levels: this many equal steps up to one, or these, in order.",
            "oneOf": [
                { "type": "integer", "minimum": 1 },
                { "type": "array", "items": { "type": "number" }, "minItems": 1 }
            ]
        })
    }
}
