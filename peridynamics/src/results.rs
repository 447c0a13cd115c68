//! What is read of a body beside its motion: energies, stress, damage, fragments; and what a checkpoint keeps.

use nalgebra::Matrix3;

use crate::Solid;

impl Solid {
    /// Stored energy per volume of a node, half of each bond's and that of its dilatation, for the forces last evaluated
    /// \[F/L²\].
    pub fn strain_energy(&self, node: usize) -> f64 {
        self.mechanics.stored(&self.rows, node) / self.block.volumes[node]
    }

    /// Virial stress of a node, for the forces last evaluated \[F/L²\]: `σ = ½ Σ f ⊗ y/V` over its bonds y and their pulls
    /// f, both at present; Kirchhoff's, and at small strains Cauchy's. Where families are cut by a surface it is that of
    /// the bonds that are there.
    pub fn stress(&self, node: usize) -> Matrix3<f64> {
        self.mechanics.virial(&self.rows, node) / self.block.volumes[node]
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
}
