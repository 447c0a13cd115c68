//! The truth that coque is judged by: published curves with their provenance, and closed forms.
//!
//! Of the workspace it uses `implicit-statics` alone, and only `validation` may read it:
//! a solver that could see the answer would be no test of the method.
//!
//! - [`mod@catalogue`]: the table of references, each with citation, quantity, units, values and uncertainty;
//! - [`curve`]: what is done with a curve: interpolate, find a limit point, measure a distance;
//! - [`elastica`]: the inextensible cantilever bent by an end moment or an end load;
//! - [`rolled_strip`]: the same strip with a Green–Lagrange strain, which is *not* the elastica when it is thick;
//! - [`vibration`]: the first natural frequency of a cantilever;
//! - [`fe_shell`]: an independent implicit finite-element shell.

pub mod catalogue;
pub mod curve;
pub mod elastica;
pub mod fe_shell;
pub mod rolled_strip;
pub mod vibration;

mod elliptic;
mod error;

pub use catalogue::{Reference, catalogue, reference};
pub use curve::{Curve, Extremum};
pub use error::ReferenceError;
