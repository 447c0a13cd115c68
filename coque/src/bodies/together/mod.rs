//! Several bodies of a scene without a fluid as one, in time or at rest.
//!
//! Each keeps its own particles, conditions and files; they take the same steps or are balanced together. What they do to each other goes
//! through one place: an `Interaction` of explicit-dynamics in marches, one of implicit-statics without time, which sees places of all and
//! adds forces and, at rest, blocks of the tangent: springs between sets (`joints.rs`), links
//! between them and to the ground (`links.rs`), sets that are glued to faces (`glue.rs`, `faces.rs`) and bodies that touch (`contact.rs`, found by `touched.rs`,
//! whose surfaces `sides.rs` finds).

mod balance;
mod body;
pub(super) mod build;
mod contact;
mod directors;
mod faces;
mod glue;
mod jointed;
mod joints;
mod kept;
mod layout;
mod links;
mod march;
mod moving;
mod near;
mod nodal;
mod nodal_on_tool;
mod on_tool;
mod parts;
mod rough_tool;
mod rows;
mod sides;
mod skin;
mod tooled;
mod touched;
mod wet;

pub(super) use contact::{Side, TouchingBodies};
pub(super) use jointed::{JointedBodies, MayBeRigid};
pub(super) use joints::{BetweenBodies, SetsOfBodies};
pub(super) use kept::{kept_between, take_up_between};
pub(super) use layout::Layout;
pub(super) use links::AllLinks;
pub(super) use on_tool::OnTool;
pub(super) use parts::Parts;
pub(super) use sides::{of_bonds, of_rigid, of_shell};
pub(super) use tooled::on_tools;
pub(super) use touched::contacts;
pub(super) use wet::{WetSurface, wetting};
