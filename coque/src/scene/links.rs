//! Links: springs by a table, cables, gaps and dashpots between sets and to the ground.

use schemars::JsonSchema;
use serde::Deserialize;

use super::bounded::{NotNegative, Positive};

/// A link from each place of a set to the ground or to another set: a spring, a cable, a stop behind a gap, or a dashpot. All its places share it
/// equally. It is drawn by the distance of its ends, or by their motion along a direction. No level scales it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkScene {
    /// Set at the near end, in a scene of several bodies written `body.set`.
    pub on: String,
    /// Set at the far end, of as many places, each paired with the nearest one: of another body or of the same one. Left out, the ground.
    pub to: Option<String>,
    /// Point of the ground at the far end \[L\], to which the line from each place goes.
    pub point: Option<[f64; 3]>,
    /// Direction of the motion that draws it, fixed in space: that of the set against the ground, or of `to` against the set; its length does not
    /// matter. Left out, the distance of its ends draws it.
    pub direction: Option<[f64; 3]>,
    /// Distance of its ends without a force \[L\]: below their distance at rest it is taut, above it slack. Left out, that at rest.
    pub length: Option<NotNegative>,
    /// Stiffness of the whole set, force by elongation \[F/L\].
    pub stiffness: Option<Positive>,
    /// Force of the whole set by elongation, `[[elongation, force], …]` with elongations ascending, straight between points and beyond them; none at
    /// elongation zero \[L, F\].
    pub table: Option<Vec<[f64; 2]>>,
    /// Dashpot of the whole set, force by rate of elongation \[F T/L\].
    pub damping: Option<Positive>,
    /// To which side alone a stiffness bears: in tension as a cable, or in compression as a stop.
    pub bears: Option<Side>,
    /// Elongation, to either side, from which on a stiffness bears: a gap that closes \[L\].
    pub gap: Option<Positive>,
}

/// A side to which a link bears.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// It pulls, and is slack where its ends come near.
    Tension,
    /// It pushes, and lets go where its ends go apart.
    Compression,
}
