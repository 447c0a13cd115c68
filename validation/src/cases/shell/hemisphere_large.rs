//! hemisphere-large: the hemisphere with a hole pulled out and pinched to eight tenths of its radius.

use benchmarks_ref::fe_shell::cases::hemisphere_with_hole_large as elements;
use benchmarks_ref::reference;

use crate::JudgeError;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Published, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::{scenes, table::AgainstTable};

/// The table of displacements under the outward and the inward force.
pub const TABLE: AgainstTable = AgainstTable {
    table: "sze_hemisphere_hole",
    load: "level",
    columns: &[("outward", "outward_displacement"), ("inward", "inward_displacement")],
    largest: 8.178,
    until: 1.0,
    without: None,
    name: "distance from the table",
    measured: MEASURED,
    reason: "coarse lattices are of second order; the table itself is within .45 % of bricks",
};

/// Distances from the table \[% of the largest displacement\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("17×17", 0.5), ("21×21", 0.24), ("25×25", 0.15), ("31×31", 0.24)]),
    (ELEMENTS, &[("17×17", 0.75), ("21×21", 0.7), ("25×25", 0.66), ("31×31", 0.61)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere-large",
        title: "Hemisphere with a hole, large displacements",
        about: "Displacements under the outward and the inward force against the table of Sze et al., over the whole load, in \
                percent of the largest displacement (8.178, with a radius of 10). Large rotations of a thin, doubly curved shell.",
        citation: "Sze, Liu and Lo 2004, section 3.4",
        variants: variants(),
        each: |run| TABLE.each(run),
        // Bricks on 24×24 differ from the table by 0.45 % at most.
        headline: Some(Headline { metric: TABLE.name, floor: 0.1, published }),
        figures: |runs| {
            let words = [
                "Load against the displacements under the forces",
                "Left the outward, right the inward displacement; level 1 is a force of 400.",
            ];
            TABLE.figure(runs, "21×21", words, [Axis::linear("displacement"), Axis::linear("load level")])
        },
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let on = |n: usize| {
        let particles = Variant::new(STATIC, scenes::HEMISPHERE, "sphere", [n, n])
            .set("loads[0].force.total", "[200, 0, 0]")
            .set("loads[1].force.total", "[0, -200, 0]")
            .set("analysis.static.levels", 20)
            .usual_if([21, 31].contains(&n));
        let nodes = Variant::elements(ELEMENTS, [n, n], move || elements(n - 1, 20));
        [particles, nodes.usual_if([25, 31].contains(&n))].map(|variant| variant.quick_if(n == 21))
    };
    [17, 21, 25, 31].into_iter().flat_map(on).collect()
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let checks = &reference(TABLE.table)?.cross_check;
    let bricks = checks[1]["columns"][1]["percent_of_table_maximum"].as_f64();
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R", error: None },
        Published { source: "CalculiX, 24×24 bricks", error: bricks },
    ])
}
