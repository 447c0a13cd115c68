//! The body without time: the same discrete energy as a system of `implicit-statics`.

mod joined;
mod static_solid;

pub use static_solid::StaticSolid;
