//! Rigid bodies: from the scene's words to `rigid-body`.

mod body;
pub(super) mod build;
mod conditions;
mod fields;
mod places;
mod wet;
