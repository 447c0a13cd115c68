//! strong-form: the published equations beside the default formulation, where the other cases have no row of them.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{STATIC, STRONG_12, STRONG_085};
use crate::metric_names::ERROR;
use crate::support::clouds::{self, Cloud, Shape};
use crate::support::studies::{off, or_refused};
use crate::{JudgeError, Metric};

const PANEL: Shape = Shape { counts: [11, 11], spacing: 25.4, ..clouds::PANEL };
const RING: Shape = Shape { counts: [25, 3], spacing: 0.4, ..clouds::STRIP };
/// Shape, what is compared, the period of the marching analysis, and the clouds: scattered particles stand in no rows, and the strip is
/// held along one.
const PROBLEMS: [(&Shape, &str, &str, &[Cloud]); 2] =
    [(&PANEL, "P", "0.031", &CLOUDS), (&RING, "W_tip", "17.9", &[CLOUDS[0], CLOUDS[1]])];
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
        headline: Some(Headline::new(ERROR, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (shape, column, period, clouds) in PROBLEMS {
        for &cloud in clouds {
            let on = |method, analysis: &str| {
                or_refused(shape.on(method, cloud).set("analysis", analysis).unsettled())
            };
            let still = on(STATIC, "{ static = { levels = [0.1] } }");
            let grid = still.grid.clone();
            variants.push(still);
            for method in [STRONG_12, STRONG_085] {
                let path = format!("{{ levels = [0.1], period = {period} }}");
                let (marched, grid) =
                    (on(method, &format!("{{ explicit = {{ quasi-static = {path} }} }}")), grid.clone());
                variants.push(marched.judged(move |run, runs| beside(run, runs.get(STATIC, &grid)?, column)));
            }
        }
    }
    variants
}

/// What a run is off the default formulation without time, and whether it came to rest.
fn beside(run: &Run, rest: Option<&Run>, column: &str) -> Result<Vec<Metric>, JudgeError> {
    let error = match rest.filter(|rest| run.done() && rest.done()) {
        Some(rest) => run.last(column)?.zip(rest.last(column)?).map(|(found, known)| found / known),
        None => None,
    };
    let unsettled = run.done().then_some(run.outcome.unsettled as f64);
    Ok(vec![
        Metric::error(ERROR, off(error), "%")
            .shown("the published pair sums derive from no energy and are exact on linear fields alone"),
        Metric::error("levels that did not come to rest", unsettled, "-")
            .shown("flutter: motion that damping does not end"),
    ])
}
