//! Walls in a scene: rigid boundaries of a fluid, at rest or in a given motion.

use explicit_dynamics::Amplitude;
use schemars::JsonSchema;
use serde::Deserialize;
use sph_core::LineSide;

use super::waves::WallWaves;
use crate::scene::bounded::Positive;

/// Rigid walls of a fluid: rows of particles behind their faces, as deep as the kernel of the fluid reaches.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallsScene {
    /// Their shape.
    pub geometry: WallGeometry,
    /// Their motion; left out, they stand.
    pub motion: Option<WallMotion>,
}

/// Shapes of walls.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum WallGeometry {
    /// A box from inside.
    Basin(Basin),
    /// A box from outside: an obstacle.
    Block(Obstacle),
    /// A line of straight pieces in the plane.
    Polyline(Polyline),
    /// A surface of triangles from a file, in space.
    Surface(WallSurface),
}

/// A box that holds the fluid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Basin {
    /// Least coordinates of its inside \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub min: Vec<f64>,
    /// Greatest coordinates of its inside \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub max: Vec<f64>,
    /// Sides without a wall, of `x0`, `x1`, `y0`, `y1`, `z0`, `z1`; left out, none.
    #[serde(default)]
    pub open: Vec<String>,
}

/// A box in the way of the fluid.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Obstacle {
    /// Edges along x, y and, in space, z \[L\].
    #[schemars(length(min = 2, max = 3))]
    pub lengths: Vec<Positive>,
    /// The corner of least coordinates \[L\]; left out, the origin.
    #[schemars(length(min = 2, max = 3))]
    pub origin: Option<Vec<f64>>,
}

/// A line of straight pieces.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polyline {
    /// Its corners in order; it is closed where the last is the first \[L\].
    pub points: Vec<[f64; 2]>,
    /// Where the wall lies, seen along the line; the fluid is on the other side.
    pub side: LineSide,
}

/// A surface from a file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallSurface {
    /// The file (STL, OBJ and the other formats of meshes), relative to the scene.
    pub file: String,
    /// A point on the side of the fluid \[L\].
    pub inside: [f64; 3],
    /// Factor on the coordinates of the file.
    #[serde(default = "one")]
    pub scale: Positive,
}

/// A rigid motion, each part a course in time that starts at zero.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallMotion {
    /// Displacement.
    pub translation: Option<WallTranslation>,
    /// Rotation, before the displacement.
    pub rotation: Option<WallRotation>,
    /// The motion of a wave maker, in place of both.
    pub waves: Option<WallWaves>,
}

/// Displacement of walls.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallTranslation {
    /// Displacement where the course is one \[L\].
    pub by: [f64; 3],
    /// Course in time.
    pub amplitude: Amplitude,
}

/// Rotation of walls about a fixed axis.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WallRotation {
    /// A point of the axis \[L\].
    #[serde(default)]
    pub centre: [f64; 3],
    /// The axis; its length does not matter.
    pub axis: [f64; 3],
    /// Angle where the course is one, right-handed \[degrees\].
    pub by: f64,
    /// Course in time.
    pub amplitude: Amplitude,
}

impl WallsScene {
    /// Whether its motion turns it.
    pub(crate) fn turns(&self) -> bool {
        let turns = |motion: &WallMotion| {
            motion.rotation.is_some() || motion.waves.as_ref().is_some_and(|own| own.hinge.is_some())
        };
        self.motion.as_ref().is_some_and(turns)
    }
}

impl WallGeometry {
    /// Key of the shape in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Basin(_) => "basin",
            Self::Block(_) => "block",
            Self::Polyline(_) => "polyline",
            Self::Surface(_) => "surface",
        }
    }

    /// Dimensions of the shape.
    pub fn dimensions(&self) -> usize {
        match self {
            Self::Basin(basin) => basin.min.len(),
            Self::Block(block) => block.lengths.len(),
            Self::Polyline(_) => 2,
            Self::Surface(_) => 3,
        }
    }
}

fn one() -> Positive {
    Positive::usual(1.0)
}
