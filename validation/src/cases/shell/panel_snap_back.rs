//! panel-snap-back: the panel at half the thickness, whose path turns back in displacement as well as in load.
//!
//! ```text
//!   P │   .-.
//!     │  /   )      both turning points of the displacement are passed by arc length
//!     │ /   (   /
//!     │/     '-'  w
//! ```

use benchmarks_ref::fe_shell::cases::{PanelSection, panel_path};
use benchmarks_ref::reference;

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREEN, Line, Mark, Series};
use crate::judge::Measured;
use crate::judge::{Case, Headline, Published, Run, Runs, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::path;
use crate::support::scenes;
use crate::{JudgeError, Metric};

const TABLE: &str = "sze_hinged_roof_t6p35_isotropic";
const BRICKS: &str = "fe_hinged_roof_t6p35_isotropic";
/// Displacement \[mm\] and load \[N\] in parts of which distances are counted: turning point and limit load, rounded.
const SCALE: (f64, f64) = (17.0, 586.0);
/// Load up to which the table is confirmed by bricks; its last rows, on the rising branch, differ by up to 46 N.
const CONFIRMED: f64 = 1000.0;
const NAME: &str = "distance from the table, confirmed part";
const UNIT: &str = "% of 17 mm, 586 N";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "panel-snap-back",
        title: "Hinged cylindrical panel, t = 6.35 mm: limit point and snap-back",
        about: "The whole path by arc length: limit load, the first turning point of the displacement at 17.0 mm, the second \
                at 14.5 mm, the least load, and the rising branch. Distances of the table's points from the computed path.",
        citation: "Sze, Liu and Lo 2004, section 3.8",
        variants: variants(),
        each,
        headline: Some(Headline { metric: NAME, floor: 0.1, published }),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for n in [11, 21] {
        // Steps of a 250th of the load draw the turning points by straight pieces.
        let particles = Variant::new(STATIC, scenes::PANEL, "cylinder", [n, n])
            .set("section.homogeneous.thickness", 6.35)
            .set(
                "analysis.arc-length",
                "{ radius = 0.004, stop = { column = \"P\", above = 3100.0 }, steps = 400 }",
            );
        let nodes = Variant::elements(ELEMENTS, [n, n], move || {
            panel_path(n - 1, 6.35, PanelSection::Isotropic, 3100.0)
        });
        variants.extend([particles, nodes].map(|variant| variant.quick().usual_if(n == 21)));
    }
    variants
}

/// Displacement of the crown \[mm\] and load \[N\].
fn points(run: &Run) -> Result<Vec<(f64, f64)>, JudgeError> {
    Ok(run.column("w_crown")?.into_iter().zip(run.column("P")?).collect())
}

fn table() -> Result<Vec<(f64, f64)>, JudgeError> {
    let table = reference(TABLE)?;
    let loads = table.column("P/Pmax")?.into_iter().map(|p| 3000.0 * p);
    Ok(table.column("minus_W_C")?.into_iter().zip(loads).collect())
}

fn bricks() -> Result<Vec<(f64, f64)>, JudgeError> {
    let table = reference(BRICKS)?;
    Ok(table.column("minus_W_C")?.into_iter().zip(table.column("P")?).collect())
}

/// Distances from the confirmed part of the table \[% of 17 mm, 586 N\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("11×11", 2.5), ("21×21", 0.69)]),
    (ELEMENTS, &[("11×11", 2.6), ("21×21", 0.56)]),
]);

/// Distances from the whole table.
#[rustfmt::skip] // a paragraph a method
const WHOLE: Measured = Measured(&[
    (STATIC, &[("11×11", 2.5), ("21×21", 0.69)]),
    (ELEMENTS, &[("11×11", 2.6), ("21×21", 0.99)]),
]);

/// Distances from bricks.
#[rustfmt::skip] // a paragraph a method
const OF_BRICKS: Measured = Measured(&[
    (STATIC, &[("11×11", 2.4), ("21×21", 0.61)]),
    (ELEMENTS, &[("11×11", 2.6), ("21×21", 0.57)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let own = points(run)?;
    let confirmed: Vec<_> = table()?.into_iter().filter(|point| point.1 <= CONFIRMED).collect();
    let low: Vec<_> = bricks()?.into_iter().filter(|point| point.1 <= CONFIRMED).collect();
    let (reason, top) = (
        "both turning points passed; the table is within .8 % of bricks up to 1000 N",
        "beyond 1000 N the table is a single transcription that bricks confirm in shape only",
    );
    let distance =
        |name: &str, known: &[(f64, f64)]| Metric::error(name, path::distance(&own, known, SCALE), UNIT);
    Ok(vec![
        distance(NAME, &confirmed).near(MEASURED.of(run)?, reason),
        distance("whole table", &table()?).near(WHOLE.of(run)?, top),
        distance("bricks", &low).near(OF_BRICKS.of(run)?, "bricks and table differ by .8 % themselves"),
    ])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let confirmed: Vec<_> = table()?.into_iter().filter(|point| point.1 <= CONFIRMED).collect();
    // The computed path of bricks ends before the table does: rows beyond its end are left out.
    let end = bricks()?.last().map_or(0.0, |point| point.0);
    let covered: Vec<_> = confirmed.into_iter().filter(|point| point.0 <= end).collect();
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R", error: None },
        Published { source: "CalculiX, bricks", error: path::distance(&bricks()?, &covered, SCALE) },
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = vec![
        Series::line("CalculiX, 16×16 bricks", bricks()?, BLACK, Line::Solid),
        Series::marks("Sze et al. 2004, S4R", table()?, GREEN, Mark::Cross),
    ];
    if let Some(run) = runs.get(STATIC, "21×21")? {
        series.push(Series::both("particles 21×21, arc length", points(run)?, BLUE, Mark::Circle));
    }
    if let Some(run) = runs.get(ELEMENTS, "21×21")? {
        series.push(Series::line("finite elements 21×21", points(run)?, BLACK, Line::Dashed));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Load against displacement of the crown, t = 6.35 mm".into(),
        caption: "Neither load nor displacement control gets past the two turning points near 17 and 14.5 mm; arc length does.".into(),
        x: Axis::linear("displacement of the crown [mm]").between(0.0, 32.0),
        y: Axis::linear("load on the whole panel [N]").between(-450.0, 1100.0),
        series,
    })])
}
