//! hemisphere-large: the hemisphere with a hole pulled out and pinched to eight tenths of its radius.

use benchmarks_ref::fe_shell::cases::hemisphere_with_hole_large as elements;
use benchmarks_ref::reference;

use super::dial::{ELEMENTS, STATIC};
use super::hemisphere::SCENE;
use super::path::Compared;
use crate::case::{Case, Headline, Published, Run, Runs, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::report::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Series};
use crate::{JudgeError, Metric};

const TABLE: &str = "sze_hemisphere_hole";
/// Columns of the runs and of the table.
const COLUMNS: [(&str, &str); 2] = [("outward", "outward_displacement"), ("inward", "inward_displacement")];
/// Largest displacement of the table.
const LARGEST: f64 = 8.178;
const NAME: &str = "distance from the table";
const UNIT: &str = "% of the largest";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere-large",
        title: "Hemisphere with a hole, large displacements",
        about: "Displacements under the outward and the inward force against the table of Sze et al., over the whole load, in \
                percent of the largest displacement (8.178, with a radius of 10). Large rotations of a thin, doubly curved shell.",
        citation: "Sze, Liu and Lo 2004, section 3.4",
        variants: variants(),
        each,
        together: |_| Ok(Vec::new()),
        // Bricks on 24×24 differ from the table by 0.45 % at most.
        headline: Some(Headline { metric: NAME, floor: 0.1, published }),
        figures,
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for n in [17, 21, 25, 31] {
        let particles = Variant::new(STATIC, SCENE, "sphere", [n, n])
            .set("loads[0].force.total", "[200, 0, 0]")
            .set("loads[1].force.total", "[0, -200, 0]")
            .set("analysis.static.levels", 20);
        let nodes = Variant::elements(ELEMENTS, [n, n], move || elements(n - 1, 20));
        let quick = |variant: Variant| if n == 21 { variant.quick() } else { variant };
        variants.extend([quick(particles), quick(nodes)]);
    }
    variants
}

/// The largest distance of each displacement from the table, in percent of the largest displacement.
pub fn errors(run: &Run) -> Result<Vec<Option<f64>>, JudgeError> {
    let mut errors = Vec::new();
    for (found, known) in COLUMNS {
        let compared = Compared { table: TABLE, known: ["P/Pmax", known], found: ["level", found] };
        errors.push(compared.largest(run, 1.0, None)?.map(|error| 100.0 * error / LARGEST));
    }
    Ok(errors)
}

/// Distances from the table \[% of the largest displacement\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("17×17", 0.5), ("21×21", 0.24), ("25×25", 0.15), ("31×31", 0.24)]),
    (ELEMENTS, &[("17×17", 0.75), ("21×21", 0.7), ("25×25", 0.66), ("31×31", 0.61)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors = errors(run)?;
    let reason = "coarse lattices are of second order; the table itself is within .45 % of bricks";
    let measured = MEASURED.of(run)?;
    let judged = |name: &str, error| Metric::error(name, error, UNIT).near(measured, reason);
    Ok(vec![
        judged(NAME, largest(errors.iter().copied())),
        judged("outward", errors[0]),
        judged("inward", errors[1]),
    ])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let checks = &reference(TABLE)?.cross_check;
    let bricks = checks[1]["columns"][1]["percent_of_table_maximum"].as_f64();
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R", error: None },
        Published { source: "CalculiX, 24×24 bricks", error: bricks },
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let table = reference(TABLE)?;
    let loads = table.column("P/Pmax")?;
    let mut series = Vec::new();
    let mut label = "Sze et al. 2004, S4R";
    for (_, known) in COLUMNS {
        let points = table.column(known)?.into_iter().zip(loads.iter().copied()).collect();
        series.push(Series::marks(std::mem::take(&mut label), points, GREEN, Mark::Cross));
    }
    for (method, words, colour) in
        [(STATIC, "particles 21×21", BLUE), (ELEMENTS, "finite elements 21×21", BLACK)]
    {
        let Some(run) = runs.get(method, "21×21") else { continue };
        let mut label = words;
        for (found, _) in COLUMNS {
            let points = run.column(found)?.into_iter().zip(run.column("level")?).collect();
            let line = if method == STATIC { Line::Solid } else { Line::Dashed };
            series.push(Series::line(std::mem::take(&mut label), points, colour, line));
        }
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Load against the displacements under the forces".into(),
        caption: "Left the outward, right the inward displacement; level 1 is a force of 400.".into(),
        x: Axis::linear("displacement"),
        y: Axis::linear("load level"),
        series,
    })])
}
