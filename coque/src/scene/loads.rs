//! Loads, each on a named set of particles.

use explicit_dynamics::Amplitude;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use crate::scene::bounded::{NotNegative, Positive};
use crate::scene::heat::Conducted;

/// A load: exactly one kind is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// Particle set, or a list of sets: the union of them.
    pub on: String,
    /// Dead force, shared by the set.
    pub force: Option<Force>,
    /// Couple about a fixed axis or about the moving edge, also about normals.
    pub couple: Option<Couple>,
    /// Pressure along the normal of a shell or of some of its cells, dead or following it; on faces of a Galerkin solid against
    /// their normal, following them.
    pub pressure: Option<Pressure>,
    /// Gas that the cells of the set enclose: one pressure, which falls as they give way.
    pub gas: Option<Gas>,
    /// Liquid that the cells of the set enclose: a volume that is pumped in or shut in.
    pub volume: Option<Volume>,
    /// Weight: an acceleration of the mass of the set.
    pub gravity: Option<Gravity>,
    /// Dead force by area on a face of a solid, or on cells of a shell.
    pub traction: Option<Traction>,
    /// Change of temperature of cells of a shell or of a solid, whose material says how it expands.
    pub temperature: Option<Temperature>,
    /// Load case to which it belongs, in a linear analysis: each case has an answer of its own, and combinations of them.
    pub case: Option<String>,
    /// Variation in time, in transient runs.
    pub amplitude: Option<Amplitude>,
    /// Whether it is applied in full before the analysis and held: the level counts the other loads.
    #[serde(default)]
    pub preload: bool,
    /// Whether it stands for what shakes the supports in axes that go with them; no scene writes it.
    #[serde(skip)]
    pub(crate) of_base: bool,
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

/// Couple on a set, by tributary length on an edge, else equally: on its directors, and where the axis has a part along normals on the places around its
/// particles, of a line on the line itself.
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

/// A gas enclosed by cells: `(p + ambient) V^exponent` stays what it is. The level, and an `amplitude` in time, pumps it in; as a `preload` it is
/// pumped in first and then held. The surface is closed, or open at rims that are held or slide in planes of symmetry or on walls.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gas {
    /// Pressure over that of the surroundings that all of it has in the volume at rest \[F/L²\]; zero of a gas that is only shut in.
    pub pressure: f64,
    /// Pressure of the surroundings, which it has before any is pumped in \[F/L²\].
    #[serde(default)]
    pub ambient: NotNegative,
    /// One at a constant temperature; the ratio of specific heats, 1.4 of air, where no heat is exchanged \[–\].
    pub exponent: Option<Positive>,
    /// Volume that it fills beside what the cells enclose, such as a tank \[L³\].
    #[serde(default)]
    pub beside: NotNegative,
}

impl Gas {
    /// The exponent, one where none is given.
    pub fn exponent(&self) -> f64 {
        self.exponent.map_or(1.0, Positive::get)
    }
}

/// A liquid that fills what cells enclose, to the brim at rest: `p = bulk_modulus (filled − V)/V`. The level, and an `amplitude` in time, pumps it in.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Volume {
    /// Volume without pressure that is pumped in, taken out where negative \[L³\]; zero of a liquid that is only shut in.
    pub added: f64,
    /// Pressure over the relative change of the liquid's volume, 2200 MPa of water \[F/L²\].
    pub bulk_modulus: Positive,
    /// Volume that it fills beside what the cells enclose \[L³\].
    #[serde(default)]
    pub beside: NotNegative,
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

/// Change of temperature of cells of a shell, of one or both of its two parts, of all of a Galerkin solid, or of nodes with bonds. The level brings it up; in a transient run it is there from the start.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Temperature {
    /// Change in the middle of the thickness, or of the whole solid, in the unit of temperature that `expansion` is by \[Θ\].
    pub change: Option<f64>,
    /// Of a shell the change of the upper face, to which the normals point, less that of the lower \[Θ\].
    pub difference: Option<f64>,
    /// Name of an array in memory with a number for each particle of a shell: in a cell the mean of its corners' multiplies `change` and `difference`.
    /// Python brings such arrays.
    pub values: Option<String>,
    /// In place of numbers: what the body takes up as it conducts the heat of `[[heat]]`.
    pub conducted: Option<Conducted>,
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
    /// See [`Load::gas`].
    Gas(Gas),
    /// See [`Load::volume`].
    Volume(Volume),
    /// See [`Load::gravity`].
    Gravity(Gravity),
    /// See [`Load::traction`].
    Traction(Traction),
    /// See [`Load::temperature`].
    Temperature(Temperature),
}

impl Load {
    /// Keys of the kinds.
    pub const WORDS: [&'static str; 8] =
        ["force", "couple", "pressure", "gas", "volume", "gravity", "traction", "temperature"];

    /// What a shaken base does to all of a body.
    pub(super) fn weight_of_base(gravity: Gravity) -> Self {
        Self {
            on: "all".into(),
            force: None,
            couple: None,
            pressure: None,
            gas: None,
            volume: None,
            gravity: Some(gravity),
            traction: None,
            temperature: None,
            case: None,
            amplitude: None,
            preload: false,
            of_base: true,
        }
    }

    /// Whether it acts on the cells of its set, of a shell: its particles do not say on which area. Pressure and gravity on all
    /// of a shell ask for no set.
    pub fn acts_on_cells(&self) -> bool {
        let by_area = self.traction.is_some() || self.force.is_some_and(|force| force.by_area);
        let uneven = self.pressure.as_ref().is_some_and(|pressure| pressure.values.is_some());
        by_area
            || uneven
            || self.encloses()
            || self.heats()
            || (self.on != "all" && (self.pressure.is_some() || self.gravity.is_some()))
    }

    /// Whether it is what cells enclose.
    pub fn encloses(&self) -> bool {
        self.gas.is_some() || self.volume.is_some()
    }

    /// Whether it is a change of temperature, which exerts no force of its own.
    pub fn heats(&self) -> bool {
        self.temperature.is_some()
    }

    /// Every kind that is given, with its key; a checked scene has exactly one.
    pub fn kinds(&self) -> Vec<(&'static str, LoadKind)> {
        [
            self.force.map(LoadKind::Force),
            self.couple.map(LoadKind::Couple),
            self.pressure.clone().map(LoadKind::Pressure),
            self.gas.map(LoadKind::Gas),
            self.volume.map(LoadKind::Volume),
            self.gravity.map(LoadKind::Gravity),
            self.traction.map(LoadKind::Traction),
            self.temperature.clone().map(LoadKind::Temperature),
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
