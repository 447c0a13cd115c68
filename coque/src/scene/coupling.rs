//! How a fluid and structures take turns.

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

/// Who goes first through a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CouplingOrder {
    /// The structures: the fluid follows their velocity over the step.
    #[default]
    StructureFirst,
    /// The fluid, with the velocity of the step before: the published order, which feeds energy into light structures.
    FluidFirst,
}

impl Default for Coupling {
    fn default() -> Self {
        Self { order: CouplingOrder::default(), impedance: true }
    }
}
