//! Figures of a run beside its curve.

use serde::{Deserialize, Serialize};

/// Figures of a fluid and of its coupling.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidFigures {
    /// Mass of the fluid \[F T²/L; by depth in a plane\]: no particle is lost or made but through openings.
    pub mass: f64,
    /// By opening: particles that came in.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub came_in: Vec<u64>,
    /// By opening: particles that went out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub went_out: Vec<u64>,
    /// Particles beyond the closed sides of basins.
    pub lost: usize,
    /// Greatest speed that a particle has had \[L/T\].
    pub greatest_speed: f64,
    /// Greatest change of density so far over the density at rest \[–\].
    pub greatest_density_error: f64,
    /// Kinetic energy \[F L; by depth in a plane F, as those below\].
    pub kinetic: f64,
    /// Energy of compression.
    pub compression: f64,
    /// Potential energy under gravity.
    pub potential: f64,
    /// What viscosities took.
    pub viscous: f64,
    /// What the diffusion of density took.
    pub diffusion: f64,
    /// Steps of all structures.
    pub substeps: u64,
    /// Most steps of a structure within one of the fluid.
    pub most_substeps: u64,
    /// Steps of the fluid that were shortened because a boundary moved fast.
    pub shortened: u64,
    /// `ρ₀c₀Δt/(ρ_s t)` of each structure at the start, ρ_s t its mass by wet area \[–\].
    pub added_mass: Vec<f64>,
}
