//! thin-ring: the ring at t/L = 1/120, where thickness no longer matters but locking would.

use benchmarks_ref::elastica::end_moment;
use benchmarks_ref::fe_shell::cases::{Strip, end_moment as elements};
use benchmarks_ref::reference;

use crate::JudgeError;
use crate::judge::{Case, Headline, Measured, Published};
use crate::methods::{CELL, ELEMENTS, STATIC};
use crate::support::{scenes, strip::KnownTip};

/// Errors \[% of L\], the largest of the levels.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("25×3", 0.052), ("49×3", 0.013)]),
    (STATIC, &[("25×3", 0.052), ("49×3", 0.013)]),
    (ELEMENTS, &[("25×3", 0.051), ("49×3", 0.013)]),
]);
const STRIP: KnownTip = KnownTip {
    scene: scenes::THIN_RING,
    length: 12.0,
    grids: [[25, 3], [49, 3]],
    exact: |level| {
        let tip = end_moment(std::f64::consts::TAU * level);
        (tip.u, tip.w)
    },
    measured: MEASURED,
    reason: "curvature along arcs, second order in the spacing; the strip is so thin that the elastica is exact to 1e-5",
    table: "sze_cantilever_end_moment",
    columns: ["M/Mmax", "minus_U_tip_S4R", "W_tip_S4R"],
    table_off: 0.12,
};

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thin-ring",
        title: "Strip rolled into a ring, t/L = 1/120",
        about: "The tip against the closed form at every level; the table of Sze et al. beside it. A formulation whose \
                shear locks would stay behind by a multiple.",
        citation: "Sze, Liu and Lo 2004, section 3.2; exact: end moment on an inextensible elastica",
        variants: STRIP.variants(|cells| elements(&Strip::THIN_RING, cells, 40)),
        each: |run| STRIP.each(run),
        together: |runs| STRIP.still(runs, 0.001),
        headline: Some(Headline { metric: KnownTip::LARGEST, floor: 1e-3, published }),
        figures: |runs| {
            let caption =
                "Marks of the shell on the lines of the closed form; the published table as small crosses.";
            STRIP.figures(runs, "Tip of the thin strip against the moment", caption)
        },
        ..Case::default()
    }
}

/// The table itself against the closed form, at all its rows.
fn published() -> Result<Vec<Published>, JudgeError> {
    let check = &reference(STRIP.table)?.cross_check[0];
    let opensees = check["max_tip_deviation_from_closed_form_over_L"].as_f64();
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R 16×1", error: Some(STRIP.table_error()?) },
        Published { source: "OpenSees 3.7.1, ASDShellQ4 16×1", error: opensees.map(|e| 100.0 * e) },
    ])
}
