//! Checks of tools: one shape each, names, vectors, and where there are none.

use std::collections::BTreeSet;

use crate::scene::analysis::Analysis;
use crate::scene::analysis_kind::Contacts;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::conditions::check_course;
use crate::scene::check::contact::without_surface;
use crate::scene::check::rubbing::{RUBBED_BONDS, too_sharp};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::problem::BodyScene;
use crate::scene::rigid::RigidScene;
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::tools::ToolScene;

/// Refuses tools without a shape or of several, of one name, without directions, and in analyses that know no contact.
pub(super) fn check_tools(scene: &BodyInScene<'_>, s: &Scope<'_>) -> Verdict {
    let tools = scene.body.tools();
    if tools.is_empty() {
        return Ok(());
    }
    let kind = scene.analysis.kind();
    let refuse = |bound: String, repair: &str| {
        let body = if scene.as_rigid().is_some() { "rigid body" } else { scene.body.word() };
        let value = format!("tools that the {body} may touch");
        Err(SceneError::Choice(s.fault("tools", &value, &bound, repair)))
    };
    let repair = "use [analysis.static] or [analysis.explicit], or leave the tools out";
    match kind.contacts {
        Contacts::None => {
            return refuse(format!("none in {}, in which nothing opens or closes", kind.name), repair);
        }
        Contacts::Frozen | Contacts::Smooth if scene.together => {
            return refuse(format!("none on one of several bodies in {}", kind.name), repair);
        }
        _ => {}
    }
    let mut names = BTreeSet::new();
    for (i, tool) in tools.iter().enumerate() {
        let own = s.below(&format!("tools[{i}]"));
        if !names.insert(&tool.name) {
            let value = format!("\"{}\"", tool.name);
            return Err(own.value(
                "name",
                value,
                "another name than that of the tools before it",
                "rename it",
            ));
        }
        s.exactly_one(&format!("tools[{i}]"), "shape", &tool.given(), &ToolScene::SHAPES)?;
        check_shape(tool, &own)?;
        check_block(scene, tool, &own)?;
        if let Some(moved) = &tool.moved {
            own.sized_all("moved", moved)?;
        }
        check_turn(tool, &own)?;
        if kind.contacts == Contacts::Smooth && tool.is_rough() {
            let bound = format!("smooth in {}, whose steps go to and fro", kind.name);
            let repair = "use [analysis.static] or [analysis.explicit], or leave `friction` out";
            return Err(SceneError::Choice(own.fault("friction", "friction", &bound, repair)));
        }
        check_preloaded(scene, tool, &own)?;
        if let Some(word) = tool.moved.map(|_| "moved").or(tool.turn.map(|_| "turn")) {
            check_course(scene, &s.path(&format!("tools[{i}]")), word, tool.amplitude.as_ref())?;
        } else if tool.amplitude.is_some() {
            let repair = "remove it, or add `moved`: only a tool that moves has a course in time";
            let fault = own.fault("amplitude", "a course in time", "none of a tool that stands", repair);
            return Err(SceneError::Choice(fault));
        }
    }
    Ok(())
}

/// Refuses a preload of what stands still or where nothing could hold it, and tools that a level would move through contact that stays as it is.
fn check_preloaded(scene: &BodyInScene<'_>, tool: &ToolScene, s: &Scope<'_>) -> Verdict {
    let kind = scene.analysis.kind();
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(key, value, bound, repair)))
    };
    if tool.preload && !tool.is_driven() {
        return refuse(
            "preload",
            "a preload",
            "`moved` or `turn` beside it",
            "remove it: what stands still needs none",
        );
    }
    if tool.preload && scene.together {
        let repair = "remove it, or let it grow with the other loads";
        return refuse(
            "preload",
            "a preload",
            "none of one of several bodies: all of them are led by one level",
            repair,
        );
    }
    if tool.preload && !kind.preloads {
        let repair = if kind.passes_time {
            "remove it, and let an `amplitude` bring the tool and hold it"
        } else {
            "use [analysis.static], [analysis.modal] or [analysis.buckling]"
        };
        return refuse("preload", "a preload", &format!("none in {}", kind.name), repair);
    }
    if kind.contacts == Contacts::Frozen && tool.is_driven_by_level() {
        let word = if tool.moved.is_some() { "moved" } else { "turn" };
        let bound = format!("a part of the preload in {}, in which contact stays as it is", kind.name);
        return refuse(word, "a motion", &bound, "add `preload = true`, or let the tool stand");
    }
    Ok(())
}

/// Refuses tools of solids that have no surface, and what was not measured on them yet: friction in a fluid, bonds at rest.
pub(super) fn check_tools_of_solid(scene: &BodyInScene<'_>, solid: &SolidScene, s: &Scope<'_>) -> Verdict {
    if solid.tools.is_empty() {
        return Ok(());
    }
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(key, value, bound, repair)))
    };
    if let Some(bound) = without_surface(solid) {
        return refuse("tools", "tools that the solid may touch", bound, "leave them out");
    }
    let bonds = solid.galerkin().is_none();
    if bonds && !matches!(scene.analysis, Analysis::Explicit(_)) {
        let bound = "none at rest: contact of bonds was measured in marches alone";
        let repair = "march it, by [analysis.explicit], or use [formulation.galerkin]";
        return refuse("tools", "tools that a solid of bonds may touch", bound, repair);
    }
    let rough = || solid.tools.iter().enumerate().filter(|(_, tool)| tool.is_rough());
    let sharp = rough().find_map(|(number, tool)| Some((number, tool.rounding.filter(too_sharp)?)));
    if let Some((number, rounding)) = sharp.filter(|_| bonds) {
        let (key, value) = (format!("tools[{number}].rounding"), format!("{}", rounding.get()));
        return refuse(&key, &value, RUBBED_BONDS, "leave `rounding` out");
    }
    let bound = match (scene.in_fluid, bonds) {
        (true, _) => "smooth: friction of solids was not measured in a fluid yet",
        (_, false) => "smooth at rest: what slips as a whole was not found to settle on a stiff tool yet",
        _ => return Ok(()),
    };
    rough().next().map_or(Ok(()), |(number, _)| {
        refuse(&format!("tools[{number}].friction"), "friction", bound, "leave `friction` out")
    })
}

/// Refuses tools of a rigid body that nothing gives way to, a coat that nothing presses on, and tools at rest, on which no rigid body was measured yet.
pub(super) fn check_tools_of_rigid(scene: &BodyInScene<'_>, rigid: &RigidScene, s: &Scope<'_>) -> Verdict {
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(key, value, bound, repair)))
    };
    let on_walls = scene.scene.contact.iter().any(|own| {
        own.other(scene.name)
            .is_some_and(|other| matches!(scene.scene.bodies.get(other), Some(BodyScene::Walls(_))))
    });
    if rigid.tools.is_empty() && !on_walls {
        let bound = "none without `tools`: another body gives way by its own stiffness";
        return rigid.coat.map_or(Ok(()), |_| refuse("coat", "a coat", bound, "add tools, or remove it"));
    }
    if rigid.coat.is_none() {
        let bound = match on_walls {
            true => "a coat where it touches walls: two rigid faces have no stiffness of contact",
            false => "given beside `tools`: two rigid faces have no stiffness of contact",
        };
        return refuse("coat", "nothing", bound, "coat = { young = …, thickness = … }");
    }
    if !matches!(scene.analysis, Analysis::Explicit(_)) {
        let bound = "none at rest: rigid bodies on tools were measured in marches alone";
        let repair = "march it, by [analysis.explicit]";
        return refuse("tools", "tools that the rigid body may touch", bound, repair);
    }
    Ok(())
}

/// Refuses turns that nothing feels, and turns without an axis.
fn check_turn(tool: &ToolScene, s: &Scope<'_>) -> Verdict {
    let Some(angle) = tool.turn else { return Ok(()) };
    s.sized("turn", angle)?;
    let refuse = |bound, repair| Err(SceneError::Choice(s.fault("turn", "a turn", bound, repair)));
    if let Some(bound) = tool.without_axis() {
        return refuse(bound, "use a capsule or a cylinder");
    }
    if !tool.is_rough() {
        return refuse("none of a smooth tool, whose turn nothing feels", "add `friction`, or remove it");
    }
    Ok(())
}

/// Refuses a block without room inside, and one beside a shell that is turned, whose axes are not those of the block.
fn check_block(scene: &BodyInScene<'_>, tool: &ToolScene, s: &Scope<'_>) -> Verdict {
    let Some(block) = &tool.block else { return Ok(()) };
    for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
        let (min, max) = (block.min[k], block.max[k]);
        // What is no number is above nothing.
        if max.partial_cmp(&min) != Some(std::cmp::Ordering::Greater) {
            let bound = format!("above {min}, the least {axis}");
            return Err(s.value(&format!("block.max[{k}]"), max, &bound, "exchange the two, or move one"));
        }
    }
    if scene.as_shell().is_some_and(|shell| shell.orientation.is_some()) {
        let bound = "none beside an `orientation`: a block lies along the axes of space";
        let fault = s.fault("block", "a block", bound, "give the shell its place by `placed`");
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}

fn check_shape(tool: &ToolScene, s: &Scope<'_>) -> Verdict {
    if let Some(plane) = &tool.plane {
        s.sized_all("plane.point", &plane.point)?;
        s.direction("plane.normal", plane.normal)?;
    }
    if let Some(sphere) = &tool.sphere {
        s.sized_all("sphere.centre", &sphere.centre)?;
    }
    if let Some(drum) = &tool.cylinder {
        s.sized_all("cylinder.point", &drum.point)?;
        s.direction("cylinder.axis", drum.axis)?;
    }
    if let Some(capsule) = &tool.capsule {
        for (i, end) in capsule.ends.iter().enumerate() {
            s.sized_all(&format!("capsule.ends[{i}]"), end)?;
        }
    }
    Ok(())
}
