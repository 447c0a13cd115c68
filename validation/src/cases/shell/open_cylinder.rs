//! open-cylinder: a cylinder with free ends pulled out by two forces; bending, then membrane action, a snap between.

use benchmarks_ref::fe_shell::cases::open_cylinder as elements;
use benchmarks_ref::reference;

use crate::JudgeError;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Metric, Published, Run, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::path::value_at;
use crate::support::{scenes, table::AgainstTable};

/// The table's row inside the snap: displacements run away at nearly constant load, so it is compared by its load.
const SNAP: (f64, f64) = (0.525, 4.061);

/// The table of the displacements of three points.
pub const TABLE: AgainstTable = AgainstTable {
    table: "sze_open_cylinder_pullout",
    load: "load",
    columns: &[("W_A", "W_A"), ("minus_U_B", "minus_U_B"), ("minus_U_C", "minus_U_C")],
    largest: 4.551,
    until: 1.0,
    without: Some(SNAP.0),
    name: "distance from the table",
    measured: MEASURED,
    reason: "cells turn by more than half a radian: curvature along arcs and the hold of directors; the table is within .9 % \
             of bricks",
};

/// Distances from the table \[% of the largest displacement\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("17×13", 1.3), ("25×17", 0.45), ("37×25", 0.32)]),
    (ELEMENTS, &[("17×13", 1.2), ("25×17", 0.88), ("37×25", 0.68)]),
]);

/// Errors of the load in the snap \[%\].
#[rustfmt::skip] // a paragraph a method
const IN_SNAP: Measured = Measured(&[
    (STATIC, &[("17×13", 0.54), ("25×17", 0.58), ("37×25", 0.88)]),
    (ELEMENTS, &[("17×13", 2.0), ("25×17", 1.7), ("37×25", 1.4)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "open-cylinder",
        title: "Pull-out of an open cylinder",
        about: "Displacements of three points against the table of Sze et al., over the whole load, in percent of the largest \
                (4.551, with a radius of 4.953). Cells turn by more than half a radian against their neighbours, which is \
                where a weak control of directors gives way.",
        citation: "Sze, Liu and Lo 2004, section 3.5",
        variants: variants(),
        each,
        headline: Some(Headline { metric: TABLE.name, floor: 0.1, published }),
        figures: |runs| {
            let words = [
                "Load against the displacements of three points",
                "W_A under the force, U_B and U_C a quarter round, at mid-length and at the free end. Near half the load the \
                 wall snaps: U_B jumps, U_C turns back.",
            ];
            let axes = [Axis::linear("displacement"), Axis::linear("load / 40000").between(0.0, 1.05)];
            TABLE.figure(runs, "25×17", words, axes)
        },
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let on = |[u, v]: [usize; 2]| {
        let particles = Variant::new(STATIC, scenes::OPEN_CYLINDER, "cylinder", [u, v]);
        let nodes = Variant::elements(ELEMENTS, [u, v], move || elements([v - 1, u - 1], 2.85, 95));
        [particles.usual_if(u != 17), nodes.usual_if(u == 25)].map(|variant| variant.quick_if(u == 25))
    };
    [[17, 13], [25, 17], [37, 25]].into_iter().flat_map(on).collect()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let snap = value_at(&run.column("minus_U_B")?, &run.column("load")?, SNAP.1);
    let apart = "the table's rows that hold the snap are a fifth of the displacement apart; bricks lie .9 % from the later";
    let mut metrics = TABLE.each(run)?;
    metrics.insert(1, Metric::compared("load in the snap", snap, "-", SNAP.0).near(IN_SNAP.of(run)?, apart));
    Ok(metrics)
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let checks = &reference(TABLE.table)?.cross_check;
    let columns = checks[1]["columns"].as_array().map_or(&[][..], Vec::as_slice);
    let worst =
        columns.iter().filter_map(|column| column["percent_of_table_maximum"].as_f64()).reduce(f64::max);
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R", error: None },
        Published { source: "CalculiX, 16×24 bricks (each of its own largest)", error: worst },
    ])
}
