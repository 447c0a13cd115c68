//! How a fluid and structures take turns.

pub use explicit_dynamics::Order as CouplingOrder;
use schemars::JsonSchema;
use serde::Deserialize;

/// How a fluid and the structures in it are coupled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Coupling {
    /// Who goes first through a step.
    pub order: CouplingOrder,
    /// Whether the load on a wet face follows its velocity within a step, as the pressure of a plane wave.
    pub impedance: bool,
}

impl Default for Coupling {
    fn default() -> Self {
        Self { order: CouplingOrder::default(), impedance: true }
    }
}
