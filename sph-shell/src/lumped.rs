//! Masses lumped at particles: they move with the particle and do not turn with its director.

use crate::Shell;
use crate::error::ShellError;

impl Shell {
    /// Adds masses \[M\] to particles: to inertia in the march and in modes, and to weight on all of the shell.
    ///
    /// # Errors
    /// [`ShellError`] for a particle beyond the cloud, and for a mass that is not positive and finite.
    pub fn lump(&mut self, masses: &[(u32, f64)]) -> Result<(), ShellError> {
        let count = self.len();
        for &(particle, mass) in masses {
            if particle as usize >= count {
                return Err(ShellError::NoSuchParticle { what: "a mass", particle, count });
            }
            if !(mass > 0.0 && mass.is_finite()) {
                return Err(ShellError::Mass { particle, mass });
            }
        }
        let turning = self.thickness().powi(2) / 12.0;
        let reference = &mut self.reference;
        if reference.rotary.is_empty() && !masses.is_empty() {
            // What turns with a director is the shell alone.
            reference.rotary = reference.masses.iter().map(|mass| mass * turning).collect();
        }
        for &(particle, mass) in masses {
            reference.masses[particle as usize] += mass;
        }
        // Junctions and ties bear what their particles do.
        if masses.is_empty() { Ok(()) } else { self.weigh_ties() }
    }
}
