//! How bonds carry an elastic solid: law, horizon, influence, correction.

use crate::material::Space;

/// A peridynamic formulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Formulation {
    /// The space that bonds lie in.
    pub space: Space,
    /// What a bond feels.
    pub law: Law,
    /// Horizon δ over the greatest spacing of nodes \[–\].
    pub horizon: f64,
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

/// The influence w of a bond by its length r, `δ' = δ + ½Δx` the search radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Influence {
    /// 1.
    Constant,
    /// `1/r`.
    Inverse,
    /// `1 − r/δ'`.
    Linear,
}

/// What corrects the moduli of nodes whose family is a lattice's, or cut by a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Correction {
    /// Nothing: whole partial volumes alone.
    None,
    /// Weights of bonds for which the energy of the six unit strains is exact at every node.
    Even,
    /// One factor a bond, from the energies of unit strains along the axes.
    EnergyFactor,
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
}
