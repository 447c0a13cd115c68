//! The surface of a shell as tools, other bodies and the shell itself touch it, and how stiff that contact is.

use contact::Mesh;
use shell_kinematics::SectionScales;
use sph_core::{Cell, Cloud};

use crate::error::ShellError;

/// How unlike thicknesses may be in a contact of surfaces.
const ALIKE: f64 = 1e-9;

/// Stiffness κ of a unit of area against a rigid tool \[F/L³\] of a shell with these sections, by the thinnest of them and the mean size of
/// its cells ([`contact::stiffness`]).
pub fn contact_stiffness(sections: impl Iterator<Item = SectionScales>, cloud: &Cloud) -> f64 {
    let spacing = contact_spacing(cloud);
    let of = |scales: SectionScales| {
        contact::stiffness(scales.membrane / scales.thickness, scales.thickness, spacing)
    };
    sections.map(of).fold(f64::INFINITY, f64::min)
}

/// Mean size of the cells, on which that stiffness depends \[L\].
pub(crate) fn contact_spacing(cloud: &Cloud) -> f64 {
    let cells = cloud.cells.len().max(1) as f64;
    let area: f64 = cloud.cells.iter().map(|cell| cell.geometry(&cloud.positions).area).sum();
    (area / cells).sqrt()
}

/// The surface of a shell with half of its thickness at each particle, and the thickness.
///
/// # Errors
/// [`ShellError::ContactOfThicknesses`] where thicknesses differ.
pub(crate) fn touched_mesh(cloud: &Cloud, half: &[f64]) -> Result<(Mesh, f64), ShellError> {
    let halves = || half.iter().copied().filter(|half| *half > 0.0);
    let (least, most) = (halves().fold(f64::INFINITY, f64::min), halves().fold(0.0, f64::max));
    if most - least > ALIKE * most {
        return Err(ShellError::ContactOfThicknesses { least: 2.0 * least, most: 2.0 * most });
    }
    // Sheets that meet have particles of their own there: contact sees the first of each place.
    let mut first: Vec<u32> = (0..cloud.len() as u32).collect();
    for joined in &cloud.joined {
        joined.iter().for_each(|&a| first[a as usize] = joined[0]);
    }
    let cell = |cell: &Cell| Cell { corners: cell.corners.map(|a| first[a as usize]), ..*cell };
    let cells: Vec<Cell> = cloud.cells.iter().map(cell).collect();
    Ok((Mesh::new(&cells, &cloud.positions, |_| most), 2.0 * most))
}
