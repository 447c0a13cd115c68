//! Element-free Galerkin
mod blocks;
mod body;
mod discretisation;
mod error;
mod essential;
mod loads;
mod parts;
mod reduction;
mod results;
mod statics;
mod steps;
mod stiffness;

pub use body::Galerkin;
pub use error::GalerkinError;
pub use parts::{Condition, Essential, Load, Parts};
pub use results::PointResult;
pub use steps::{Step, lead};
