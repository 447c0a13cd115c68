//! A scene: a problem as plain, validated data.

mod analysis;
mod bounds;
pub(crate) mod catalogue;
mod check;
mod conditions;
pub(crate) mod error;
mod formulation;
mod geometry;
mod levels;
mod material;
mod mesh;
mod nearest;
mod overrides;
mod read;
pub(crate) mod render;
pub(crate) mod schema;
pub(crate) mod source;
mod statics;
mod tables;
pub(crate) mod units;

pub use analysis::{Analysis, Damping, Explicit, QuasiStatic, Transient};
pub use conditions::{
    Amplitude, Axis, Couple, Diaphragm, Fixed, Force, Gravity, Held, Load, LoadKind, Moved, Pressure,
    Support, SupportKind, Symmetry,
};
pub use formulation::{Formulation, Nodal, Reach, StressPoint, StrongForm};
pub use geometry::{
    Box3, Cylinder, Disorder, Geometry, OnPlane, Orientation, Plate, Region, Scattered, Sphere, Twisted,
};
pub use levels::Levels;
pub(crate) use material::MaterialSection;
pub use material::{Elastic, Homogeneous, Layered, Material, Orthotropic, Ply, Section};
pub use mesh::Mesh;
pub use statics::{ArcLength, Buckling, LevelSign, Linear, Modal, Prebuckling, Static, Stop};

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::source::Source;
use crate::scene::units::Units;

/// A problem: geometry, material, conditions, analysis, and what to record.
///
/// A `Scene` in hand has passed every check that needs no particles; [`Scene::build`] makes the others.
/// Dimensions are in the scene's own units.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Scene {
    /// One line that names the problem.
    pub title: String,
    /// The one consistent set of units.
    pub units: Units,
    /// Shape of the mid-surface and its particles.
    pub geometry: Geometry,
    /// Rotation of geometry, conditions and probes together.
    pub orientation: Option<Orientation>,
    /// What the shell is made of.
    pub material: Material,
    /// How the material fills the thickness.
    pub section: Section,
    /// The particle method.
    #[serde(default)]
    pub formulation: Formulation,
    /// Particle sets by name, beside the built-in ones.
    #[serde(default)]
    pub sets: BTreeMap<String, Region>,
    /// Supports and prescribed motions.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// Loads.
    #[serde(default)]
    pub loads: Vec<Load>,
    /// How to find answers.
    pub analysis: Analysis,
    /// Columns of the curve.
    #[serde(default)]
    pub curve: Vec<Probe>,
    /// Further results.
    #[serde(default)]
    pub output: Output,
    /// The text the scene was read from.
    #[serde(skip, default = "Source::none")]
    pub source: Source,
}

/// One column of the curve.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name of the column.
    pub name: String,
    /// What it measures.
    pub of: Measured,
    /// Particle set; the mean over it, for a reaction the sum.
    pub on: String,
    /// Component that is taken, in the un-turned frame.
    pub direction: [f64; 3],
    /// Factor on the value, such as 4 for the reaction of a quarter model.
    #[serde(default = "one")]
    pub factor: f64,
}

/// What a column measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Measured {
    /// Component of the displacement \[L\].
    Displacement,
    /// Component of the position \[L\].
    Position,
    /// Component of the force that the supports exert \[F\].
    Reaction,
    /// Angle by which the director has turned about the direction, counted on beyond π \[rad\].
    Rotation,
    /// Component of the director \[–\].
    Director,
}

/// Further results.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Columns of the plot `curve.svg`.
    pub plot: Option<Plot>,
    /// Frames for ParaView, in the folder `fields`.
    pub fields: Option<Fields>,
    /// Longest wall time between checkpoints, from which `coque resume` goes on \[s\]; none are kept without.
    pub checkpoint_every: Option<f64>,
}

/// Which frames are written, and what stands in them beside the motion of the particles.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fields {
    /// Every N-th settled level, record in time, converged point or mode; the first always.
    #[serde(default = "each")]
    pub every: u64,
    /// The shell with its thickness as well, in files of its own.
    #[serde(default)]
    pub extruded: bool,
    /// Strains, resultants and, of homogeneous sections, surface stresses at the sampling points.
    #[serde(default)]
    pub stresses: bool,
}

/// Which column is drawn over which.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plot {
    /// Column along the horizontal axis.
    pub x: String,
    /// Column along the vertical axis.
    pub y: String,
}

fn each() -> u64 {
    1
}

fn one() -> f64 {
    1.0
}
