//! Weakly compressible fluids of SPH particles, their walls and wet boundaries.
#![warn(missing_docs)]

mod books;
mod boundary;
mod cells;
mod continuity;
mod diffusion;
mod dispatch;
mod energies;
mod error;
mod fluid;
mod formulation;
mod gather;
mod gauges;
mod hidden;
mod kernel;
mod lanes;
mod liquid;
mod momentum;
mod nearby;
mod overlap;
mod parallel;
mod parts;
mod sorted;
mod start;
mod state;
mod sweeps;
mod time;
mod transport;
mod viscosity;
mod walls;

pub use energies::Energies;
pub use error::FluidError;
pub use fluid::{Fluid, StepBounds};
pub use formulation::{Formulation, Scheme, WallRule};
pub use liquid::Liquid;
pub use parts::{Motion, Parts, Rotation, Start, Structure, Wall};
