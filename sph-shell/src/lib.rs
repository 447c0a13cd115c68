//! A thin shell carried by one layer of SPH particles: the model.
//!
//! Particles hold a position `x` and a unit director `d`. Strains are sampled at points whose
//! stencils come from `sph-core`, turned into resultants by `shell-kinematics`, and carried back to
//! the particles by the transposed stencils, so that forces are the exact derivative of an energy.
//! `explicit-dynamics` marches the result. [`Formulation`] says where the points lie.
//!
//! | where is | look in |
//! |---|---|
//! | the point loop (strain → stress → force) | `point.rs`, `Shell::internal_force` |
//! | the step of one particle (kick, hold, drift) | `particle.rs` |
//! | the whole step in one sweep | `fused.rs` |
//! | strains and resultants, to be read | `results.rs` |
//! | zero-energy control | `cell_control.rs`, `pair_control.rs` |
//! | what a clamp does | `supports.rs` |
//! | the paper's eqs. 3, 4, 8, 9 to the letter | `strong_form.rs` |

mod cell_control;
mod couple;
mod dispatch;
mod error;
mod formulation;
mod freedoms;
mod fused;
mod loads;
mod march;
mod membrane_arcs;
mod motion;
mod packs;
mod pair_control;
mod particle;
mod point;
mod pressure;
mod reference;
mod results;
mod shear;
mod shell;
mod spectrum;
mod statics;
mod stiffness;
mod strong_form;
mod supports;
mod sweep;

pub use couple::{CoupleAxis, EdgeCouple};
pub use error::ShellError;
pub use formulation::{Formulation, FormulationRow, Reach, formulations};
pub use loads::{AppliedLoad, Body, Force, Gravity, Load};
pub use pressure::Pressure;
pub use reference::Reference;
pub use results::PointResult;
pub use shell::{Parts, Shell, Supported};
pub use statics::StaticShell;
pub use strong_form::density_rate;
pub use supports::{
    Clamped, Diaphragm, DirectorHold, Held, Hinged, Holds, Motion, Moved, Support, SymmetryPlane,
};
