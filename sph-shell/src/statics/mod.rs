//! The shell without time: its unknowns, the tangent of its energy and of its loads, the system that is balanced.

pub(crate) mod dofs;
pub(crate) mod load_stiffness;
pub(crate) mod static_shell;
pub(crate) mod stiffness;
