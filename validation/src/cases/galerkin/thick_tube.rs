//! thick-tube: a thick tube under internal pressure, against Lamé's solution.

use super::INCREMENTS;
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("thick-tube.toml");
/// Pressure \[N/m²\], radii \[m\] and Poisson's ratio; Young's modulus is one.
const PRESSURE: f64 = 1e-4;
const RADII: [f64; 2] = [1.0, 2.0];
const POISSON: f64 = 0.3;
const NAMES: [&str; 2] = ["inside", "outside"];

/// The tube, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thick-tube",
        title: "A thick tube under internal pressure",
        about: "A quarter of a slice in plane strain. Displacements of the inner and of the outer face along the radius.",
        citation: "Lamé's solution [timoshenko1970]",
        variants: ["[12, 4, 4]", "[16, 4, 6]"]
            .into_iter()
            .map(|cells| {
                Variant::scene(INCREMENTS, SCENE, cells)
                    .set("bodies.tube.solid.geometry.arc.cells", cells)
                    .quick_if(cells.starts_with("[12"))
                    .judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(NAMES[0], 0.01)),
        ..Case::default()
    }
}

/// Displacement along the radius at a radius \[m\].
fn exact(radius: f64) -> f64 {
    let [inner, outer] = RADII.map(|r| r * r);
    let scale = PRESSURE * inner * (1.0 + POISSON) / (outer - inner);
    scale * ((1.0 - 2.0 * POISSON) * radius + outer / radius)
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let metric = |(name, radius): (&'static str, f64)| {
        let found = Metric::compared(name, run.last(name)?, "m", exact(radius));
        Ok(found.near(0.52, "cells are chords of the circle, and stiff"))
    };
    NAMES.into_iter().zip(RADII).map(metric).collect()
}
