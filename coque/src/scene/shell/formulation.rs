//! The particle method: where strains are sampled and how wide the corrected kernel reaches.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Deserialize;
use serde::de::{Deserializer, Error, Visitor};
use sph_shell::Divergence;

use crate::scene::bounded::{NotNegative, Order, Smoothing};

/// The particle method.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Formulation {
    /// Strains at one point per cell of the cloud; forces are the exact transpose.
    StressPoint(StressPoint),
    /// Strains at the particles; forces are the exact transpose.
    Nodal(Nodal),
    /// Strains and stress divergence at the particles, by the equations published in \[lin2013\].
    StrongForm(StrongForm),
}

/// Options of [`Formulation::StressPoint`].
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StressPoint {
    /// Reach of the kernel; left out, that of the cell.
    #[serde(default)]
    pub support: Reach,
    /// Kernel; only with a reach in numbers.
    pub kernel: Option<String>,
    /// Measure of the curvature: `stretch-corrected`, of a material that yields `logarithmic`.
    pub curvature: Option<String>,
}

/// How far the kernel of a stress point reaches.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Reach {
    /// To the three or four particles of the cell, in closed form.
    #[default]
    Cell,
    /// To this many distances to the fourth nearest particle.
    Wide(f64),
}

/// Options of [`Formulation::Nodal`].
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nodal {
    /// Degree of the polynomials that gradients reproduce, 1 to 3.
    #[serde(default = "first")]
    pub order: Order,
    /// Smoothing length in spacings; 1.2, 1.3, 1.5 for order 1, 2, 3.
    pub smoothing: Option<Smoothing>,
    /// Corrects gradients so that constant stress has no divergence; default from order 2.
    pub consistent: Option<bool>,
    /// Kernel.
    #[serde(default = "cubic_spline")]
    pub kernel: String,
    /// Measure of the curvature.
    #[serde(default = "stretch_corrected")]
    pub curvature: String,
}

/// Options of [`Formulation::StrongForm`].
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrongForm {
    /// How the sum of eq. 4 reads the divergence of the stress.
    #[serde(default)]
    pub divergence: Divergence,
    /// Smoothing length in spacings; 1.2 with the sum, 0.85 with the difference.
    pub smoothing: Option<Smoothing>,
    /// Coefficient of the artificial viscosity \[–\].
    #[serde(default = "published_viscosity")]
    pub viscosity: NotNegative,
    /// Kernel.
    #[serde(default = "cubic_spline")]
    pub kernel: String,
    /// Measure of the curvature; with the sum that of the paper, `green-lagrange`, with the difference `stretch-corrected`.
    pub curvature: Option<String>,
}

impl Default for Formulation {
    fn default() -> Self {
        Self::StressPoint(StressPoint { support: Reach::Cell, kernel: None, curvature: None })
    }
}

impl Formulation {
    /// Key of the method in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::StressPoint(_) => "stress-point",
            Self::Nodal(_) => "nodal",
            Self::StrongForm(_) => "strong-form",
        }
    }

    /// Name of the curvature measure, where it does not depend on the material.
    pub fn curvature(&self) -> Option<&str> {
        match self {
            Self::StressPoint(f) => f.curvature.as_deref(),
            Self::Nodal(f) => Some(&f.curvature),
            Self::StrongForm(f) => Some(f.curvature()),
        }
    }

    /// Name of the kernel; none where cells do without one.
    pub fn kernel(&self) -> Option<&str> {
        match self {
            Self::StressPoint(f) if f.support == Reach::Cell => None,
            Self::StressPoint(f) => Some(f.kernel.as_deref().unwrap_or(CUBIC_SPLINE)),
            Self::Nodal(f) => Some(&f.kernel),
            Self::StrongForm(f) => Some(&f.kernel),
        }
    }

    /// One line that names the method with its options.
    pub fn describe(&self) -> String {
        match self {
            Self::StressPoint(f) => match f.support {
                Reach::Cell => "stress-point, support cell".into(),
                Reach::Wide(reach) => format!("stress-point, support {reach}"),
            },
            Self::Nodal(f) => format!("nodal, order {}, smoothing {}", f.order, f.smoothing_length()),
            Self::StrongForm(f) => {
                let divergence = if f.divergence == Divergence::Sum { "sum" } else { "difference" };
                format!("strong-form, {divergence}, smoothing {}", f.smoothing_length())
            }
        }
    }
}

impl Nodal {
    /// Smoothing length in spacings, with the default of the order.
    pub fn smoothing_length(&self) -> f64 {
        // Widths at which each order was studied and found stable on regular and disordered clouds.
        let usual = match self.order.get() {
            1 => 1.2,
            2 => 1.3,
            _ => 1.5,
        };
        self.smoothing.map_or(usual, |smoothing| smoothing.get())
    }

    /// Whether gradients are corrected for a consistent divergence.
    pub fn divergence_consistent(&self) -> bool {
        self.consistent.unwrap_or(true)
    }
}

impl StrongForm {
    /// Smoothing length in spacings, with the default of the divergence.
    pub fn smoothing_length(&self) -> f64 {
        // Of the paper, and the width up to which a march damps what grows at edges.
        let usual = if self.divergence == Divergence::Sum { 1.2 } else { 0.85 };
        self.smoothing.map_or(usual, |smoothing| smoothing.get())
    }

    /// Name of the curvature measure, with the default of the divergence.
    pub fn curvature(&self) -> &str {
        let usual = if self.divergence == Divergence::Sum { "green-lagrange" } else { STRETCH_CORRECTED };
        self.curvature.as_deref().unwrap_or(usual)
    }
}

const CUBIC_SPLINE: &str = "cubic-spline";
pub(super) const STRETCH_CORRECTED: &str = "stretch-corrected";

fn cubic_spline() -> String {
    CUBIC_SPLINE.into()
}

fn stretch_corrected() -> String {
    STRETCH_CORRECTED.into()
}

fn first() -> Order {
    Order::usual(1)
}

/// Coefficient of the artificial viscosity of \[lin2013\].
fn published_viscosity() -> NotNegative {
    NotNegative::usual(1.0)
}

impl<'de> Deserialize<'de> for Reach {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct WordOrNumber;
        impl Visitor<'_> for WordOrNumber {
            type Value = Reach;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("\"cell\" or a number")
            }

            fn visit_str<E: Error>(self, word: &str) -> Result<Reach, E> {
                match word {
                    "cell" => Ok(Reach::Cell),
                    _ => Err(E::unknown_variant(word, &["cell"])),
                }
            }

            fn visit_f64<E: Error>(self, reach: f64) -> Result<Reach, E> {
                Ok(Reach::Wide(reach))
            }

            fn visit_i64<E: Error>(self, reach: i64) -> Result<Reach, E> {
                Ok(Reach::Wide(reach as f64))
            }
        }
        deserializer.deserialize_any(WordOrNumber)
    }
}

impl JsonSchema for Reach {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Reach".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "How far the kernel of a stress point reaches: to the particles of the cell, in closed form, \
                            or to this many distances to the fourth nearest particle.",
            "oneOf": [{ "const": "cell" }, { "type": "number" }]
        })
    }
}
