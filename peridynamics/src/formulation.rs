//! How bonds carry an elastic solid: law, horizon, influence, correction.

use crate::error::SolidError;
use crate::material::{Elastic, Moduli, Space};

/// Poisson's ratios this close are equal.
const SAME: f64 = 1e-9;

/// A peridynamic formulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Formulation {
    /// The space that bonds lie in.
    pub space: Space,
    /// What a bond feels.
    pub law: Law,
    /// Horizon δ over the greatest spacing of nodes \[–\].
    pub horizon: f64,
    /// How much of a node's volume lies inside the horizon of another.
    pub volumes: Volumes,
    /// How much a bond counts by its length.
    pub influence: Influence,
    /// What corrects lattices and surfaces.
    pub correction: Correction,
}

/// What a bond feels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Its own extension alone (PMB \[silling2005\]): Poisson's ratio is that of pairwise forces.
    BondBased,
    /// Its extension and the dilatation at both ends (LPS \[silling2007\]): any Poisson's ratio.
    StateBased,
}

/// How much of a node's volume lies inside the horizon of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Volumes {
    /// The part of its width: one up to δ − ½Δx, zero from δ + ½Δx on, linear between.
    Partial,
    /// All of it up to δ.
    Whole,
}

/// The influence w of a bond by its length r, `δ' = δ + ½Δx`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum Influence {
    /// All bonds alike.
    Constant,
    /// As 1/r.
    Inverse,
    /// Falling along a straight line to zero at the reach of a family, `1 − r/δ'`.
    Linear,
}

/// What corrects the moduli of nodes whose family is a lattice's, or cut by a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum Correction {
    /// Nothing: whole partial volumes alone.
    None,
    /// Weights for which the energy of the six unit strains is exact at every node.
    #[default]
    Even,
    /// Weights of `even`, changed as little as makes uniform strains balance the tractions on faces at every node: loaded ends, layers in
    /// bending and clamped edges are right. For nodes on the edges of a block without cut-outs and disorder.
    Balanced,
    /// One factor a bond, from the energies of unit strains along the axes.
    EnergyFactor,
}

impl Formulation {
    /// The constants of a material in the space of the bonds.
    ///
    /// # Errors
    /// [`SolidError::Material`], and [`SolidError::Pairwise`] for a Poisson's ratio that pairwise forces have not.
    pub(crate) fn moduli(&self, material: &Elastic) -> Result<Moduli, SolidError> {
        let moduli = material.moduli(self.space)?;
        let carried = self.law.poisson(self.space, material.poisson);
        if (material.poisson - carried).abs() > SAME {
            return Err(SolidError::Pairwise(material.poisson, carried));
        }
        Ok(moduli)
    }
}

impl Law {
    /// Whether a bond feels the dilatation at its ends beside its own extension.
    pub fn has_dilatation(self) -> bool {
        match self {
            Self::BondBased => false,
            Self::StateBased => true,
        }
    }

    /// Poisson's ratio \[–\] that bonds can carry where one is stated: of pairwise forces that of their space, else any.
    pub fn poisson(self, space: Space, stated: f64) -> f64 {
        if self.has_dilatation() { stated } else { space.pairwise_poisson() }
    }
}

impl Influence {
    /// w of a bond of length r, for a search radius δ' \[1; 1/L; 1\].
    pub fn weight(self, length: f64, reach: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Inverse => 1.0 / length,
            Self::Linear => 1.0 - length / reach,
        }
    }

    /// `∫ w r² dV` over a whole ball, or disc of thickness one, of radius δ \[L⁵; L⁴, less one with `1/r`\].
    pub(crate) fn second_moment(self, dimensions: usize, horizon: f64, reach: f64) -> f64 {
        // ∫ r^k dV = s δ^(d + k)/(d + k), s the area of the unit sphere or circle.
        let d = dimensions as i32;
        let surface = if d == 3 { 4.0 } else { 2.0 } * std::f64::consts::PI;
        let moment = |k: i32| surface * horizon.powi(d + k) / f64::from(d + k);
        match self {
            Self::Constant => moment(2),
            Self::Inverse => moment(1),
            Self::Linear => moment(2) - moment(3) / reach,
        }
    }
}
