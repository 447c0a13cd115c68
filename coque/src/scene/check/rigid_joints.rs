//! Checks of joints: which bodies they join, where, and in which analyses there are none.

use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::source::suggest;
use crate::scene::{Analysis, Explicit, JointScene};

/// Refuses joints of what is not rigid, of a body with itself, at rest, and in a plane fluid those that would leave its plane.
pub(super) fn check_rigid_joints(scene: &Scene) -> Verdict {
    if scene.joints.is_empty() {
        return Ok(());
    }
    let s = scene.scope();
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if !matches!(scene.analysis, Analysis::Explicit(Explicit { transient: Some(_), .. })) {
        let bound =
            format!("none in {}: joints are constraints of a march in real time", scene.analysis.kind().name);
        return refuse(
            "joints",
            "a joint",
            &bound,
            "use [analysis.explicit.transient], or stiff [[links]] or springs at rest",
        );
    }
    let plane = scene.fluid().is_some_and(|(_, fluid)| fluid.dimensions() == 2);
    for (i, joint) in scene.joints.iter().enumerate() {
        let at = |key: &str| format!("joints[{i}].{key}");
        let JointScene { on, to, at: place, .. } = joint;
        for (name, key) in [(Some(on), "on"), (to.as_ref(), "to")] {
            let Some(name) = name else { continue };
            let value = format!("\"{name}\"");
            match scene.bodies.get(name) {
                Some(BodyScene::Rigid(_)) => {}
                Some(body) => {
                    let bound = format!("a rigid body; `{name}` is a {}", body.word());
                    return refuse(
                        &at(key),
                        &value,
                        &bound,
                        "name a rigid body, or glue the other one to it by [[glue]]",
                    );
                }
                None => {
                    let known: Vec<&str> = scene.bodies.keys().map(String::as_str).collect();
                    return Err(SceneError::Set(s.fault(
                        &at(key),
                        &value,
                        "which is no body",
                        &suggest(name, &known),
                    )));
                }
            }
        }
        if to.as_ref() == Some(on) {
            let repair = "name another body, or leave `to` out for the ground";
            return refuse(&at("to"), &format!("\"{on}\""), "another body than `on`", repair);
        }
        s.exactly_one(&format!("joints[{i}]"), "kind", &joint.given(), &JointScene::WORDS)?;
        s.sized_all(&at("at"), place)?;
        let earlier = &scene.joints[..i];
        if let Some(name) = joint.name.as_ref().filter(|_| earlier.iter().any(|own| own.name == joint.name)) {
            let repair = "give each joint a name of its own";
            return refuse(&at("name"), &format!("\"{name}\""), "no name of another joint", repair);
        }
        if let (Some(axis), Some(word)) = (joint.axis(), joint.given().first()) {
            let path = at(&format!("{word}.axis"));
            s.direction(&path, axis)?;
            let [x, y, z] = axis;
            let (in_plane, bound, repair) = match word {
                &"hinge" => (
                    x == 0.0 && y == 0.0,
                    "along z",
                    "use [0, 0, 1]: a body in a plane fluid turns in the plane",
                ),
                _ => (
                    z == 0.0,
                    "in the plane of x and y",
                    "set its third component to zero: a body in a plane fluid stays in the plane",
                ),
            };
            if plane && !in_plane {
                return Err(s.value(&path, format!("{axis:?}"), bound, repair));
            }
        }
    }
    Ok(())
}
