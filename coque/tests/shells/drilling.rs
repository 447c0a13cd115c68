//! Couples about normals in scenes: against what supports bear, and a beam.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{last, overridden, ran};
use coque::Ended;

/// A plate askew in space under a couple about its normal, on a line, a lone particle and an area.
fn plate(on: &str, rest: &str) -> String {
    format!(
        r#"
title = "Plate"
units = {{ length = "m", force = "N", time = "s" }}
geometry.plate = {{ lengths = [0.4, 0.3], particles = [9, 7] }}
orientation = {{ axis = [0.3, 1.0, 0.2], degrees = 40.0 }}
material.elastic = {{ young = 70e9, poisson = 0.3, density = 2700.0 }}
section.homogeneous = {{ thickness = 0.004 }}
sets.point = {{ nearest = [0.2, 0.15, 0.0] }}
sets.area = {{ box = {{ min = [0.15, 0.1, -1.0], max = [0.3, 0.2, 1.0] }} }}
sets.middle = {{ nearest = [0.3, 0.15, 0.0] }}
loads = [{{ on = "{on}", couple = {{ moment = 120.0, axis = [0.2, -0.1, 1.0] }} }}]
{rest}
"#
    )
}

const CLAMPED: &str = r#"
supports = [{ on = "u0", clamped = {} }]
curve = [
    { name = "x", of = "reaction-moment", on = "u0", direction = [1, 0, 0] },
    { name = "y", of = "reaction-moment", on = "u0", direction = [0, 1, 0] },
    { name = "z", of = "reaction-moment", on = "u0", direction = [0, 0, 1] },
    { name = "f", of = "reaction", on = "u0", direction = [0.3, 0.5, 1] },
    { name = "v", of = "displacement", on = "u1", direction = [0, 1, 0] },
]
"#;

/// Supports bear the whole couple, linear and at large, whatever set it is on, and the far edge goes as that of a beam.
#[test]
fn supports_bear_all_of_a_couple_about_the_normal() {
    let axis = [0.2, -0.1, 1.0];
    let size = 120.0 / (0.2_f64 * 0.2 + 0.1 * 0.1 + 1.0).sqrt();
    for on in ["u1", "point", "area"] {
        for analysis in ["analysis.linear = {}", "analysis.static = { levels = 2 }"] {
            let scene = plate(on, &format!("{CLAMPED}{analysis}"));
            let outcome = ran(overridden(&scene, "plate.toml", &[]));
            assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
            for (name, part) in ["x", "y", "z"].into_iter().zip(axis) {
                let found = last(&outcome, name);
                // Measured up to 2e-9: rounding of the stiff forces in the plane of what the couple bends out of it.
                assert!((found + size * part).abs() < 6e-9 * size, "{on}, {analysis}: {name} {found}");
            }
            assert!(last(&outcome, "f").abs() < 1e-4 * size, "{on}, {analysis}");
            // In its plane a beam of EI = 630 000 that bends by M L²/2EI, more where the couple is nearer to the end; at large it leans out of its plane.
            if analysis.contains("linear") {
                let beam = size * 0.16 / 1.26e6;
                let v = last(&outcome, "v");
                assert!(v > 0.6 * beam && v < 1.3 * beam, "{on}: {v:e} {beam:e}");
            }
        }
    }
}
