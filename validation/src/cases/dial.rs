//! The dial of formulations: the same case run with each, from the compact cell to the published strong form.

use crate::answers::{answers, unit};
use crate::case::Variant;
use crate::measure::frontier;
use crate::report::{
    Axis, BLACK, BLUE, Chart, Colour, Figure, GREEN, GREY, Line, Mark, ORANGE, PURPLE, SKY, Series, VERMILION,
};
use crate::run::CaseResult;
use crate::table::short;

/// The default formulation.
pub const CELL: &str = "stress-point cell";
/// Stress points with a kernel that reaches the four particles of a cell.
pub const WIDE_14: &str = "stress-point 1.4";
/// Stress points with a kernel that reaches twelve particles, the outer eight with little weight.
pub const WIDE_25: &str = "stress-point 2.5";
/// Stress points with the widest kernel that scenes allow.
pub const WIDE_30: &str = "stress-point 3";
/// Sampling at the particles, gradients exact on linear fields.
pub const NODAL_1: &str = "nodal 1";
/// Sampling at the particles, gradients exact on quadratic fields, divergence consistent.
pub const NODAL_2: &str = "nodal 2";
/// Sampling at the particles, gradients exact on cubic fields, divergence consistent, Gregory end weights.
pub const NODAL_3: &str = "nodal 3";
/// The published equations with the published smoothing length.
pub const STRONG_12: &str = "strong-form 1.2";
/// The published equations with a narrower kernel.
pub const STRONG_085: &str = "strong-form 0.85";

/// The default formulation without time: the same discrete energy, solved by Newton's method.
pub const STATIC: &str = "stress-point cell, static";

/// The independent finite-element shell.
pub const ELEMENTS: &str = "fe shell";

/// One position of the dial.
pub struct Setting {
    /// Name in table and report.
    pub method: &'static str,
    /// Path and value in the scene; none for the default.
    pub set: Option<(&'static str, &'static str)>,
    /// Colour in charts.
    pub colour: Colour,
    /// Mark in charts.
    pub mark: Mark,
}

/// The dial, with finite elements beside it. Reach 2 is left out: on these lattices it holds the same four particles as 1.4.
#[rustfmt::skip]
pub const DIAL: [Setting; 11] = [
    Setting { method: CELL, set: None, colour: BLUE, mark: Mark::Disc },
    Setting { method: STATIC, set: None, colour: BLUE, mark: Mark::Square },
    Setting { method: ELEMENTS, set: None, colour: BLACK, mark: Mark::Diamond },
    Setting { method: WIDE_14, set: Some(("stress-point.support", "1.4")), colour: SKY, mark: Mark::Circle },
    Setting { method: WIDE_25, set: Some(("stress-point.support", "2.5")), colour: SKY, mark: Mark::Square },
    Setting { method: WIDE_30, set: Some(("stress-point.support", "3.0")), colour: SKY, mark: Mark::Triangle },
    Setting { method: NODAL_1, set: Some(("nodal.order", "1")), colour: ORANGE, mark: Mark::Circle },
    Setting { method: NODAL_2, set: Some(("nodal.order", "2")), colour: PURPLE, mark: Mark::Square },
    Setting { method: NODAL_3, set: Some(("nodal.order", "3")), colour: GREEN, mark: Mark::Triangle },
    Setting { method: STRONG_12, set: Some(("strong-form.smoothing", "1.2")), colour: VERMILION, mark: Mark::Cross },
    Setting { method: STRONG_085, set: Some(("strong-form.smoothing", "0.85")), colour: BLACK, mark: Mark::Cross },
];

/// The position of a method.
pub fn setting(method: &str) -> Option<&'static Setting> {
    DIAL.iter().find(|setting| setting.method == method)
}

/// A variant of a scene at a position of the dial.
pub fn variant(method: &str, scene: &'static str, geometry: &str, counts: [usize; 2]) -> Variant {
    let variant = Variant::new(method, scene, geometry, counts);
    match setting(method).and_then(|setting| setting.set) {
        Some((path, value)) => variant.set(&format!("formulation.{path}"), value),
        None => variant,
    }
}

/// A variant of a scene without time, at some load levels.
pub fn static_variant(scene: &'static str, geometry: &str, counts: [usize; 2], levels: &[f64]) -> Variant {
    let levels: Vec<String> = levels.iter().map(|level| format!("{level:?}")).collect();
    Variant::new(STATIC, scene, geometry, counts)
        .set("analysis.static.levels", format!("[{}]", levels.join(", ")))
}

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
    for setting in &DIAL {
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
            unit(result)
        ),
        x: Axis::log("wall time of a point of the curve, one thread [s]"),
        y: Axis::log(&format!("error [{}]", unit(result))),
        series,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_on_the_dial_once() {
        for method in [
            CELL, STATIC, ELEMENTS, WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3, STRONG_12,
            STRONG_085,
        ] {
            assert_eq!(DIAL.iter().filter(|setting| setting.method == method).count(), 1, "{method}");
        }
    }
}
