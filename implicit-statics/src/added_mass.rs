//! The mass that an incompressible medium beside a system adds to it, `Mₐ = Bᵀ L⁻¹ B`, as an operator.
//!
//! B makes fluxes into the nodes of the medium of a motion of the unknowns, L is its symmetric positive Laplacian over the density: the pressures
//! p of an acceleration a obey `L p = B a` and push back by `−Bᵀ p`. Mₐ is symmetric, nowhere negative, and full over all that is wet; here
//! it is one solve with a factor of L, made once. Where `K − σ(M + Mₐ)` is to be solved and counted, p stand as unknowns beside the others:
//!
//! ```text
//! | K − σM   s Bᵀ |        s = √|σ|, the sign that of σ: the lower block eliminated leaves K − σ(M + Mₐ), and takes with it
//! | s B      ± L  |        as many negative pivots as L has rows where σ < 0, none else (Haynsworth)
//! ```

use crate::error::require;
use crate::{EquilibriumError, SymmetricSolver};

/// What a medium adds to the mass of a system.
pub struct AddedMass {
    nodes: usize,
    pattern: Vec<(usize, usize)>,
    values: Vec<f64>,
    flux: Vec<(usize, usize, f64)>,
    solver: SymmetricSolver,
    /// Pressures of the last motion.
    pressures: Vec<f64>,
}

impl AddedMass {
    /// A medium of so many nodes: L by its lower triangle with the whole diagonal, each entry once \[L⁴/(F T²) · L\], and the entries of B, node,
    /// unknown and flux for a unit of it; those of the same node and unknown add up.
    ///
    /// # Errors
    /// [`EquilibriumError`] for a pattern or for entries out of bounds, and for a Laplacian that is not positive: a medium that is shut in.
    pub fn new(
        nodes: usize,
        pattern: Vec<(usize, usize)>,
        values: Vec<f64>,
        mut flux: Vec<(usize, usize, f64)>,
    ) -> Result<Self, EquilibriumError> {
        if let Some(&(node, ..)) = flux.iter().find(|entry| entry.0 >= nodes) {
            require(false, "node of a flux", node as f64, "one of the medium's")?;
        }
        flux.sort_unstable_by_key(|&(node, unknown, _)| (node, unknown));
        flux.dedup_by(|next, kept| {
            let same = (next.0, next.1) == (kept.0, kept.1);
            if same {
                kept.2 += next.2;
            }
            same
        });
        let mut solver = SymmetricSolver::new(nodes, &pattern)?;
        let inertia = solver.factor(&values)?;
        let bad = inertia.negative + inertia.zero;
        require(bad == 0, "eigenvalues of a Laplacian that are not positive", bad as f64, "none")?;
        let pressures = vec![0.0; nodes];
        Ok(Self { nodes, pattern, values, flux, solver, pressures })
    }

    /// Pressures `L⁻¹ B a` at the nodes for an acceleration of the unknowns.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the factor does not solve.
    pub fn pressures(&mut self, motion: &[f64]) -> Result<&[f64], EquilibriumError> {
        self.pressures.fill(0.0);
        for &(node, unknown, flux) in &self.flux {
            self.pressures[node] += flux * motion[unknown];
        }
        self.solver.solve(&mut self.pressures)?;
        Ok(&self.pressures)
    }

    /// `out += Mₐ a`.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the factor does not solve.
    pub fn add_product(&mut self, motion: &[f64], out: &mut [f64]) -> Result<(), EquilibriumError> {
        self.pressures(motion)?;
        for &(node, unknown, flux) in &self.flux {
            out[unknown] += flux * self.pressures[node];
        }
        Ok(())
    }

    /// Nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.nodes
    }

    /// The greatest unknown that it moves with, and one; zero without any.
    pub(crate) fn reach(&self) -> usize {
        self.flux.iter().map(|&(_, unknown, _)| unknown + 1).max().unwrap_or(0)
    }

    /// The pattern of a system of so many unknowns with the pressures behind them.
    pub(crate) fn beside(&self, unknowns: usize, pattern: &[(usize, usize)]) -> Vec<(usize, usize)> {
        let between = self.flux.iter().map(|&(node, unknown, _)| (unknowns + node, unknown));
        let own = self.pattern.iter().map(|&(row, column)| (unknowns + row, unknowns + column));
        pattern.iter().copied().chain(between).chain(own).collect()
    }

    /// Appends what stands behind `K − σM` in that pattern; how many negative pivots it brings.
    pub(crate) fn append(&self, shift: f64, values: &mut Vec<f64>) -> usize {
        let (size, sign) = (shift.abs().sqrt(), if shift < 0.0 { -1.0 } else { 1.0 });
        values.extend(self.flux.iter().map(|entry| size * entry.2));
        values.extend(self.values.iter().map(|value| sign * value));
        if shift < 0.0 { self.nodes } else { 0 }
    }
}
