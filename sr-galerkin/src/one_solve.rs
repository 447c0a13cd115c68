//! The source's own scheme: one linear answer a step, no iteration for balance. Only to reproduce its figures.

use implicit_statics::{Equilibrium, EquilibriumError, SymmetricSolver};

use crate::body::Galerkin;

/// Leads a body through load steps with one solve each, `K Δq = Δλ p + (f_ext − f_int)`: what a step leaves out of balance goes into
/// the next. The deflection is off by the first order of the step; states are no equilibria.
pub struct OneSolve {
    solver: SymmetricSolver,
    values: Vec<f64>,
    motion: Vec<f64>,
    internal: Vec<f64>,
    external: Vec<f64>,
    steps: usize,
}

impl OneSolve {
    /// Analyses the pattern of a body.
    ///
    /// # Errors
    /// [`EquilibriumError`] of the analysis.
    pub fn new(body: &Galerkin) -> Result<Self, EquilibriumError> {
        let (n, pattern) = (body.unknowns(), body.pattern());
        let solver = SymmetricSolver::placed(n, &pattern, body.places().as_deref())?;
        let [motion, internal, external] = [0; 3].map(|_| vec![0.0; n]);
        Ok(Self { solver, values: vec![0.0; pattern.len()], motion, internal, external, steps: 0 })
    }

    /// Makes the step from one level to another and takes its end as the state that the next starts from. The norm of the forces
    /// left out of balance, over that of the loads.
    ///
    /// # Errors
    /// Of the factor; [`EquilibriumError::Force`] where a point cannot follow.
    pub fn step(&mut self, body: &mut Galerkin, (from, to): (f64, f64)) -> Result<f64, EquilibriumError> {
        self.steps += 1;
        body.tangent(from, &mut self.values);
        self.solver.factor(&self.values)?;
        body.load_rate(from, &mut self.motion);
        self.balance(body, from)?;
        for (i, motion) in self.motion.iter_mut().enumerate() {
            *motion = (to - from) * *motion + self.external[i] - self.internal[i];
        }
        self.solver.solve(&mut self.motion)?;
        body.update(&self.motion);
        self.balance(body, to)?;
        body.accept();
        let squares = |left: f64, (a, b): (&f64, &f64)| left + (a - b) * (a - b);
        let left = self.external.iter().zip(&self.internal).fold(0.0, squares).sqrt();
        let load = self.external.iter().fold(0.0, |sum, f| sum + f * f).sqrt();
        Ok(if load > 0.0 { left / load } else { left })
    }

    /// Internal and external forces of the present state.
    fn balance(&mut self, body: &mut Galerkin, level: f64) -> Result<(), EquilibriumError> {
        body.internal(level, &mut self.internal);
        body.external(level, &mut self.external);
        match self.internal.iter().position(|force| !force.is_finite()) {
            None => Ok(()),
            Some(unknown) => {
                let name = body.name_unknown(unknown);
                Err(EquilibriumError::Force { step: self.steps, level, name })
            }
        }
    }
}
