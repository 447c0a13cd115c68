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
    /// How each wet face moves along its normal by unknowns, and `ρ A g·n`, n into the water \[F/L\].
    pub faces: Vec<(Vec<(usize, f64)>, f64)>,
}

impl InStillWater {
    /// By which part gravity would raise the square of the frequency of a mode of unit mass, below zero lower it, about: the potential energy of the
    /// waves that it makes, `½ρg∫ζ² dA`, less that of faces that move in the pressure at rest, `½ρg∫n_z w² dA`, over its own. Of a floor that goes
    /// up and down as one both are alike.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the factor of the water does not solve.
    pub fn share_of_gravity(&mut self, shape: &[f64], eigenvalue: f64) -> Result<f64, EquilibriumError> {
        let pressures = self.added.pressures(shape)?;
        let of_waves = self.scale * self.scale * self.water.surface_stiffness(pressures, &self.gravity);
        let of_face = |(along, weight): &(Vec<(usize, f64)>, f64)| {
            let moved: f64 = along.iter().map(|&(unknown, way)| way * shape[unknown]).sum();
            weight * moved * moved
        };
        Ok((of_waves + self.faces.iter().map(of_face).sum::<f64>()) / eigenvalue)
    }
}
