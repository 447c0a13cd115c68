//! A scene: a problem as plain, validated data.

mod analysis;
mod bounds;
pub(crate) mod catalogue;
mod check;
mod conditions;
mod curve;
pub(crate) mod error;
mod forms;
mod levels;
mod nearest;
mod output;
mod overrides;
mod problem;
mod read;
mod region;
pub(crate) mod render;
pub(crate) mod schema;
mod scope;
mod shell;
pub(crate) mod source;
mod statics;
mod tables;
pub(crate) mod units;

pub use analysis::{Analysis, Damping, Explicit, QuasiStatic, Transient};
pub use conditions::{
    Amplitude, Axis, Couple, Diaphragm, Fixed, Force, Gravity, Held, Load, LoadKind, Moved, Pressure,
    Support, SupportKind, Symmetry,
};
pub use curve::{Measured, Probe};
pub use levels::Levels;
pub use output::{Fields, Output, Plot};
pub use problem::{BodyScene, Scene};
pub use region::{Box3, OnPlane, Region};
pub use shell::ShellScene;
pub use shell::formulation::{Formulation, Nodal, Reach, StressPoint, StrongForm};
pub use shell::geometry::{
    Cylinder, Disorder, Geometry, Orientation, Placing, Plate, Scattered, Sphere, Twisted,
};
pub(crate) use shell::material::MaterialSection;
pub use shell::material::{Elastic, Homogeneous, Layered, Material, Orthotropic, Ply, Section};
pub use shell::mesh::Mesh;
pub use statics::{ArcLength, Buckling, LevelSign, Linear, Modal, Prebuckling, Static, Stop};
