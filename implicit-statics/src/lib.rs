//! Equilibria of discrete systems: Newton, arc length, inertia, modes.
//!
//! This crate knows no shell. A system tells by [`Equilibrium`] its forces, its tangent and how it moves; everything
//! else is here. The sparse solver stands behind one type, [`SymmetricSolver`].
//!
//! | to | use |
//! |---|---|
//! | solve a linear problem | [`linear_response`] |
//! | find equilibrium at a load | [`Newton::at_level`] |
//! | follow a path past limit and turning points | [`follow`] with a [`Control`] |
//! | locate critical points on the way | [`CriticalOptions`] in [`PathOptions`] |
//! | go over to another branch | [`switch_branch`] |
//! | know frequencies | [`natural_modes`] |
//! | estimate buckling loads | [`linear_buckling`] |

mod critical;
mod eigen;
mod equilibrium;
mod error;
mod modal;
mod newton;
mod path;
mod pattern;
mod solver;
mod stepper;
mod vectors;

pub use critical::{CriticalKind, CriticalOptions, CriticalPoint, switch_branch};
pub use equilibrium::Equilibrium;
pub use error::BalanceError;
pub use modal::{BucklingMode, Mode, linear_buckling, lowest_modes, natural_modes};
pub use newton::{Converged, Increment, Newton, NewtonOptions, linear_response};
pub use path::{Control, Direction, End, Measure, Path, PathOptions, Point, Start, follow};
pub use solver::{Inertia, SymmetricSolver};
