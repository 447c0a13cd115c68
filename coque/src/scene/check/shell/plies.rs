//! Checks of plies: what each is made of.

use super::by_temperature::check_no_tables;
use super::material::{check_elastic_numbers, check_orthotropic};
use super::own_law::check_plastic;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::material::{Elastic, Material};
use crate::scene::shell::plastic::Plastic;
use crate::scene::shell::plies::{Layered, Ply};

impl ShellScene {
    pub(super) fn check_layered(&self, section: &Layered, s: &Scope<'_>) -> Verdict {
        s.direction("section.layered.axis", section.axis)?;
        if section.plies.is_empty() {
            let repair = "give at least one: plies = [{ thickness = 1.0, angle = 0.0 }]";
            return Err(s.value("section.layered.plies", "empty", "a list of plies", repair));
        }
        match &self.material {
            Material::Plastic(plastic) => check_rolling(plastic, section, s)?,
            Material::Elastic(elastic) => check_even(elastic, s)?,
            _ => {}
        }
        for (i, ply) in section.plies.iter().enumerate() {
            self.check_ply(section, ply, &s.below(&format!("section.layered.plies[{i}]")))?;
        }
        Ok(())
    }

    /// A ply, whose keys stand below `own`.
    fn check_ply(&self, section: &Layered, ply: &Ply, own: &Scope<'_>) -> Verdict {
        let refuse = |path: &str, value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(own.fault(path, value, bound, repair)))
        };
        if ply.slices.is_some() && !ply.material(&self.material).yields() {
            let repair = "remove it, or give the ply material.plastic";
            return refuse("slices", "slices", "none of a material that does not yield", repair);
        }
        match &ply.material {
            None => Ok(()),
            Some(Material::Elastic(elastic)) => {
                check_even(elastic, own)?;
                check_elastic_numbers(elastic, own)
            }
            Some(Material::Orthotropic(material)) => check_orthotropic(material, own),
            Some(Material::Plastic(plastic)) => {
                check_plastic(plastic, own)?;
                check_rolling(plastic, section, own)
            }
            Some(other @ (Material::Rubber(_) | Material::Smeared(_) | Material::File(_))) => {
                let repair = "give the ply one of them, or remove `material`";
                let path = format!("material.{}", other.word());
                refuse(&path, other.word(), "elastic, orthotropic or plastic in a ply", repair)
            }
        }
    }
}

/// A ply is the same at all particles.
fn check_even(elastic: &Elastic, s: &Scope<'_>) -> Verdict {
    check_no_tables(elastic, s)?;
    if elastic.young_values.is_none() {
        return Ok(());
    }
    let (path, bound) = ("material.elastic.young-values", "none of plies");
    let repair = "remove it, or give [section.homogeneous]";
    Err(SceneError::Choice(s.fault(path, "numbers by particle", bound, repair)))
}

/// A rolled sheet lies by the axis of the plies, and by the angle of its own.
fn check_rolling(plastic: &Plastic, section: &Layered, s: &Scope<'_>) -> Verdict {
    let Some(anisotropy) = &plastic.anisotropy else { return Ok(()) };
    let path = "material.plastic.anisotropy.axis";
    s.direction(path, anisotropy.axis)?;
    if anisotropy.axis == section.axis {
        return Ok(());
    }
    let bound = format!("{:?}, the axis of the plies", section.axis);
    let repair = "write that axis, and give the ply the angle of its rolling direction";
    Err(s.value(path, format!("{:?}", anisotropy.axis), &bound, repair))
}
