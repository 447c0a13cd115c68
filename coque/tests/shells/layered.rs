//! Layered scenes: beams of plies in closed form, the laminated roof, axes that turn with the scene.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{Replaced, column, ran, run};
use coque::{Ended, Outcome, Scene};

fn strip(rest: &str) -> Outcome {
    ran(Scene::parse(&format!("{STRIP}{rest}"), "strip.toml"))
}

/// The roof with few particles and some values replaced.
fn roof(replaced: Replaced) -> Outcome {
    let few = [("geometry.cylinder.particles", "[11, 11]")];
    let outcome = run("panel-laminated.toml", &[&few, replaced].concat());
    assert_eq!(outcome.ended, Ended::Done);
    outcome
}

/// A cantilever strip of two plies, stiff below and soft above, without Poisson's ratio: a composite beam.
const STRIP: &str = r#"
title = "Strip of two plies"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [41, 5] }
material.orthotropic = { young_along = 12e6, young_across = 3e6, poisson = 0.0, shear = 4e6, density = 10.0 }
section.layered = { axis = [1.0, 0.0, 0.0], plies = [{ thickness = 0.1, angle = 0 }, { thickness = 0.1, angle = 90 }] }
supports = [{ on = "u0", clamped = {} }]
analysis.static.levels = 1
curve = [
    { name = "u", of = "displacement", on = "u1", direction = [1.0, 0.0, 0.0] },
    { name = "w", of = "displacement", on = "u1", direction = [0.0, 0.0, 1.0] },
]
"#;

/// A, B, D of that strip per width: Σ E t, Σ E t ζ, Σ E (t ζ² + t³/12) with ζ = ∓0.05.
const A: f64 = 15e6 * 0.1;
const B: f64 = -9e6 * 0.1 * 0.05;
const D: f64 = 15e6 * (0.1 * 0.0025 + 0.001 / 12.0);

#[test]
fn a_strip_of_two_plies_bends_as_a_composite_beam() {
    // P = 1e-3 N: a slope of 4e-5 leaves nothing to geometry.
    let outcome = strip("loads = [{ on = \"u1\", force = { total = [0.0, 0.0, 1e-3] } }]\n");
    let expected = 1e-3 * 1e3 / (3.0 * (D - B * B / A));
    let found = *column(&outcome, "w").last().unwrap();
    // 41 particles along a cubic: 1/40² of it, and shear 3EI/(GAL²) = 3e-4.
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
}

#[test]
fn a_pulled_strip_of_two_plies_curls_towards_the_stiff_one() {
    let outcome = strip("loads = [{ on = \"u1\", force = { total = [1e-3, 0.0, 0.0] } }]\n");
    // N = Ae + Bκ, 0 = Be + Dκ: the soft upper ply stretches more, the tip goes down by κL²/2.
    let e = 1e-3 / (A - B * B / D);
    let curl = -0.5 * (-B / D * e) * 100.0;
    let (u, w) = (*column(&outcome, "u").last().unwrap(), *column(&outcome, "w").last().unwrap());
    assert!((u / (10.0 * e) - 1.0).abs() < 1e-4, "{u} {e}");
    assert!(curl < 0.0 && (w / curl - 1.0).abs() < 2e-3, "{w} {curl}");
}

#[test]
fn limit_loads_of_the_laminated_roofs_are_the_published_ones() {
    // Sze, Liu and Lo 2004, hinged roofs of three plies: largest P/Pmax of 0/90/0 and 90/0/90, Pmax = 3000 N. The tables have
    // three to four digits and steps of 1 mm; 11×11 particles are .1 and .6 % below.
    for (axis, published) in [("[0.0, 1.0, 0.0]", 0.3618), ("[1.0, 0.0, 0.0]", 0.597)] {
        let outcome = roof(&[
            ("section.layered.axis", axis),
            ("analysis.static.levels", "[0.1, 0.2, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55]"),
        ]);
        let limit = &outcome.summary.record.critical[0];
        assert_eq!(limit.kind, "limit point");
        let ratio = 4.0 * limit.level / (3000.0 * published);
        assert!((ratio - 1.0).abs() < 0.02, "{axis}: {ratio}");
    }
}

#[test]
fn in_time_and_without_time_agree_on_the_laminated_roof() {
    let levels = "[0.2, 0.3333333333333333]";
    let explicit = column(&roof(&[("analysis.explicit.quasi-static.levels", levels)]), "P");
    let without = column(&roof(&[("analysis.static.levels", levels)]), "P");
    for (a, b) in explicit.iter().rev().zip(without.iter().rev()).take(2) {
        // The tolerance of the hold, 1e-10 of kinetic over internal energy: a residue of 1e-5, more where the path is flat.
        assert!((a / b - 1.0).abs() < 5e-4, "{a} {b}");
    }
}

#[test]
fn only_the_sum_of_axis_and_angles_matters_and_it_turns_with_the_scene() {
    let levels = ("analysis.static.levels", "[0.1, 0.3]");
    let small = ("geometry.cylinder.particles", "[7, 7]");
    let plies = "[{ thickness = 4.0, angle = 0.0 }, { thickness = 8.0, angle = 35.0 }]";
    let turned_plies = "[{ thickness = 4.0, angle = -90.0 }, { thickness = 8.0, angle = -55.0 }]";
    let base = [levels, small, ("section.layered.plies", plies), ("section.layered.axis", "[1.0, 0.0, 0.0]")];
    let first = column(&roof(&base), "P");
    let turn = ("orientation", "{ axis = [1.0, -2.0, 0.5], degrees = 73.0 }");
    let turned = column(&roof(&[&base[..], &[turn]].concat()), "P");
    // About the outward normal y is a quarter turn after the projection of x.
    let other =
        [levels, small, ("section.layered.plies", turned_plies), ("section.layered.axis", "[0.0, 1.0, 0.0]")];
    let other = column(&roof(&other), "P");
    for ((a, b), c) in first.iter().zip(&turned).zip(&other).skip(1) {
        assert!((b / a - 1.0).abs() < 1e-7 && (c / a - 1.0).abs() < 1e-7, "{a} {b} {c}");
    }
}
