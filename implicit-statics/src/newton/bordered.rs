//! The equation beside equilibrium, and the solve that meets both.

use super::{Increment, Newton};
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError};

/// The equation beside equilibrium.
pub(crate) enum Constraint<'a> {
    /// The level is given.
    Level,
    /// `c·Δq = target`.
    Functional { weights: &'a [f64], target: f64 },
    /// `Σ wᵢ Δqᵢ² + ψ² Δλ² = R²` \[crisfield1981\], linearised consistently \[schweizerhof1986\].
    Sphere { weights: &'a [f64], load: f64, radius: f64 },
}

impl Newton {
    /// One bordered solve: `K δ = r + δλ p` with the constraint linearised, by two solves with one factor
    /// \[batoz1979\].
    pub(super) fn correction<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        increment: &Increment,
        constraint: &Constraint,
    ) -> Result<Increment, EquilibriumError> {
        let mut motion = self.residual.clone();
        let of_here = self.factored.is_none_or(|at| at == level);
        let both = of_here && self.answer.is_none() && !matches!(constraint, Constraint::Level);
        let response = if both {
            self.answer_with(system, level, &mut motion)?
        } else {
            self.solver.solve(&mut motion).map_err(|error| error.named(system, self.step, level))?;
            self.effort.solves += 1;
            match (constraint, &self.answer) {
                (Constraint::Level, _) => return Ok(Increment { motion, level: 0.0 }),
                (_, Some(answer)) if of_here => answer.clone(),
                _ => self.response(system, level)?,
            }
        };
        let (missing, rate) = match constraint {
            Constraint::Level => unreachable!("returned above"),
            Constraint::Functional { weights, target } => {
                (target - dot(weights, &increment.motion) - dot(weights, &motion), dot(weights, &response))
            }
            Constraint::Sphere { weights, load, radius } => {
                let normal: Vec<f64> = increment.motion.iter().zip(*weights).map(|(q, w)| q * w).collect();
                let excess =
                    dot(&normal, &increment.motion) + load * increment.level.powi(2) - radius * radius;
                (-0.5 * excess - dot(&normal, &motion), dot(&normal, &response) + load * increment.level)
            }
        };
        let change = missing / rate;
        if !change.is_finite() {
            return Err(EquilibriumError::Uncontrolled { step: self.step, level, rate });
        }
        for (motion, response) in motion.iter_mut().zip(&response) {
            *motion += change * response;
        }
        Ok(Increment { motion, level: change })
    }
}
