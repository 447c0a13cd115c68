//! Surfaces from files: those of `mesh-io`, with a report that tells what is doubtful about their cloud as well.

pub use mesh_io::surface::*;

use crate::bodies::shell::warnings::warnings_of_cloud;

/// Everything that was found in a file: the output of `coque mesh`.
///
/// # Errors
/// [`MeshError`] for a surface that no cloud can be made of.
pub fn report(surface: &Surface) -> Result<String, MeshError> {
    mesh_io::surface::report(surface, warnings_of_cloud)
}
