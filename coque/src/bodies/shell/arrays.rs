//! Numbers by particle that a scene calls by the name of an array in memory.

use super::build::Builder;
use crate::scene::body_in_scene::OnSet;
use crate::scene::error::SceneError;
use crate::scene::scope::Scope;
use crate::scene::{Load, Scene};

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

impl Builder<'_> {
    /// What multiplies a load at each particle, where its scene says so.
    pub(super) fn factors(&self, load: &OnSet<'_, Load>, particles: usize) -> Result<Vec<f64>, SceneError> {
        let Some(name) = load.pressure.as_ref().and_then(|pressure| pressure.values.as_ref()) else {
            return Ok(Vec::new());
        };
        let path = load.at("pressure.values");
        Ok(by_particle(self.scene.scene, &self.scene.scope(), &path, name, particles)?.to_vec())
    }
}
