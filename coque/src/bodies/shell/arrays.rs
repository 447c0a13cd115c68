//! Numbers by particle that a scene calls by the name of an array in memory.

use sph_core::Cloud;

use super::build::Builder;
use crate::scene::body_in_scene::OnSet;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Elastic, Load, Scene};

/// The numbers that a key calls by their name, one for each of so many particles.
///
/// # Errors
/// [`SceneError`] for a name of no array, and for an array of other length or with a number that is not finite.
pub(super) fn by_particle<'a>(
    scene: &'a Scene,
    at: &Scope<'_>,
    path: &str,
    name: &str,
    particles: usize,
) -> Result<&'a [f64], SceneError> {
    let bound = format!("an array with a number for each of the {particles} particles");
    let refuse = |value: &str, repair: &str| SceneError::Choice(at.fault(path, value, &bound, repair));
    let Some(array) = scene.arrays.get(name) else {
        let repair = format!("bring it, in Python by arrays={{\"{name}\": …}}; files have no such arrays");
        return Err(refuse(&format!("{name}, no array in memory"), &repair));
    };
    if array.len() != particles {
        let repair = "order them as the points of a frame";
        return Err(refuse(&format!("{name}, an array of {} numbers", array.len()), repair));
    }
    match array.iter().position(|number| !number.is_finite()) {
        None => Ok(array),
        Some(at) => Err(refuse(&format!("{name}, not finite at particle {at}"), "correct the array")),
    }
}

/// The mean over the corners of each of some cells.
pub(super) fn by_cell(numbers: &[f64], cells: &[u32], cloud: &Cloud) -> Vec<f64> {
    let mean = |&cell: &u32| {
        let corners = cloud.cells[cell as usize].particles();
        corners.iter().map(|&corner| numbers[corner as usize]).sum::<f64>() / corners.len() as f64
    };
    cells.iter().map(mean).collect()
}

impl Builder<'_> {
    /// Young's modulus of each of some cells \[F/L²\].
    ///
    /// # Errors
    /// [`SceneError`] for an array that does not belong to the particles, and for moduli that are not positive.
    pub(super) fn young(
        &self,
        elastic: &Elastic,
        at: &Scope<'_>,
        cells: &[u32],
        cloud: &Cloud,
    ) -> Result<Vec<f64>, SceneError> {
        const VALUES: &str = "material.elastic.young-values";
        let own = elastic.young.get();
        let Some(name) = &elastic.young_values else { return Ok(vec![own; cells.len()]) };
        let factors = by_particle(self.scene.scene, at, VALUES, name, cloud.len())?;
        let all: Vec<f64> = by_cell(factors, cells, cloud).into_iter().map(|factor| own * factor).collect();
        match cells.iter().zip(&all).find(|(_, young)| !(**young > 0.0 && young.is_finite())) {
            None => Ok(all),
            Some((cell, young)) => {
                let value = format!("a modulus of {young:.4e} in cell {cell}");
                Err(at.value(VALUES, value, "positive in every cell", "correct the array"))
            }
        }
    }

    /// What multiplies a load at each particle, where its scene says so.
    pub(super) fn factors(&self, load: &OnSet<'_, Load>, particles: usize) -> Result<Vec<f64>, SceneError> {
        let Some(name) = load.pressure.as_ref().and_then(|pressure| pressure.values.as_ref()) else {
            return Ok(Vec::new());
        };
        let path = load.at("pressure.values");
        Ok(by_particle(self.scene.scene, &self.scene.scope(), &path, name, particles)?.to_vec())
    }
}
