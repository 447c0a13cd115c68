//! cantilever-end-shear: a thin cantilever under a dead end force, judged by the exact elastica.
//!
//! ```text
//!   ▓────────────────╴ ↑ P      α = P L²/EI up to 4
//! ```

use benchmarks_ref::elastica::end_load;
use benchmarks_ref::fe_shell::cases::{Strip, end_shear as elements};

use crate::judge::{Case, Headline, Measured, Published};
use crate::methods::{CELL, ELEMENTS, STATIC};
use crate::support::{peers, scenes, strip::KnownTip};

/// P L²/EI at level one.
const FULL_LOAD: f64 = 4.0;
/// Errors \[% of L\], the largest of the levels.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("21×3", 0.022), ("41×3", 0.0048)]),
    (STATIC, &[("21×3", 0.022), ("41×3", 0.0049)]),
    (ELEMENTS, &[("21×3", 0.022), ("41×3", 0.0049)]),
]);
const STRIP: KnownTip = KnownTip {
    scene: scenes::CANTILEVER_END_SHEAR,
    length: 10.0,
    grids: [[21, 3], [41, 3]],
    exact: |level| {
        let tip = end_load(FULL_LOAD * level);
        (tip.u, tip.w)
    },
    measured: MEASURED,
    reason: "second order in the spacing; shear and stretch, which the elastica leaves out, are 1e-4 of L at t/L = 1/100",
    table: "sze_cantilever_end_shear",
    columns: ["P/Pmax", "minus_U_tip", "W_tip"],
    table_off: 0.04,
};

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cantilever-end-shear",
        title: "Cantilever under a dead end force, t/L = 1/100",
        about: "The tip against the exact elastica at every level; the table of Sze et al. beside it. Bending varies \
                along the strip here, unlike on the rings.",
        citation: "Sze, Liu and Lo 2004, section 3.1; exact: Mattiasson 1981, elliptic integrals",
        variants: STRIP.variants(|cells| elements(&Strip::END_SHEAR, cells, 10)),
        each: |run| STRIP.each(run),
        together: |runs| STRIP.still(runs, 0.001),
        headline: Some(Headline {
            metric: KnownTip::LARGEST,
            // Shear and stretch, which the elastica leaves out, are 1e-4 of L.
            floor: 0.01,
            // The table itself against the elastica, at all its rows.
            published: || {
                Ok(vec![Published {
                    source: "Sze et al. 2004, S4R 16×1", error: Some(STRIP.table_error()?)
                }])
            },
        }),
        peers: || peers::tips("cantilever-end-shear", "41×3", STRIP.exact),
        figures: |runs| {
            let caption = "Level 1 is P L²/EI = 4. Marks of the shell on the lines of the elastica; the published table as small \
                           crosses.";
            STRIP.figures(runs, "Tip of the cantilever against the end force", caption)
        },
        ..Case::default()
    }
}
