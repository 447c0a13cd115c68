//! The checks of a solid: its own keys, relative to where it stands in the scene, and what goes with it.

mod conditions;
mod galerkin;
mod geometry;
mod heat;
mod material;
mod yielding;

pub(super) use self::conditions::{check_face, check_solid_load, check_solid_support, check_traction};
pub(super) use self::heat::{check_conduction_of_solid, check_temperature_of_solid};
use crate::scene::analysis::Analysis;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::sets::check_set_name;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::solid::material::SolidMaterial;
use yielding::check_yielding_bonds;

impl SolidScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Verdict {
        self.check_geometry(s)?;
        if self.material.elastic().is_some_and(|elastic| elastic.young_values.is_some()) {
            let (value, bound) = ("numbers by particle", "one `young` for a solid");
            let repair = "remove it, or divide the solid into parts";
            return Err(SceneError::Choice(s.fault("material.elastic.young-values", value, bound, repair)));
        }
        if let Some(expansion) = self.material.elastic().and_then(|elastic| elastic.expansion) {
            s.sized("material.elastic.expansion", expansion)?;
            if self.has_directors() {
                let value = "a coefficient of expansion";
                let bound =
                    "none of a plate of two sheets: blocks of bonds, Galerkin solids and shells expand";
                let repair = "remove it, or model the plate as a shell";
                return Err(SceneError::Choice(s.fault("material.elastic.expansion", value, bound, repair)));
            }
        }
        if self.material.elastic().is_some_and(|elastic| elastic.by_temperature.is_some()) {
            let (value, bound) = ("numbers by temperature", "none of a solid: shells alone are heated");
            let fault = s.fault("material.elastic.by_temperature", value, bound, "remove it");
            return Err(SceneError::Choice(fault));
        }
        if self.material.elastic().is_some_and(|elastic| elastic.strength.is_some()) {
            let (value, bound) = ("a strength", "none of a solid: reserve factors are those of shells");
            let repair = "remove it, and measure `von-mises` or `tresca`";
            return Err(SceneError::Choice(s.fault("material.elastic.strength", value, bound, repair)));
        }
        if let Some(galerkin) = self.galerkin() {
            return self.check_galerkin(galerkin, s);
        }
        self.check_formulation(s)?;
        self.check_material(s)?;
        self.check_fracture(s)
    }
}

/// Refuses what does not go with a solid.
pub(super) fn check_solid(scene: &BodyInScene<'_>, solid: &SolidScene) -> Verdict {
    let s = &scene.body_scope();
    if solid.galerkin().is_some() && matches!(scene.analysis, Analysis::Explicit(_)) {
        let bound = format!("none in {}: it has no motion in time", scene.analysis.kind().name);
        let repair = "use [analysis.static], linear, arc-length, relaxation, modal or buckling, or bonds";
        let fault = s.fault("formulation.galerkin", "a Galerkin solid", &bound, repair);
        return Err(SceneError::Choice(fault));
    }
    if let SolidMaterial::Plastic(plastic) = &solid.material
        && solid.galerkin().is_none()
    {
        check_yielding_bonds(scene, solid, plastic)?;
    }
    let at_rest =
        matches!(scene.analysis, Analysis::Linear(_) | Analysis::Buckling(_)) || scene.analysis.swings();
    if solid.material.yields() && at_rest {
        let bound =
            format!("none in {}, which takes the material as it is at rest", scene.analysis.kind().name);
        let repair = "use [analysis.static] or [analysis.arc-length], or [material.elastic]";
        let fault = s.fault("material.plastic", "[material.plastic]", &bound, repair);
        return Err(SceneError::Choice(fault));
    }
    for (i, set) in solid.unbreakable.iter().enumerate() {
        check_set_name(scene, &s.path(&format!("unbreakable[{i}]")), set)?;
    }
    // Of several bodies the shells have a thickness to be written: that there is one is seen to of them together.
    if scene.scene.bodies.len() == 1 && scene.output.fields.is_some_and(|fields| fields.extruded) {
        let fault = scene.scope().fault(
            "output.fields.extruded",
            "a shell with its thickness",
            "none of a solid",
            "remove it: a solid is written as it is",
        );
        return Err(SceneError::Choice(fault));
    }
    if solid.contact.is_some() && !matches!(scene.analysis, Analysis::Explicit(_)) {
        let bound = format!("none in {}: it is not in the tangent", scene.analysis.kind().name);
        let repair = "remove it, or use [analysis.explicit]";
        return Err(SceneError::Choice(s.fault("contact", "contact", &bound, repair)));
    }
    conditions::check_solid_velocity(scene, solid)
}
