//! Error against cost: one mark a run.

use crate::figures::{Axis, Chart, Figure, GREY, Line, Series};
use crate::format::short;
use crate::judge::CaseResult;
use crate::judge::measure::frontier;
use crate::methods::METHODS;
use crate::tables::{answers, unit_of_answers};

/// Error over wall time, one mark a run; none for fewer than three.
pub fn cost_chart(result: &CaseResult) -> Option<Figure> {
    let headline = result.case.headline?;
    let points: Vec<(&str, (f64, f64))> = answers(result)
        .iter()
        .map(|a| {
            (a.run.variant.method.as_str(), (a.run.outcome.seconds_per_point(), a.error.max(headline.floor)))
        })
        .collect();
    if points.len() < 3 {
        return None;
    }
    let all: Vec<(f64, f64)> = points.iter().map(|&(_, point)| point).collect();
    let best = frontier(&all).into_iter().map(|i| all[i]).collect();
    let mut series = vec![Series::line("best of error and cost", best, GREY, Line::Solid)];
    for setting in &METHODS {
        let own: Vec<(f64, f64)> =
            points.iter().filter(|(method, _)| *method == setting.method).map(|&(_, point)| point).collect();
        if !own.is_empty() {
            series.push(Series::marks(setting.method, own, setting.colour, setting.mark));
        }
    }
    Some(Figure::Chart(Chart {
        title: format!("{}: error against cost", result.case.name),
        caption: format!(
            "Each mark is a run: error ({}) against the wall time of a point of its curve. Left and down is better; the \
             grey line joins the runs that none beats in both. Errors below {} {} are drawn there: the reference is not \
             known better.",
            headline.metric,
            short(headline.floor),
            unit_of_answers(result)
        ),
        x: Axis::log("wall time of a point of the curve, one thread [s]"),
        y: Axis::log(&format!("error [{}]", unit_of_answers(result))),
        series,
    }))
}
