//! Checks of links: what they join, what they are made of, and where there is none.

use super::sets::check_set_name;
use super::several::check_before;
use super::wet_rigid::stays_in_plane;
use crate::scene::LinkScene;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::linked::{LinkInScene, links};
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::{Analysis, Explicit};

/// Refuses links of what is no structure, in analyses that know none, and those that are not one thing.
pub(super) fn check_links(scene: &Scene) -> Verdict {
    if scene.links.is_empty() {
        return Ok(());
    }
    let s = scene.scope();
    if matches!(scene.analysis, Analysis::Harmonic(_)) {
        let repair = "use supports with a `spring` and the damping of the analysis, or march by [analysis.explicit.transient]";
        return Err(SceneError::Choice(s.fault("links", "a link", "none in a harmonic analysis", repair)));
    }
    if matches!(scene.analysis, Analysis::Heat(_)) {
        let repair = "remove them, or use [analysis.static] with a load whose `temperature` is `conducted`";
        return Err(SceneError::Choice(s.fault("links", "a link", "none in a heat analysis", repair)));
    }
    if scene.analysis.is_shaken_by_bases() {
        let bent = |link: &LinkScene| {
            let given = [
                ("gap", link.gap.is_some()),
                ("bears", link.bears.is_some()),
                ("table", link.table.is_some()),
            ];
            given.into_iter().find(|(_, given)| *given).map(|(key, _)| key)
        };
        if let Some((i, key)) = scene.links.iter().enumerate().find_map(|(i, link)| Some((i, bent(link)?))) {
            let bound = format!("none in {}, whose answers go to both sides", scene.analysis.kind().name);
            let repair = "give a `stiffness` alone, or march by [analysis.explicit.transient]";
            let value = "a force that is not straight";
            return Err(SceneError::Choice(s.fault(&format!("links[{i}].{key}"), value, &bound, repair)));
        }
    }
    for link in links(scene)? {
        check_ends(scene, &link)?;
        check_kind(scene, &link)?;
    }
    // Of several bodies this is looked at for each of them.
    if let (false, Some((name, body))) = (scene.is_together(), scene.bodies.first_key_value()) {
        check_before(&BodyInScene::new(scene, name, body)?)?;
    }
    Ok(())
}

fn check_ends(scene: &Scene, link: &LinkInScene<'_>) -> Verdict {
    let (s, LinkInScene { path, on, to, own }) = (&scene.scope(), link);
    let at = |key: &str| format!("{path}.{key}");
    let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(&at(key), value, bound, repair)))
    };
    let plane_fluid = scene.fluid().is_some_and(|(_, fluid)| fluid.dimensions() == 2);
    for ((name, set), key) in
        [(Some(*on), "on"), (*to, "to")].into_iter().filter_map(|(end, key)| Some((end?, key)))
    {
        let Some(body) = scene.bodies.get(name) else { continue };
        if matches!(body, BodyScene::Fluid(_) | BodyScene::Walls(_)) {
            let value = format!(
                "a set of `{name}`, {} {}",
                if body.word() == "walls" { "of" } else { "a" },
                body.word()
            );
            let repair = match key {
                "to" => "give the `point` of the ground in its place, or name a structure",
                _ => "name a structure here",
            };
            return refuse(key, &value, "one of a shell, a solid or a rigid body", repair);
        }
        let view = BodyInScene::new(scene, name, body)?;
        check_set_name(&view, &at(key), set)?;
        if let Some(direction) = own.direction {
            if let Some(solid) = view.as_solid() {
                s.in_plane(&at("direction"), direction, solid.is_plane())?;
            }
            if plane_fluid && view.as_rigid().is_some() {
                stays_in_plane(s, &at("direction"), direction)?;
            }
        }
    }
    if own.to.is_some() && own.point.is_some() {
        return refuse("point", "a point of the ground beside `to`", "one far end", "keep `to` or `point`");
    }
    if let Some(point) = own.point {
        s.sized_all(&at("point"), &point)?;
    }
    match own.direction {
        Some(direction) => {
            s.direction(&at("direction"), direction)?;
            let bound = "none where a `direction` draws the link: it is of the distance of its ends";
            if own.point.is_some() {
                return refuse("point", "a point of the ground", bound, "remove `point`, or `direction`");
            }
            if own.length.is_some() {
                return refuse("length", "a length", bound, "remove `length`, or `direction`");
            }
            Ok(())
        }
        None if own.to.is_none() && own.point.is_none() => {
            let repair = "add `to`, the `point` of the ground to which it goes, or a `direction` of motion against the ground";
            Err(SceneError::Missing(s.fault(&at("to"), "nothing", "a far end", repair)))
        }
        None => Ok(()),
    }
}

fn check_kind(scene: &Scene, link: &LinkInScene<'_>) -> Verdict {
    let (s, path, own) = (&scene.scope(), &link.path, link.own);
    let at = |key: &str| format!("{path}.{key}");
    let LinkScene { stiffness, table, damping, bears, gap, length, .. } = own;
    let given =
        [("stiffness", stiffness.is_some()), ("table", table.is_some()), ("damping", damping.is_some())];
    let known = given.map(|(word, _)| word);
    let given: Vec<&str> = given.into_iter().filter_map(|(word, there)| there.then_some(word)).collect();
    s.exactly_one(path, "kind of force", &given, &known)?;
    let only = |key: &str, there: bool, with: &str, repair: &str| match there {
        true => {
            let (value, bound) = (format!("`{key}`"), format!("none without `{with}`"));
            Err(SceneError::Choice(s.fault(&at(key), &value, &bound, repair)))
        }
        false => Ok(()),
    };
    if stiffness.is_none() {
        let repair =
            "remove it: a table says itself where the force is zero, and a dashpot resists both ways";
        only("bears", bears.is_some(), "stiffness", repair)?;
        only("gap", gap.is_some(), "stiffness", repair)?;
    }
    if damping.is_some() {
        only("length", length.is_some(), "stiffness", "remove it: a dashpot has no force at any length")?;
        let transient = matches!(scene.analysis, Analysis::Explicit(Explicit { transient: Some(_), .. }));
        if !transient {
            let bound = format!("none in {}, where no real time passes", scene.analysis.kind().name);
            let repair = "remove the dashpot, or use [analysis.explicit.transient]";
            return Err(SceneError::Choice(s.fault(&at("damping"), "a dashpot", &bound, repair)));
        }
    }
    let Some(table) = table else { return Ok(()) };
    for (i, point) in table.iter().enumerate() {
        s.sized_all(&at(&format!("table[{i}]")), point)?;
    }
    if table.len() < 2 {
        let value = format!("{} points", table.len());
        return Err(s.value(&at("table"), value, "two points at least", "add points, or give a `stiffness`"));
    }
    if let Some(i) = (1..table.len()).find(|&i| table[i][0] <= table[i - 1][0]) {
        let (value, bound) =
            (table[i][0], format!("more than the elongation before it, {}", table[i - 1][0]));
        return Err(s.value(&at(&format!("table[{i}]")), value, &bound, "sort the points by elongation"));
    }
    if contact::ForceCurve::through(table).is_none() {
        let bound = "one without a force at elongation zero";
        let repair = "move its elongations, or add the point [0, 0]; what is taut at rest has a `length` below the distance of its ends";
        return Err(SceneError::Choice(s.fault(&at("table"), "a table", bound, repair)));
    }
    Ok(())
}
