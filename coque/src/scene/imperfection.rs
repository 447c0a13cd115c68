//! What bends a body before anything acts on it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::ModeNumber;

/// Deflection of the unstrained body: the shape of a buckling mode, or of a plate of two sheets half-waves of sines.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Imperfection {
    /// Number of the buckling mode, from 1: one of [analysis.buckling] of the same scene without imperfection, under its full loads
    /// and motions.
    pub mode: Option<ModeNumber>,
    /// In place of a mode, on two sheets: half-waves along x and y, zero on the edges.
    pub half_waves: Option<[u32; 2]>,
    /// Greatest displacement \[L\]. Positive sines go along z; a positive mode along x, y or z where it is greatest along an axis, of
    /// several such particles the first.
    pub amplitude: f64,
}
