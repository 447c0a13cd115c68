//! Checks of a solid that shape functions carry.

use solid_kinematics::{ElasticError, Moduli};
use sph_core::{Vec3, kernels};
use sr_galerkin::Volumes;

use crate::scene::check::shell::check_plastic;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::per_axis::PerAxis;
use crate::scene::scope::Scope;
use crate::scene::shell::plastic::Plastic;
use crate::scene::solid::SolidScene;
use crate::scene::solid::galerkin::{Galerkin, GalerkinBasis, GalerkinLaw, GalerkinSupport};
use crate::scene::solid::geometry::NodePlaces;
use crate::scene::solid::material::{OrthotropicSolid, SolidMaterial};

/// Cosine of the angle between two material axes from which they are not perpendicular.
const SKEW: f64 = 1e-6;
/// Greatest radius of a support over the spacing: thirteen nodes along each axis.
const WIDEST: f64 = 6.0;

impl SolidScene {
    pub(super) fn check_galerkin(&self, galerkin: &Galerkin, s: &Scope<'_>) -> Verdict {
        self.refuse_keys_of_bonds(s)?;
        let at = |key: &str| format!("formulation.galerkin.{key}");
        if self.dimensions() != 3 {
            let value = format!("a list of {} numbers", self.dimensions());
            let repair = "give three lengths: the method is one in space";
            return Err(s.value("geometry.block.lengths", value, "a list of 3", repair));
        }
        let places = self.geometry.block.as_ref().and_then(|block| block.nodes);
        if places == Some(NodePlaces::Centres) {
            let (value, bound) = ("\"centres\"", "\"edges\": supports are held at nodes on the faces");
            return Err(s.value("geometry.block.nodes", value, bound, "remove it"));
        }
        if galerkin.across.is_some() && galerkin.basis != GalerkinBasis::Plate17 {
            let repair = "remove it, or use basis = \"plate17\"";
            let fault = s.fault(&at("across"), "an axis", "none but of `plate17`", repair);
            return Err(SceneError::Choice(fault));
        }
        if galerkin.update.is_some() && galerkin.law == GalerkinLaw::StVenant {
            let repair = "remove it, or use law = \"strain-rotation\"";
            let fault =
                s.fault(&at("update"), "an update", "none of St Venant's law, which has no steps", repair);
            return Err(SceneError::Choice(fault));
        }
        check_support(galerkin, s)?;
        let known: Vec<&str> = ["csrbf2"].into_iter().chain(kernels().map(|k| k.name())).collect();
        s.word(&at("kernel"), &galerkin.kernel, &known)?;
        match &self.material {
            SolidMaterial::Elastic(elastic) => {
                let at = |key: &str| format!("material.elastic.{key}");
                let repair = "ν = 0.5 is incompressible; most solids have 0.2 to 0.4";
                s.between(&at("poisson"), elastic.poisson, [-1.0, 0.5], repair)
            }
            SolidMaterial::Orthotropic(orthotropic) => check_orthotropic(orthotropic, s),
            SolidMaterial::Plastic(plastic) => check_yielding(plastic, galerkin, s),
        }
    }

    /// What only bonds have.
    fn refuse_keys_of_bonds(&self, s: &Scope<'_>) -> Verdict {
        let given = [
            ("fracture", self.fracture.is_some()),
            ("cracks", !self.cracks.is_empty()),
            ("unbreakable", !self.unbreakable.is_empty()),
            ("contact", self.contact.is_some()),
            ("imperfection", self.imperfection.is_some()),
            ("velocity", self.velocity.is_some()),
            ("geometry.cut_outs", !self.geometry.cut_outs.is_empty()),
        ];
        let Some((key, _)) = given.into_iter().find(|(_, given)| *given) else { return Ok(()) };
        let bound = "none in a Galerkin solid";
        let repair = "remove it, or use [formulation.state-based], whose bonds have it";
        Err(SceneError::Choice(s.fault(key, &format!("`{key}`"), bound, repair)))
    }
}

fn check_support(galerkin: &Galerkin, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("formulation.galerkin.support.{key}");
    let repair = "in units of the spacing; 2.5 suits quadratic bases, 3.5 along a plate plate17";
    let check = |path: &str, radius: f64| s.between(path, radius, [1.0, WIDEST], repair);
    let (word, radii) = match &galerkin.support {
        None => return Ok(()),
        Some(GalerkinSupport::Sphere(radius)) => return check(&at("sphere"), *radius),
        Some(GalerkinSupport::Ellipsoid(radii)) => ("ellipsoid", radii),
        Some(GalerkinSupport::Tensor(radii)) => ("tensor", radii),
    };
    match radii {
        PerAxis::Same(radius) => check(&at(word), *radius),
        PerAxis::Each(list) if list.len() != 3 => {
            let value = format!("a list of {} numbers", list.len());
            Err(s.value(&at(word), value, "a number, or a list of 3", "give one radius for each axis"))
        }
        PerAxis::Each(list) => {
            let mut numbered = list.iter().enumerate();
            numbered.try_for_each(|(i, &radius)| check(&at(&format!("{word}[{i}]")), radius))
        }
    }
}

fn check_orthotropic(given: &OrthotropicSolid, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("material.orthotropic.{key}");
    for i in 0..3 {
        s.sized(&at(&format!("poisson[{i}]")), given.poisson[i])?;
    }
    let poisson = given.poisson;
    if let Err(ElasticError::Indefinite { pivot }) = Moduli::orthotropic(&given.constants()) {
        let value = format!("{poisson:?}, with which a strain has no energy (least pivot {pivot:.3e})");
        let bound = "ratios with ν₁₂² < E₁/E₂ and so on: every strain costs energy";
        return Err(s.value(
            &at("poisson"),
            value,
            bound,
            "use smaller ratios; ν₂₁ = ν₁₂ E₂/E₁ is the other one",
        ));
    }
    let Some(axes) = given.axes else { return Ok(()) };
    for (i, &axis) in axes.iter().enumerate() {
        s.direction(&at(&format!("axes[{i}]")), axis)?;
    }
    let [first, second] = axes.map(|axis| Vec3::from(axis).normalize());
    let cosine = first.dot(&second);
    if cosine.abs() <= SKEW {
        return Ok(());
    }
    let value = format!("{:?}, {cosine:.3} along the first", axes[1]);
    Err(s.value(
        &at("axes[1]"),
        value,
        "perpendicular to the first",
        "take out its part along the first axis",
    ))
}

/// A material that yields goes by increments of strain and rotation, and by one change of volume a cell.
fn check_yielding(plastic: &Plastic, galerkin: &Galerkin, s: &Scope<'_>) -> Verdict {
    check_plastic(plastic, s)?;
    let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
        Err(SceneError::Choice(s.fault(path, value, bound, repair)))
    };
    if plastic.anisotropy.is_some() {
        let repair = "remove it: a solid yields by von Mises' criterion; a rolled sheet is a shell";
        return refuse("material.plastic.anisotropy", "Hill's criterion", "none of a solid", repair);
    }
    if !plastic.back_stresses.is_empty() {
        let repair = "use `kinematic`, linear hardening; a shell has back stresses that recover";
        return refuse("material.plastic.back-stresses", "back stresses", "none of a solid", repair);
    }
    if plastic.rate.is_some() {
        let repair = "remove it: a solid without bonds is computed at rest, where rates do nothing; a shell in time has it";
        return refuse("material.plastic.rate", "a law of rates", "none of a solid", repair);
    }
    if galerkin.law != GalerkinLaw::StrainRotation {
        let bound = "\"strain-rotation\" beside [material.plastic], which goes by increments";
        return refuse("formulation.galerkin.law", "another law", bound, "remove it");
    }
    match galerkin.volumes {
        None | Some(Volumes::Mean) => Ok(()),
        Some(_) => {
            let bound =
                "\"mean\" beside [material.plastic]: flow keeps the volume, and points by themselves lock";
            refuse("formulation.galerkin.volumes", "another change of volume", bound, "remove it")
        }
    }
}
