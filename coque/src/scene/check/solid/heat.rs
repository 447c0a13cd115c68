//! Checks of a solid that conducts heat, or is heated.

use super::conditions::check_face_of_heat;
use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::{BodyInScene, OnSet};
use crate::scene::check::heat_alone::{conducted, refuse_mechanics};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::loads::{Load, Temperature};
use crate::scene::output::Fields;
use crate::scene::solid::SolidScene;

/// Refuses what enters no solid, materials that do not say how they conduct and store, and what moves in an analysis of heat.
pub(in super::super) fn check_conduction_of_solid(
    scene: &BodyInScene<'_>,
    solid: &SolidScene,
    in_time: bool,
) -> Verdict {
    let s = &scene.scope();
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if solid.has_directors() {
        let bound = "none on a plate of two sheets: blocks of bonds, Galerkin solids and shells conduct it";
        return refuse("heat", "heat", bound, "remove it, or model the plate as a shell");
    }
    for (i, own) in scene.scene.heat.iter().enumerate() {
        let at = |key: &str| format!("heat[{i}].{key}");
        if own.edge_flux.is_some() {
            let repair = "use `flux` on a face: heat by its area";
            return refuse(&at("edge_flux"), "heat through an edge", "none of a solid", repair);
        }
        let sided = [
            ("film.faces", own.film.is_some_and(|film| film.faces.is_some())),
            ("radiation.faces", own.radiation.is_some_and(|own| own.faces.is_some())),
        ];
        if let Some((key, _)) = sided.into_iter().find(|(_, given)| *given) {
            let bound = "none of a solid, whose faces have one side";
            return refuse(&at(key), "faces of a shell", bound, "remove it");
        }
        if own.flux.is_some() || own.film.is_some() || own.radiation.is_some() {
            check_face_of_heat(scene, &at("on"), &own.on)?;
        }
    }
    let own = &scene.body_scope();
    let at = |key: &str| format!("material.{}.{key}", solid.material.word());
    if solid.material.yields() {
        let bound = "elastic or orthotropic: a material that yields has no conductivity";
        let repair = "give the solid an elastic material for its heat";
        return Err(SceneError::Choice(own.fault("material.plastic", "heat", bound, repair)));
    }
    if solid.material.conductivity().is_none() {
        let bound = "a conductivity of every material through which heat runs";
        let repair = "add it, in force by time and temperature";
        return Err(SceneError::Missing(own.fault(&at("conductivity"), "nothing", bound, repair)));
    }
    if in_time && solid.material.heat_by_volume().is_none() {
        let bound = "the specific heat of every material that warms in time";
        let repair = "add it, in squares of length by time and by temperature, J/(kg K) of newtons, metres and seconds";
        return Err(SceneError::Missing(own.fault(&at("specific_heat"), "nothing", bound, repair)));
    }
    if !matches!(scene.analysis, Analysis::Heat(_)) {
        return Ok(());
    }
    let found = [
        ("supports", !scene.supports.is_empty()),
        ("loads", !scene.loads.is_empty()),
        ("tools", !solid.tools.is_empty()),
        ("fracture", solid.fracture.is_some()),
        ("contact", solid.contact.is_some()),
        ("imperfection", solid.imperfection.is_some()),
        ("velocity", solid.velocity.is_some()),
        ("output.fields", scene.output.fields.is_some_and(Fields::shows_stresses)),
    ];
    let found = found.into_iter().find(|(_, given)| *given);
    found.map_or(Ok(()), |(key, _)| refuse_mechanics(scene, key))
}

/// Refuses changes that a solid does not have, sets that are not all of it, and analyses without a place for it.
pub(in super::super) fn check_temperature_of_solid(
    scene: &BodyInScene<'_>,
    load: &OnSet<'_, Load>,
    solid: &SolidScene,
) -> Verdict {
    let Some(Temperature { difference, values, .. }) = &load.temperature else { return Ok(()) };
    let (s, at) = (&scene.scope(), load.at("temperature"));
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if solid.has_directors() {
        let bound = "none of a plate of two sheets: blocks of bonds, Galerkin solids and shells expand";
        return refuse(&at, "a `temperature`", bound, "remove it, or model the plate as a shell");
    }
    if difference.is_some() {
        let bound = "none of a solid, which has no thickness";
        let repair = "let the solid conduct heat between its faces: [[heat]], and `conducted`";
        return refuse(&format!("{at}.difference"), "a difference between faces", bound, repair);
    }
    if values.is_some() {
        let bound = "one `change` for a solid, or `conducted`";
        return refuse(&format!("{at}.values"), "numbers by particle", bound, "remove it");
    }
    if load.on != "all" && solid.galerkin().is_some() {
        let bound = "\"all\": a Galerkin solid is warmed as a whole, or by what it conducts";
        let repair = "use on = \"all\", or hold the set at its temperature by [[heat]] and take up what is `conducted`";
        return refuse(&load.at("on"), &format!("\"{}\"", load.on), bound, repair);
    }
    if scene.together && conducted(load) {
        let bound = "none among several bodies, which do not conduct heat";
        return refuse(&format!("{at}.conducted"), "conducted heat", bound, "give `change` in numbers");
    }
    let material = &scene.body_scope();
    match solid.material.elastic() {
        None => {
            let (path, value) = (format!("material.{}", solid.material.word()), "a `temperature`");
            let bound = "elastic: solids of other materials do not expand";
            let repair = "use [material.elastic] with an `expansion`, or remove the temperature";
            return Err(SceneError::Choice(material.fault(&path, value, bound, repair)));
        }
        Some(elastic) if elastic.expansion.is_none() => {
            let bound = "a coefficient of expansion of a solid that is heated";
            let fault = material.fault(
                "material.elastic.expansion",
                "nothing",
                bound,
                "add it, by degree of temperature",
            );
            return Err(SceneError::Missing(fault));
        }
        Some(_) => {}
    }
    let knows = match scene.analysis {
        Analysis::Static(_)
        | Analysis::Linear(_)
        | Analysis::ArcLength(_)
        | Analysis::Relaxation(_)
        | Analysis::Buckling(_) => true,
        Analysis::Explicit(_) => solid.galerkin().is_none(),
        _ => false,
    };
    if !knows {
        let bound = format!("none of a solid in {}", scene.analysis.kind().name);
        let repair =
            "use [analysis.static], linear, arc-length, relaxation or buckling, or model the body as a shell";
        return refuse(&at, "a `temperature`", &bound, repair);
    }
    Ok(())
}
