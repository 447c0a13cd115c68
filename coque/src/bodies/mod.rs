//! The bodies of a scene: what the application asks of any of them, and a folder for each kind.

pub(crate) mod probe;
pub(crate) mod sets;
pub(crate) mod shell;
