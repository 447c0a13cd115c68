//! Charts of a case with the reviewed curves in them: a case draws its runs twice, once with the curves of now, once with
//! those that were reviewed, so that its reference stands beside both.

use coque::Curve;

use super::change::Change;
use super::reviewed::{Reviewed, kept};
use crate::Run;
use crate::figures::{Axis, BLUE, Chart, Figure, Line, Mark, Series, VERMILION};
use crate::judge::Runs;

/// Charts of the case in which a curve has changed, with the reviewed points over the lines of now.
pub fn charts(change: &Change<'_>) -> Vec<Chart> {
    let case = &change.result.case;
    let before = Runs {
        chosen: change.result.runs.iter().map(|run| before(run, change)).collect(),
        left_out: change.result.runs.left_out.clone(),
    };
    // A figure may need more rows than a snapshot keeps, and is left out then: the columns are drawn in any case.
    let (Ok(now), Ok(before)) = ((case.figures)(&change.result.runs), (case.figures)(&before)) else {
        return Vec::new();
    };
    let of = |figures: Vec<Figure>| {
        figures.into_iter().filter_map(|figure| match figure {
            Figure::Chart(chart) => Some(chart),
            _ => None,
        })
    };
    let before: Vec<Chart> = of(before).collect();
    of(now).filter_map(|chart| both(before.iter().find(|other| other.title == chart.title)?, chart)).collect()
}

/// A chart of now with the series of another that differ; none where none does.
fn both(before: &Chart, mut now: Chart) -> Option<Chart> {
    let differs = |series: &&Series| {
        !series.points.is_empty() && !now.series.iter().any(|other| other.points == series.points)
    };
    let reviewed: Vec<Series> = before
        .series
        .iter()
        .filter(differs)
        .map(|series| {
            let label = if series.label.is_empty() {
                String::new()
            } else {
                format!("as reviewed: {}", series.label)
            };
            Series::marks(&label, series.points.clone(), VERMILION, Mark::Circle)
        })
        .collect();
    now.series.extend(reviewed);
    (now.series.len() > before.series.len()).then_some(now)
}

/// The run with the curve that was reviewed, where that is another.
fn before(run: &Run, change: &Change<'_>) -> Run {
    let mut run = run.clone();
    let Some(reviewed) = change.reviewed(&run.variant.method, &run.variant.grid) else { return run };
    if !changed(&run.outcome.curve, reviewed).is_empty() {
        run.outcome.curve = curve(&run.outcome.curve, reviewed);
    }
    run
}

/// The rows that were reviewed; a column that no snapshot holds, such as the time, as it is now.
fn curve(now: &Curve, reviewed: &Reviewed) -> Curve {
    let rows = kept(now.rows.len());
    let columns = now.columns.iter().enumerate().map(|(at, column)| {
        reviewed
            .column(&column.title())
            .unwrap_or_else(|| rows.iter().map(|&row| now.rows[row][at]).collect())
    });
    let columns: Vec<Vec<f64>> = columns.collect();
    let count = columns.iter().map(Vec::len).min().unwrap_or(0);
    let rows = (0..count).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
    Curve { columns: now.columns.clone(), rows }
}

/// A column that is not as it was reviewed.
pub struct Changed {
    /// Its title.
    pub title: String,
    /// Largest difference over the largest value that was reviewed; none where the number of rows has changed.
    pub part: Option<f64>,
    /// The column as it was reviewed and as it is now, over the first column of the curve.
    pub chart: Chart,
}

/// The columns of a curve that are not as they were reviewed. What a snapshot rounds away is no change.
pub fn changed(now: &Curve, reviewed: &Reviewed) -> Vec<Changed> {
    /// Half a unit of the fourth digit of the largest value, and as much for the digit that falls on the edge.
    const ROUNDED: f64 = 1.1e-3;
    let rows = kept(now.rows.len());
    let over: Vec<f64> = now.rows.iter().map(|row| row.first().copied().unwrap_or_default()).collect();
    let columns = now.columns.iter().enumerate().filter_map(|(at, column)| {
        let title = column.title();
        let old = reviewed.column(&title)?;
        let largest = old.iter().fold(f64::MIN_POSITIVE, |largest, value| largest.max(value.abs()));
        let new: Vec<f64> = rows.iter().map(|&row| now.rows[row][at]).collect();
        let apart = old.iter().zip(&new).map(|(old, new)| (old - new).abs()).fold(0.0, f64::max);
        let part = (old.len() == new.len()).then_some(apart / largest);
        if part.is_some_and(|part| part < ROUNDED) {
            return None;
        }
        let line = over.iter().copied().zip(now.rows.iter().map(|row| row[at])).collect();
        let marks = rows.iter().map(|&row| over[row]).zip(old).collect();
        Some(Changed {
            part,
            chart: Chart {
                title: title.clone(),
                caption: "Line: now; circles: as reviewed.".into(),
                x: Axis::linear(&now.columns.first().map(coque::Column::title).unwrap_or_default()),
                y: Axis::linear(&title),
                series: vec![
                    Series::line("now", line, BLUE, Line::Solid),
                    Series::marks("as reviewed", marks, VERMILION, Mark::Circle),
                ],
            },
            title,
        })
    });
    columns.collect()
}
