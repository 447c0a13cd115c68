//! Sets that are moved and directors that are rotated by the load level, in every analysis without time.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::f64::consts::PI;

use crate::common::{column, ran};
use coque::{Ended, Outcome, Scene};

const STRIP: &str = r#"
title = "Strip"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [41, 3] }
material.elastic = { young = 12e6, poisson = 0.0, density = 10.0 }
section.homogeneous.thickness = 0.1
curve = [
    { name = "u", of = "displacement", on = "u1", direction = [1, 0, 0] },
    { name = "w", of = "displacement", on = "u1", direction = [0, 0, 1] },
    { name = "P", of = "reaction", on = "u1", direction = [1, 0, 0] },
]
"#;
/// E b h \[N\].
const EA: f64 = 1.2e6;
const LENGTH: f64 = 10.0;

fn strip(supports: &str, analysis: &str) -> Outcome {
    let clamped = "{ on = \"u0\", clamped = {} }";
    let text = format!("{STRIP}supports = [{clamped}, {supports}]\nanalysis.{analysis}\n");
    let outcome = ran(Scene::parse(&text, "strip.toml"));
    assert_eq!(outcome.ended, Ended::Done, "{analysis}: {}", outcome.summary.ended);
    outcome
}

fn last(outcome: &Outcome, name: &str) -> f64 {
    *column(outcome, name).last().unwrap()
}

/// Stretched by a thousandth: P = EA ε, but for the square of ε; ½ P u is stored.
#[test]
fn an_edge_that_is_moved_pulls_in_every_analysis() {
    let moved = "{ on = \"u1\", moved = { direction = [1, 0, 0], by = 0.01 } }";
    for analysis in [
        "static.levels = 2",
        "linear = {}",
        "arc-length.until = 1.0",
        "relaxation = { levels = 1, tolerance = 1e-8 }",
    ] {
        let outcome = strip(moved, analysis);
        let (u, p, stored) = (last(&outcome, "u"), last(&outcome, "P"), last(&outcome, "internal"));
        assert!((u - 0.01).abs() < 1e-12, "{analysis}: {u}");
        assert!((p / (1e-3 * EA) - 1.0).abs() < 3e-3, "{analysis}: {p}");
        assert!((stored / (0.5 * p * u) - 1.0).abs() < 1e-3, "{analysis}: {stored}");
    }
}

/// Half a turn of the end: the strip is half a circle, its end 2L/π above the clamp.
#[test]
fn an_edge_that_is_rotated_rolls_the_strip() {
    let rotated = "{ on = \"u1\", rotated = { axis = [0, -1, 0], by = 180.0 } }";
    let outcome = strip(rotated, "static.levels = 8");
    let (u, w) = (last(&outcome, "u"), last(&outcome, "w"));
    assert!((u / -LENGTH - 1.0).abs() < 3e-4, "{u}");
    assert!((w.abs() / (2.0 * LENGTH / PI) - 1.0).abs() < 1e-3, "{w}");
}

/// Buckling of a column under a force and under a motion of the same edge: the same force.
#[test]
fn a_motion_buckles_a_column_at_the_force_that_does() {
    let moved = "{ on = \"u1\", moved = { direction = [-1, 0, 0], by = 0.01 } }";
    let by_motion = last(&strip(moved, "buckling.modes = 1"), "level") * 1e-3 * EA;
    let text = format!(
        "{STRIP}supports = [{{ on = \"u0\", clamped = {{}} }}]\n\
         loads = [{{ on = \"u1\", force = {{ total = [-1.0, 0.0, 0.0] }} }}]\nanalysis.buckling.modes = 1\n"
    );
    let by_force = last(&ran(Scene::parse(&text, "column.toml")), "level");
    assert!((by_motion / by_force - 1.0).abs() < 1e-4, "{by_motion} against {by_force}");
}
