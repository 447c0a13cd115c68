//! What a particle of a body that yields has gone through.

use crate::scene::Measured;
use crate::{Warning, WarningKind};

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

/// Plastic strains that a table of hardening does not reach, from strains and the ends of their tables.
pub(crate) fn beyond_data(found: impl Iterator<Item = (f64, f64)>) -> Option<Warning> {
    let beyond = found.filter(|(strain, until)| strain > until);
    beyond.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(greatest, until)| {
        let message = format!(
            "plastic strains reach {greatest:.3}, and the table of hardening ends at {until:.3}: its last slope was kept; add rows to \
             material.plastic.hardening.table"
        );
        Warning::new(WarningKind::BeyondData, message)
    })
}
