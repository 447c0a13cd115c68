//! How a solid is carried: by bonds, or by shape functions on its nodes.

pub use peridynamics::{Correction, Influence};
use schemars::JsonSchema;
use serde::Deserialize;

use super::galerkin::Galerkin;
use crate::scene::bounded::Horizon;

/// Formulations of solids.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum SolidFormulation {
    /// A bond feels its own extension alone \[silling2005\]: Poisson's ratio is 1/4, in plane stress 1/3.
    BondBased(Bonds),
    /// A bond feels the dilatation at its ends as well \[silling2007\]: any Poisson's ratio.
    StateBased(Bonds),
    /// A thin plate as two plane-stress sheets on directors, state-based.
    TwoSheets(TwoSheets),
    /// Without bonds: moving least squares on strain and rotation, through large rotations at rest \[song2018\].
    Galerkin(Galerkin),
}

/// Options of bonds in a plane or in space.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bonds {
    /// Horizon over the greatest spacing of nodes \[–\].
    #[serde(default = "usual_horizon")]
    pub horizon: Horizon,
    /// What acts across the plane of a block of two lengths, which must give it.
    pub plane: Option<Plane>,
    /// How much a bond counts by its length.
    #[serde(default = "linear")]
    pub influence: Influence,
    /// What corrects lattices and surfaces.
    #[serde(default)]
    pub correction: Correction,
}

/// Options of [`SolidFormulation::TwoSheets`].
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TwoSheets {
    /// Horizon over the greatest spacing of nodes \[–\].
    #[serde(default = "horizon_of_sheets")]
    pub horizon: Horizon,
    /// How much a bond counts by its length.
    #[serde(default = "inverse")]
    pub influence: Influence,
    /// What corrects lattices and surfaces; left out, `balanced` where nodes stand on the edges of a whole block in order, else `even`.
    pub correction: Option<Correction>,
}

/// What acts across a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Plane {
    /// No stress: a thin plate.
    Stress,
    /// No strain: a slice of a long body.
    Strain,
}

impl SolidFormulation {
    /// Key of the formulation in a scene.
    pub fn word(&self) -> &'static str {
        match self {
            Self::BondBased(_) => "bond-based",
            Self::StateBased(_) => "state-based",
            Self::TwoSheets(_) => "two-sheets",
            Self::Galerkin(_) => "galerkin",
        }
    }

    /// The method without bonds, if it is that.
    pub fn galerkin(&self) -> Option<&Galerkin> {
        match self {
            Self::Galerkin(galerkin) => Some(galerkin),
            _ => None,
        }
    }

    /// Horizon over the greatest spacing of nodes \[–\]; zero without bonds.
    pub fn horizon(&self) -> f64 {
        match self {
            Self::BondBased(bonds) | Self::StateBased(bonds) => bonds.horizon.get(),
            Self::TwoSheets(sheets) => sheets.horizon.get(),
            Self::Galerkin(_) => 0.0,
        }
    }

    /// What acts across a plane; nothing is said in space, of two sheets, and without bonds.
    pub fn plane(&self) -> Option<Plane> {
        match self {
            Self::BondBased(bonds) | Self::StateBased(bonds) => bonds.plane,
            Self::TwoSheets(_) | Self::Galerkin(_) => None,
        }
    }

    /// How much a bond counts by its length.
    pub fn influence(&self) -> Influence {
        match self {
            Self::BondBased(bonds) | Self::StateBased(bonds) => bonds.influence,
            Self::TwoSheets(sheets) => sheets.influence,
            Self::Galerkin(_) => Influence::Constant,
        }
    }

    /// What corrects lattices and surfaces, if it is said.
    pub fn correction(&self) -> Option<Correction> {
        match self {
            Self::BondBased(bonds) | Self::StateBased(bonds) => Some(bonds.correction),
            Self::TwoSheets(sheets) => sheets.correction,
            Self::Galerkin(_) => Some(Correction::None),
        }
    }

    /// One line that names the formulation with its options and what corrects it.
    pub fn describe(&self, correction: Correction) -> String {
        if let Self::Galerkin(galerkin) = self {
            return galerkin.describe();
        }
        let plane = match self.plane() {
            None => "",
            Some(Plane::Stress) => ", plane stress",
            Some(Plane::Strain) => ", plane strain",
        };
        let influence = match self.influence() {
            Influence::Constant => "constant",
            Influence::Inverse => "inverse",
            Influence::Linear => "linear",
        };
        let correction = match correction {
            Correction::Even => "even correction",
            Correction::Balanced => "balanced correction",
            Correction::EnergyFactor => "energy factors",
            Correction::None => "no correction",
        };
        let (word, horizon) = (self.word(), self.horizon());
        format!("{word}{plane}, horizon {horizon}, {influence} influence, {correction}")
    }
}

/// The fraction keeps nodes at three spacings inside.
fn usual_horizon() -> Horizon {
    Horizon::usual(3.015)
}

/// Eight neighbours: larger horizons are worse on plates.
fn horizon_of_sheets() -> Horizon {
    Horizon::usual(1.5)
}

fn linear() -> Influence {
    Influence::Linear
}

fn inverse() -> Influence {
    Influence::Inverse
}
