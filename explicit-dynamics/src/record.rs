//! What is recorded of a run: energies and their balance.

use serde::{Deserialize, Serialize};

use crate::step::Instant;

/// Energies of a run up to an instant \[F L\].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Internal energy.
    pub internal: f64,
    /// Work of loads and prescribed motions.
    pub external: f64,
    /// Taken by damping.
    pub dissipated: f64,
}

impl Balance {
    /// What is missing: `kinetic + internal + dissipated − external − (kinetic + internal at the start)`.
    pub fn error(&self, initial: f64) -> f64 {
        self.kinetic + self.internal + self.dissipated - self.external - initial
    }
}

/// The energies of a run at an instant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Steps done.
    pub step: u64,
    /// When, and at which load level.
    pub at: Instant,
    /// Energies; `balance_error` is against the first record.
    pub energy: Balance,
    /// [`Balance::error`] against the energy of the start, less what comes and goes between two steps of central differences
    /// (what they keep is `½ v⁻·M v⁺ + U`, not the energy with the mean of the velocities) \[F L\].
    pub balance_error: f64,
    /// True at the end of a hold whose stop criterion was met.
    pub settled: bool,
}
