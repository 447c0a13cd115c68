//! The mid-surface from a file.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// Triangles and quadrangles, or points, from a file; particles at its nodes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// The file, relative to the folder of the scene: `.msh`, `.inp`, `.stl`, `.obj`, `.ply`, `.vtu` or `.csv`.
    pub file: String,
    /// Factor on all lengths of the file, such as 0.001 from mm to m.
    #[serde(default = "unscaled")]
    pub scale: Positive,
    /// Whether to turn the normals to the other side.
    #[serde(default)]
    pub flip: bool,
}

pub(in crate::scene) fn unscaled() -> Positive {
    Positive::usual(1.0)
}
