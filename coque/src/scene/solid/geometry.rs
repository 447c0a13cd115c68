//! The nodes of a solid: a box in rows, straight or bent, and what is cut out of it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::{BlockGrading, Displaced, Positive};
use crate::scene::per_axis::PerAxis;

/// The nodes of a solid: exactly one of `block` and `arc` is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidGeometry {
    /// A box of nodes along the axes.
    pub block: Option<Block>,
    /// Part of a cylinder with its thickness, of a Galerkin solid.
    pub arc: Option<Arc>,
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
    pub lengths: Vec<Positive>,
    /// Distance between nodes, one for all axes or one for each \[L\]; the nearest that divides the lengths is taken.
    pub spacing: PerAxis,
    /// The corner of least coordinates \[L\]; left out, the origin.
    #[schemars(length(min = 2, max = 3))]
    pub origin: Option<Vec<f64>>,
    /// Thickness across the plane of a block of two lengths \[L\], by which forces, masses and energies are multiplied; left out, they are those of
    /// a unit of depth. A plate of two sheets must give it.
    pub thickness: Option<Positive>,
    /// Where the nodes stand; left out, `centres`, of a plate of two sheets `edges`.
    pub nodes: Option<NodePlaces>,
    /// Last over first spacing along each axis; 1 is even.
    #[schemars(length(min = 2, max = 3))]
    pub grading: Option<Vec<BlockGrading>>,
    /// Moves nodes at random.
    pub disorder: Option<NodeDisorder>,
}

/// Part of a thick cylinder about the y axis, as the cylinder of a shell: x of its sets runs along the arc, y along the axis from
/// zero, z outward. `x0` names the face at the first angle.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// Radius of the middle surface \[L\].
    pub radius: Positive,
    /// First and last angle \[degrees\], 0 at the crown +z, growing towards +x.
    pub angles: [f64; 2],
    /// Length along y \[L\].
    pub length: Positive,
    /// Thickness, half of it to either side of the middle surface \[L\].
    pub thickness: Positive,
    /// Cells along the arc, along y and across; nodes stand at their corners.
    pub cells: [usize; 3],
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
    pub fraction: Displaced,
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
    pub radius: Positive,
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
    pub radius: Positive,
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
