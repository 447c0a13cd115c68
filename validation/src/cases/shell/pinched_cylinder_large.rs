//! pinched-cylinder-large: the cylinder between diaphragms pinched until its wall buckles inward.

use benchmarks_ref::fe_shell::cases::pinched_cylinder_large as elements;

use crate::judge::{Case, Headline, Measured, Published, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::{scenes, table::AgainstTable};

/// The table, up to the load \[12000\] up to which bricks confirm it.
pub const TABLE: AgainstTable = AgainstTable {
    table: "sze_pinched_cylinder_diaphragm",
    load: "load",
    columns: &[("minus_W_A", "minus_W_A"), ("U_B", "U_B")],
    largest: 36.208,
    until: 0.15,
    without: None,
    name: "distance from the table to 0.15",
    measured: MEASURED,
    reason: "the wall buckles, and what buckles shows every error of a coarse lattice enlarged",
};

/// Distances from the table \[% of the largest displacement\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("21×21", 12.0), ("31×31", 4.4), ("38×25", 1.1), ("33×33", 3.3)]),
    (ELEMENTS, &[("21×21", 5.5), ("31×31", 0.66), ("38×25", 2.1), ("33×33", 0.24)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "pinched-cylinder-large",
        title: "Pinched cylinder between diaphragms, large displacements",
        about: "Displacements under a force and a quarter round from it against the table of Sze et al., up to 0.15 of the full \
                load, in percent of the displacement there (36.2, with a radius of 100). Beyond, the table is a single \
                transcription that bricks confirm in shape only.",
        citation: "Sze, Liu and Lo 2004, section 3.6",
        variants: variants(),
        each: |run| TABLE.each(run),
        headline: Some(Headline {
            metric: TABLE.name,
            floor: 0.1,
            published: || Ok(vec![Published { source: "Sze et al. 2004, S4R 48×48", error: None }]),
        }),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let on = |[u, v]: [usize; 2]| {
        let particles = Variant::new(STATIC, scenes::PINCHED_CYLINDER_LARGE, "cylinder", [u, v]);
        let nodes = Variant::elements(ELEMENTS, [u, v], move || elements([v - 1, u - 1], 40.0, 40));
        [particles.usual_if(u == 38), nodes.usual_if(u == 33)].map(|variant| variant.quick_if(u == 21))
    };
    // 38×25 makes nearly square cells of as many particles as 31×31, whose are 1.6 : 1.
    [[21, 21], [31, 31], [38, 25], [33, 33]].into_iter().flat_map(on).collect()
}
