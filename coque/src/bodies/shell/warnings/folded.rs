//! Cells that lie on each other: a mesh folded onto itself, or laid twice.

use sph_core::{CellList, Vec3};

use super::sheet::Sheet;

/// Distance of two layers, in units of the size of a cell, below which they lie on each other.
const ON: f64 = 0.05;

/// Pairs of cells one of which has its middle within the other, closer than half a thickness \[L\] or a twentieth of the cell.
///
/// One look-up a cell in a grid; a cell looks as far as its farthest corner.
pub(crate) fn overlaps(sheet: &Sheet<'_>, positions: &[Vec3], thickness: f64) -> Vec<(usize, usize)> {
    let count = sheet.cells.len();
    let mean = (sheet.areas.iter().sum::<f64>() / count.max(1) as f64).sqrt();
    let grid = CellList::new(&sheet.centres, mean);
    let (mut near, mut found) = (Vec::new(), Vec::new());
    for (c, cell) in sheet.cells.iter().enumerate() {
        let (centre, normal) = (sheet.centres[c], sheet.normals[c]);
        let corners: Vec<Vec3> = cell.particles().iter().map(|&a| positions[a as usize] - centre).collect();
        let reach = corners.iter().fold(0.0_f64, |most, arm| most.max(arm.norm()));
        grid.within(&centre, reach, &mut near);
        for d in near.iter().map(|&d| d as usize).filter(|&d| d != c) {
            let arm = sheet.centres[d] - centre;
            let touching = cell.particles().iter().any(|a| sheet.cells[d].particles().contains(a));
            let size = sheet.areas[c].min(sheet.areas[d]).sqrt();
            let bound = if touching { ON * size } else { (ON * size).max(0.5 * thickness) };
            let inside = (0..corners.len()).all(|i| {
                let (from, to) = (corners[i], corners[(i + 1) % corners.len()]);
                (to - from).cross(&(arm - from)).dot(&normal) > 0.0
            });
            let parallel = normal.dot(&sheet.normals[d]).abs() > 0.9;
            if inside && parallel && arm.dot(&normal).abs() < bound {
                found.push((c.min(d), c.max(d)));
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}
