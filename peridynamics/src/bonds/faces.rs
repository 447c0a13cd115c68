//! The faces of a body as its nodes bear them: the vector of the area that each stands for.

use sph_core::{Block, Vec3};

use super::images::Images;
use crate::error::SolidError;
use crate::mirror::Mirror;

/// Volumes between faces may differ from those of the nodes by this part.
const CLOSED: f64 = 1e-9;

/// `aᵢ`, the area of the faces of the box that each whole node stands for, outward \[L²\]; none on planes of symmetry.
///
/// # Errors
/// [`SolidError::Unbalanced`] for nodes that do not fill the box between the faces that they stand on, `Σ aᵢ·xᵢ = V` along each
/// axis: cell centres, holes, arcs.
pub(crate) fn areas(
    block: &Block,
    mirrors: &[Mirror],
    images: Option<&Images>,
) -> Result<Vec<Vec3>, SolidError> {
    let mut areas = vec![Vec3::zeros(); block.len()];
    let whole: f64 = block.volumes.iter().sum();
    for axis in 0..block.dimensions {
        let mut between = 0.0;
        let of_axis = || mirrors.iter().filter(|mirror| mirror.axis == axis);
        let plane = of_axis().next().map_or(0.0, |mirror| mirror.at);
        let (least, most) = along(block, axis);
        for (upper, sign) in [(0, -1.0), (1, 1.0)] {
            let is_here = |mirror: &Mirror| (mirror.at > 0.5 * (least + most)) == (upper == 1);
            if of_axis().any(is_here) {
                continue;
            }
            for &(node, area) in &block.faces[2 * axis + upper] {
                let node = node as usize;
                let share = images.map_or(1.0, |images| images.share(node));
                areas[node][axis] += sign * area / share;
                between += sign * area * (block.positions[node][axis] - plane);
            }
        }
        if of_axis().count() < 2 && (between - whole).abs() > CLOSED * whole {
            return Err(SolidError::Unbalanced(
                "its nodes do not fill the box between the faces they stand on",
            ));
        }
    }
    Ok(areas)
}

/// Least and greatest coordinate.
fn along(block: &Block, axis: usize) -> (f64, f64) {
    let bounds = (f64::INFINITY, f64::NEG_INFINITY);
    block.positions.iter().fold(bounds, |(least, most), x| (least.min(x[axis]), most.max(x[axis])))
}
