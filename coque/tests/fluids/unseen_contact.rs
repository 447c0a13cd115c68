//! What structures in a fluid do not feel: walls, and water at a face that the scene leaves dry.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::{CUBE, GATE, SHELL_GATE};
use crate::common::{overridden, ran, scene};
use coque::{Outcome, Scene};

/// A stone over a pool, and above it air.
const STONE: &str = r#"title = "Stone"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.4, record_every = 0.01 }
loads = [{ on = "all", gravity = { acceleration = [0.0, -10.0, 0.0] } }]
[bodies.water.fluid]
geometry.block = { lengths = [0.4, 0.1], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 30.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.6], open = ["y1"] }
[bodies.stone.solid]
geometry.block = { lengths = [0.1, 0.08], origin = [0.14, 0.12], spacing = 0.02 }
material.elastic = { young = 2e6, poisson = 0.3333, density = 3000.0 }
formulation.bond-based = { horizon = 3.015, plane = "stress" }
"#;

/// What refuses a scene after replacements of one text by another, in one line.
fn refused(text: &str, replaced: &[(&str, &str)]) -> String {
    let built = Scene::parse(&changed(text, replaced), "scene.toml").and_then(|scene| scene.build(1));
    built.map(|_| ()).unwrap_err().to_string()
}

fn changed(text: &str, replaced: &[(&str, &str)]) -> String {
    replaced.iter().fold(text.to_string(), |text, (from, to)| {
        assert!(text.contains(from), "the scene no longer says {from}");
        text.replacen(from, to, 1)
    })
}

/// Words of the warnings about a scene as it is built.
fn at_start(text: &str, replaced: &[(&str, &str)]) -> Vec<&'static str> {
    let model = Scene::parse(&changed(text, replaced), "scene.toml").unwrap().build(1).unwrap();
    model.warnings().iter().map(|warning| warning.kind.word()).collect()
}

fn words(outcome: &Outcome) -> Vec<&'static str> {
    outcome.summary.record.warnings.iter().map(|warning| warning.kind.word()).collect()
}

fn run(text: &str, replaced: &[(&str, &str)]) -> Outcome {
    ran(overridden(&changed(text, replaced), "scene.toml", &[]))
}

#[test]
fn water_at_a_dry_face_is_refused() {
    let said = refused(CUBE, &[("wet = \"front\"", "wet = \"back\"")]);
    assert!(said.contains("`bodies.plate.shell.wet` is \"back\""), "{said}");
    assert!(said.contains("within a spacing of the front"), "{said}");
    let said =
        scene("shell-in-water.toml", &[("bodies.plate.shell.wet", "back")]).unwrap().build(1).map(|_| ());
    assert!(said.unwrap_err().to_string().contains("within a spacing of the front"));
    // Its director points away from the water.
    let said = refused(SHELL_GATE, &[("placed =", "wet = \"front\"\nplaced =")]);
    assert!(said.contains("within a spacing of the back"), "{said}");
    assert!(at_start(SHELL_GATE, &[("placed =", "wet = \"back\"\nplaced =")]).is_empty());
    assert!(at_start(CUBE, &[]).is_empty());
}

/// A dam breaks towards a gate whose near face is dry: at the start no water is there, later it is.
#[test]
fn water_that_gets_to_a_dry_face_is_reported() {
    let far = ("origin = [0.11, 0.0, -0.04]", "origin = [0.16, 0.0, -0.04]");
    let long = ("duration = 0.01", "duration = 0.12");
    let outcome = run(SHELL_GATE, &[("placed =", "wet = \"front\"\nplaced ="), far, long]);
    let reported = |outcome: &Outcome| {
        outcome.summary.record.warnings.iter().find(|w| w.kind.word() == "dry-face").cloned()
    };
    let said = reported(&outcome).unwrap().message;
    assert!(said.starts_with("gate: at time 0.") && said.contains("wet = \"both\""), "{said}");
    assert_eq!(reported(&run(SHELL_GATE, &[("placed =", "wet = \"back\"\nplaced ="), far, long])), None);
}

#[test]
fn a_stone_that_sinks_through_the_floor_is_reported() {
    let outcome = run(STONE, &[]);
    let said: Vec<&str> = outcome
        .summary
        .record
        .warnings
        .iter()
        .filter(|w| w.kind.word() == "no-contact")
        .map(|w| &w.message[..])
        .collect();
    assert_eq!(said.len(), 2, "{said:?}");
    // The stone's nodes stand half a spacing within it: its lowest are 130 mm over the floor.
    assert!(said[0].contains("denser than the fluid (3000 for 1000)"), "{said:?}");
    assert!(said[0].contains("`tank`, 0.1300 below it"), "{said:?}");
    assert!(said[1].contains("it was in `tank`"), "{said:?}");
}

/// What floats, what is held, what has no time to fall, and what falls on dry ground.
#[test]
fn only_what_may_get_to_a_wall_is_reported_at_the_start() {
    assert_eq!(at_start(STONE, &[]), ["no-contact"]);
    assert!(at_start(STONE, &[("density = 3000.0", "density = 500.0")]).is_empty());
    assert!(at_start(STONE, &[("duration = 0.4", "duration = 0.1")]).is_empty());
    let held = ("[bodies.water", "supports = [{ on = \"stone.y1\", clamped = {} }]\n[bodies.water");
    assert!(at_start(STONE, &[held]).is_empty());
    let dry = ("lengths = [0.4, 0.1]", "lengths = [0.1, 0.1]");
    assert_eq!(at_start(STONE, &[("density = 3000.0", "density = 500.0"), dry]), ["no-contact"]);
}

#[test]
fn a_loose_body_in_a_wall_is_refused_and_a_held_one_is_not() {
    let low = ("origin = [0.14, 0.12]", "origin = [0.14, -0.04]");
    let without = ("lengths = [0.4, 0.1]", "lengths = [0.1, 0.1]");
    let said = refused(STONE, &[low, without]);
    assert!(said.contains("`bodies.stone.solid.geometry`") && said.contains("deep into `tank`"), "{said}");
    let held = ("[bodies.water", "supports = [{ on = \"stone.y0\", clamped = {} }]\n[bodies.water");
    assert!(words(&run(STONE, &[low, without, held, ("duration = 0.4", "duration = 0.05")])).is_empty());
    assert!(at_start(GATE, &[]).is_empty());
}
