//! What a bar holds, and what it does not, in words.

use std::collections::BTreeSet;

use crate::scene::{Analysis, BodyScene, Checked, ErrorProbe, ToolScene};

/// What the bars of a scene hold.
pub(super) fn holds(scene: &Checked) -> Vec<String> {
    let mut held = vec!["lattice".to_string()];
    if matches!(scene.analysis, Analysis::Explicit(_)) {
        held.push("time step (it follows the spacing)".into());
    }
    let bonds = scene
        .bodies
        .values()
        .any(|body| matches!(body, BodyScene::Solid(solid) if solid.galerkin().is_none()));
    if bonds {
        held.push("horizon (so many spacings, it shrinks with them)".into());
    }
    let tools = tools(scene).next().is_some();
    if tools || !scene.contact.is_empty() {
        held.push("depth of contact (it follows the spacing)".into());
    }
    held
}

/// The tools of all bodies.
fn tools(scene: &Checked) -> impl Iterator<Item = &ToolScene> {
    scene.bodies.values().flat_map(BodyScene::tools)
}

/// What they do not hold, each with the probe that tells how much it is, where there is one.
pub(super) fn lacks(scene: &Checked) -> Vec<(Option<ErrorProbe>, String)> {
    let mut left = Vec::new();
    match &scene.analysis {
        Analysis::Explicit(explicit) => {
            if let Some(path) = &explicit.quasi_static {
                let share = 100.0 * path.accuracy.get();
                let words = format!("what is missing from rest (up to {share} % of each answer)");
                left.push((Some(ErrorProbe::Rest), words));
            } else {
                left.push((Some(ErrorProbe::Records), "time between records".into()));
            }
        }
        Analysis::Relaxation(_) => {
            left.push((Some(ErrorProbe::Rest), "what is missing from rest (`tolerance`)".into()));
        }
        Analysis::ArcLength(_) => {
            let words = "the polynomial between points of the path (arc step)";
            left.push((Some(ErrorProbe::Arc), words.into()));
        }
        _ => {}
    }
    if tools(scene).any(ToolScene::is_rough) && !matches!(scene.analysis, Analysis::Explicit(_)) {
        left.push((None, "the steps in which friction is followed (levels, and those of a preload)".into()));
    }
    for body in scene.bodies.values() {
        match body {
            BodyScene::Shell(_) => left.push((None, "what a shell leaves out of a solid".into())),
            BodyScene::Solid(solid) if solid.galerkin().is_some() => {
                let words = "the support of the shape functions (so many spacings)";
                left.push((Some(ErrorProbe::Support), words.into()));
            }
            BodyScene::Solid(_) => {
                left.push((Some(ErrorProbe::Horizon), "the number of spacings in a horizon".into()));
            }
            BodyScene::Fluid(_) => {
                left.push((Some(ErrorProbe::SoundSpeed), "the sound speed of the fluid".into()));
                left.push((Some(ErrorProbe::Smoothing), "the smoothing length of the fluid".into()));
            }
            BodyScene::Walls(_) | BodyScene::Rigid(_) => {}
        }
    }
    // Bodies of one kind leave out the same.
    let mut seen = BTreeSet::new();
    left.retain(|(_, words)| seen.insert(words.clone()));
    left
}
