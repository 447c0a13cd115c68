//! cantilever-end-shear: a thin cantilever under a dead end force, judged by the exact elastica.
//!
//! ```text
//!   ▓────────────────╴ ↑ P      α = P L²/EI up to 4
//! ```

use benchmarks_ref::elastica::end_load;
use benchmarks_ref::reference;

use super::dial::{self, CELL};
use super::strip;
use crate::case::{Case, Run, Runs};
use crate::measure::largest;
use crate::report::{BLUE, Figure, GREEN, Mark, Series};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../scenes/cantilever-end-shear.toml");
/// Length of the strip \[m\].
const LENGTH: f64 = 10.0;
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
        variants: vec![
            dial::variant(CELL, SCENE, "plate", [21, 3]).quick(),
            dial::variant(CELL, SCENE, "plate", [41, 3]),
        ],
        each,
        together: |_| Ok(Vec::new()),
        figures,
    }
}

fn exact(level: f64) -> (f64, f64) {
    let tip = end_load(FULL_LOAD * level);
    (tip.u, tip.w)
}

fn levels() -> impl Iterator<Item = f64> {
    (1..=10).map(|i| f64::from(i) / 10.0)
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let errors: Vec<_> =
        levels().map(|level| strip::tip_error(run, level, LENGTH, exact(level))).collect::<Result<_, _>>()?;
    let full = errors.last().copied().flatten();
    let reason = "issue 2; shear and stretch, which the elastica leaves out, are 1e-4 of L at t/L = 1/100";
    let mut metrics = vec![
        Metric::error("tip, largest", largest(errors), "% of L").within_if(
            run.variant.grid == "41×3",
            0.5,
            reason,
        ),
        Metric::error("tip at 1", full, "% of L"),
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
    metrics.push(
        Metric::error("Sze table, largest", largest(from_table), "% of L")
            .because("the table is itself within 0.04 % of L of the elastica"),
    );
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let finest = runs.get(CELL, "41×3").or_else(|| runs.get(CELL, "21×3"));
    let Some(run) = finest else { return Ok(Vec::new()) };
    let mut chart = strip::tip_chart(
        "Tip of the cantilever against the end force",
        "Level 1 is P L²/EI = 4. Marks of the shell on the lines of the elastica; the published table as small crosses.",
        &[(run, BLUE, Mark::Disc)],
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
