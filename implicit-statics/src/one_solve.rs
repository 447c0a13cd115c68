//! Load steps of one linear answer each, without iterations for balance.

use crate::equilibrium::Equilibrium;
use crate::error::EquilibriumError;
use crate::inertia::Inertia;
use crate::solver::SymmetricSolver;

/// Leads a system through load steps with one solve each: Euler's method on the rate equation, with what is out of balance carried over,
///
/// ```text
/// K(q) Δq = Δλ p(q) + r(q)        r = external − internal
/// ```
///
/// which is the first iteration of Newton's method to the next level, and no second. States are no equilibria: an error e leaves
/// `c (Δq + e)²` of it at the next level, c the curvature of the forces over their slope, so that errors do not add up and are of the second
/// order of the step once it is small, `c Δq ≪ 1`. Where it is not, as in thin bodies, whose membranes resist the straight way of a turn, they are
/// as large as the motion. How far a state is from its equilibrium the next solve tells, before the load goes on: `K⁻¹ r` at its end
/// ([`OneSolve::remaining_displacement`]). The factor for it is that of the next step: `n` steps take `n + 1`.
pub struct OneSolve {
    solver: SymmetricSolver,
    values: Vec<f64>,
    motion: Vec<f64>,
    internal: Vec<f64>,
    external: Vec<f64>,
    /// Whether the factor is that of the present state.
    factored: bool,
    steps: usize,
}

impl OneSolve {
    /// Analyses the pattern of a system.
    ///
    /// # Errors
    /// [`EquilibriumError`] of the analysis.
    pub fn new(system: &(impl Equilibrium + ?Sized)) -> Result<Self, EquilibriumError> {
        let (n, pattern) = (system.unknowns(), system.pattern());
        let solver = SymmetricSolver::placed(n, &pattern, system.coordinates().as_deref())?;
        let [motion, internal, external] = [0; 3].map(|_| vec![0.0; n]);
        let values = vec![0.0; pattern.len()];
        Ok(Self { solver, values, motion, internal, external, factored: false, steps: 0 })
    }

    /// Makes the step from one level to another and takes its end as the state that the next starts from. The norm of the forces
    /// left out of balance, over that of the loads; where there are none, over that of the forces that prescribed values take, or heat.
    ///
    /// # Errors
    /// Of the factor; [`EquilibriumError::Force`] where forces are no numbers, [`EquilibriumError::OutOfBounds`] where the system
    /// refuses the state.
    pub fn step(
        &mut self,
        system: &mut (impl Equilibrium + ?Sized),
        (from, to): (f64, f64),
    ) -> Result<f64, EquilibriumError> {
        self.steps += 1;
        self.factor(system, from)?;
        system.load_rate(from, &mut self.motion);
        let added = self.motion.iter().fold(0.0, |sum, f| sum + f * f).sqrt();
        self.balance(system, from)?;
        for (i, motion) in self.motion.iter_mut().enumerate() {
            *motion = (to - from) * *motion + self.external[i] - self.internal[i];
        }
        self.solver.solve(&mut self.motion)?;
        system.update(&self.motion);
        self.factored = false;
        self.balance(system, to)?;
        let pairs = self.external.iter().zip(&self.internal);
        let left = pairs.fold(0.0, |sum, (a, b)| sum + (a - b) * (a - b)).sqrt();
        let load = self.external.iter().fold(0.0, |sum, f| sum + f * f).sqrt();
        let heat = if system.stress_forces(to) > 0.0 { to.abs() * added } else { 0.0 };
        let scale = if load > 0.0 { load } else { system.driving_force() }.max(heat);
        system.within_bounds().map_err(|found| EquilibriumError::OutOfBounds {
            step: self.steps,
            level: to,
            found,
        })?;
        system.commit();
        Ok(if scale > 0.0 { left / scale } else { left })
    }

    /// The motion by which the present state, at the level of the last step, would come nearer to its equilibrium: one more solve, not
    /// made.
    ///
    /// # Errors
    /// Of the factor.
    pub fn remaining_displacement(
        &mut self,
        system: &mut (impl Equilibrium + ?Sized),
        level: f64,
    ) -> Result<&[f64], EquilibriumError> {
        self.factor(system, level)?;
        self.balance(system, level)?;
        for (i, motion) in self.motion.iter_mut().enumerate() {
            *motion = self.external[i] - self.internal[i];
        }
        self.solver.solve(&mut self.motion)?;
        Ok(&self.motion)
    }

    /// Signs of the pivots of the last factor.
    pub fn inertia(&self) -> Inertia {
        self.solver.inertia()
    }

    /// Factors the tangent of the present state, unless that was done.
    fn factor(
        &mut self,
        system: &mut (impl Equilibrium + ?Sized),
        level: f64,
    ) -> Result<(), EquilibriumError> {
        if !self.factored {
            system.tangent(level, &mut self.values);
            self.solver.factor_with(&self.values, &system.beside_pattern(level))?;
            self.factored = true;
        }
        Ok(())
    }

    /// Internal and external forces of the present state.
    fn balance(
        &mut self,
        system: &mut (impl Equilibrium + ?Sized),
        level: f64,
    ) -> Result<(), EquilibriumError> {
        system.internal(level, &mut self.internal);
        system.external(level, &mut self.external);
        match self.internal.iter().position(|force| !force.is_finite()) {
            None => Ok(()),
            Some(unknown) => {
                let name = system.name_unknown(unknown);
                Err(EquilibriumError::Force { step: self.steps, level, name })
            }
        }
    }
}
