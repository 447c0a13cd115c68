//! The nodes of a solid: a box in rows, straight or bent, and what is cut out of it; or a lattice in a closed surface.

use schemars::JsonSchema;
use serde::Deserialize;
use sph_core::{BlockLattice, Vec3};

use crate::scene::bounded::{BlockGrading, Displaced, Positive};
use crate::scene::per_axis::PerAxis;
use crate::scene::shell::mesh::{Mesh, unscaled};
use crate::scene::solid::SolidScene;

/// The nodes of a solid: exactly one of `block`, `arc` and `filled` is given.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidGeometry {
    /// A box of nodes along the axes.
    pub block: Option<Block>,
    /// Part of a cylinder with its thickness, of a Galerkin solid.
    pub arc: Option<Arc>,
    /// What a closed surface from a file encloses.
    pub filled: Option<FilledSurface>,
    /// What is cut out of a block: a node goes where its place lies in one of these.
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

/// A closed surface that looks outwards, filled with nodes of a cubic lattice.
///
/// The surface cuts the cells of the lattice: a node has the volume of what of its cell lies inside and stands at the centroid of that, and cells
/// less than half full go to the nodes beside them. Of a Galerkin solid nodes stand at the corners of cells, the outermost on the surface, and integrals are
/// taken over what of the cells lies inside. Volume, centroid and area of the body are those of the surface. Groups of faces of the file are
/// sets; so are `surface`, all of it, and `x0` to `z1`, what of it lies in the planes of the box round it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FilledSurface {
    /// The file, relative to the folder of the scene: `.stl`, `.obj`, `.ply`, `.msh`, `.inp` or `.vtu`. Of tetrahedra in a `.msh` it is what bounds
    /// them.
    pub file: String,
    /// Distance between nodes \[L\]. The lattice begins at a flat end of the surface, else its middle is that of the box round it.
    pub spacing: Positive,
    /// Factor on all lengths of the file, such as 0.001 from mm to m.
    #[serde(default = "unscaled")]
    pub scale: Positive,
    /// Whether to turn all faces to the other side, of a file whose faces look inwards.
    #[serde(default)]
    pub flip: bool,
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

impl SolidScene {
    /// The lattice of its nodes; of an arc that of the straight block that is bent to it, the middle surface at z = 0. A surface that they fill has
    /// one when its file has been read, without extent before.
    pub(crate) fn lattice(&self) -> BlockLattice {
        match (&self.geometry.block, self.geometry.arc) {
            (Some(block), _) => self.lattice_of(block),
            (None, arc) => arc.map_or_else(empty, |arc| arc.straight()),
        }
    }

    fn lattice_of(&self, block: &Block) -> BlockLattice {
        let Block { lengths, spacing, origin, thickness, nodes, grading, disorder } = block;
        let origin = |axis: usize| origin.as_ref().and_then(|list| list.get(axis)).copied().unwrap_or(0.0);
        let grading = |axis: usize| grading.as_ref().and_then(|list| list.get(axis)).map_or(1.0, |g| g.get());
        let across = thickness.map_or(1.0, |thickness| thickness.get());
        let on_faces = self.has_directors() || self.galerkin().is_some();
        let usual = if on_faces { NodePlaces::Edges } else { NodePlaces::Centres };
        BlockLattice {
            dimensions: lengths.len(),
            lengths: [0, 1, 2].map(|axis| lengths.get(axis).map_or(across, |length| length.get())),
            spacing: [0, 1, 2].map(|axis| spacing.along(axis)),
            origin: Vec3::from([0, 1, 2].map(origin)),
            nodes: match nodes.unwrap_or(usual) {
                NodePlaces::Centres => sph_core::NodePlaces::Centres,
                NodePlaces::Edges => sph_core::NodePlaces::Edges,
            },
            grading: [0, 1, 2].map(grading),
            disorder: disorder.map_or(0.0, |disorder| disorder.fraction.get()),
            seed: disorder.map_or(0, |disorder| disorder.seed),
        }
    }
}

impl FilledSurface {
    /// Its file, as other bodies name one.
    pub(crate) fn mesh(&self) -> Mesh {
        Mesh { file: self.file.clone(), scale: self.scale, flip: self.flip }
    }
}

impl SolidGeometry {
    /// Key of what its nodes are.
    pub(crate) fn word(&self) -> &'static str {
        match (&self.block, &self.filled) {
            (Some(_), _) => "block",
            (None, Some(_)) => "filled",
            (None, None) => "arc",
        }
    }
}

impl Arc {
    /// The straight block that is bent to it.
    fn straight(&self) -> BlockLattice {
        let [first, last] = self.angles.map(f64::to_radians);
        let lengths = [self.radius.get() * (last - first), self.length.get(), self.thickness.get()];
        BlockLattice {
            lengths,
            spacing: [0, 1, 2].map(|axis| lengths[axis] / self.cells[axis] as f64),
            origin: Vec3::new(self.radius.get() * first, 0.0, -0.5 * self.thickness.get()),
            nodes: sph_core::NodePlaces::Edges,
            ..empty()
        }
    }

    /// The place of a point of the straight block.
    pub(crate) fn bent(&self, x: &Vec3) -> Vec3 {
        let (angle, radius) = (x.x / self.radius.get(), self.radius.get() + x.z);
        Vec3::new(radius * libm::sin(angle), x.y, radius * libm::cos(angle))
    }
}

/// A lattice without extent.
fn empty() -> BlockLattice {
    BlockLattice {
        dimensions: 3,
        lengths: [0.0; 3],
        spacing: [0.0; 3],
        origin: Vec3::zeros(),
        nodes: sph_core::NodePlaces::Centres,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 0,
    }
}
