//! Checks of contacts: which bodies may touch, and where there is none.

use crate::scene::analysis::Analysis;
use crate::scene::analysis_kind::Contacts;
use crate::scene::check::rubbing::{RUBBED_BONDS, too_sharp};
use crate::scene::contact::ContactScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::solid::SolidScene;
use crate::scene::tools::ToolScene;
use crate::scene::walls::WallGeometry;

/// Refuses contacts of bodies without a surface, pairs that are named twice, and analyses that know none.
pub(super) fn check_contact(scene: &Scene) -> Verdict {
    if scene.contact.is_empty() {
        return Ok(());
    }
    for (number, own) in scene.contact.iter().enumerate() {
        match (&own.between, own.pair()) {
            (Some(_), Some(pair)) => check_pair(scene, number, pair)?,
            (Some([name, _]), None) => check_one(scene, number, name)?,
            (None, _) => check_itself(scene, number)?,
        }
    }
    let kind = scene.analysis.kind();
    let repair = "use [analysis.static] or [analysis.explicit], or leave the contact out";
    match kind.contacts {
        Contacts::None => {
            let bound = format!("none in {}, in which nothing opens or closes", kind.name);
            return refuse(scene, "contact", "contact", &bound, repair);
        }
        Contacts::Frozen | Contacts::Smooth if scene.is_together() => {
            let bound = format!("none of several bodies in {}", kind.name);
            return refuse(scene, "contact", "contact", &bound, repair);
        }
        _ => {}
    }
    let rough = scene.contact.iter().position(ContactScene::is_rough);
    if let (Contacts::Smooth, Some(number)) = (kind.contacts, rough) {
        let bound = format!("smooth in {}, whose steps go to and fro", kind.name);
        let repair = "use [analysis.static] or [analysis.explicit], or leave `friction` out";
        return refuse(scene, &format!("contact[{number}].friction"), "friction", &bound, repair);
    }
    Ok(())
}

/// A body with itself: a shell that is alone in its scene, once.
fn check_itself(scene: &Scene, number: usize) -> Verdict {
    let path = format!("contact[{number}]");
    if scene.is_together() {
        let (value, bound) = ("nothing", "two bodies of the scene, or one twice that touches itself");
        let repair = "add between = [\"…\", \"…\"], or leave the contact out";
        return refuse(scene, &format!("{path}.between"), value, bound, repair);
    }
    if number > 0 {
        let bound = "one: it is all of the contact of the body with itself";
        return refuse(scene, &path, "another contact", bound, "remove it");
    }
    if scene.as_shell().is_none() {
        let repair = "leave it out; fragments of a solid of bonds touch by [bodies.NAME.solid.contact]";
        return refuse(scene, "contact", "contact of a body with itself", "that of a shell", repair);
    }
    Ok(())
}

/// One of several bodies with itself: a shell, once.
fn check_one(scene: &Scene, number: usize, name: &str) -> Verdict {
    let path = format!("contact[{number}].between");
    let value = format!("\"{name}\" with itself");
    if !matches!(scene.bodies.get(name), Some(BodyScene::Shell(_))) {
        let bound = "two bodies, or a shell twice, which touches itself";
        return refuse(scene, &path, &value, bound, "name another body");
    }
    if let Some(first) = scene.contact[..number].iter().position(|other| other.is_of_itself(name)) {
        let bound = format!("named once: contact[{first}] is of the same shell");
        return refuse(scene, &path, &value, &bound, "remove one of them");
    }
    Ok(())
}

/// Two bodies of a scene, each pair once.
fn check_pair(scene: &Scene, number: usize, between: &[String; 2]) -> Verdict {
    let path = format!("contact[{number}].between");
    let named = format!("\"{}\" and \"{}\"", between[0], between[1]);
    for name in between {
        let bound = match scene.bodies.get(name) {
            Some(BodyScene::Shell(_) | BodyScene::Rigid(_) | BodyScene::Walls(_)) => continue,
            Some(BodyScene::Solid(solid)) => match without_surface(solid) {
                None => continue,
                Some(bound) => bound,
            },
            _ => "a shell, a solid or a rigid body of the scene",
        };
        let touch = |body: &BodyScene| match body {
            BodyScene::Shell(_) | BodyScene::Rigid(_) => true,
            BodyScene::Solid(solid) => without_surface(solid).is_none(),
            _ => false,
        };
        let known = scene.bodies.iter().filter(|(_, body)| touch(body)).map(|(name, _)| name.as_str());
        let repair = format!("name two of {}", known.collect::<Vec<_>>().join(", "));
        return refuse(scene, &path, &format!("\"{name}\""), bound, &repair);
    }
    if between.iter().all(|name| matches!(scene.bodies.get(name), Some(BodyScene::Rigid(_)))) {
        let bound = "a body that gives way beside a rigid one: two rigid ones have no stiffness of contact";
        return refuse(
            scene,
            &path,
            &named,
            bound,
            "name a shell or a solid for one of them, or leave the contact out",
        );
    }
    check_walls(scene, number, between)?;
    check_unmeasured(scene, number, between)?;
    let same = |other: &ContactScene| other.other(&between[0]) == Some(&between[1]);
    if let Some(first) = scene.contact[..number].iter().position(same) {
        let bound = format!("named once: contact[{first}] is of the same two");
        return refuse(scene, &path, &named, &bound, "remove one of them");
    }
    Ok(())
}

/// Walls are tools of shells, solids and rigid bodies: basins and blocks, which stand or move without turning.
fn check_walls(scene: &Scene, number: usize, between: &[String; 2]) -> Verdict {
    let path = format!("contact[{number}].between");
    for (name, other) in [(&between[0], &between[1]), (&between[1], &between[0])] {
        let Some(BodyScene::Walls(walls)) = scene.bodies.get(name) else { continue };
        if !matches!(
            scene.bodies.get(other),
            Some(BodyScene::Shell(_) | BodyScene::Solid(_) | BodyScene::Rigid(_))
        ) {
            let bound = format!(
                "a shell, a solid or a rigid body beside the walls `{name}`: walls do not touch walls"
            );
            let repair = "name a shell, a solid or a rigid body, or leave the contact out";
            return refuse(scene, &path, &format!("\"{other}\""), &bound, repair);
        }
        if !matches!(walls.geometry, WallGeometry::Basin(_) | WallGeometry::Block(_)) {
            let bound = "walls that are a `basin` or a `block`, whose faces are known exactly";
            let repair = "give the other body tools of the same shape, [[bodies.NAME.shell.tools]]";
            return refuse(scene, &path, &format!("\"{name}\""), bound, repair);
        }
        if walls.motion.as_ref().is_some_and(|motion| motion.waves.is_some()) {
            let bound = "walls that stand, or move by `translation`";
            let repair = "leave the contact out, or give the motion by `translation`";
            return refuse(scene, &path, &format!("\"{name}\", which makes waves"), bound, repair);
        }
        if walls.turns() {
            let bound = "walls that stand, or move without turning";
            let repair = "leave the rotation out, or the contact";
            return refuse(scene, &path, &format!("\"{name}\", which turns"), bound, repair);
        }
        let tools = scene.bodies.get(other).map_or(&[][..], BodyScene::tools);
        let same = |tool: &ToolScene| tool.of_contact.is_none() && tool.name.split('.').next() == Some(name);
        if let Some(tool) = tools.iter().find(|tool| same(tool)) {
            let bound = format!("walls of another name than the tool `{}` of `{other}`", tool.name);
            return refuse(scene, &path, &format!("\"{name}\""), &bound, "rename the tool");
        }
        let turned =
            |body: &BodyScene| matches!(body, BodyScene::Shell(shell) if shell.orientation.is_some());
        if scene.bodies.get(other).is_some_and(turned) {
            let bound =
                format!("a shell without `orientation` beside the walls `{name}`, which lie along the axes");
            let repair = "give the shell its place by `placed`";
            return refuse(scene, &path, &format!("\"{other}\""), &bound, repair);
        }
    }
    Ok(())
}

/// Refuses what was not measured yet: solids of bonds that touch at rest, friction of what is no shell at rest or in a fluid; and that of two solids
/// of bonds, balls without faces in which an anchor could lie.
fn check_unmeasured(scene: &Scene, number: usize, between: &[String; 2]) -> Verdict {
    let of_bonds = |body: &BodyScene| matches!(body, BodyScene::Solid(solid) if solid.galerkin().is_none());
    let marched = matches!(scene.analysis, Analysis::Explicit(_));
    let friction = scene.contact[number].friction.filter(|_| scene.contact[number].is_rough());
    let both = between.iter().all(|name| scene.bodies.get(name).is_some_and(of_bonds));
    for name in between {
        let Some(body) = scene.bodies.get(name) else { continue };
        if of_bonds(body) && !marched {
            let path = format!("contact[{number}].between");
            let bound = "a shell, a Galerkin solid or a rigid body at rest: contact of bonds was measured in marches alone";
            return refuse(scene, &path, &format!("\"{name}\""), bound, "march it, by [analysis.explicit]");
        }
        let sharp = scene.contact[number].rounding.filter(too_sharp).filter(|_| of_bonds(body));
        if let Some(rounding) = sharp.filter(|_| friction.is_some()) {
            let path = format!("contact[{number}].rounding");
            let repair = "leave `rounding` out";
            return refuse(scene, &path, &format!("{}", rounding.get()), RUBBED_BONDS, repair);
        }
        let rubs = matches!(body, BodyScene::Shell(_) | BodyScene::Walls(_));
        let bound = match (marched, scene.fluid()) {
            (true, None) if both => {
                "smooth between two solids of bonds: they are balls, which have no faces to stick to".into()
            }
            _ if rubs => continue,
            (true, None) => continue,
            (true, Some(_)) => {
                format!("smooth where `{name}` is no shell: its friction was not measured in a fluid yet")
            }
            (false, _) => format!(
                "smooth where `{name}` is no shell: friction between solids was measured in marches alone"
            ),
        };
        if let Some(friction) = friction {
            let path = format!("contact[{number}].friction");
            return refuse(scene, &path, &format!("{}", friction.get()), &bound, "leave `friction` out");
        }
    }
    Ok(())
}

/// Why a solid has no surface that others touch.
pub(super) fn without_surface(solid: &SolidScene) -> Option<&'static str> {
    let bonds = solid.galerkin().is_none();
    if solid.is_plane() {
        Some("a body in space: a plane one has no faces that others touch")
    } else if solid.has_directors() {
        Some("a shell, or a solid with layers of nodes: two sheets have none")
    } else if solid.geometry.filled.is_some() {
        Some(if bonds {
            "a block, whose nodes all stand half a spacing behind its faces: those that fill a surface do not"
        } else {
            "a block or an arc, whose nodes on a face have others straight behind them: those on a surface from a file do not"
        })
    } else if bonds && solid.lattice().grading != [1.0; 3] {
        Some("a solid of bonds on an even lattice, whose nodes are balls of one radius")
    } else {
        None
    }
}

fn refuse(scene: &Scene, path: &str, value: &str, bound: &str, repair: &str) -> Verdict {
    Err(SceneError::Choice(scene.scope().fault(path, value, bound, repair)))
}
