//! The checks of a solid: its own keys, relative to where it stands in the scene, and what goes with it.

mod conditions;
mod fracture;
mod galerkin;
mod geometry;
mod material;

use crate::scene::analysis::Analysis;
use crate::scene::error::SceneError;
use crate::scene::problem::Scene;
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;

type Checked = Result<(), SceneError>;

impl SolidScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Checked {
        self.check_geometry(s)?;
        if let Some(galerkin) = self.galerkin() {
            return self.check_galerkin(galerkin, s);
        }
        self.check_formulation(s)?;
        self.check_material(s)?;
        self.check_fracture(s)
    }
}

impl Scene {
    /// Refuses what does not go with a solid.
    pub(super) fn check_solid(&self, solid: &SolidScene) -> Checked {
        let s = &self.body_scope();
        if solid.galerkin().is_some() && matches!(self.analysis, Analysis::Explicit(_)) {
            let bound = format!("none in {}: it has no motion in time", self.analysis.kind().name);
            let repair = "use [analysis.static], linear, arc-length, relaxation, modal or buckling, or bonds";
            let fault = s.fault("formulation.galerkin", "a Galerkin solid", &bound, repair);
            return Err(SceneError::Choice(fault));
        }
        for (i, set) in solid.unbreakable.iter().enumerate() {
            self.check_set_name(&s.path(&format!("unbreakable[{i}]")), set)?;
        }
        if self.output.fields.is_some_and(|fields| fields.extruded) {
            let fault = self.scope().fault(
                "output.fields.extruded",
                "a shell with its thickness",
                "none of a solid",
                "remove it: a solid is written as it is",
            );
            return Err(SceneError::Choice(fault));
        }
        if solid.contact.is_some() && !matches!(self.analysis, Analysis::Explicit(_)) {
            let bound = format!("none in {}: it is not in the tangent", self.analysis.kind().name);
            let repair = "remove it, or use [analysis.explicit]";
            return Err(SceneError::Choice(s.fault("contact", "contact", &bound, repair)));
        }
        self.check_solid_velocity(solid)
    }
}
