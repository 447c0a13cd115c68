//! Supports, prescribed motions and loads.

pub(crate) mod body;
pub(crate) mod case;
pub(crate) mod cavity;
pub(crate) mod constraints;
pub(crate) mod couple;
mod enclosed;
pub(crate) mod frozen;
pub(crate) mod loads;
pub(crate) mod on_share;
pub(crate) mod own_contact;
pub(crate) mod preload;
pub(crate) mod prescribed;
pub(crate) mod prescribed_at;
pub(crate) mod pressure;
pub(crate) mod resultants;
pub(crate) mod spread;
pub(crate) mod springs;
pub(crate) mod stages;
pub(crate) mod supports;
pub(crate) mod tools;
pub(crate) mod touched;
pub(crate) mod turn;
pub(crate) mod turned;
