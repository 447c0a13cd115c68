//! What the folder of a run shows, or a run in memory: its frames with words, its curve, its summary; for pages and pictures.

pub(crate) mod folder;
pub(crate) mod frames;
pub(crate) mod page;
