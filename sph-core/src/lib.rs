//! Space: particles on a surface, their neighbours, and gradients that are exact where they promise to be.
//!
//! A [`Cloud`] is the immutable reference geometry; a [`SamplingOperator`] turns nodal fields of that cloud into
//! values and surface gradients at sampling points, and its transpose turns point quantities into nodal sums.
//! There is no mechanics and no time in this crate.
//!
//! ```
//! use sph_core::{EndWeights, Plate, cell_operator, lattice};
//! let plate = Plate { lengths: [2.0, 1.0] };
//! let cloud = lattice(&plate, [21, 11], EndWeights::Trapezoid)?;
//! let operator = cell_operator(&cloud)?;
//! let height: Vec<f64> = cloud.positions.iter().map(|x| 3.0 * x.x - x.y).collect();
//! let slope = operator.gradient(&height);
//! assert!(slope.iter().all(|g| (g[0] - 3.0).abs() < 1e-12 && (g[1] + 1.0).abs() < 1e-12));
//! # Ok::<(), sph_core::SpaceError>(())
//! ```

mod boundary;
mod cell;
mod cell_stencil;
mod cloud;
mod consistent;
mod correction;
mod error;
mod flips;
mod frame;
mod graded;
mod jitter;
mod kernel;
mod kernel_operator;
mod lattice;
mod matching;
mod neighbours;
mod nodal_operator;
mod pairing;
mod patch;
mod poisson;
mod random;
mod sampling;
mod sides;
mod surface_mesh;
mod triangulate;
mod unevenness;

pub use cell::{Cell, CellGeometry};
pub use cell_stencil::cell_operator;
pub use cloud::Cloud;
pub use consistent::{ConsistencyReport, make_divergence_consistent};
pub use correction::{Correction, LinearlyExact, Neighbourhood, Shape, ThroughParticle, corrections};
pub use error::SpaceError;
pub use frame::Frame;
pub use graded::Graded;
pub use jitter::jittered_lattice;
pub use kernel::{CubicSpline, Kernel, QuinticSpline, WendlandC2, WendlandC4, kernel, kernels};
pub use kernel_operator::kernel_operator;
pub use lattice::{EndWeights, Lattice, lattice};
pub use neighbours::CellList;
pub use nodal_operator::nodal_operator;
pub use pairing::pair_triangles;
pub use patch::{Cylinder, Parametric, Patch, Plate, Sphere, Twisted};
pub use poisson::poisson_cloud;
pub use sampling::{SamplingOperator, SamplingPoint, Stencil, Transposed};
pub use sides::{Side, Sides};

/// A point or vector of space; positions are in `[L]`.
pub type Vec3 = nalgebra::Vector3<f64>;
