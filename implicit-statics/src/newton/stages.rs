//! Corrections in stages: where stiff contact would let go of one row of vertices an iteration, it is softened first.

use super::{Constraint, Converged, Newton};
use crate::options::NewtonOptions;
use crate::{Equilibrium, EquilibriumError, Front, Increment};

/// The iteration in which what touches must no longer change, nor a step be shortened; else contact is softened. Stages take as many, so that
/// together they are never much more than twice what the better of both takes.
const SETTLED: usize = 20;
/// Depth of a start over the distance at which faces touch beyond which contact is softened at once: there the barrier stands.
const DEEP: f64 = 0.5;
/// Tolerance of a stage: looser, the next one walks what this one left.
const OF_STAGE: f64 = 1e-7;
/// Iterations of a stage: the next one goes on from what it has come to.
const IN_STAGE: usize = 8;

/// A part of a correction.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Phase {
    /// By the contact's own stiffness, as long as what touches settles before stages would.
    Watched,
    /// By softened contact.
    Stage,
    /// By its own stiffness, to balance.
    Last,
}

impl Phase {
    /// Bound of the residual, relative.
    pub fn tolerance(self, options: &NewtonOptions) -> f64 {
        if self == Self::Stage { OF_STAGE.max(options.tolerance) } else { options.tolerance }
    }

    /// Iterations allowed.
    pub fn iterations(self, options: &NewtonOptions) -> usize {
        if self == Self::Stage { IN_STAGE.min(options.iterations) } else { options.iterations }
    }

    /// Whether contact had better be softened, by what touches after so many iterations of those allowed, by what did before, and by the share of
    /// the last motion that was made.
    pub fn walks(
        self,
        [iterations, allowed]: [usize; 2],
        front: impl FnOnce() -> Front,
        seen: &mut u64,
        share: f64,
    ) -> bool {
        let settled = SETTLED.min(allowed);
        if self != Self::Watched || iterations > 0 && iterations + 1 < settled {
            return false;
        }
        let Front { set, depth } = front();
        let before = std::mem::replace(seen, set);
        if iterations == 0 { depth > DEEP } else { iterations >= settled && (before != set || share < 1.0) }
    }
}

/// How a part of a correction ended.
pub(super) enum Iterated {
    /// In balance.
    Balanced(Converged),
    /// Before, with the residuals of every iterate \[F\].
    Cut(Vec<f64>),
}

impl Newton {
    /// What is said where all iterations have led to no balance.
    pub(super) fn not_converged(&self, level: f64, bound: f64, residuals: Vec<f64>) -> EquilibriumError {
        let (iterations, residual) = (residuals.len() - 1, residuals.last().copied().unwrap_or_default());
        EquilibriumError::NotConverged { step: self.step, level, iterations, residual, bound, residuals }
    }

    /// Iterates to equilibrium and constraint from the present (predicted) state at `level`; `increment` holds
    /// what was predicted since the last equilibrium and takes up the corrections. The state is not put back.
    ///
    /// Where what touches still changes in the twentieth iteration, contact is softened, and stiffened stage by stage up to its own stiffness
    /// ([`Equilibrium::stages_of_contact`]): the balance is that of the latter.
    pub(crate) fn correct<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        mut level: f64,
        increment: &mut Increment,
        constraint: &Constraint,
        bent: bool,
    ) -> Result<Converged, EquilibriumError> {
        self.most_negative = 0;
        let stages = system.stages_of_contact();
        let first = if stages.is_empty() { Phase::Last } else { Phase::Watched };
        let mut residuals = match self.iterate(system, &mut level, increment, (constraint, bent), first)? {
            Iterated::Balanced(converged) => return Ok(converged),
            Iterated::Cut(residuals) => residuals,
        };
        let mut made = residuals.len() - 1;
        for length in stages {
            let begun = (system.save(), increment.clone(), level);
            system.soften_contact(Some(length));
            self.has_moved();
            match self.iterate(system, &mut level, increment, (constraint, false), Phase::Stage) {
                Ok(Iterated::Balanced(Converged { residuals: stage, .. }) | Iterated::Cut(stage)) => {
                    made += stage.len() - 1;
                    residuals.extend(stage);
                }
                Err(_) => {
                    self.go_back(system, &begun.0);
                    (*increment, level) = (begun.1, begun.2);
                }
            }
        }
        system.soften_contact(None);
        self.has_moved();
        match self.iterate(system, &mut level, increment, (constraint, false), Phase::Last)? {
            Iterated::Balanced(converged) => {
                residuals.extend(&converged.residuals);
                Ok(Converged { iterations: made + converged.iterations, residuals, ..converged })
            }
            Iterated::Cut(_) => unreachable!("the last part ends in balance or fails"),
        }
    }
}
