//! The sampling points: the pipeline of one pack, the sweep over all, what each formulation adds, and what can be read there.

pub(crate) mod bounds;
pub(crate) mod point;
pub(crate) mod remembered;
pub(crate) mod remembering;
pub(crate) mod results;
pub(crate) mod ring;
pub(crate) mod scheme;
pub(crate) mod strong_form;
pub(crate) mod sweep;
