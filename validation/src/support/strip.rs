//! Strips: the distance of the tip from where it should be, the tip's path, the rolled shapes.

use benchmarks_ref::fe_shell::cases::{CaseError, Solved};
use benchmarks_ref::reference;

use crate::JudgeError;
use crate::figures::{Axis, BLACK, Chart, Colour, Figure, GREEN, Line, Mark, Series, Shapes, Sheet, shade};
use crate::format::short;
use crate::judge::measure::largest;
use crate::judge::{Measured, Metric, Recorded, Run, Runs, Variant};
use crate::methods::{CELL, ELEMENTS, STATIC, setting};
use crate::metric_names::DYNAMICS;

/// Unit of all errors of strips.
pub const UNIT: &str = "% of L";

/// Distance of the tip from `exact` = (shortening, deflection), both in parts of `length`: √(Δu² + Δw²)/L in percent.
pub fn tip_error(run: &Run, level: f64, length: f64, exact: (f64, f64)) -> Result<Option<f64>, JudgeError> {
    let (u, w) = (run.at("minus_U_tip", level)?, run.at("W_tip", level)?);
    Ok(u.zip(w).map(|(u, w)| 100.0 * libm::hypot(u / length - exact.0, w / length - exact.1)))
}

/// How far the static run on a grid is from the explicit one: what is left of the dynamics in the latter.
///
/// `measured` is what that was \[% of L\].
pub fn still(
    runs: &Runs,
    grid: &str,
    levels: &[f64],
    length: f64,
    measured: f64,
) -> Result<Vec<Recorded>, JudgeError> {
    let (Some(moving), Some(at)) = (runs.get(CELL, grid)?, runs.number(STATIC, grid)?) else {
        return Ok(Vec::new());
    };
    let mut differences = Vec::new();
    for &level in levels {
        for column in ["minus_U_tip", "W_tip"] {
            let pair = moving.at(column, level)?.zip(runs.chosen[at].at(column, level)?);
            differences.push(pair.map(|(a, b)| 100.0 * (a - b).abs() / length));
        }
    }
    let found = Metric::error(DYNAMICS, largest(differences), UNIT);
    Ok(vec![(at, found.near(measured, "unfinished rest at the levels of the explicit run"))])
}

/// A strip whose tip is known at ten levels by a closed form, and by a published table beside it.
pub struct KnownTip {
    /// The scene, a plate.
    pub scene: &'static str,
    /// Length of the strip.
    pub length: f64,
    /// A coarse lattice, and one of usual fineness.
    pub grids: [[usize; 2]; 2],
    /// Shortening and deflection at a level, in parts of the length.
    pub exact: fn(f64) -> (f64, f64),
    /// Errors \[% of the length\], the largest of the levels, when the case was last reviewed.
    pub measured: Measured,
    /// What the error is made of.
    pub reason: &'static str,
    /// The table.
    pub table: &'static str,
    /// Its columns: level, shortening, deflection.
    pub columns: [&'static str; 3],
    /// How far the table is off the closed form at these levels \[% of the length\].
    pub table_off: f64,
}

impl KnownTip {
    /// Name of the metric by which the answers are compared.
    pub const LARGEST: &'static str = "tip, largest";

    /// Particles in time and without, and finite elements, on both lattices; those in time on the coarse one are quick.
    pub fn variants(&self, elements: fn([usize; 2]) -> Result<Solved, CaseError>) -> Vec<Variant> {
        let [coarse, usual] = self.grids;
        let on = |[u, v]: [usize; 2]| {
            let marched = Variant::new(CELL, self.scene, "plate", [u, v]).quick_if([u, v] == coarse);
            let still = Variant::new(STATIC, self.scene, "plate", [u, v]).static_levels(&LEVELS).quick();
            let nodes = Variant::elements(ELEMENTS, [u, v], move || elements([u - 1, v - 1])).quick();
            [marched, still, nodes].map(|variant| variant.usual_if([u, v] == usual))
        };
        self.grids.into_iter().flat_map(on).collect()
    }

    /// The tip against the closed form and against the table.
    pub fn each(&self, run: &Run) -> Result<Vec<Metric>, JudgeError> {
        let errors = LEVELS.iter().map(|&level| tip_error(run, level, self.length, (self.exact)(level)));
        let errors = errors.collect::<Result<Vec<_>, _>>()?;
        let (full, measured) = (errors.last().copied().flatten(), self.measured.of(run)?);
        let mut from_table = Vec::new();
        for (level, u, w) in self.rows()? {
            if LEVELS.iter().any(|known| (known - level).abs() < 1e-9) {
                from_table.push(tip_error(run, level, self.length, (u / self.length, w / self.length))?);
            }
        }
        let beside = format!(
            "the table is itself {} % of L off the exact curve; to that three times the error measured against the curve",
            short(self.table_off)
        );
        Ok(vec![
            Metric::error(Self::LARGEST, largest(errors), UNIT).near(measured, self.reason),
            Metric::error("tip at 1", full, UNIT).near(measured, self.reason),
            Metric::error("Sze table, largest", largest(from_table), UNIT)
                .within(self.table_off + 3.0 * measured, beside),
        ])
    }

    /// How far the static run of usual fineness is from the explicit one.
    pub fn still(&self, runs: &Runs, measured: f64) -> Result<Vec<Recorded>, JudgeError> {
        still(runs, &words(self.grids[1]), &LEVELS, self.length, measured)
    }

    /// Rows of the table: level, shortening, deflection.
    fn rows(&self) -> Result<Vec<(f64, f64, f64)>, JudgeError> {
        let table = reference(self.table)?;
        let [levels, u, w] = self.columns.map(|name| table.column(name));
        Ok(levels?.into_iter().zip(u?.into_iter().zip(w?)).map(|(level, (u, w))| (level, u, w)).collect())
    }

    /// Largest distance of the rows of the table from the closed form, in percent of the length.
    pub fn table_error(&self) -> Result<f64, JudgeError> {
        let distance = |(level, u, w): (f64, f64, f64)| {
            let tip = (self.exact)(level);
            100.0 * libm::hypot(u / self.length - tip.0, w / self.length - tip.1)
        };
        Ok(self.rows()?.into_iter().map(distance).fold(0.0, f64::max))
    }

    /// The tip's path by all methods and by the table.
    pub fn figures(&self, runs: &Runs, title: &str, caption: &str) -> Result<Vec<Figure>, JudgeError> {
        let [coarse, usual] = self.grids.map(words);
        let grid = if runs.get(CELL, &usual)?.is_some() { usual } else { coarse };
        let shown = on_grid(runs, &grid);
        if shown.is_empty() {
            return Ok(Vec::new());
        }
        let mut chart = tip_chart(title, caption, &shown, self.length, |level| Some((self.exact)(level)))?;
        let rows = self.rows()?;
        let marks = |label, pick: fn(&(f64, f64, f64)) -> f64| {
            let points = rows.iter().map(|row| (row.0, pick(row) / self.length)).collect();
            Series::marks(label, points, GREEN, Mark::Cross)
        };
        chart.series.extend([marks("Sze et al. 2004, S4R", |row| row.1), marks("", |row| row.2)]);
        Ok(vec![Figure::Chart(chart)])
    }
}

/// The levels of the scenes with a known tip.
const LEVELS: [f64; 10] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];

/// Name of a lattice.
fn words([u, v]: [usize; 2]) -> String {
    format!("{u}×{v}")
}

/// Tip displacements in parts of the length against the load level, with the exact law as lines.
pub fn tip_chart(
    title: &str,
    caption: &str,
    runs: &[(&Run, Colour, Mark)],
    length: f64,
    exact: impl Fn(f64) -> Option<(f64, f64)>,
) -> Result<Chart, JudgeError> {
    let levels: Vec<f64> = (0..=200).map(|i| f64::from(i) / 200.0).collect();
    let law = |pick: fn((f64, f64)) -> f64| -> Vec<(f64, f64)> {
        levels.iter().filter_map(|&level| Some((level, pick(exact(level)?)))).collect()
    };
    let mut series = vec![
        Series::line("exact: −u/L (solid), w/L (dashed)", law(|tip| tip.0), BLACK, Line::Solid),
        Series::line("", law(|tip| tip.1), BLACK, Line::Dashed),
    ];
    for (run, colour, mark) in runs {
        let level = run.column("level")?;
        let mut label = format!("{} {}", run.variant.method, run.variant.grid);
        for column in ["minus_U_tip", "W_tip"] {
            let values = run.column(column)?;
            let points = level.iter().zip(values).map(|(&level, value)| (level, value / length)).collect();
            series.push(Series::marks(&std::mem::take(&mut label), points, *colour, *mark));
        }
    }
    Ok(Chart {
        title: title.into(),
        caption: caption.into(),
        x: Axis::linear("load level"),
        y: Axis::linear("displacement of the tip / L"),
        series,
    })
}

/// The settled shapes of a run, laid over each other.
pub fn rolled_shapes(title: &str, caption: &str, run: &Run) -> Shapes {
    let sheets = run
        .outcome
        .shapes
        .iter()
        .map(|shape| {
            Sheet::new(
                &format!("level {}", short(shape.level)),
                &run.outcome.faces,
                shape,
                shade(shape.level),
            )
        })
        .collect();
    Shapes { title: title.into(), caption: caption.into(), view: (-62.0, 16.0), sheets }
}

/// The runs at some grid, with the looks of their methods.
pub fn on_grid<'a>(runs: &'a Runs, grid: &str) -> Vec<(&'a Run, Colour, Mark)> {
    let own = runs.iter().filter(|run| run.variant.grid == grid);
    own.filter_map(|run| setting(&run.variant.method).map(|look| (run, look.colour, look.mark))).collect()
}
