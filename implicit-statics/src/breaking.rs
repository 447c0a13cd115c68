//! What breaks at its limit: one critical set at a time, with a balance between.
//!
//! A body whose bonds reach their limits one after another follows its path only if each breaks before the next is asked for:
//! where several go beyond their limits in one step, all of them share what the first should have handed on. So a step that
//! takes anything beyond its limit is made shorter, to where the first reaches it; that set breaks, and the level is balanced
//! without it, again and again, until nothing is beyond its limit. Only then does the level go on. What is set free at a
//! constant level beyond what it takes to bring the broken bonds to their limits is the loss of a snap: inertia would carry it
//! off as waves, and in a body that creeps to its next balance bonds break as they reach their limits, not beyond.

use crate::newton::Constraint;
use crate::vectors::dot;
use crate::{Converged, Equilibrium, EquilibriumError, Increment, Newton};

/// Part by which a limit may be exceeded where it is met: what a secant reaches in one or two tries.
const BEYOND: f64 = 2e-3;
/// Tries at the size of a step that ends where a limit is met.
const TRIES: usize = 12;

/// A critical set that broke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Breach {
    /// Load level \[–\].
    pub level: f64,
    /// How far it was taken, one at its limit ([`Equilibrium::utilisation`]) \[–\].
    pub utilisation: f64,
    /// Force that the held values that move took as it broke ([`Equilibrium::driving_force`]) \[F\].
    pub driving_force: f64,
    /// Energy that it takes to its limit \[F L\].
    pub energy: f64,
    /// Energy set free on the way to the next balance, apart from that \[F L\].
    pub released: f64,
}

/// A set that broke, and the balance without it.
pub(crate) struct Gone {
    pub breach: Breach,
    pub converged: Converged,
    pub increment: Increment,
}

impl Newton {
    /// Breaks what the present state, which balances `level`, takes furthest beyond its limit, and balances the level without it;
    /// none, and nothing done, where all is within its limits.
    ///
    /// # Errors
    /// [`EquilibriumError::GaveWay`] where the level has no balance without it.
    pub fn give_way<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
    ) -> Result<Option<Breach>, EquilibriumError> {
        let gone = self.break_critical(system, level, &Constraint::Level)?;
        if let Some(gone) = &gone {
            self.accept(&gone.increment);
            system.commit();
        }
        Ok(gone.map(|gone| gone.breach))
    }

    /// The same under a constraint that allows no step; the state is not taken over.
    pub(crate) fn break_critical<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        constraint: &Constraint,
    ) -> Result<Option<Gone>, EquilibriumError> {
        let utilisation = system.utilisation();
        if utilisation < 1.0 {
            return Ok(None);
        }
        let driving_force = system.driving_force();
        let saved = system.save();
        let before = system.energy();
        let energy = system.break_critical();
        self.forget();
        let mut increment = Increment { motion: vec![0.0; system.unknowns()], level: 0.0 };
        let converged = match self.correct(system, level, &mut increment, constraint, false) {
            Ok(converged) => converged,
            Err(cause) => {
                self.go_back(system, &saved);
                return Err(EquilibriumError::GaveWay { step: self.step, level, cause: Box::new(cause) });
            }
        };
        let released = before - energy - system.energy() + dot(self.load(), &increment.motion);
        let breach = Breach { level, utilisation, driving_force, energy, released };
        Ok(Some(Gone { breach, converged, increment }))
    }
}

/// Where a step is to end so that the first limit is met there: a secant between a size within the limits and one beyond.
pub(crate) struct Limit {
    within: [f64; 2],
    beyond: Option<[f64; 2]>,
    tries: usize,
}

impl Limit {
    /// Where a step begins, nothing is beyond its limit.
    pub fn from<E: Equilibrium + ?Sized>(system: &mut E) -> Self {
        Self { within: [0.0, system.utilisation()], beyond: None, tries: 0 }
    }

    /// The size to try next where one that was made ends beyond a limit, or short of one that is known to be met; none where
    /// it is kept.
    pub fn other_size<E: Equilibrium + ?Sized>(&mut self, system: &mut E, size: f64) -> Option<f64> {
        let reached = system.utilisation();
        let begun_beyond = self.within[1] >= 1.0;
        if begun_beyond || self.tries == TRIES || (1.0..1.0 + BEYOND).contains(&reached) {
            return None;
        }
        if reached < 1.0 {
            self.within = [size, reached];
        } else {
            self.beyond = Some([size, reached]);
        }
        let [[near, low], [far, high]] = [self.within, self.beyond?];
        self.tries += 1;
        let secant = near + (far - near) * (1.0 + 0.5 * BEYOND - low) / (high - low);
        // Where the set that is critical changes, or the state leaps, a secant may creep from one side.
        Some(if self.tries > TRIES / 2 { 0.5 * (near + far) } else { secant })
    }

    /// Whether the step was made shorter.
    pub fn cuts(&self) -> bool {
        self.tries > 0
    }
}

/// The share of a step at which the first limit is met, were it met in proportion: from one utilisation, within the limits, to
/// another beyond. None where that is close to its limit already, or nothing is gained.
pub(crate) fn nearer(from: f64, to: f64) -> Option<f64> {
    let share = (1.0 + 0.5 * BEYOND - from) / (to - from);
    (from < 1.0 && to >= 1.0 + BEYOND).then_some(share)
}
