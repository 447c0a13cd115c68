//! What several test files use: frames read back, surfaces.

#![allow(dead_code)] // every test file takes its own share

pub mod fields;
pub mod meshes;
