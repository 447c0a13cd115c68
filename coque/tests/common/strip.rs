//! A cantilever strip as a scene, and its deflection.

#![allow(dead_code)] // each test binary uses its own part

use coque::{Outcome, Rendering, Scene, Silent, render};

/// A strip 10 × 1 clamped at its left end, without Poisson's ratio.
pub fn strip(section: &str, loads: &str) -> String {
    format!(
        "title = \"Strip\"\nunits = {{ length = \"-\", force = \"-\", time = \"-\" }}\n\
        geometry.plate = {{ lengths = [10.0, 1.0], particles = [41, 5] }}\n\
        material.elastic = {{ young = 1e6, poisson = 0.0, density = 2.0 }}\n{section}\n\
        analysis.linear = {{}}\nsupports = [{{ on = \"u0\", clamped = {{}} }}]\n{loads}\n\
        [[curve]]\nname = \"w\"\nof = \"displacement\"\non = \"u1\"\ndirection = [0.0, 0.0, 1.0]\n\
        [sets]\nroot.box = {{ min = [0.0, 0.0, 0.0], max = [6.0, 1.0, 0.0] }}\n\
        tip.box = {{ min = [6.0, 0.0, 0.0], max = [10.0, 1.0, 0.0] }}\n"
    )
}

/// A section of it.
pub const THIN: &str = "section.homogeneous.thickness = 0.2";

/// Runs a scene on one thread; a refusal is shown.
pub fn run(text: &str) -> Outcome {
    let scene = Scene::parse(text, "scene.toml").and_then(|scene| scene.build(1));
    scene
        .unwrap_or_else(|e| panic!("{}", render(&e, Rendering { width: 100, colour: false })))
        .run(&mut Silent)
}

/// Deflection of its end at the end of the run.
pub fn last(outcome: &Outcome) -> f64 {
    *outcome.curve.column("w").unwrap().last().unwrap()
}
