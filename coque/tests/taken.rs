//! What a column takes of the values of its particles.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{last, overridden, ran};
use coque::Outcome;

const PLATE: &str = r#"
title = "Cantilever twisted by a force on a corner"
units = { length = "-", force = "-", time = "-" }
geometry.plate = { lengths = [2.0, 1.0], particles = [9, 5] }
material.elastic = { young = 1e5, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.1 }
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1v0", force = { total = [0, 0, -0.1] } }]
analysis.linear = {}
curve = [
    { name = "left-out", of = "displacement", on = "u1", direction = [0, 0, 1] },
    { name = "mean", of = "displacement", on = "u1", take = "mean", direction = [0, 0, 1] },
    { name = "sum", of = "displacement", on = "u1", take = "sum", direction = [0, 0, 1] },
    { name = "max", of = "displacement", on = "u1", take = "max", direction = [0, 0, 1] },
    { name = "min", of = "displacement", on = "u1", take = "min", direction = [0, 0, 1], factor = 2.0 },
    { name = "P", of = "reaction", on = "u0", direction = [0, 0, 1] },
    { name = "P-sum", of = "reaction", on = "u0", take = "sum", direction = [0, 0, 1] },
    { name = "P-mean", of = "reaction", on = "u0", take = "mean", direction = [0, 0, 1] },
]
"#;

fn plate(analysis: &str) -> Outcome {
    ran(overridden(PLATE, "plate.toml", &[("analysis", analysis)]))
}

#[test]
fn a_column_takes_what_it_says() {
    for analysis in ["{ linear = {} }", "{ static = { levels = 1 } }"] {
        let bent = plate(analysis);
        let shape = &bent.shapes.last().unwrap().positions;
        // The edge u1 is the last particle of each of the five rows along u.
        let edge: Vec<f64> = shape.iter().skip(8).step_by(9).map(|x| x.z).collect();
        assert_eq!(edge.len(), 5);
        let (most, least) =
            (edge.iter().copied().fold(f64::MIN, f64::max), edge.iter().copied().fold(f64::MAX, f64::min));
        assert!(least < 1.05 * most && most < 0.0, "the plate twists: {edge:?}");
        let close = |name: &str, wanted: f64| {
            let found = last(&bent, name);
            assert!((found / wanted - 1.0).abs() < 1e-9, "{name} in {analysis}: {found} for {wanted}");
        };
        close("mean", edge.iter().sum::<f64>() / 5.0);
        close("sum", edge.iter().sum());
        close("max", most);
        close("min", 2.0 * least);
        close("P", 0.1);
        close("P-mean", 0.02);
        for (left_out, given) in [("left-out", "mean"), ("P", "P-sum")] {
            assert_eq!(last(&bent, left_out).to_bits(), last(&bent, given).to_bits());
        }
    }
}
