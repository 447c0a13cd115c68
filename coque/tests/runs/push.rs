//! Forces that a function of the caller exerts: the bits of the same load in the scene, and where there are none.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use coque::{Exert, Model, NoPush, Outcome, Scene, Silent};

/// A strip clamped at one end, marched in time, with a load on one corner where `load` says so.
fn strip(load: &str, analysis: &str, threads: usize) -> Model {
    let text = format!(
        r#"
title = "A strip pushed at a corner"
units = {{ length = "m", force = "N", time = "s" }}
geometry.plate = {{ lengths = [10.0, 1.0], particles = [21, 3] }}
material.elastic = {{ young = 1.2e6, poisson = 0.3, density = 1.0 }}
section.homogeneous = {{ thickness = 0.1 }}
sets.corner = {{ nearest = [10.0, 1.0, 0.0] }}
supports = [{{ on = "u0", clamped = {{}} }}]
{load}
analysis.{analysis}
curve = [{{ name = "w", of = "displacement", on = "corner", direction = [0.0, 0.0, 1.0] }}]
"#
    );
    Scene::parse(&text, "strip.toml").unwrap().build(threads).unwrap()
}

const LOAD: &str = r#"loads = [{ on = "corner", force = { total = [0.0, 0.01, 0.1] } }]"#;
const MARCH: &str = "explicit.transient = { duration = 0.5, record_every = 0.05 }";

fn pushed(mut model: Model, exert: Exert) -> Outcome {
    model.push(exert).unwrap();
    model.run(&mut Silent)
}

#[test]
fn a_force_by_a_function_has_the_bits_of_the_scene() {
    let by_scene = strip(LOAD, MARCH, 1).run(&mut Silent);
    let corner = {
        let model = strip("", MARCH, 1);
        let rest = model.body.body().configuration().rest.to_vec();
        rest.iter().position(|x| x.x > 9.9 && x.y > 0.9).unwrap()
    };
    for threads in [1, 2] {
        let outcome = pushed(
            strip("", MARCH, threads),
            Box::new(move |_, _, _, forces| forces[corner] = [0.0, 0.01, 0.1]),
        );
        assert_eq!(outcome.curve.rows, by_scene.curve.rows);
        assert!(outcome.summary.body.modelled.iter().any(|line| line.contains("function of the caller")));
        assert!(!outcome.summary.body.left_out.contains(&"loads".to_string()));
    }
    assert!(by_scene.curve.rows.last().unwrap().last().unwrap().abs() > 1e-3);
}

#[test]
fn there_is_none_without_time() {
    let push = |analysis: &str| strip(LOAD, analysis, 1).push(Box::new(|_, _, _, _| {})).unwrap_err();
    assert_eq!(push("linear = {}"), NoPush::Timeless("a linear analysis"));
    assert_eq!(push("static = { levels = 1 }"), NoPush::Timeless("a static analysis"));
}

#[test]
fn a_force_that_grows_with_the_level_has_the_bits_of_the_scene() {
    let path = "explicit.quasi-static = { levels = 2, ramp = 1.0 }";
    let by_scene = strip(LOAD, path, 1).run(&mut Silent);
    let model = strip("", path, 1);
    let rest = model.body.body().configuration().rest.to_vec();
    let corner = rest.iter().position(|x| x.x > 9.9 && x.y > 0.9).unwrap();
    let exert: Exert =
        Box::new(move |at, _, _, forces| forces[corner] = [0.0, 0.01, 0.1].map(|f| f * at.level));
    assert_eq!(pushed(model, exert).curve.rows, by_scene.curve.rows);
    assert!(by_scene.curve.rows.last().unwrap().last().unwrap().abs() > 1e-3);
}
