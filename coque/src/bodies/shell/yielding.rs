//! What the particles of a shell that yields have gone through, from its cells.

use sph_shell::Shell;

use crate::bodies::Yielding;

/// By particle: the greatest plastic strain and the least thickness of the cells round it, and its share of what they dissipated.
pub(super) fn yielding(shell: &Shell) -> Vec<Yielding> {
    let of_cells = shell.yielded();
    if of_cells.is_empty() {
        return Vec::new();
    }
    let thickness = shell.thickness();
    let mut out =
        vec![Yielding { plastic_strain: 0.0, thickness: f64::INFINITY, dissipated: 0.0 }; shell.len()];
    for (cell, own) in shell.reference().cloud.cells.iter().zip(&of_cells) {
        for &a in cell.particles() {
            let of = &mut out[a as usize];
            of.plastic_strain = of.plastic_strain.max(own.plastic_strain);
            of.thickness = of.thickness.min(thickness * own.thickness);
            of.dissipated += own.dissipated * own.area / cell.count as f64;
        }
    }
    out
}
