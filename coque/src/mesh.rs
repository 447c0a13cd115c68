//! Surfaces from files: those of `mesh-io`, with a report that tells what is doubtful about their cloud as well.

use std::fmt::Write;

pub use mesh_io::surface::*;
use sph_core::ClosedSurface;

use crate::bodies::from_file::triangles;
use crate::bodies::shell::warnings::warnings_of_cloud;

/// Everything that was found in a file: the output of `coque mesh`.
///
/// # Errors
/// [`MeshError`] for a surface that no cloud can be made of.
pub fn report(surface: &Surface) -> Result<String, MeshError> {
    mesh_io::surface::report(surface, warnings_of_cloud)
}

/// The same of the surface of a body, with what it encloses: the output of `coque mesh --body`.
///
/// # Errors
/// [`MeshError`] for a surface that encloses no body as well.
pub fn report_body(surface: &Surface) -> Result<String, MeshError> {
    let closed = ClosedSurface::new(surface.positions.clone(), triangles(surface).0);
    let (volume, centroid) = closed
        .map_err(|fault| {
            let said = fault.to_string();
            let (what, repair) = said.split_once("; ").unwrap_or((&said, ""));
            MeshError { file: surface.file.clone(), line: None, what: what.into(), repair: repair.into() }
        })?
        .volume();
    let mut out = report(surface)?;
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "  encloses   a volume of {volume:.6e} round [{:.5e}, {:.5e}, {:.5e}]",
        centroid.x, centroid.y, centroid.z
    );
    Ok(out)
}
