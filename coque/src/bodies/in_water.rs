//! Still water about bodies at rest, as the search for their modes takes it.

use fluid_sph::StillWater;
use implicit_statics::{AddedMass, EquilibriumError};
use sph_core::Vec3;

/// Still water about shells at rest.
pub(crate) struct InStillWater {
    /// Its Laplacian and its surface.
    pub water: StillWater,
    /// What it adds to their masses.
    pub added: AddedMass,
    /// A pressure in those of `added`, whose Laplacian is made as great as the stiffness of the shells: a factor of both takes small entries for rounding.
    pub scale: f64,
    /// What waves of its surface would swing under \[L/T²\].
    pub gravity: Vec3,
}

impl InStillWater {
    /// By which part gravity on the free surface would raise the square of the frequency of a mode of unit mass, about: the potential energy
    /// of the waves that it makes over its own.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the factor of the water does not solve.
    pub fn share_of_waves(&mut self, shape: &[f64], eigenvalue: f64) -> Result<f64, EquilibriumError> {
        let pressures = self.added.pressures(shape)?;
        let of_unit = self.water.surface_stiffness(pressures, &self.gravity);
        Ok(self.scale * self.scale * of_unit / eigenvalue)
    }
}
