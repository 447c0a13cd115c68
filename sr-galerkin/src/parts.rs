//! What a body is made of: nodes, background cells, material, conditions, loads.

use solid_kinematics::{Material, Tangent, Tensor};
use sph_core::{Basis, FacePoint, Hexahedra, Support, Vec3, VolumePoint, Weight};

use crate::images::Mirror;

/// Everything that a body is built from.
pub struct Parts {
    /// Nodes \[L\].
    pub nodes: Vec<Vec3>,
    /// Background cells, where the integrals are taken.
    pub cells: Hexahedra,
    /// Gauss points along an edge of a cell, 1 to 4; 3 is usual.
    pub rule: usize,
    /// What a surface cuts out of the cells; none of whole ones.
    pub cut: Option<CutCells>,
    /// Basis of the shape functions.
    pub basis: Basis,
    /// Their support.
    pub support: Support,
    /// Their weight.
    pub weight: Weight,
    /// Material.
    pub material: Material,
    /// Material axes at rest, as columns.
    pub axes: Tensor,
    /// Density \[M/L³\].
    pub density: f64,
    /// Planes of symmetry; what holds nodes on them is in the conditions.
    pub mirrors: Vec<Mirror>,
    /// What holds and moves nodes.
    pub conditions: Vec<Condition>,
    /// How conditions are imposed.
    pub essential: Essential,
    /// Loads at level one.
    pub loads: Vec<Load>,
    /// Derivative that Newton's method iterates with.
    pub tangent: Tangent,
    /// Where the change of volume is taken.
    pub volumes: Volumes,
    /// Threads; the answer is the same to the last bit.
    pub threads: usize,
}

/// Cells that a surface cuts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutCells {
    /// Points of each, the cube of the rule, in place of Gauss's; volumes may be zero.
    pub points: Vec<Vec<VolumePoint>>,
    /// Points of the whole surface, by which what a uniform stress leaves on nodes is found ([`crate::Galerkin::uneven`]).
    pub surface: Vec<FacePoint>,
    /// Volumes of the nodes, by which masses are shared out where the integral of a shape function is not positive \[L³\].
    pub shares: Vec<f64>,
}

/// A prescribed displacement of nodes along a direction; the others stay free.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// The nodes.
    pub nodes: Vec<u32>,
    /// Direction; its length does not matter.
    pub direction: Vec3,
    /// Displacement at level one \[L\]; it goes with the level.
    pub by: f64,
}

impl Condition {
    /// Nodes that stay where they are along a direction.
    pub fn held(nodes: Vec<u32>, direction: Vec3) -> Self {
        Self { nodes, direction, by: 0.0 }
    }

    /// Nodes that stay where they are.
    pub fn fixed(nodes: &[u32]) -> [Self; 3] {
        [Vec3::x(), Vec3::y(), Vec3::z()].map(|axis| Self::held(nodes.to_vec(), axis))
    }
}

/// Where the change of volume is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "GalerkinVolumes")
)]
pub enum Volumes {
    /// Of a material that Poisson's ratios make more than three times as stiff against it (ν above ⅓) the points of a cell share its
    /// mean, the more so the stiffer: else the solid locks as it becomes incompressible.
    #[default]
    Shared,
    /// The points of a cell have its mean, whatever the material: of one that flows, which keeps its volume as it does so.
    Mean,
    /// At every point by itself.
    Points,
}

/// How conditions are imposed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "GalerkinEssential")
)]
pub enum Essential {
    /// Displacements of nodes have the prescribed values.
    #[default]
    Collocation,
    /// Nodal parameters have them, as in the source: displacements leak.
    Direct,
}

/// A load at level one.
#[derive(Clone, Debug, PartialEq)]
pub enum Load {
    /// A force per area at rest, its direction fixed \[F/L²\].
    Traction {
        /// Faces of background cells, by their corners.
        faces: Vec<[u32; 4]>,
        /// The traction.
        traction: Vec3,
    },
    /// A force per volume at rest, its direction fixed \[F/L³\].
    Body(Vec3),
    /// A pressure that stays normal to the deformed face and presses on it \[F/L²\].
    Pressure {
        /// Faces of background cells, by their corners.
        faces: Vec<[u32; 4]>,
        /// The pressure.
        pressure: f64,
    },
    /// A traction at points of a surface that is no face of a cell.
    TractionOver {
        /// Points with their areas.
        points: Vec<FacePoint>,
        /// The traction \[F/L²\].
        traction: Vec3,
    },
    /// A pressure that follows, at such points.
    PressureOver {
        /// Points with their tangents at rest.
        points: Vec<FacePoint>,
        /// The pressure \[F/L²\].
        pressure: f64,
    },
    /// A force at a point, its direction fixed.
    Point {
        /// Place at rest \[L\].
        place: Vec3,
        /// The force \[F\].
        force: Vec3,
    },
}
