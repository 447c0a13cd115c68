//! Checks of material and section, and whether they go together.

use super::by_temperature::{check_no_tables, check_tables};
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::geometry::Geometry;
use crate::scene::shell::material::{Elastic, Material, Orthotropic};
use crate::scene::shell::section::{Homogeneous, MaterialSection, Section};

impl Homogeneous {
    /// Refuses a thickness that is given in two ways.
    fn check_one_course(&self, s: &Scope<'_>) -> Verdict {
        let (key, found) = match (&self.taper, &self.table, &self.values) {
            (Some(_), Some(_), _) => ("table", "a taper and a table"),
            (Some(_), _, Some(_)) => ("values", "a taper and an array"),
            (_, Some(_), Some(_)) => ("values", "a table and an array"),
            _ => return Ok(()),
        };
        let repair = format!("write all of the thickness into `{key}`, or remove it");
        Err(SceneError::Choice(s.fault(&format!("section.homogeneous.{key}"), found, "one of them", &repair)))
    }
}

/// Poisson's ratio of an isotropic material.
pub(super) fn check_poisson(path: &str, poisson: f64, s: &Scope<'_>) -> Verdict {
    let repair = "ν = 0.5 is incompressible and has no plane-stress limit here; most solids have 0.2 to 0.4";
    s.between(path, poisson, [-1.0, 0.5], repair)
}

/// Poisson's ratio and expansion of an isotropic material.
pub(super) fn check_elastic_numbers(elastic: &Elastic, s: &Scope<'_>) -> Verdict {
    check_poisson("material.elastic.poisson", elastic.poisson, s)?;
    s.sized("material.elastic.expansion", elastic.expansion.unwrap_or_default())
}

/// The constants of a fibre.
pub(super) fn check_orthotropic(material: &Orthotropic, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("material.orthotropic.{key}");
    let bound = (*material.young_along / *material.young_across).sqrt();
    let repair = "ν_LT² must be less than E_L/E_T, or some strain would release energy; give the contraction across \
                  the fibre under stress along it";
    s.between(&at("poisson"), material.poisson, [-bound, bound], repair)?;
    s.sized_all(&at("expansion"), &material.expansion.unwrap_or_default())?;
    let interaction = material.strength.and_then(|own| own.interaction).unwrap_or_default();
    let repair = "beyond that the surface of failure is not closed; leave it out for the usual -0.5";
    s.between(&at("strength.interaction"), interaction, [-1.0, 1.0], repair)
}

impl ShellScene {
    pub(super) fn check_material(&self, s: &Scope<'_>) -> Verdict {
        match &self.material {
            Material::Elastic(elastic) => self.check_elastic(elastic, s)?,
            Material::Orthotropic(orthotropic) => check_orthotropic(orthotropic, s)?,
            Material::Plastic(plastic) => self.check_plastic_material(plastic, s)?,
            Material::Rubber(rubber) => self.check_rubber_material(rubber, s)?,
            Material::File(_) => self.check_of_file("material.file", s)?,
            Material::Smeared(_) => {}
        }
        self.check_section(s)?;
        self.material_section(s).map(drop)
    }

    /// What stands in a file wants one.
    fn check_of_file(&self, path: &str, s: &Scope<'_>) -> Verdict {
        if self.geometry.mesh().is_some() {
            return Ok(());
        }
        let bound = "none without [geometry.mesh]";
        let repair = "give [material.elastic] and [section.homogeneous], or bring a mesh that has them";
        Err(SceneError::Choice(s.fault(path, "that of a file", bound, repair)))
    }

    fn check_elastic(&self, elastic: &Elastic, s: &Scope<'_>) -> Verdict {
        if elastic.young_values.is_some() && matches!(self.section, Section::File(_)) {
            let (value, bound) = ("numbers by particle", "none beside [section.file]");
            let repair = "remove it, or give [section.homogeneous]";
            return Err(SceneError::Choice(s.fault("material.elastic.young-values", value, bound, repair)));
        }
        if !matches!(self.section, Section::Homogeneous(_)) {
            check_no_tables(elastic, s)?;
        }
        check_tables(elastic, s)?;
        check_elastic_numbers(elastic, s)
    }

    fn check_section(&self, s: &Scope<'_>) -> Verdict {
        let total = self.section.thickness().unwrap_or_default();
        let (path, value) = match &self.section {
            Section::Homogeneous(section) => {
                section.check_one_course(s)?;
                if section.slices.is_some() && !self.material.yields() {
                    let bound = "none of a material that does not yield";
                    let repair = "remove it, or give [material.plastic]";
                    let fault = s.fault("section.homogeneous.slices", "slices", bound, repair);
                    return Err(SceneError::Choice(fault));
                }
                if let Some(taper) = &section.taper {
                    s.sized_all("section.homogeneous.taper.point", &taper.point)?;
                    s.direction("section.homogeneous.taper.gradient", taper.gradient)?;
                }
                ("section.homogeneous.thickness", total.to_string())
            }
            Section::File(_) => return self.check_of_file("section.file", s),
            Section::Stiffness(section) => {
                section.check(s)?;
                ("section.stiffness.thickness", total.to_string())
            }
            Section::Layered(section) => {
                self.check_layered(section, s)?;
                ("section.layered.plies", format!("{total} thick altogether"))
            }
        };
        let radius = match &self.geometry {
            Geometry::Plate(_) | Geometry::Mesh(_) => f64::INFINITY,
            Geometry::Cylinder(cylinder) => *cylinder.radius,
            Geometry::Sphere(sphere) => *sphere.radius,
            // On the centre line the curvatures are ± twist / length.
            Geometry::Twisted(strip) => *strip.length / strip.twist.to_radians().abs(),
        };
        if total >= radius {
            let bound = format!("less than the radius {radius} of the surface");
            let repair = "a thin shell wants a thickness of at most a fifth of the radius";
            return Err(s.value(path, value, &bound, repair));
        }
        Ok(())
    }

    /// Material and section together: the one material has axes and needs a section that says where they lie, the other
    /// has none to turn.
    ///
    /// # Errors
    /// [`SceneError::Choice`] for an orthotropic homogeneous section and an isotropic layered one, of the scene or of a file.
    pub(crate) fn material_section(&self, s: &Scope<'_>) -> Result<MaterialSection<'_>, SceneError> {
        let thickness = self.section.thickness().unwrap_or_default();
        let (path, value, bound, repair) = match (&self.material, &self.section) {
            (Material::Elastic(material), Section::Homogeneous(section)) => {
                return Ok(MaterialSection::Homogeneous(material, section));
            }
            (material @ (Material::Orthotropic(_) | Material::Plastic(_)), Section::Layered(section)) => {
                return Ok(MaterialSection::Layered(material, section));
            }
            (material @ Material::Elastic(_), Section::Layered(section)) if section.mixed() => {
                return Ok(MaterialSection::Layered(material, section));
            }
            (Material::Plastic(material), Section::Homogeneous(section)) => {
                return Ok(MaterialSection::Plastic(material, section));
            }
            (Material::Rubber(material), Section::Homogeneous(section)) => {
                return Ok(MaterialSection::Rubber(material, section));
            }
            (Material::Smeared(_), Section::Stiffness(section)) => return Ok(MaterialSection::Given(section)),
            (Material::File(_), Section::File(_)) => return Ok(MaterialSection::OfFile(None, None)),
            (Material::Elastic(material), Section::File(_)) => {
                return Ok(MaterialSection::OfFile(Some(material), None));
            }
            (Material::File(_), Section::Homogeneous(section)) => {
                return Ok(MaterialSection::OfFile(None, Some(section)));
            }
            (Material::Plastic(_), Section::File(_)) => (
                "material.plastic",
                "a material that yields",
                "none but with [section.homogeneous] or [section.layered]",
                "give [section.homogeneous] with the thickness".into(),
            ),
            (Material::Rubber(_), Section::File(_) | Section::Layered(_)) => (
                "material.rubber",
                "rubber",
                "none but with [section.homogeneous]",
                "give [section.homogeneous] with the thickness".into(),
            ),
            (Material::Smeared(_), _) => (
                "material.smeared",
                "a mass alone",
                "a stiffness as well",
                "give [section.stiffness], or a material with moduli, such as [material.elastic]".into(),
            ),
            (_, Section::Stiffness(_)) => (
                "section.stiffness",
                "a stiffness beside that of the material",
                "one of them",
                "use [material.smeared], which has a density alone, or [section.homogeneous] or [section.layered]"
                    .into(),
            ),
            (Material::Orthotropic(_), Section::File(_)) => (
                "section.file",
                "no direction to the fibre of [material.orthotropic]",
                "one",
                "use [section.layered] for plies, or [material.elastic] or [material.file] beside it".into(),
            ),
            (Material::File(_), Section::Layered(_)) => (
                "section.layered",
                "angles to [material.file], whose materials are the same in all directions",
                "the thickness alone",
                "use [section.homogeneous] or [section.file], or [material.orthotropic] for plies".into(),
            ),
            (Material::Orthotropic(_), Section::Homogeneous(_)) => (
                "section.homogeneous",
                "no direction to the fibre of [material.orthotropic]",
                "one",
                format!(
                    "use [section.layered] with one ply: axis = [1.0, 0.0, 0.0] and plies = [{{ thickness = {thickness:?}, angle = 0.0 }}]"
                ),
            ),
            (Material::Elastic(_), Section::Layered(_)) => (
                "section.layered",
                "angles to [material.elastic], which is the same in all directions",
                "the thickness alone",
                format!(
                    "use [section.homogeneous] with thickness = {thickness:?}, [material.orthotropic] for plies, or give a ply a `material` of its own"
                ),
            ),
        };
        Err(SceneError::Choice(s.fault(path, value, bound, &repair)))
    }
}
