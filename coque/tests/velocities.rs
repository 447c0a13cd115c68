//! Velocities at the start: free plates that fly and spin, and what supports hold.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{column, last, overridden, ran};
use coque::Outcome;

const PLATE: &str = r#"
title = "Free plate"
units = { length = "-", force = "-", time = "-" }
geometry.plate = { lengths = [1.0, 1.0], particles = [5, 5] }
material.elastic = { young = 1.0, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.1 }
analysis.explicit.transient = { duration = 10.0, record_every = 1.0 }
curve = [
    { name = "x", of = "displacement", on = "all", take = "max", direction = [1, 0, 0] },
    { name = "z", of = "displacement", on = "all", take = "min", direction = [0, 0, 1] },
    { name = "angle", of = "rotation", on = "all", direction = [1, 0, 0] },
    { name = "edge", of = "displacement", on = "u0", direction = [0, 0, 1] },
]
"#;

fn plate(replaced: &[(&str, &str)]) -> Outcome {
    ran(overridden(PLATE, "plate.toml", replaced))
}

#[test]
fn a_free_plate_flies_on() {
    let flying = plate(&[("velocity", "{ linear = [0.02, 0, -0.01] }")]);
    let energy = 0.5 * 0.1 * (0.02_f64.powi(2) + 0.01_f64.powi(2));
    assert_eq!(flying.curve.rows.len(), 11);
    for (row, time) in column(&flying, "time").into_iter().enumerate() {
        for (name, speed) in [("x", 0.02), ("z", -0.01)] {
            assert!((column(&flying, name)[row] - speed * time).abs() < 1e-14, "{name} at {time}");
        }
        assert!((column(&flying, "kinetic")[row] / energy - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_free_plate_spins_on() {
    // Three turns about a line in its plane; an edge has a two-hundredth of the speed of sound.
    let rate = 0.01;
    let more = [
        ("velocity", "{ spin = { axis = [2, 0, 0], point = [0, 0.5, 0], rate = 0.01 } }"),
        ("analysis.explicit.transient", "{ duration = 1885.0, record_every = 5.0 }"),
    ];
    let spinning = plate(&more);
    let energy = |row: usize| column(&spinning, "kinetic")[row] + column(&spinning, "internal")[row];
    for (row, time) in column(&spinning, "time").into_iter().enumerate() {
        let angle = column(&spinning, "angle")[row];
        assert!((angle - rate * time).abs() < 1e-3, "{angle} at {time}");
        assert!((energy(row) / energy(0) - 1.0).abs() < 1e-3, "{} at {time}", energy(row) / energy(0));
    }
    // A turned scene spins the same.
    let turned = plate(&[&more[..], &[("orientation", "{ axis = [1, 2, 3], degrees = 50 }")]].concat());
    assert!((last(&turned, "angle") - last(&spinning, "angle")).abs() < 1e-6);
}

#[test]
fn what_supports_hold_stays_at_rest() {
    let thrown = plate(&[
        ("supports", r#"[{ on = "u0", hinged = {} }]"#),
        ("velocity", "{ linear = [0, 0, 0.01], spin = { axis = [0, 1, 0], rate = 0.01 } }"),
        ("analysis.explicit.transient.duration", "1.0"),
    ]);
    assert!(column(&thrown, "edge").iter().all(|z| *z == 0.0));
    // One row of five is held; its particles stand for half a cell each.
    let energy = column(&thrown, "kinetic")[0];
    assert!(energy > 0.0 && energy < 0.9 * 0.5 * 0.1 * 0.01_f64.powi(2) * 2.0, "{energy}");
}
