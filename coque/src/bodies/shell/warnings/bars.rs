//! What sheet and bar having one director makes of deep stiffeners.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use super::look::Look;
use crate::bodies::shell::bars::bar_of;
use crate::scene::Material;

/// Relative error of a deflection above which it is reported.
const OFF: f64 = 0.02;

/// Where a bar shears by γ = Q/GA, directors of the sheet beside it lean with it over the width of a cell, and its own shear stiffness `S Δ` bears a part of Q
/// that it would not. Of the deflection of a half wave as long as the bar, `φ = π² (EI + EA e²)/(GA L²)` over `1 + φ` is shear at most; too little of it is the part
/// `SΔ/(GA + SΔ)`. Plates on blades of a tenth and a twentieth of their length, 32 cells along, are 3.3 and .6 % too stiff; this says 2.2 and 1.0.
pub(super) fn deep(look: &Look<'_>) -> Option<String> {
    let shell = look.scene?.shell;
    let Material::Elastic(elastic) = &shell.material else { return None };
    let sheet = 5.0 / 12.0 * elastic.young.get() / (1.0 + elastic.poisson) * look.thickness * look.spacing;
    let lengths = longest(look, shell.stiffeners.len());
    let doubtful = shell.stiffeners.iter().zip(lengths).filter_map(|(stiffener, length)| {
        let bar = bar_of(stiffener, shell)?;
        let bending = bar.section.bending + bar.section.axial * bar.height * bar.height;
        let sheared = PI * PI * bending / (bar.section.shear * length * length);
        // Of half a bar half of the sheet is there.
        let sheet = stiffener.share.get() * sheet;
        let off = sheared / (1.0 + sheared) * sheet / (sheet + bar.section.shear);
        Some((off, &stiffener.on))
    });
    let (off, on) = doubtful.max_by(|one, other| one.0.total_cmp(&other.0)).filter(|(off, _)| *off > OFF)?;
    Some(format!(
        "the stiffener on `{on}` is deep for its length: it may be too stiff by some {:.0} % of a deflection, since the sheet beside it shears with it over the width \
         of a cell, at most {:.0} % are let pass; take finer cells, or model it as a sheet of the mesh",
        100.0 * off,
        100.0 * OFF
    ))
}

/// Length of the longest line of each of so many stiffeners: a set may have several, side by side.
fn longest(look: &Look<'_>, stiffeners: usize) -> Vec<f64> {
    let rest = look.shell.rest_positions();
    let mut lines: Vec<Vec<(BTreeSet<u32>, f64)>> = vec![Vec::new(); stiffeners];
    for piece in look.shell.bar_forces() {
        let [a, b] = piece.ends;
        let own = &mut lines[piece.stiffener];
        let meets = |line: &(BTreeSet<u32>, f64)| line.0.contains(&a) || line.0.contains(&b);
        let (met, apart): (Vec<_>, Vec<_>) = std::mem::take(own).into_iter().partition(meets);
        let mut line = (BTreeSet::from([a, b]), (rest[b as usize] - rest[a as usize]).norm());
        for (ends, length) in met {
            line.0.extend(ends);
            line.1 += length;
        }
        *own = apart;
        own.push(line);
    }
    lines.iter().map(|lines| lines.iter().map(|line| line.1).fold(0.0, f64::max)).collect()
}
