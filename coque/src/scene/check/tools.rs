//! Checks of tools: one shape each, names, vectors, and where there are none.

use std::collections::BTreeSet;

use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::conditions::check_course;
use crate::scene::check::contact::without_surface;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::tools::ToolScene;

/// Refuses tools without a shape or of several, of one name, without directions, in analyses that know no contact, and in fluids.
pub(super) fn check_tools(scene: &BodyInScene<'_>, s: &Scope<'_>) -> Verdict {
    let tools = scene.body.tools();
    if tools.is_empty() {
        return Ok(());
    }
    let kind = scene.analysis.kind();
    let refuse = |bound: String, repair: &str| {
        let value = format!("tools that the {} may touch", scene.body.word());
        Err(SceneError::Choice(s.fault("tools", &value, &bound, repair)))
    };
    if !kind.touches {
        let repair = "use [analysis.static] or [analysis.explicit], or leave the tools out";
        return refuse(format!("none in {}, in which nothing opens or closes", kind.name), repair);
    }
    if scene.in_fluid {
        return refuse("none in a fluid".into(), "leave them out");
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
        if let Some(moved) = &tool.moved {
            own.sized_all("moved", moved)?;
        }
        check_turn(tool, &own)?;
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

/// Refuses tools of solids that have no surface, and what was not measured on them yet: friction, bonds at rest.
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
    for (i, tool) in solid.tools.iter().enumerate() {
        if let Some(friction) = tool.friction.filter(|_| tool.is_rough()) {
            let (key, value) = (format!("tools[{i}].friction"), format!("{}", friction.get()));
            let bound = "zero: friction of solids was not measured yet";
            return refuse(&key, &value, bound, "leave `friction` out");
        }
    }
    Ok(())
}

/// Refuses turns that nothing feels, and turns without an axis.
fn check_turn(tool: &ToolScene, s: &Scope<'_>) -> Verdict {
    let Some(angle) = tool.turn else { return Ok(()) };
    s.sized("turn", angle)?;
    let refuse = |bound, repair| Err(SceneError::Choice(s.fault("turn", "a turn", bound, repair)));
    if tool.sphere.is_some() {
        return refuse("none of a ball, which has no axis", "use a capsule or a cylinder");
    }
    if !tool.is_rough() {
        return refuse("none of a smooth tool, whose turn nothing feels", "add `friction`, or remove it");
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
