//! hemisphere-in-time: the hemisphere with a hole marched to rest, from linear loads to the full one, against statics.

use super::common::{Cloud, ERROR, HEMISPHERE, Shape};
use crate::case::{Booked, Case, Headline, Runs, Variant};
use crate::cases::dial::{CELL, STATIC};
use crate::measure::largest;
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
        each: |_| Ok(Vec::new()),
        together,
        headline: Some(Headline { metric: ERROR, floor: 0.001, published: || Ok(Vec::new()) }),
        figures: |_| Ok(Vec::new()),
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (n, levels) in [(11, &LEVELS[..]), (21, &LEVELS[..1])] {
        for cloud in [Cloud::Lattice, Cloud::Jitter(0.25, 1)] {
            for method in [CELL, STATIC] {
                let mut variant = Shape { counts: [n, n], ..HEMISPHERE }.on(method, cloud);
                variant.grid = format!("{n}×{n} {}", cloud.name());
                let analysis = if method == CELL {
                    format!("{{ explicit = {{ quasi-static = {{ levels = {levels:?}, period = 1.5 }} }} }}")
                } else {
                    format!("{{ static = {{ levels = {levels:?} }} }}")
                };
                variants.push(
                    variant
                        .set("loads[0].force.total", "[200, 0, 0]")
                        .set("loads[1].force.total", "[0, -200, 0]")
                        .set("analysis", analysis),
                );
            }
        }
    }
    variants
}

fn together(runs: &Runs) -> Result<Vec<Booked>, JudgeError> {
    let mut metrics = Vec::new();
    for (number, run) in runs.0.iter().enumerate().filter(|(_, run)| run.variant.method == CELL) {
        let Some(rest) = runs.get(STATIC, &run.variant.grid) else { continue };
        let levels = if run.variant.grid.starts_with("11") { &LEVELS[..] } else { &LEVELS[..1] };
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
        let reason = "the same discrete energy: what is left is motion below the stop criterion, 1e-4 of a displacement, with rows read after the hold";
        metrics.push((number, Metric::error(ERROR, error, "%").within(0.1, reason)));
    }
    Ok(metrics)
}
