//! The wet surface of a shell: points that stand for it, the load of a fluid on them, and its way to the particles.

mod places;
mod sheet;
mod strip;
pub(crate) mod surface;
pub(crate) mod wetting;

pub use surface::WetColumn;
pub use wetting::{WetFaces, Wetting};
