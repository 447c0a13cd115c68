//! From a scene to what the particles are made of and how they are sampled: section, axes, strain measure, formulation.

use shell_kinematics::{
    BackStress, GivenSection, Hardening, IntegratedSection, Isotropic, IsotropicSection, LayeredSection,
    MaterialError, Plastic, PlasticPly, PlasticSection, Ply, RValues, Rate, Rubber, RubberSection, Section,
    Stiffness, StrainMeasure,
};
use sph_core::{CubicSpline, Vec3};
use sph_shell::{Formulation, Reach};

use crate::bodies::refusal::model_error;
use crate::bodies::shell::build::Builder;
use crate::bodies::shell::heat::isotropic;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{self, MaterialSection};

/// What a section is made of.
#[derive(Clone)]
pub(super) enum SectionSpec {
    /// One isotropic material through a thickness \[L\], in closed form or by Gauss points.
    Isotropic(Isotropic, f64, Option<usize>),
    /// Plies of which none yields.
    Layered(Vec<Ply>),
    /// Plies of which one yields at least.
    Yielding(Vec<PlasticPly>),
    /// One material that yields, through a thickness \[L\] in so many slices.
    Plastic(Plastic, f64, usize),
    /// Rubber through a thickness \[L\].
    Rubber(Rubber, f64),
    /// Whatever it is, so stiff and of a thickness \[L\].
    Given(Stiffness, f64),
}

impl SectionSpec {
    /// Thickness \[L\].
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Isotropic(_, thickness, _)
            | Self::Plastic(_, thickness, _)
            | Self::Rubber(_, thickness)
            | Self::Given(_, thickness) => *thickness,
            Self::Layered(plies) => plies.iter().map(|ply| ply.thickness).sum(),
            Self::Yielding(plies) => plies.iter().map(|ply| ply.thickness).sum(),
        }
    }

    /// The same, of another thickness \[L\]; plies and given stiffnesses stay as they are.
    pub fn with_thickness(&self, thickness: f64) -> Self {
        match self {
            Self::Isotropic(material, _, points) => Self::Isotropic(*material, thickness, *points),
            Self::Plastic(material, _, slices) => Self::Plastic(material.clone(), thickness, *slices),
            Self::Rubber(material, _) => Self::Rubber(material.clone(), thickness),
            Self::Layered(plies) => Self::Layered(plies.clone()),
            Self::Yielding(plies) => Self::Yielding(plies.clone()),
            Self::Given(stiffness, own) => Self::Given(*stiffness, *own),
        }
    }

    /// Young's modulus \[F/L²\] of one that is isotropic.
    pub fn young(&self) -> Option<f64> {
        match self {
            Self::Isotropic(material, ..) => Some(material.young),
            Self::Plastic(material, ..) => Some(material.elastic().young),
            // Incompressible.
            Self::Rubber(material, _) => Some(3.0 * material.shear()),
            Self::Layered(_) | Self::Yielding(_) | Self::Given(..) => None,
        }
    }

    /// The section, of numbers that have been checked.
    ///
    /// # Errors
    /// [`MaterialError`] for those that have not.
    pub fn try_section(&self) -> Result<Box<dyn Section>, MaterialError> {
        Ok(match self {
            Self::Isotropic(material, thickness, None) => {
                Box::new(IsotropicSection::new(*material, *thickness)?)
            }
            Self::Isotropic(material, thickness, Some(points)) => {
                Box::new(IntegratedSection::new(*material, *thickness, *points)?)
            }
            Self::Layered(plies) => Box::new(LayeredSection::new(plies)?),
            Self::Yielding(plies) => Box::new(PlasticSection::layered(plies)?),
            Self::Plastic(material, thickness, slices) => {
                Box::new(PlasticSection::new(material.clone(), *thickness, *slices)?)
            }
            Self::Rubber(material, thickness) => Box::new(RubberSection::new(material.clone(), *thickness)?),
            Self::Given(stiffness, thickness) => Box::new(GivenSection::new(*stiffness, *thickness)?),
        })
    }
}

/// A material that yields.
///
/// # Errors
/// [`MaterialError`] for numbers out of bounds.
pub(crate) fn plastic(given: &scene::Plastic) -> Result<Plastic, MaterialError> {
    let elastic = Isotropic::new(given.young.get(), given.poisson)?;
    let slow = Plastic::new(elastic, hardening(&given.hardening)?).kinematic(given.kinematic.get())?;
    let backs =
        given.back_stresses.iter().map(|back| BackStress::new(back.modulus.get(), back.recovery.get()));
    let slow = slow.recovering(backs.collect::<Result<_, _>>()?)?;
    let material = match given.rate {
        None => slow,
        Some(scene::Rate::CowperSymonds(law)) => {
            slow.rated(Rate::cowper_symonds(law.reference.get(), law.exponent.get())?)
        }
        Some(scene::Rate::JohnsonCook(law)) => {
            slow.rated(Rate::johnson_cook(law.reference.get(), law.factor.get())?)
        }
    };
    let Some(rolled) = &given.anisotropy else { return Ok(material) };
    Ok(material.anisotropic(RValues::new(rolled.r0.get(), rolled.r45.get(), rolled.r90.get())?))
}

/// How the yield stress grows.
///
/// # Errors
/// [`MaterialError`] for numbers out of bounds.
pub(crate) fn hardening(given: &scene::Hardening) -> Result<Hardening, MaterialError> {
    match given {
        scene::Hardening::Linear(own) => Hardening::linear(own.yield_stress.get(), own.slope.get()),
        scene::Hardening::Voce(own) => {
            Hardening::voce(own.yield_stress.get(), own.rise.get(), own.rate.get())
        }
        scene::Hardening::Swift(own) => {
            Hardening::swift(own.factor.get(), own.offset.get(), own.exponent.get())
        }
        scene::Hardening::Table(rows) => Hardening::table(rows),
    }
}

/// Rubber.
///
/// # Errors
/// [`MaterialError`] for numbers out of bounds.
pub(crate) fn rubber(given: &scene::Rubber) -> Result<Rubber, MaterialError> {
    match &given.law {
        scene::RubberLaw::NeoHooke(own) => Rubber::neo_hooke(own.c1.get()),
        scene::RubberLaw::MooneyRivlin(own) => Rubber::mooney_rivlin(own.c1.get(), own.c2.get()),
        scene::RubberLaw::Ogden(rows) => Rubber::ogden(rows),
    }
}

impl Builder<'_> {
    /// What a shell without parts is made of, or one of its parts, whose keys stand below `s`.
    pub(super) fn spec(&self, shell: &scene::ShellScene, s: &Scope<'_>) -> Result<SectionSpec, SceneError> {
        let refuse = |path: &'static str| {
            move |e: MaterialError| model_error(self.scene.source, &s.path(path), &e.to_string())
        };
        match shell.material_section(s)? {
            MaterialSection::Homogeneous(elastic, section) => {
                let points = section.gauss_points.as_deref().copied();
                isotropic(elastic.young.get(), elastic)
                    .map(|material| SectionSpec::Isotropic(material, section.thickness.get(), points))
                    .map_err(refuse("material.elastic"))
            }
            MaterialSection::Plastic(material, section) => {
                let path = s.path(&format!("material.plastic.hardening.{}", material.hardening.word()));
                let yielding =
                    plastic(material).map_err(|e| model_error(self.scene.source, &path, &e.to_string()))?;
                Ok(SectionSpec::Plastic(yielding, section.thickness.get(), section.slices()))
            }
            MaterialSection::Rubber(material, section) => {
                let path = s.path(&format!("material.rubber.law.{}", material.law.word()));
                let of =
                    rubber(material).map_err(|e| model_error(self.scene.source, &path, &e.to_string()))?;
                Ok(SectionSpec::Rubber(of, section.thickness.get()))
            }
            MaterialSection::Layered(material, section) => self.plies(material, section, s),
            MaterialSection::Given(section) => {
                Ok(SectionSpec::Given(section.matrices(), section.thickness.get()))
            }
            MaterialSection::OfFile(..) => {
                Err(model_error(self.scene.source, &s.path("section"), "a file gives its sections to cells"))
            }
        }
    }

    /// The section made of it.
    pub(super) fn section(&self, spec: &SectionSpec, s: &Scope<'_>) -> Result<Box<dyn Section>, SceneError> {
        let path = match spec {
            SectionSpec::Isotropic(..) | SectionSpec::Plastic(..) | SectionSpec::Rubber(..) => {
                "section.homogeneous"
            }
            SectionSpec::Layered(_) | SectionSpec::Yielding(_) => "section.layered",
            SectionSpec::Given(..) => "section.stiffness",
        };
        spec.try_section().map_err(|e| model_error(self.scene.source, &s.path(path), &e.to_string()))
    }

    /// Direction of angle zero of plies, or in which a sheet was rolled.
    pub(crate) fn material_axis(&self, shell: &scene::ShellScene) -> Option<Vec3> {
        match (&shell.material, &shell.section) {
            (_, scene::Section::Layered(section)) => Some(self.turned(section.axis)),
            (_, scene::Section::Stiffness(section)) => Some(self.turned(section.axis)),
            (scene::Material::Plastic(sheet), _) => sheet.anisotropy.map(|rolled| self.turned(rolled.axis)),
            _ => None,
        }
    }

    /// The strain measure of a shell, or of one of its parts, whose keys stand below `s`.
    pub(crate) fn strain(
        &self,
        shell: &scene::ShellScene,
        s: &Scope<'_>,
    ) -> Result<&'static dyn StrainMeasure, SceneError> {
        let name = shell.curvature();
        let path = s.path(&format!("formulation.{}.curvature", shell.formulation.word()));
        let unknown =
            || model_error(self.scene.source, &path, &format!("no strain measure is called {name}"));
        shell_kinematics::strain_measure(name).ok_or_else(unknown)
    }

    pub(crate) fn formulation(&self) -> Formulation {
        // The scene has been checked: an unknown kernel cannot come this far.
        let kernel = self.scene.shell.formulation.kernel().and_then(sph_core::kernel).unwrap_or(&CubicSpline);
        match &self.scene.shell.formulation {
            scene::Formulation::StressPoint(f) => Formulation::StressPoint(match f.support {
                scene::Reach::Cell => Reach::Cell,
                scene::Reach::Wide(reach) => Reach::Kernel(kernel, reach),
            }),
            scene::Formulation::Nodal(f) => Formulation::Nodal {
                order: f.order.get(),
                smoothing: f.smoothing_length(),
                consistent: f.divergence_consistent(),
                kernel,
            },
            scene::Formulation::StrongForm(f) => Formulation::StrongForm {
                smoothing: f.smoothing_length(),
                viscosity: f.viscosity.get(),
                divergence: f.divergence,
                kernel,
            },
        }
    }
}
