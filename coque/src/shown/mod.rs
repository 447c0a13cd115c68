//! What the folder of a run shows: its frames with words, its curve, its summary; for pages and pictures.

pub(crate) mod folder;
pub(crate) mod frames;
