//! cantilever-end-shear: a thin cantilever under a dead end force, judged by the exact elastica.
//!
//! ```text
//!   ▓────────────────╴ ↑ P      α = P L²/EI up to 4
//! ```

use benchmarks_ref::elastica::end_load;
use benchmarks_ref::fe_shell::cases::{Strip, end_shear as end_shear_elements};
use benchmarks_ref::reference;

use super::dial::{self, CELL, ELEMENTS, STATIC};
use super::strip;
use crate::case::{Case, Headline, Published, Run, Runs, Variant};
use crate::measure::largest;
use crate::measured::Measured;
use crate::report::{Figure, GREEN, Mark, Series};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../scenes/cantilever-end-shear.toml");
/// Length of the strip \[m\].
const LENGTH: f64 = 10.0;
/// Name of the metric by which the answers are compared.
const LARGEST: &str = "tip, largest";
/// P L²/EI at level one.
const FULL_LOAD: f64 = 4.0;

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cantilever-end-shear",
        title: "Cantilever under a dead end force, t/L = 1/100",
        about: "The tip against the exact elastica at every level; the table of Sze et al. beside it. Bending varies \
                along the strip here, unlike on the rings.",
        citation: "Sze, Liu and Lo 2004, section 3.1; exact: Mattiasson 1981, elliptic integrals",
        variants: variants(),
        each,
        together: |runs| strip::still(runs, "41×3", &levels().collect::<Vec<_>>(), LENGTH, 0.001),
        // Shear and stretch, which the elastica leaves out, are 1e-4 of L.
        headline: Some(Headline { metric: LARGEST, floor: 0.01, published }),
        figures,
    }
}

fn variants() -> Vec<Variant> {
    let levels: Vec<f64> = levels().collect();
    let mut variants = Vec::new();
    for [u, v] in [[21, 3], [41, 3]] {
        let marched = dial::variant(CELL, SCENE, "plate", [u, v]);
        variants.push(if u == 21 { marched.quick() } else { marched });
        variants.push(dial::static_variant(SCENE, "plate", [u, v], &levels).quick());
        let elements = move || end_shear_elements(&Strip::END_SHEAR, [u - 1, v - 1], 10);
        variants.push(Variant::elements(ELEMENTS, [u, v], elements).quick());
    }
    variants
}

fn exact(level: f64) -> (f64, f64) {
    let tip = end_load(FULL_LOAD * level);
    (tip.u, tip.w)
}

fn levels() -> impl Iterator<Item = f64> {
    (1..=10).map(|i| f64::from(i) / 10.0)
}

/// Errors \[% of L\], the largest of the levels.
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (CELL, &[("21×3", 0.022), ("41×3", 0.0048)]),
    (STATIC, &[("21×3", 0.022), ("41×3", 0.0049)]),
    (ELEMENTS, &[("21×3", 0.022), ("41×3", 0.0049)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors: Vec<_> =
        levels().map(|level| strip::tip_error(run, level, LENGTH, exact(level))).collect::<Result<_, _>>()?;
    let full = errors.last().copied().flatten();
    let reason = "second order in the spacing; shear and stretch, which the elastica leaves out, are 1e-4 of L at t/L = 1/100";
    let measured = MEASURED.of(run)?;
    let mut metrics = vec![
        Metric::error(LARGEST, largest(errors), strip::UNIT).near(measured, reason),
        Metric::error("tip at 1", full, strip::UNIT).near(measured, reason),
    ];
    let table = reference("sze_cantilever_end_shear")?;
    let mut from_table = Vec::new();
    for row in 1..table.rows.len() {
        let level = table.number(row, "P/Pmax")?;
        let tip = (table.number(row, "minus_U_tip")? / LENGTH, table.number(row, "W_tip")? / LENGTH);
        if levels().any(|known| (known - level).abs() < 1e-9) {
            from_table.push(strip::tip_error(run, level, LENGTH, tip)?);
        }
    }
    let found = Metric::error("Sze table, largest", largest(from_table), strip::UNIT);
    metrics.push(strip::beside_table(found, 0.04, measured));
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let grid = if runs.get(CELL, "41×3").is_some() { "41×3" } else { "21×3" };
    let shown: Vec<_> = strip::on_grid(runs, grid);
    if shown.is_empty() {
        return Ok(Vec::new());
    }
    let mut chart = strip::tip_chart(
        "Tip of the cantilever against the end force",
        "Level 1 is P L²/EI = 4. Marks of the shell on the lines of the elastica; the published table as small crosses.",
        &shown,
        LENGTH,
        |level| Some(exact(level)),
    )?;
    let table = reference("sze_cantilever_end_shear")?;
    let loads = table.column("P/Pmax")?;
    let mut label = "Sze et al. 2004, S4R";
    for column in ["minus_U_tip", "W_tip"] {
        let points = loads.iter().zip(table.column(column)?).map(|(&p, value)| (p, value / LENGTH)).collect();
        chart.series.push(Series::marks(std::mem::take(&mut label), points, GREEN, Mark::Cross));
    }
    Ok(vec![Figure::Chart(chart)])
}

/// The table itself against the elastica, at all its rows.
fn published() -> Result<Vec<Published>, JudgeError> {
    let table = reference("sze_cantilever_end_shear")?;
    let [levels, u, w] = ["P/Pmax", "minus_U_tip", "W_tip"].map(|name| table.column(name));
    let error = strip::table_error(&levels?, &u?, &w?, LENGTH, exact);
    Ok(vec![Published { source: "Sze et al. 2004, S4R 16×1", error: Some(error) }])
}
