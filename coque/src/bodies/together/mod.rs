//! Several bodies of a scene without a fluid as one, in time or at rest.
//!
//! Each keeps its own particles, conditions and files; they take the same steps or are balanced together. What they do to each other goes
//! through one place: an `Interaction` of explicit-dynamics in marches, one of implicit-statics without time, which sees places of all and
//! adds forces and, at rest, blocks of the tangent: springs between sets (`joints.rs`) and shells that touch (`contact.rs`, found by `touched.rs`).

mod balance;
mod body;
pub(super) mod build;
mod contact;
mod joints;
mod layout;
mod march;
mod moving;
mod parts;
mod touched;
