//! Checks of stiffeners: what they are made of, where they lie, and where there are none.

use super::material::check_poisson;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::sets::check_set_name;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::formulation::{Formulation, Reach};
use crate::scene::shell::material::Material;
use crate::scene::shell::section::Section;
use crate::scene::shell::stiffeners::{StiffenerMaterial, StiffenerScene, StiffenerSection};

/// Refuses stiffeners of no elastic material, without a place, other formulations than by cells, heat, and a fluid.
pub(super) fn check_stiffeners(scene: &BodyInScene<'_>, shell: &ShellScene, s: &Scope<'_>) -> Verdict {
    for (i, stiffener) in shell.stiffeners.iter().enumerate() {
        let own = s.below(&format!("stiffeners[{i}]"));
        check_set_name(scene, &own.path("on"), &stiffener.on)?;
        check_material(stiffener, shell, &own)?;
        check_place(stiffener, shell, &own)?;
        check_in_surface(scene, stiffener, &own)?;
    }
    if shell.stiffeners.is_empty() {
        return Ok(());
    }
    let refuse = |bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault("stiffeners[0]", "a stiffener", bound, repair)))
    };
    if !matches!(&shell.formulation, Formulation::StressPoint(f) if f.support == Reach::Cell) {
        let bound = "none but where strains are sampled in cells";
        return refuse(bound, "use [formulation.stress-point] without `support`, the default");
    }
    if scene.in_fluid {
        let repair = "model it as a sheet of the mesh, or smear its stiffness over [section.stiffness]";
        return refuse("none in a fluid, which would not see it", repair);
    }
    if let Some(load) = scene.loads.iter().find(|load| load.gravity.is_some() && load.on != "all") {
        let bound = "\"all\" on a shell with [[stiffeners]]: gravity on a part of it leaves their weight out";
        let value = format!("\"{}\"", load.on);
        return Err(SceneError::Choice(scene.scope().fault(&load.at("on"), &value, bound, "load all of it")));
    }
    if let Some(load) = scene.loads.iter().find(|load| load.heats()) {
        let bound = "none on a shell with [[stiffeners]], which do not expand with it";
        let repair = "remove it, or model the stiffeners as sheets of the mesh";
        return Err(SceneError::Choice(scene.scope().fault(&load.at("temperature"), "heat", bound, repair)));
    }
    Ok(())
}

fn check_material(stiffener: &StiffenerScene, shell: &ShellScene, own: &Scope<'_>) -> Verdict {
    if let Some(StiffenerMaterial::Elastic(elastic)) = stiffener.material {
        return check_poisson("material.elastic.poisson", elastic.poisson, own);
    }
    if stiffener.elastic(&shell.material).is_some() {
        return Ok(());
    }
    let value = format!("no material, on a shell of the material `{}`", shell.material.word());
    let bound = "`material.elastic` of a stiffener, which is isotropic and elastic";
    let repair = "add material.elastic = { young = …, poisson = …, density = … } to it";
    Err(SceneError::Choice(own.fault("section", &value, bound, repair)))
}

/// Bending in the surface wants a second moment about its normal, and sets that there are.
fn check_in_surface(scene: &BodyInScene<'_>, stiffener: &StiffenerScene, own: &Scope<'_>) -> Verdict {
    let Some(in_surface) = &stiffener.in_surface else { return Ok(()) };
    for (k, set) in in_surface.held.iter().enumerate() {
        check_set_name(scene, &own.path(&format!("in_surface.held[{k}]")), set)?;
    }
    match stiffener.section {
        StiffenerSection::Profile(profile) if profile.lateral.get() == 0.0 => {
            let bound =
                "`section.profile.lateral` above zero, the second moment about the normal of the surface";
            Err(own.value("section.profile.lateral", 0.0, bound, "give it, or leave `in_surface` out"))
        }
        _ => Ok(()),
    }
}

/// A side wants a face and a height, an eccentricity neither.
fn check_place(stiffener: &StiffenerScene, shell: &ShellScene, own: &Scope<'_>) -> Verdict {
    let mut given = Vec::new();
    given.extend(stiffener.side.map(|_| "side"));
    given.extend(stiffener.eccentricity.map(|_| "eccentricity"));
    own.exactly_one("on", "place across the surface", &given, &["side", "eccentricity"])?;
    own.sized("eccentricity", stiffener.eccentricity.unwrap_or_default())?;
    if stiffener.side.is_none() {
        return Ok(());
    }
    let refuse = |bound: &str| {
        let repair = "give its `eccentricity`, the height of its centroid over the particles";
        Err(SceneError::Choice(own.fault("side", "a side", bound, repair)))
    };
    if matches!(stiffener.section, StiffenerSection::Profile(_)) {
        return refuse("none of a profile, whose numbers do not say how far its centroid is from its foot");
    }
    let homogeneous = matches!(&shell.section, Section::Homogeneous(_) | Section::Layered(_));
    if shell.has_parts() || !homogeneous || matches!(shell.material, Material::File(_)) {
        return refuse(
            "none but on a shell of one section, homogeneous or layered, which has its faces in one place",
        );
    }
    Ok(())
}
