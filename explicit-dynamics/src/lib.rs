//! Marching `M q̈ = f` by central differences: amplitudes, damping, stable step, energy balance.
//!
//! This crate knows no shell and no particle method. A system tells by [`Dynamics`] how to evaluate
//! forces, how to kick its velocities and how to drift its configuration (which is where a rotation
//! advances on its sphere); everything else is here. Velocities live at the half steps: this is the leapfrog
//! form of velocity Verlet, the same trajectory of configurations with one kick a step.
//!
//! | to | use |
//! |---|---|
//! | march freely in time | [`Transient`] |
//! | find equilibria along a load path | [`QuasiStatic`] |
//! | know the stable step | [`largest_eigenvalue`], [`stable_step`] |
//! | watch, stop | [`Observer`], [`Record`] |
//! | keep a march and go on later, to the same bits | [`Observer::between`], [`Standing`], `QuasiStatic::go_on`, `Transient::go_on` |

mod amplitude;
mod clock;
mod damping;
mod dynamics;
mod error;
mod quasi_static;
mod stable_step;
mod standing;
mod transient;

pub use amplitude::Amplitude;
pub use clock::{Balance, Clock, Observer, Record};
pub use damping::{Damping, KineticDamping};
pub use dynamics::{Dynamics, Instant, Step, Work};
pub use error::MarchError;
pub use quasi_static::{LevelReached, QuasiStatic};
pub use stable_step::{LinearisedDynamics, Spectrum, largest_eigenvalue, stable_step};
pub use standing::{Hold, Place, Standing};
pub use transient::Transient;
