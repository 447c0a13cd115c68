//! The module `_coque`: scenes in, text and arrays out, callbacks on the way. All that is pleasant about the package is Python, in
//! `coque-python/python/coque`.

mod brought;
mod command;
mod drawn;
mod errors;
mod forecast;
mod leaving;
mod outcome;
mod page;
mod push;
mod running;
mod scene;
mod steps;
mod watched;

use pyo3::prelude::*;

/// What the package `coque` is made of.
#[pymodule]
mod _coque {
    #[pymodule_export]
    use super::command::command_line;
    #[pymodule_export]
    use super::drawn::read_frame;
    #[pymodule_export]
    use super::forecast::forecast;
    #[pymodule_export]
    use super::leaving::leave;
    #[pymodule_export]
    use super::page::{Page, page_of};
    #[pymodule_export]
    use super::running::resume;
    #[pymodule_export]
    use super::scene::{Scene, frames_listed, schema};
    #[pymodule_export]
    use super::steps::Simulation;
}
