//! Checks of still water, in which shells have modes: water that stands, on a lattice, and nothing in it but shells.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::several::check_before;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::{BodyScene, Scene};

/// Refuses what has no modes in still water.
pub(in crate::scene::check) fn check_still(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let s = &scene.source.body(name, "fluid");
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(key, value, bound, repair)))
    };
    if let Some(word) = fluid.geometry.rings().map(|_| fluid.geometry.word()) {
        let bound = "`block` or `blocks` in a modal analysis, which solves the still water on their lattice";
        return refuse(
            &format!("geometry.{word}"),
            "rings of particles",
            bound,
            "fill the place with blocks",
        );
    }
    let given = [
        ("velocity", "a velocity", fluid.velocity.is_some()),
        ("beach", "a beach", fluid.beach.is_some()),
        ("periodic", "periodic sides", fluid.periodic.is_some()),
        ("current", "a current", fluid.current.is_some()),
    ];
    if let Some((key, value, _)) = given.iter().find(|(.., given)| *given) {
        let bound = "none in a modal analysis: the water is still and ends at walls and at its surface";
        return refuse(key, value, bound, "leave it out, or use [analysis.explicit.transient]");
    }
    for (name, body) in &scene.bodies {
        let s = scene.source.body(name, body.word());
        let (key, value, bound) = match body {
            BodyScene::Walls(walls) if walls.motion.is_some() => {
                ("motion", "a motion", "none in a modal analysis, in which walls stand")
            }
            BodyScene::Solid(_) => ("", "a solid", "a shell: in still water only shells have modes"),
            BodyScene::Rigid(_) => ("", "a rigid body", "a shell: in still water only shells have modes"),
            BodyScene::Shell(_) => {
                check_before(&BodyInScene::new(scene, name, body)?)?;
                continue;
            }
            BodyScene::Fluid(_) | BodyScene::Walls(_) => continue,
        };
        let path = s.path(key);
        let repair = "leave it out, or use [analysis.explicit.transient]";
        return Err(SceneError::Choice(scene.source.fault(path.trim_end_matches('.'), value, bound, repair)));
    }
    if scene.structures().next().is_none() {
        let bound = "a shell that swings in it: the modes of water alone are none of this analysis";
        return refuse("geometry", "water alone", bound, "add a shell, as in [bodies.plate.shell]");
    }
    if scene.contact.is_empty() {
        return Ok(());
    }
    let bound = "none in a modal analysis with a fluid";
    let fault = scene.scope().fault("contact", "a contact", bound, "leave it out");
    Err(SceneError::Choice(fault))
}
