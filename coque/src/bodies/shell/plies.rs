//! From the plies of a scene to those of a section.

use shell_kinematics::{FibreStrength, MaterialError, Orthotropic, PlasticPly, Ply, PlyMaterial, Strength};

use super::build::Builder;
use super::heat::isotropic;
use super::material::{SectionSpec, plastic};
use crate::bodies::refusal::model_error;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{self, Layered, Material};

impl Builder<'_> {
    /// Plies in a shell of a material, whose keys stand below `s`.
    ///
    /// # Errors
    /// [`SceneError`] for numbers out of bounds.
    pub(super) fn plies(
        &self,
        shell: &Material,
        section: &Layered,
        s: &Scope<'_>,
    ) -> Result<SectionSpec, SceneError> {
        let mut all = Vec::with_capacity(section.plies.len());
        for (i, ply) in section.plies.iter().enumerate() {
            let own = match ply.material {
                Some(_) => s.below(&format!("section.layered.plies[{i}]")),
                None => s.clone(),
            };
            let of = ply.material(shell);
            let refuse = |error: MaterialError| {
                model_error(
                    self.scene.source,
                    &own.path(&format!("material.{}", of.word())),
                    &error.to_string(),
                )
            };
            let material = made_of(of, ply).map_err(refuse)?;
            all.push(PlasticPly { material, thickness: ply.thickness.get(), angle: ply.angle.to_radians() });
        }
        let yields = all.iter().any(|ply| matches!(ply.material, PlyMaterial::Plastic(..)));
        Ok(if yields {
            SectionSpec::Yielding(all)
        } else {
            SectionSpec::Layered(all.iter().map(PlasticPly::elastic).collect::<Vec<Ply>>())
        })
    }
}

/// What a ply is made of.
fn made_of(material: &Material, ply: &scene::Ply) -> Result<PlyMaterial, MaterialError> {
    Ok(match material {
        Material::Orthotropic(m) => {
            let across = m.shear_across.unwrap_or(m.shear);
            let fibre = Orthotropic::new(*m.young_along, *m.young_across, m.poisson, *m.shear, *across)?;
            let fibre = match &m.strength {
                Some(given) => fibre.strong(Strength::Fibre(strength(given)?)),
                None => fibre,
            };
            PlyMaterial::Orthotropic(m.expansion.map_or(Ok(fibre), |own| fibre.expanding(own))?)
        }
        Material::Elastic(m) => PlyMaterial::Elastic(isotropic(m.young.get(), m)?),
        Material::Plastic(m) => PlyMaterial::Plastic(plastic(m)?, ply.slices()),
        // The checks leave a ply no other.
        Material::Rubber(_) | Material::Smeared(_) | Material::File(_) => return Err(MaterialError::NoPlies),
    })
}

/// What a ply bears.
///
/// # Errors
/// [`MaterialError`] for numbers out of bounds.
fn strength(given: &scene::FibreStrength) -> Result<FibreStrength, MaterialError> {
    let along = [given.along_tension.get(), given.along_compression.get()];
    let across = [given.across_tension.get(), given.across_compression.get()];
    let plain = FibreStrength::new(along, across, given.shear.get())?;
    let sheared = given.shear_across.map_or(Ok(plain), |own| plain.sheared_across(own.get()))?;
    given.interaction.map_or(Ok(sheared), |own| sheared.interacting(own))
}
