//! Bonds between the nodes of a solid, as its mechanics.

use super::correction::weights;
use super::families::{Families, Nodes};
use super::forces::{Scratch, Wanted, Watch};
use super::network::{Network, Row};
use crate::error::SolidError;
use crate::formulation::{Formulation, Law};
use crate::material::Elastic;
use crate::mechanics::{Evaluation, Mechanics};
use sph_core::Block;

/// Poisson's ratios this close are equal.
const SAME: f64 = 1e-9;

/// Bonds between nodes.
pub(crate) struct SolidBonds {
    pub network: Network,
    scratch: Scratch,
    watch: Option<Watch>,
}

impl SolidBonds {
    /// Joins the nodes of a block.
    ///
    /// # Errors
    /// [`SolidError`] for the material, the horizon, the nodes, and a body in space without thickness.
    pub fn new(block: &Block, material: &Elastic, formulation: &Formulation) -> Result<Self, SolidError> {
        let moduli = material.moduli(formulation.space)?;
        let pairwise = formulation.space.pairwise_poisson();
        if formulation.law == Law::BondBased && (material.poisson - pairwise).abs() > SAME {
            return Err(SolidError::Pairwise(material.poisson, pairwise));
        }
        let spacing = block.greatest_spacing();
        let nodes = Nodes { positions: &block.positions, volumes: &block.volumes, spacing };
        let families = Families::new(&nodes, formulation.horizon, formulation.volumes)?;
        if moduli.dimensions == 3 && flat(&families, block) {
            return Err(SolidError::OneLayer);
        }
        let thickness = if moduli.dimensions == 2 { block.spacing[2] } else { 1.0 };
        let weights = weights(&families, &block.positions, formulation, &moduli, thickness);
        let network = Network::new(&families, &weights, &block.volumes, &moduli);
        let scratch = Scratch::new(&network);
        Ok(Self { network, scratch, watch: None })
    }
}

/// Whether all nodes lie in a plane through the first bonds.
fn flat(families: &Families, block: &Block) -> bool {
    let spread = block.positions.iter().fold(nalgebra::Matrix3::zeros(), |sum, x| {
        let from = x - block.positions[0];
        sum + from * from.transpose()
    });
    let eigen = nalgebra::SymmetricEigen::new(spread).eigenvalues;
    let least = eigen.iter().fold(f64::INFINITY, |least, value| least.min(value.abs()));
    least <= 1e-9 * families.horizon * families.horizon * block.len() as f64
}

impl Mechanics for SolidBonds {
    fn evaluate(&mut self, rows: &mut [Row], forces: &mut [Row], wanted: Evaluation) -> f64 {
        let Evaluation { energy, watch, threads } = wanted;
        let watch = self.watch.as_ref().filter(|_| watch);
        self.network.evaluate(rows, forces, &mut self.scratch, Wanted { energy, watch, threads })
    }

    fn tangent(&mut self, rows: &mut [Row], along: &mut [Row], out: &mut [Row], threads: usize) -> bool {
        self.network.tangent(rows, along, out, &mut self.scratch, threads);
        true
    }

    fn break_bonds(&mut self) -> f64 {
        0.0
    }

    fn bytes(&self) -> usize {
        self.network.bytes()
    }

    fn bonds(&self) -> usize {
        self.network.bonds
    }
}
