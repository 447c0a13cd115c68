//! The bodies of a scene: what the application asks of any of them, and a folder for each kind.
//!
//! | where is | look in |
//! |---|---|
//! | what a body must offer | `body.rs` |
//! | for which analyses it is ready | `ready.rs` |
//! | a body with its task, ready to run | `model.rs` |
//! | columns of the curve | `probe.rs` |
//! | what fields show of it | `shown.rs` |
//! | which kind is built; what all kinds refuse | `build.rs`; `refusal.rs` |
//! | what loads and supports amount to | `resultants.rs` |
//! | what stresses say whatever their axes; stresses of plies; at particles | `invariants.rs`; `plies.rs`; `recovered.rs` |
//! | which rigid motions are free | `rigid.rs` |
//! | still water about bodies at rest | `in_water.rs` |
//! | bodies that nothing keeps apart | `outline.rs`, `unseen.rs` |
//! | contacts with what they do now, and their names | `contact_now.rs`, `contacts_of_scene.rs` |
//! | glue with what it does now | `glue_now.rs` |
//! | shells; solids with bonds, without; fluids and walls | `shell/`; `solid/`, `galerkin/`; `fluid/` |
//! | rigid bodies | `rigid_body/` |
//! | closed surfaces from files | `from_file.rs` |
//! | several bodies as one, and what bodies do to each other, in a fluid too | `together/` |
//! | a fluid, its walls and the structures in it as one body | `coupled/` |

mod beside;
pub(crate) mod body;
mod build;
mod built_body;
mod conducting;
mod contact_now;
pub(crate) mod contacts_of_scene;
mod coupled;
mod field_source;
mod figures;
mod fluid;
pub(crate) mod from_file;
mod galerkin;
mod glue_now;
mod hot;
mod imperfect;
mod in_water;
mod invariants;
pub(crate) mod memory;
pub(crate) mod model;
mod one_process;
mod outline;
mod plies;
mod point_numbers;
pub(crate) mod probe;
mod ready;
mod recovered;
mod refusal;
mod resultants;
mod rigid;
mod rigid_body;
mod sampled;
pub(crate) mod sets;
pub(crate) mod shell;
mod solid;
mod together;
mod tool_shapes;
mod unseen;
mod yielding;

pub(crate) use body::extent;
pub use body::{
    Body, Configuration, Description, Diagnostics, DynamicBody, Mismatch, PrescribedPoint, Shape, StateArray,
    StaticBody, TangentCost,
};
use built_body::BuiltBody;
pub use contact_now::{ContactFields, ContactNow, Spanned, With};
pub use field_source::{FieldRequest, FieldSource, Part, State, StressFields};
pub use figures::FluidFigures;
pub use glue_now::GlueNow;
pub(crate) use in_water::InStillWater;
pub use memory::Memory;
pub(crate) use model::Identity;
pub use model::{Model, NoPush, Surrounding, Task};
pub use one_process::{NotShared, OneProcess};
pub use outline::Outline;
pub use probe::Probe;
pub use ready::{ConductingBody, Ready};
pub use resultants::{LoadResultants, Resultant};
pub use yielding::Yielding;
