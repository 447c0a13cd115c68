//! The module `_coque`: scenes in, text and arrays out, callbacks on the way. All that is pleasant about the package is Python, in
//! `coque-python/python/coque`.

mod drawn;
mod errors;
mod outcome;
mod scene;
mod steps;
mod watched;

use pyo3::prelude::*;

/// What the package `coque` is made of.
#[pymodule]
mod _coque {
    #[pymodule_export]
    use super::drawn::read_frame;
    #[pymodule_export]
    use super::scene::{Scene, frames_listed, schema};
    #[pymodule_export]
    use super::steps::Simulation;
}
