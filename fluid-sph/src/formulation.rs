//! What is chosen of the method: widths, dissipations, scheme of time, rule of the walls.

use crate::error::FluidError;

/// How a fluid is marched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Forces where the velocities are kicked, the rate of density half a step later: two half sweeps a step.
    KickDriftKick,
    /// The published predictor and corrector: two whole sweeps a step.
    PredictorCorrector,
}

/// Which pressure a particle of a wall has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(rename = "WallMethod")
)]
pub enum WallRule {
    /// Their pressure is that of the fluid before them, shifted hydrostatically \[adami2012\].
    Extrapolated,
    /// Their density follows the equation of continuity, as in the published method \[crespo2007\].
    Dynamic,
}

/// The method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Formulation {
    /// Smoothing length over spacing h/Δx \[–\]; by default that at which lattices resist shear least (src/lattice.rs).
    pub smoothing: f64,
    /// Artificial viscosity α \[–\].
    pub viscosity: f64,
    /// Kinematic viscosity ν of laminar flow \[L²/T\]; none at zero. Walls hold such a fluid.
    pub kinematic_viscosity: f64,
    /// Diffusion of density δ \[–\].
    pub density_diffusion: f64,
    /// Share ε of the mean velocity in that which moves particles (XSPH) \[–\].
    pub xsph: f64,
    /// Part of the step criteria that a step takes \[–\].
    pub courant: f64,
    /// How it is marched.
    pub scheme: Scheme,
    /// Which pressure a wall has.
    pub walls: WallRule,
    /// Whether the fluid has no free surface: walls may then pull.
    pub confined: bool,
    /// Whether walls and structures let it slip: no friction acts against them.
    pub slip: bool,
}

impl Default for Formulation {
    fn default() -> Self {
        Self {
            smoothing: 1.55,
            viscosity: 0.02,
            kinematic_viscosity: 0.0,
            density_diffusion: 0.1,
            xsph: 0.0,
            courant: 0.3,
            scheme: Scheme::KickDriftKick,
            walls: WallRule::Extrapolated,
            confined: false,
            slip: false,
        }
    }
}

impl Formulation {
    /// The published set.
    pub fn published() -> Self {
        Self {
            smoothing: 1.3,
            viscosity: 0.1,
            density_diffusion: 0.0,
            xsph: 0.5,
            scheme: Scheme::PredictorCorrector,
            walls: WallRule::Dynamic,
            ..Self::default()
        }
    }

    /// Refuses numbers out of bounds.
    pub(crate) fn check(&self) -> Result<(), FluidError> {
        let within = |key, value: f64, low: f64, high: f64, bound| {
            let good = value >= low && value <= high;
            if good { Ok(()) } else { Err(FluidError::Option { key, value, bound }) }
        };
        within("smoothing", self.smoothing, 1.0, 4.0, "between 1 and 4; 1.55 suits most flows")?;
        within("viscosity", self.viscosity, 0.0, 10.0, "between 0 and 10; 0.02 suits most flows")?;
        within("kinematic_viscosity", self.kinematic_viscosity, 0.0, f64::MAX, "zero or positive, finite")?;
        within(
            "density_diffusion",
            self.density_diffusion,
            0.0,
            1.0,
            "between 0 and 1; 0.1 suits most flows",
        )?;
        within("xsph", self.xsph, 0.0, 1.0, "between 0 and 1")?;
        within("courant", self.courant, 1e-3, 1.0, "between 0.001 and 1; 0.3 is safe")
    }
}
