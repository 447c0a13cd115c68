//! What is read of a body node by node, and what a checkpoint keeps of it.

use nalgebra::Matrix3;

use crate::Solid;
use crate::error::SolidError;

impl Solid {
    /// Stored energy per volume of a node, half of each bond's and that of its dilatation, for the forces last evaluated
    /// \[F/L²\].
    pub fn strain_energy(&self, node: usize) -> f64 {
        self.mechanics.stored(&self.rows, node) / self.block.volumes[node]
    }

    /// Virial stress of a node, for the forces last evaluated \[F/L²\]: `σ = ½ Σ f ⊗ y/V` over its bonds y and their pulls
    /// f, both at present; Kirchhoff's, and at small strains Cauchy's. Where families are cut by a surface it is that of
    /// the bonds that are there. In plane strain `σ_zz = ν (σ_xx + σ_yy) − E αΔT`, by Hooke's law; in plane stress it is zero.
    pub fn stress(&self, node: usize) -> Matrix3<f64> {
        let mut stress = self.mechanics.virial(&self.rows, node) / self.block.volumes[node];
        if let Some(across) = self.across {
            stress[(2, 2)] = across.stress(stress[(0, 0)] + stress[(1, 1)], self.free_strain(node));
        }
        stress
    }

    /// Damage of a node: the broken part of its family by volume, zero whole, one free of bonds \[–\].
    pub fn damage(&self, node: usize) -> f64 {
        self.mechanics.damage(node)
    }

    /// Damage of a column in the upper sheet and in the lower one \[–\]; none but of a plate of two, whose damage is their mean.
    pub fn damage_of_sheets(&self, node: usize) -> Option<[f64; 2]> {
        self.mechanics.damage_of_sheets(node)
    }

    /// Energy that the broken bonds of a node held when they broke, half of each bond's and what its dilatation lost \[F L\].
    pub fn fracture_energy(&self, node: usize) -> f64 {
        self.mechanics.fracture_energy(node)
    }

    /// Equivalent plastic strain of a node, as the last step kept it \[–\]; none where bonds do not yield.
    pub fn plastic_strain(&self, node: usize) -> Option<f64> {
        self.mechanics.past(node).map(|past| past.strain)
    }

    /// Plastic work per volume of a node, as the last step kept it \[F/L²\]; none where bonds do not yield.
    pub fn plastic_work(&self, node: usize) -> Option<f64> {
        self.mechanics.past(node).map(|past| past.work / self.block.volumes[node])
    }

    /// Refuses equilibria that are sought without a march.
    ///
    /// # Errors
    /// [`SolidError::Yielding`] where bonds yield.
    pub fn check_statics(&self) -> Result<(), SolidError> {
        let refused = SolidError::Yielding(
            "go through a march: their equilibria, modes and buckling loads hang on the way there; take a quasi-static march",
        );
        if self.mechanics.yields() { Err(refused) } else { Ok(()) }
    }

    /// Nodes of each fragment, in the order of their first nodes; whole bonds join the nodes of one.
    pub fn fragments(&self) -> Vec<usize> {
        self.mechanics.fragments()
    }

    /// Rows and their rates: positions, behind them directors.
    pub fn motion(&self) -> [&[[f64; 4]]; 2] {
        [&self.rows, &self.rates]
    }

    /// Beside the motion all that changes as bonds break: the broken ones, the energy they held, the work on bonds.
    pub fn broken(&self) -> [Vec<f64>; 3] {
        self.mechanics.broken()
    }

    /// Takes up the state of the same body, to the same bits; false, and nothing changed, for that of another, or one in
    /// which bonds are whole that are broken here.
    pub fn take_up(&mut self, [rows, rates]: [&[[f64; 4]]; 2], broken: [&[f64]; 3]) -> bool {
        if rows.len() != self.rows.len() || rates.len() != self.rates.len() || !self.mechanics.take_up(broken)
        {
            return false;
        }
        self.rows.copy_from_slice(rows);
        self.rates.copy_from_slice(rates);
        true
    }

    /// What flow changes beside the motion, of bonds that yield: plastic extensions of bonds \[L\]; strains \[–\] and works \[F L\] of nodes.
    pub fn flowed(&self) -> [Vec<f64>; 2] {
        self.mechanics.flowed()
    }

    /// Takes up what flowed in the same body, to the same bits; false, and nothing changed, for that of another.
    pub fn take_up_flow(&mut self, flowed: [&[f64]; 2]) -> bool {
        self.mechanics.take_up_flow(flowed)
    }
}
