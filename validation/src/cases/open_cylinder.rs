//! open-cylinder: a cylinder with free ends pulled out by two forces; bending, then membrane action, a snap between.

use benchmarks_ref::fe_shell::cases::open_cylinder as elements;
use benchmarks_ref::reference;

use super::dial::{ELEMENTS, STATIC};
use super::path::{Compared, distance, value_at};
use crate::case::{Case, Headline, Published, Run, Runs, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::report::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Series};
use crate::{JudgeError, Metric};

pub const SCENE: &str = include_str!("../../../scenes/open-cylinder.toml");
const TABLE: &str = "sze_open_cylinder_pullout";
const COLUMNS: [&str; 3] = ["W_A", "minus_U_B", "minus_U_C"];
/// Largest displacement of the table.
const LARGEST: f64 = 4.551;
/// The table's row inside the snap: displacements run away at nearly constant load, so it is compared by its load.
const SNAP: (f64, f64) = (0.525, 4.061);
const NAME: &str = "distance from the table";
const UNIT: &str = "% of the largest";

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
        together: |_| Ok(Vec::new()),
        headline: Some(Headline { metric: NAME, floor: 0.1, published }),
        figures,
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for [u, v] in [[17, 13], [25, 17], [37, 25]] {
        let particles = Variant::new(STATIC, SCENE, "cylinder", [u, v]);
        let nodes = Variant::elements(ELEMENTS, [u, v], move || elements([v - 1, u - 1], 2.85, 95));
        let quick = |variant: Variant| if u == 25 { variant.quick() } else { variant };
        variants.extend([quick(particles), quick(nodes)]);
    }
    variants
}

/// The largest distance of each displacement from the table, in percent of the largest displacement.
pub fn errors(run: &Run) -> Result<Vec<Option<f64>>, JudgeError> {
    let mut errors = Vec::new();
    for column in COLUMNS {
        let compared = Compared { table: TABLE, known: ["P/Pmax", column], found: ["load", column] };
        errors.push(compared.largest(run, 1.0, Some(SNAP.0))?.map(|error| 100.0 * error / LARGEST));
    }
    Ok(errors)
}

/// The largest distance of the table's points from the paths of the three displacements, in percent of the largest
/// displacement and of the full load: for runs whose load falls in the snap, where [`errors`] end.
pub fn from_path(run: &Run) -> Result<Option<f64>, JudgeError> {
    let (table, load) = (reference(TABLE)?, run.column("load")?);
    let loads = table.column("P/Pmax")?;
    let mut errors = Vec::new();
    for column in COLUMNS {
        let path: Vec<_> = run.column(column)?.into_iter().zip(load.iter().copied()).collect();
        let points: Vec<_> = table.column(column)?.into_iter().zip(loads.iter().copied()).collect();
        errors.push(distance(&path, &points, (LARGEST, 1.0)));
    }
    Ok(largest(errors))
}

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

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors = errors(run)?;
    let snap = value_at(&run.column("minus_U_B")?, &run.column("load")?, SNAP.1);
    let reason = "cells turn by more than half a radian: curvature along arcs and the hold of directors; the table is within .9 % \
                  of bricks";
    let (measured, in_snap) = (MEASURED.of(run)?, IN_SNAP.of(run)?);
    let judged = |name: &str, error| Metric::error(name, error, UNIT).near(measured, reason);
    let apart = "the table's rows that hold the snap are a fifth of the displacement apart; bricks lie .9 % from the later";
    let load = Metric::compared("load in the snap", snap, "-", SNAP.0).near(in_snap, apart);
    let named = COLUMNS.iter().zip(&errors).map(|(name, error)| judged(name, *error));
    Ok([judged(NAME, largest(errors.iter().copied())), load].into_iter().chain(named).collect())
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let checks = &reference(TABLE)?.cross_check;
    let columns = checks[1]["columns"].as_array().map_or(&[][..], Vec::as_slice);
    let worst =
        columns.iter().filter_map(|column| column["percent_of_table_maximum"].as_f64()).reduce(f64::max);
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R", error: None },
        Published { source: "CalculiX, 16×24 bricks (each of its own largest)", error: worst },
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let table = reference(TABLE)?;
    let loads = table.column("P/Pmax")?;
    let mut series = Vec::new();
    let mut label = "Sze et al. 2004, S4R";
    for column in COLUMNS {
        let points = table.column(column)?.into_iter().zip(loads.iter().copied()).collect();
        series.push(Series::marks(std::mem::take(&mut label), points, GREEN, Mark::Cross));
    }
    for (method, words, colour, line) in [
        (STATIC, "particles 25×17", BLUE, Line::Solid),
        (ELEMENTS, "finite elements 25×17", BLACK, Line::Dashed),
    ] {
        let Some(run) = runs.get(method, "25×17") else { continue };
        let mut label = words;
        for column in COLUMNS {
            let points = run.column(column)?.into_iter().zip(run.column("load")?).collect();
            series.push(Series::line(std::mem::take(&mut label), points, colour, line));
        }
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Load against the displacements of three points".into(),
        caption: "W_A under the force, U_B and U_C a quarter round, at mid-length and at the free end. Near half the load the \
                  wall snaps: U_B jumps, U_C turns back."
            .into(),
        x: Axis::linear("displacement"),
        y: Axis::linear("load / 40000").between(0.0, 1.05),
        series,
    })])
}
