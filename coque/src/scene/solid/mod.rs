//! A solid in a scene: its nodes, its material, how it is carried, when its bonds break.

pub(crate) mod formulation;
pub(crate) mod fracture;
pub(crate) mod galerkin;
pub(crate) mod geometry;
pub(crate) mod material;

use schemars::JsonSchema;
use serde::Deserialize;

use super::imperfection::Imperfection;
use super::tools::ToolScene;
use super::velocity::Velocity;
use formulation::{Correction, SolidFormulation};
use fracture::{Contact, Crack, Fracture};
use galerkin::Galerkin;
use geometry::{NodePlaces, SolidGeometry};
use material::SolidMaterial;

/// A solid: of nodes joined by bonds in space, in a plane, or as a thin plate of two sheets; or of shape functions in space.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolidScene {
    /// Its nodes.
    pub geometry: SolidGeometry,
    /// What it is made of.
    pub material: SolidMaterial,
    /// How it is carried.
    pub formulation: SolidFormulation,
    /// When bonds break; left out, never.
    pub fracture: Option<Fracture>,
    /// Cracks that are there at the start.
    #[serde(default)]
    pub cracks: Vec<Crack>,
    /// Sets of nodes whose bonds never break, such as those where loads enter.
    #[serde(default)]
    pub unbreakable: Vec<String>,
    /// Contact of fragments with each other and with walls; left out, there is none.
    pub contact: Option<Contact>,
    /// Rigid tools that it may touch, smooth ones.
    #[serde(default)]
    pub tools: Vec<ToolScene>,
    /// Deflection of the unstrained body.
    pub imperfection: Option<Imperfection>,
    /// Velocity at the start, in transient runs.
    pub velocity: Option<Velocity>,
}

impl SolidScene {
    /// Dimensions of its block, two or three.
    pub fn dimensions(&self) -> usize {
        self.geometry.block.as_ref().map_or(3, |block| block.lengths.len())
    }

    /// How it is carried without bonds, if it is.
    pub fn galerkin(&self) -> Option<&Galerkin> {
        self.formulation.galerkin()
    }

    /// Whether it is a plate of two sheets, which has directors.
    pub fn has_directors(&self) -> bool {
        matches!(self.formulation, SolidFormulation::TwoSheets(_))
    }

    /// What corrects lattices and surfaces; of two sheets the best that their nodes allow, where nothing is said.
    pub fn correction(&self) -> Correction {
        let block = self.geometry.block.as_ref();
        let in_order = block.is_some_and(|block| {
            block.nodes != Some(NodePlaces::Centres)
                && block.disorder.is_none()
                && self.geometry.cut_outs.is_empty()
        });
        let best = if in_order { Correction::Balanced } else { Correction::Even };
        self.formulation.correction().unwrap_or(best)
    }

    /// Whether its nodes move in a plane only.
    pub fn is_plane(&self) -> bool {
        self.dimensions() == 2 && !self.has_directors()
    }
}
