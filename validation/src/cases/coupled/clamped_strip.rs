//! clamped-strip: a strip between two clamps under pressure, 2.9 thicknesses deep, where tension carries most.

use benchmarks_ref::fluid_structure::clamped_strip;
use benchmarks_ref::fluid_structure_forms::CHANNEL_STRIP;

use crate::judge::{Case, Headline, Published, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("clamped-strip.toml");
const PRESSURE: f64 = 200.0;
const NAME: &str = "middle";
const QUARTER: &str = "quarter";
const REASON: &str = "half a percent is asked of a wall before water is let at it; .1 % is left of any spacing: the strip's \
                      pressure follows it and its curvature is along arcs";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "clamped-strip",
        title: "Clamped strip under pressure, 2.9 thicknesses deep",
        about: "Plane strain by a strip of three particles between two mirrors. Deflection of middle and quarter against \
                converged elements; bending alone would bend the strip five times as far.",
        citation: "oomph-lib's Kirchhoff-Love beam, as in the collapsible channel of solids4foam; von Kármán's strip beside it",
        variants: [21, 41, 81]
            .into_iter()
            .map(|n| Variant::new(STATIC, SCENE, "plate", [n, 3]).quick_if(n < 81).usual_if(n == 41))
            .collect(),
        each,
        // The reference is confirmed to .07 %.
        headline: Some(Headline { metric: NAME, floor: 0.07, published }),
        ..Case::default()
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let table = clamped_strip()?;
    let mut metrics = Vec::new();
    for (name, column, part) in [(NAME, "w_middle", 0.5), (QUARTER, "w_quarter", 0.25)] {
        // The table counts deflections against the pressure.
        let exact = -table.at(part)?;
        metrics.push(Metric::compared(name, run.last(column)?, "m", exact).within(0.005 * exact, REASON));
    }
    Ok(metrics)
}

/// The strip after von Kármán.
fn published() -> Result<Vec<Published>, JudgeError> {
    let found = CHANNEL_STRIP.clamped_under(PRESSURE).deflection(0.5);
    let error = 100.0 * (found / -clamped_strip()?.at(0.5)? - 1.0).abs();
    Ok(vec![Published { source: "von Kármán's strip", error: Some(error) }])
}
