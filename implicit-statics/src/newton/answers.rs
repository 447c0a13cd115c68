//! Answers to loads by the factor at hand.

use super::Newton;
use crate::{Equilibrium, EquilibriumError, Inertia};

impl Newton {
    /// `K⁻¹ p` at the present state, p the load rate `∂(external − internal)/∂λ`.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the tangent is singular.
    pub fn response<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Vec<f64>, EquilibriumError> {
        self.tangent(system, level)?;
        if let Some(response) = &self.answer {
            return Ok(response.clone());
        }
        self.answer_by_factor(system, level)
    }

    /// Factorises the tangent of a state for answers to several loads: [`Newton::response_of`].
    ///
    /// # Errors
    /// [`EquilibriumError`] where the tangent is singular.
    pub fn factorise<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Inertia, EquilibriumError> {
        self.tangent(system, level)
    }

    /// `K⁻¹ p` by the factor at hand, p the load rate of a system that has the same tangent and unknowns under other loads.
    ///
    /// # Errors
    /// [`EquilibriumError`] where the tangent is singular.
    pub fn response_of<E: Equilibrium + ?Sized>(
        &mut self,
        other: &mut E,
        level: f64,
    ) -> Result<Vec<f64>, EquilibriumError> {
        let response = self.answer_by_factor(other, level);
        self.answer = None;
        response
    }

    /// The same by the factor at hand.
    fn answer_by_factor<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Vec<f64>, EquilibriumError> {
        system.load_rate(level, &mut self.rate);
        let mut response = self.rate.clone();
        self.solver.solve(&mut response).map_err(|error| error.named(system, self.step, level))?;
        self.effort.solves += 1;
        self.answer = Some(response.clone());
        Ok(response)
    }

    /// The same together with the solution for a right side, which takes its place: the factor is read once.
    pub(super) fn answer_with<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        right: &mut [f64],
    ) -> Result<Vec<f64>, EquilibriumError> {
        system.load_rate(level, &mut self.rate);
        let mut response = self.rate.clone();
        self.solver
            .solve_all([right, &mut response])
            .map_err(|error| error.named(system, self.step, level))?;
        self.effort.solves += 2;
        self.answer = Some(response.clone());
        Ok(response)
    }
}
