//! When bonds break, cracks that are there at the start, contact of what has come apart.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{Near, Positive, Shortening};

/// When bonds break: exactly one of `energy` and `stretch` is given.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fracture {
    /// Energy that a unit area of crack takes \[F/L\].
    pub energy: Option<Positive>,
    /// What of a bond is held against its share of that energy; left out, its stretch.
    pub by: Option<BondMeasure>,
    /// Stretches of a bond at which it breaks.
    pub stretch: Option<Stretches>,
}

/// What of a bond is held against its share of the energy of a crack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BondMeasure {
    /// Its stretch in tension.
    #[default]
    Stretch,
    /// The work done on it in tension.
    Work,
}

/// Stretches, extension over length, at which a bond breaks.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stretches {
    /// Greatest stretch \[–\].
    pub tension: Positive,
    /// Least stretch, between -1 and 0 \[–\]; left out, bonds do not break in compression.
    pub compression: Option<Shortening>,
}

/// A crack that is there at the start: it breaks every bond that it cuts. In a plane it goes `from` one point `to` another, in
/// space it is a plane convex polygon of `corners`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Crack {
    /// One end \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub from: Option<Vec<f64>>,
    /// The other end \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub to: Option<Vec<f64>>,
    /// Corners in order \[L\].
    pub corners: Option<Vec<[f64; 3]>>,
}

/// Contact: nodes without a bond that come near each other repel.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Distance at which they begin to, over the spacing \[–\].
    #[serde(default = "usual_distance")]
    pub distance: Near,
    /// Planes that no node passes.
    #[serde(default)]
    pub walls: Vec<Wall>,
}

/// A plane that no node passes.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// A point of the plane \[L\].
    pub point: [f64; 3],
    /// Its normal, towards the body; the length does not matter.
    pub normal: [f64; 3],
}

/// A little less than the distance at which neighbours stand at rest.
fn usual_distance() -> Near {
    Near::usual(0.9)
}
