//! Paths in parts: how one begins, from the state in which another ended or from anywhere else, and how it ends; a pattern that changes, how far a
//! state may move at once, and the line search on the way.

use crate::newton::{AT_REST, Converged, Newton, ROUNDING};
use crate::vectors::{dot, norm};
use crate::{Equilibrium, EquilibriumError, Increment, SymmetricSolver};

impl Newton {
    /// Takes note that the caller has moved the state: the factor at hand is none of it.
    pub fn has_moved(&mut self) {
        (self.factored, self.answer) = (None, None);
    }

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

    /// Reads another pattern and analyses it; the sense of scale stays.
    pub(super) fn analyse<E: Equilibrium + ?Sized>(&mut self, system: &E) -> Result<(), EquilibriumError> {
        let (n, pattern) = (system.unknowns(), system.pattern());
        let mut solver = SymmetricSolver::placed(n, &pattern, system.coordinates().as_deref())?;
        solver.refer_to(self.solver.first_stiffness());
        self.values.resize(pattern.len(), 0.0);
        self.solver = solver;
        Ok(())
    }

    /// Whether a motion is too short against the way made to be more than rounding.
    pub(crate) fn is_rounding(&self, motion: &[f64], increment: &Increment) -> bool {
        self.length(motion) <= AT_REST * self.way(increment)
    }

    /// Length of the way from the start of the path, of the present step or of the first, whichever is longest.
    pub(super) fn way(&self, increment: &Increment) -> f64 {
        let sum: Vec<f64> = self.travelled.iter().zip(&increment.motion).map(|(a, b)| a + b).collect();
        self.length(&sum).max(self.length(&increment.motion)).max(self.first_way)
    }

    /// Ends a path in the present state.
    pub(crate) fn leave<E: Equilibrium + ?Sized>(&mut self, system: &E) {
        self.left = system.save();
    }

    /// Takes the present state over if it balances a level by the scale of what is expected, else corrects it; then the scale is that of what it bears. Of a path
    /// that goes on, the commit of a history may have changed forces since the state was balanced: that is the next step's to balance, for balanced alone it
    /// would be a step of its own.
    pub(crate) fn settle<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        goes_on: bool,
    ) -> Result<Converged, EquilibriumError> {
        let expected = self.force_scale;
        let size = self.residual(system, level)?;
        let asked = self.options.tolerance * norm(&self.external).max(expected);
        let bound = asked.max(ROUNDING * system.stress_forces(level));
        let committed = goes_on && system.tangent_is_of_the_step();
        let converged = if !committed && (size > bound || system.within_bounds().is_err()) {
            self.at_level(system, level)?
        } else {
            let inertia = self.tangent(system, level)?;
            self.force_scale = expected.max(norm(&self.external)).max(norm(&self.internal));
            // A history that goes on was committed where this state was accepted. Once more, of strains that differ from those by rounding, would be a step
            // in which nothing flows.
            if !committed {
                self.keep(system);
            }
            Converged { level, iterations: 0, residuals: vec![size], bound, inertia }
        };
        if system.has_moving_tools() {
            let borne = norm(&self.external).max(norm(&self.internal));
            self.force_scale = Self::of_expected(system, expected).max(borne);
        }
        Ok(converged)
    }
}

/// Shortens a motion to what the system may move at once.
pub(crate) fn within_reach<E: Equilibrium + ?Sized>(system: &mut E, motion: &mut [f64]) {
    let share = system.reach(motion);
    if share < 1.0 {
        motion.iter_mut().for_each(|q| *q *= share);
    }
}

/// A line search sets in when `|δ·r|` along the step `δ` does not fall to this share \[matthies1979, crisfield1991\].
const SLACK: f64 = 0.8;
/// Trials of one line search.
const TRIALS: usize = 6;

impl Newton {
    /// Moves along `motion` by the whole of it, or by the share where `|motion·r|` has fallen enough.
    ///
    /// Only an overshoot (change of sign of `motion·r`, the slope of the potential) is shortened.
    pub(super) fn search<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        motion: &[f64],
    ) -> Result<f64, EquilibriumError> {
        let start = dot(motion, &self.residual);
        let saved = system.save();
        let mut share = 1.0;
        let mut scaled = motion.to_vec();
        for _ in 0..TRIALS {
            self.advance(system, &scaled);
            let slope = self.residual(system, level).map_or(f64::NAN, |_| dot(motion, &self.residual));
            if slope.abs() <= SLACK * start.abs() || slope * start > 0.0 {
                return Ok(share);
            }
            let crossing = start / (start - slope); // of the straight line between the slopes at 0 and here
            share *= if crossing.is_finite() { crossing.clamp(0.1, 0.9) } else { 0.5 };
            self.go_back(system, &saved);
            for (scaled, motion) in scaled.iter_mut().zip(motion) {
                *scaled = share * motion;
            }
        }
        self.advance(system, &scaled);
        Ok(share)
    }
}
