//! Paths in parts: how one begins, from the state in which another ended or from anywhere else, and how it ends.

use super::{Converged, Newton};
use crate::vectors::norm;
use crate::{Equilibrium, EquilibriumError};

impl Newton {
    /// Begins a path: the sense of scale is that of its start; a factor of the same state by the same stiffnesses serves on.
    pub(crate) fn begin<E: Equilibrium + ?Sized>(
        &mut self,
        system: &E,
        stiffness: Option<&[f64]>,
    ) -> Result<(), EquilibriumError> {
        let n = self.residual.len();
        let zeros = vec![0.0; n];
        let stiffness = stiffness.unwrap_or(&zeros);
        if stiffness.len() != n {
            let name = "stiffness at the start";
            return Err(EquilibriumError::Length { name, length: stiffness.len(), expected: n });
        }
        if self.solver.first_stiffness() != stiffness || system.save() != self.left {
            self.factored = None;
        }
        self.solver.refer_to(stiffness);
        self.step = 0;
        (self.force_scale, self.first_way) = (0.0, 0.0);
        self.travelled.fill(0.0);
        Ok(())
    }

    /// Has the system take its present state as one that is kept; the factor serves on where the tangent stays what it was.
    pub(crate) fn keep<E: Equilibrium + ?Sized>(&mut self, system: &mut E) {
        if system.tangent_is_of_the_step() {
            self.factored = None;
        }
        system.commit();
    }

    /// Knows no factor of the present state: the system has changed in it.
    pub(crate) fn forget(&mut self) {
        self.factored = None;
    }

    /// The loads last evaluated \[F\].
    pub(crate) fn load(&self) -> &[f64] {
        &self.external
    }

    /// Ends a path in the present state.
    pub(crate) fn leave<E: Equilibrium + ?Sized>(&mut self, system: &E) {
        self.left = system.save();
    }

    /// Takes the present state over if it balances a level, else corrects it.
    pub(crate) fn settle<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Converged, EquilibriumError> {
        let size = self.residual(system, level)?;
        let bound = self.options.tolerance * norm(&self.external).max(self.force_scale);
        if size > bound || system.within_bounds().is_err() {
            return self.at_level(system, level);
        }
        let inertia = self.tangent(system, level)?;
        self.force_scale = self.force_scale.max(norm(&self.external)).max(norm(&self.internal));
        self.keep(system);
        Ok(Converged { level, iterations: 0, residuals: vec![size], bound, inertia })
    }
}
