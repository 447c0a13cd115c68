//! hemisphere-in-time: the hemisphere with a hole marched to rest, from linear loads to the full one, against statics.

use crate::judge::measure::largest;
use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{CELL, STATIC};
use crate::metric_names::ERROR;
use crate::support::clouds::{Cloud, HEMISPHERE, Shape};
use crate::{JudgeError, Metric};

/// Parts of the full load of 400 (200 on the quarter); the first is that of the linear problem.
const LEVELS: [f64; 5] = [0.005, 0.05, 0.2, 0.5, 1.0];

/// The scenes, and how far the two ways may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere-in-time",
        title: "Hemisphere with a hole by marching",
        about: "The thin hemisphere under 1/200 of its full load, where it is linear, at 21×21, and up to the full load at 11×11, by \
                damped marching with the usual ramp, hold and damping (T₁ = 1.5 by the modes of the scene): the largest difference \
                of a displacement from the static answer of the same particles, over the largest displacement at that load.",
        citation: "reference: the same particles without time",
        variants: variants(),
        headline: Some(Headline::new(ERROR, 0.001)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (n, levels) in [(11, &LEVELS[..]), (21, &LEVELS[..1])] {
        for cloud in [Cloud::Lattice, Cloud::Jitter(0.25, 1)] {
            let grid = format!("{n}×{n} {}", cloud.name());
            let on = |method, analysis: String| {
                let variant = Shape { counts: [n, n], ..HEMISPHERE }.on(method, cloud).named(grid.clone());
                variant
                    .set("loads[0].force.total", "[200, 0, 0]")
                    .set("loads[1].force.total", "[0, -200, 0]")
                    .set("analysis", analysis)
            };
            let marched =
                format!("{{ explicit = {{ quasi-static = {{ levels = {levels:?}, period = 1.5 }} }} }}");
            let still = format!("{{ static = {{ levels = {levels:?} }} }}");
            let rest = grid.clone();
            variants.extend([
                on(CELL, marched).judged(move |run, runs| beside(run, runs.get(STATIC, &rest)?, levels)),
                on(STATIC, still),
            ]);
        }
    }
    variants
}

/// The largest difference from the static answer, over the largest displacement at that load.
fn beside(run: &Run, rest: Option<&Run>, levels: &[f64]) -> Result<Vec<Metric>, JudgeError> {
    let Some(rest) = rest else { return Ok(Vec::new()) };
    let mut errors = Vec::new();
    for &level in levels {
        let mut pairs = Vec::new();
        for column in ["outward", "inward"] {
            pairs.push(run.at(column, level)?.zip(rest.at(column, level)?));
        }
        let size = largest(pairs.iter().map(|pair| pair.map(|pair| pair.1.abs())));
        let apart = largest(pairs.iter().map(|pair| pair.map(|(found, rest)| (found - rest).abs())));
        errors.push(apart.zip(size).map(|(apart, size)| 100.0 * apart / size));
    }
    let error = largest(errors).filter(|_| run.done());
    let reason = "the same discrete energy: what is left is motion below the stop criterion, 1e-4 of a displacement, with rows \
                  read after the hold";
    Ok(vec![Metric::error(ERROR, error, "%").within(0.1, reason)])
}
