//! Bodies that are warmer: every point is strained from where it would be free, `Fₘ = F/s` with `s = 1 + λ αΔT`.
//!
//! ```text
//! W = Σ V s³ Wₘ(F/s)        P = s² Pₘ(F/s)        A = s Aₘ
//! ```
//!
//! Each point is so the one of a body that was built as large as it is free when warm, with volumes `V s³` and gradients `∂φ/∂X / s`; whatever moves, turns, yields or shares its change
//! of volume does so from there. A free body of one temperature is free of stress, whatever the law. What expands alike in all directions does so whatever its moduli are.

use crate::discretisation::Cell;

/// By how much the points of a body expand.
pub(crate) struct Heat {
    /// αΔT of each point at level one \[–\].
    pub strains: Vec<f64>,
    /// s of each point.
    pub stretch: Vec<f64>,
    /// Norm of what the stresses that would hold the strains back exert at level one, point by point \[F\].
    pub exerts: f64,
}

/// Volumes of the points of a cell as they are when they are warm.
pub(crate) fn warm_volumes(cell: &Cell, stretches: Option<&[f64]>) -> Option<Vec<f64>> {
    stretches.map(|own| cell.volumes.iter().zip(own).map(|(volume, s)| volume * s * s * s).collect())
}
