//! The analyses: one file each, and what they have in common.

pub(crate) mod criticality;
pub(crate) mod linear;
pub(crate) mod march;
pub(crate) mod modes;
pub(crate) mod path;
pub(crate) mod stability;
