//! What a bar holds, and what it does not, in words.

use crate::scene::{Analysis, BodyScene, Checked};

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
    held
}

/// What they do not hold.
pub(super) fn lacks(scene: &Checked) -> Vec<String> {
    let mut left = Vec::new();
    match &scene.analysis {
        Analysis::Explicit(explicit) => {
            if let Some(path) = &explicit.quasi_static {
                left.push(format!(
                    "what is missing from rest (up to {} % of each answer)",
                    100.0 * path.accuracy.get()
                ));
            } else {
                left.push("time between records".into());
            }
        }
        Analysis::Relaxation(_) => left.push("what is missing from rest (`tolerance`)".into()),
        Analysis::ArcLength(_) => left.push("the polynomial between points of the path (arc step)".into()),
        _ => {}
    }
    for body in scene.bodies.values() {
        match body {
            BodyScene::Shell(_) => left.push("what a shell leaves out of a solid".into()),
            BodyScene::Solid(solid) if solid.galerkin().is_some() => {
                left.push("the support of the shape functions (so many spacings)".into());
            }
            BodyScene::Solid(_) => left.push("the number of spacings in a horizon".into()),
            BodyScene::Fluid(_) => left.push("the sound speed and the smoothing length of the fluid".into()),
            BodyScene::Walls(_) => {}
        }
    }
    left
}
