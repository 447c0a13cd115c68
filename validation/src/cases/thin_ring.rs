//! thin-ring: the ring at t/L = 1/120, where thickness no longer matters but locking would.

use benchmarks_ref::elastica::end_moment;
use benchmarks_ref::fe_shell::cases::{Strip, end_moment as end_moment_elements};
use benchmarks_ref::reference;

use super::dial::{self, CELL, ELEMENTS, STATIC};
use super::strip;
use crate::case::{Case, Headline, Published, Run, Runs, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::report::{Figure, GREEN, Mark, Series};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../scenes/thin-ring.toml");
/// Length of the strip \[m\].
const LENGTH: f64 = 12.0;
/// Name of the metric by which the answers are compared.
const LARGEST: &str = "tip, largest";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thin-ring",
        title: "Strip rolled into a ring, t/L = 1/120",
        about: "The tip against the closed form at every level; the table of Sze et al. beside it. A formulation whose \
                shear locks would stay behind by a multiple.",
        citation: "Sze, Liu and Lo 2004, section 3.2; exact: end moment on an inextensible elastica",
        variants: variants(),
        each,
        together: |runs| strip::still(runs, "49×3", &levels().collect::<Vec<_>>(), LENGTH, 0.001),
        headline: Some(Headline { metric: LARGEST, floor: 1e-3, published }),
        figures,
    }
}

fn variants() -> Vec<Variant> {
    let levels: Vec<f64> = levels().collect();
    let mut variants = Vec::new();
    for [u, v] in [[25, 3], [49, 3]] {
        let marched = dial::variant(CELL, SCENE, "plate", [u, v]);
        variants.push(if u == 25 { marched.quick() } else { marched });
        variants.push(dial::static_variant(SCENE, "plate", [u, v], &levels).quick());
        let elements = move || end_moment_elements(&Strip::THIN_RING, [u - 1, v - 1], 40);
        variants.push(Variant::elements(ELEMENTS, [u, v], elements).quick());
    }
    variants
}

fn exact(level: f64) -> (f64, f64) {
    let tip = end_moment(std::f64::consts::TAU * level);
    (tip.u, tip.w)
}

/// The levels of the scene: every second row of the table.
fn levels() -> impl Iterator<Item = f64> {
    (1..=10).map(|i| f64::from(i) / 10.0)
}

/// Errors \[% of L\], the largest of the levels.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("25×3", 0.052), ("49×3", 0.013)]),
    (STATIC, &[("25×3", 0.052), ("49×3", 0.013)]),
    (ELEMENTS, &[("25×3", 0.051), ("49×3", 0.013)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let exact_errors: Vec<_> =
        levels().map(|level| strip::tip_error(run, level, LENGTH, exact(level))).collect::<Result<_, _>>()?;
    let full = exact_errors.last().copied().flatten();
    let reason = "curvature along arcs, second order in the spacing; the strip is so thin that the elastica is exact to 1e-5";
    let measured = MEASURED.of(run)?;
    let mut metrics = vec![
        Metric::error(LARGEST, largest(exact_errors), strip::UNIT).near(measured, reason),
        Metric::error("tip at 1", full, strip::UNIT).near(measured, reason),
    ];
    let table = reference("sze_cantilever_end_moment")?;
    let mut from_table = Vec::new();
    for row in 1..table.rows.len() {
        let level = table.number(row, "M/Mmax")?;
        let tip = (table.number(row, "minus_U_tip_S4R")? / LENGTH, table.number(row, "W_tip_S4R")? / LENGTH);
        if levels().any(|known| (known - level).abs() < 1e-9) {
            from_table.push(strip::tip_error(run, level, LENGTH, tip)?);
        }
    }
    let found = Metric::error("Sze table, largest", largest(from_table), strip::UNIT);
    metrics.push(strip::beside_table(found, 0.12, measured));
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let grid = if runs.get(CELL, "49×3").is_some() { "49×3" } else { "25×3" };
    let shown: Vec<_> = strip::on_grid(runs, grid);
    if shown.is_empty() {
        return Ok(Vec::new());
    }
    let mut chart = strip::tip_chart(
        "Tip of the thin strip against the moment",
        "Marks of the shell on the lines of the closed form; the published table as small crosses.",
        &shown,
        LENGTH,
        |level| Some(exact(level)),
    )?;
    let table = reference("sze_cantilever_end_moment")?;
    let moments = table.column("M/Mmax")?;
    let mut label = "Sze et al. 2004, S4R";
    for column in ["minus_U_tip_S4R", "W_tip_S4R"] {
        let points =
            moments.iter().zip(table.column(column)?).map(|(&m, value)| (m, value / LENGTH)).collect();
        chart.series.push(Series::marks(std::mem::take(&mut label), points, GREEN, Mark::Cross));
    }
    Ok(vec![Figure::Chart(chart)])
}

/// The table itself against the closed form, at all its rows.
fn published() -> Result<Vec<Published>, JudgeError> {
    let table = reference("sze_cantilever_end_moment")?;
    let columns = ["M/Mmax", "minus_U_tip_S4R", "W_tip_S4R"].map(|name| table.column(name));
    let [levels, u, w] = columns;
    let error = strip::table_error(&levels?, &u?, &w?, LENGTH, exact);
    let opensees = table.cross_check[0]["max_tip_deviation_from_closed_form_over_L"].as_f64();
    Ok(vec![
        Published { source: "Sze et al. 2004, S4R 16×1", error: Some(error) },
        Published { source: "OpenSees 3.7.1, ASDShellQ4 16×1", error: opensees.map(|e| 100.0 * e) },
    ])
}
