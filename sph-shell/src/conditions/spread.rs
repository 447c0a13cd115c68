//! What cells bear as parts of their particles: areas, and with them masses and loads by area.

use sph_core::Cloud;

use crate::error::ShellError;

/// Part of each particle's tributary area that lies in some cells \[L²\]; particles without a part are left out.
///
/// A particle's area A_a is divided among its cells as their corners are, `w_c/m_c` of a cell of area w_c and m_c corners: the
/// parts of cells that cover the shell add up to the areas, whatever rule the areas were found by. Each part is multiplied by
/// `by` of its cell, such as a mass by area.
pub fn spread(cloud: &Cloud, cells: &[u32], by: impl Fn(u32) -> f64) -> Vec<(u32, f64)> {
    let corner = |c: usize| cloud.cells[c].geometry(&cloud.positions).area / f64::from(cloud.cells[c].count);
    let mut whole = vec![0.0; cloud.len()];
    let mut part = vec![0.0; cloud.len()];
    for (c, cell) in cloud.cells.iter().enumerate() {
        cell.particles().iter().for_each(|&a| whole[a as usize] += corner(c));
    }
    for &c in cells {
        let size = corner(c as usize) * by(c);
        cloud.cells[c as usize].particles().iter().for_each(|&a| part[a as usize] += size);
    }
    let shared = (0..).zip(part).zip(whole).filter(|((_, part), _)| *part != 0.0);
    shared.map(|((a, part), whole)| (a, cloud.areas[a as usize] * part / whole)).collect()
}

/// Refuses empty sets of cells and numbers beyond the cloud.
pub(crate) fn check_cells(what: &'static str, cells: &[u32], cloud: &Cloud) -> Result<(), ShellError> {
    let count = cloud.cells.len();
    match cells.iter().find(|&&cell| cell as usize >= count) {
        Some(&cell) => Err(ShellError::NoSuchCell { what, cell, count }),
        None if cells.is_empty() => Err(ShellError::EmptySet(what)),
        None => Ok(()),
    }
}
