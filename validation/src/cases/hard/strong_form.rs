//! strong-form: the published equations beside the default formulation, where the other cases have no row of them.

use super::common::{Cloud, ERROR, Shape, off, or_refused};
use crate::case::{Booked, Case, Headline, Run, Runs, Variant};
use crate::cases::dial::{STATIC, STRONG_12, STRONG_085};
use crate::cases::{panel, ring};
use crate::{JudgeError, Metric};

const PANEL: Shape = Shape {
    name: "panel",
    scene: panel::SCENE,
    geometry: "cylinder",
    keys: "radius = 2540.0, angles = [0.0, 5.729577951308232], length = 254.0",
    counts: [11, 11],
    spacing: 25.4,
};
const RING: Shape = Shape {
    name: "ring",
    scene: ring::SCENE,
    geometry: "plate",
    keys: "lengths = [10.0, 1.0]",
    counts: [25, 3],
    spacing: 0.4,
};
/// Shape, what is compared, levels, and the analysis that marches.
const PROBLEMS: [(&Shape, &str, &str, &str); 2] =
    [(&PANEL, "P", "[0.1]", "period = 0.031"), (&RING, "W_tip", "[0.1]", "period = 17.9")];
const CLOUDS: [Cloud; 3] = [Cloud::Lattice, Cloud::Jitter(0.25, 1), Cloud::Scattered(1)];

/// The scenes, their reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strong-form",
        title: "The published equations beside",
        about: "Panel and strip at a tenth of their displacement and moment, on a lattice, on one moved by a quarter of the \
                spacing, and (panel) scattered, with the published smoothing length and with a narrower one; shown, not judged. Zero modes, \
                spin, noise and threads stand with the other cases, larger loads with the usual ones.",
        citation: "reference: the default formulation without time on the same particles",
        variants: variants(),
        each: |_| Ok(Vec::new()),
        together,
        headline: Some(Headline { metric: ERROR, floor: 0.01, published: || Ok(Vec::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (shape, _, levels, march) in PROBLEMS {
        // Scattered particles stand in no rows, and the strip is held along one.
        for cloud in CLOUDS.into_iter().filter(|cloud| shape.name == "panel" || *cloud != CLOUDS[2]) {
            for method in [STATIC, STRONG_12, STRONG_085] {
                let analysis = if method == STATIC {
                    format!("{{ static = {{ levels = {levels} }} }}")
                } else {
                    format!("{{ explicit = {{ quasi-static = {{ levels = {levels}, {march} }} }} }}")
                };
                let variant = shape.on(method, cloud).set("analysis", analysis);
                variants.push(or_refused(variant.restless()));
            }
        }
    }
    variants
}

fn error(runs: &Runs, run: &Run) -> Result<Option<f64>, JudgeError> {
    let problem = PROBLEMS.iter().find(|problem| run.variant.grid.starts_with(problem.0.name));
    let (Some((_, column, ..)), Some(rest)) = (problem, runs.get(STATIC, &run.variant.grid)) else {
        return Ok(None);
    };
    if !(run.done() && rest.done()) {
        return Ok(None);
    }
    let (found, known) = (run.column(column)?.last().copied(), rest.column(column)?);
    Ok(off(found.zip(known.last()).map(|(found, known)| found / known)))
}

fn together(runs: &Runs) -> Result<Vec<Booked>, JudgeError> {
    let mut metrics: Vec<Booked> = Vec::new();
    for (number, run) in runs.0.iter().enumerate().filter(|(_, run)| run.variant.method != STATIC) {
        let error = Metric::error(ERROR, error(runs, run)?, "%");
        metrics.push((
            number,
            error.shown("the published pair sums derive from no energy and are exact on linear fields alone"),
        ));
        let restless = run.done().then_some(run.outcome.restless as f64);
        let shown = Metric::error("levels that did not come to rest", restless, "-");
        metrics.push((number, shown.shown("flutter: motion that damping does not end")));
    }
    Ok(metrics)
}
