//! What cases share: scenes, clouds, meshes, bare shells, and comparisons with tables and closed forms.

pub mod clouds;
pub mod coupled;
pub mod fluids;
pub mod linear;
pub mod marched;
pub mod mesh_scenes;
pub mod meshes;
pub mod misses;
pub mod path;
pub mod peers;
pub mod relaxed;
pub mod scenes;
pub mod sheets;
pub mod solids;
pub mod stopwatch;
pub mod strip;
pub mod studies;
pub mod table;
pub mod watched;
