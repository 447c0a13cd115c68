//! What a particle of a body that yields has gone through.

use crate::scene::Measured;

/// What the cells round a particle have gone through, as it was committed last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Yielding {
    /// Greatest equivalent plastic strain \[–\].
    pub plastic_strain: f64,
    /// Least thickness \[L\].
    pub thickness: f64,
    /// Energy dissipated, the particle's share \[F L\].
    pub dissipated: f64,
}

impl Yielding {
    /// The number that a column shows.
    pub(crate) fn read(&self, of: Measured) -> f64 {
        match of {
            Measured::PlasticStrain => self.plastic_strain,
            Measured::Thickness => self.thickness,
            _ => self.dissipated,
        }
    }
}
