//! Checks of the material of a solid and of the bonds that carry it.

use peridynamics::Space;

use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::solid::formulation::{Plane, SolidFormulation};

/// Poisson's ratio of pairwise forces may be written with three digits.
const ROUNDING: f64 = 5e-4;

impl SolidScene {
    /// The space that its bonds lie in.
    pub(crate) fn space(&self) -> Space {
        match self.formulation.plane() {
            Some(Plane::Stress) => Space::PlaneStress,
            Some(Plane::Strain) => Space::PlaneStrain,
            None if self.has_directors() => Space::PlaneStress,
            None => Space::Solid,
        }
    }

    pub(super) fn check_formulation(&self, s: &Scope<'_>) -> Verdict {
        let word = self.formulation.word();
        let at = |key: &str| format!("formulation.{word}.{key}");
        let two = self.dimensions() == 2;
        match &self.formulation {
            SolidFormulation::TwoSheets(_) if !two => {
                let repair = "give two lengths and a thickness: lengths = [a, b], thickness = t";
                let value = format!("a list of {} numbers", self.dimensions());
                Err(s.value("geometry.block.lengths", value, "a list of 2 for two sheets", repair))
            }
            SolidFormulation::TwoSheets(_) | SolidFormulation::Galerkin(_) => Ok(()),
            _ if two && self.formulation.plane().is_none() => {
                let repair =
                    format!("add `plane = \"stress\"` or `plane = \"strain\"` in `formulation.{word}`");
                let bound = "given beside two lengths";
                Err(SceneError::Missing(s.fault(&at("plane"), "nothing", bound, &repair)))
            }
            _ if !two && self.formulation.plane().is_some() => {
                let repair = "remove it, or give two lengths for a plane block";
                let fault = s.fault(&at("plane"), "a plane", "none beside three lengths", repair);
                Err(SceneError::Choice(fault))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn check_material(&self, s: &Scope<'_>) -> Verdict {
        let Some(elastic) = self.material.elastic() else {
            let repair = "use [material.elastic], or [bodies.NAME.solid.formulation.galerkin]";
            let (value, bound) = ("an orthotropic material", "`elastic` where bonds carry the solid");
            return Err(SceneError::Choice(s.fault("material.orthotropic", value, bound, repair)));
        };
        let at = |key: &str| format!("material.elastic.{key}");
        let (nu, space) = (elastic.poisson, self.space());
        let top = if space == Space::PlaneStress { 1.0 } else { 0.5 };
        let repair = "ν = 0.5 is incompressible; most solids have 0.2 to 0.4";
        s.between(&at("poisson"), nu, [-1.0, top], repair)?;
        let only = space.pairwise_poisson();
        if !matches!(self.formulation, SolidFormulation::BondBased(_)) || (nu - only).abs() <= ROUNDING {
            return Ok(());
        }
        let bound = format!("{only:.4}, that of pairwise forces in this space");
        let repair = "use [formulation.state-based] for any other, or this value";
        Err(s.value(&at("poisson"), nu, &bound, repair))
    }
}
