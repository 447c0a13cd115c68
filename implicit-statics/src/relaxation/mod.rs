//! Adaptive dynamic relaxation: equilibrium by a fictitious motion, without a factor of the tangent.
//!
//! The unknowns move with a fictitious step of one and masses that keep it stable. By Gerschgorin `ω² ≤ max Σⱼ|K_ij|/M_i`, and
//! central differences are stable for ω < 2, hence `M_i = Λ/4 Σⱼ|K_ij|` with Λ a little above one \[underwood1983\].
//! The slowest modes are made faster ([`slow`]), and a level starts where the levels before point ([`past`]).

mod deflation;
mod motion;
mod predictor;
mod snap_energy;

use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use crate::breaking::{Breach, nearer};
use crate::error::require;
use crate::options::RelaxationOptions;
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError};
use deflation::SlowModes;
use motion::Motion;
use predictor::Past;
use snap_energy::Energies;
pub use snap_energy::SnapEnergy;

/// Tries at the level at which a first limit is met.
const TRIES: usize = 6;

/// How an equilibrium was relaxed.
#[derive(Debug, Clone, PartialEq)]
pub struct Relaxed {
    /// Load level \[–\].
    pub level: f64,
    /// Iterations: moves of the unknowns.
    pub iterations: usize,
    /// Evaluations of the forces, those that found the slow modes among them.
    pub evaluations: usize,
    /// Row sums taken.
    pub row_sums: usize,
    /// Times the motion began again from rest.
    pub rests: usize,
    /// ‖external − internal‖ of the first state and of those given to the observer, the last included \[F\].
    pub residuals: Vec<f64>,
    /// Bound that the last one met \[F\].
    pub bound: f64,
    /// What the relative bound is relative to: loads or the forces that bring prescribed values about, without either the first residual
    /// \[F\].
    pub load: f64,
    /// Energy set free between the levels: a snap, where it is beyond what a path leaves over. Where something broke it is that of
    /// the way from there on.
    pub release: SnapEnergy,
    /// What broke on the way, set by set.
    pub breaches: Vec<Breach>,
}

/// Where a relaxation stands, reported every hundred iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxing {
    /// Load level that is sought \[–\].
    pub level: f64,
    /// Iterations so far.
    pub iterations: usize,
    /// ‖external − internal‖ \[F\].
    pub residual: f64,
    /// What it must fall to \[F\].
    pub bound: f64,
}

/// Finds the equilibrium at level `to` from the present state, which balances level `from`; for more levels than one,
/// [`Relaxation`] is faster.
///
/// # Errors
/// Those of [`Relaxation::to_level`], [`EquilibriumError::Option`].
pub fn relax<E: Equilibrium + ?Sized>(
    system: &mut E,
    options: &RelaxationOptions,
    levels: (f64, f64),
    observer: impl FnMut(&Relaxing) -> ControlFlow<()>,
) -> Result<Relaxed, EquilibriumError> {
    Relaxation::new(options)?.to_level(system, levels, observer)
}

/// Relaxation from level to level: masses, slow modes and the course of the path serve the levels that follow.
#[derive(Debug, Clone)]
pub struct Relaxation {
    options: RelaxationOptions,
    memory: RelaxationMemory,
}

/// What a relaxation knows between two levels: with it and the state of its system it goes on to the same bits.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RelaxationMemory {
    /// M; empty before the first level \[F/L, times the square of a step\].
    masses: Vec<f64>,
    slow: SlowModes,
    past: Past,
    energies: Energies,
    /// Largest component of a way from level to level so far \[L\].
    reach: f64,
}

impl Relaxation {
    /// A relaxation that knows nothing of its system yet.
    ///
    /// # Errors
    /// [`EquilibriumError::Option`] for options out of bounds.
    pub fn new(options: &RelaxationOptions) -> Result<Self, EquilibriumError> {
        require(options.tolerance > 0.0, "relaxation tolerance", options.tolerance, "positive")?;
        require(options.force >= 0.0, "relaxation force", options.force, "zero or more")?;
        require(options.iterations > 0, "relaxation iterations", options.iterations as f64, "one at least")?;
        require(options.safety >= 1.0, "relaxation safety", options.safety, "one at least")?;
        Ok(Self { options: options.clone(), memory: RelaxationMemory::default() })
    }

    /// A relaxation that goes on where another stood between two levels, with its system as it was there.
    ///
    /// # Errors
    /// Those of [`Relaxation::new`]; [`EquilibriumError::Length`] for the memory of another system.
    pub fn resume<E: Equilibrium + ?Sized>(
        options: &RelaxationOptions,
        memory: RelaxationMemory,
        system: &E,
    ) -> Result<Self, EquilibriumError> {
        let (unknowns, state) = (system.unknowns(), system.save().len());
        let masses = Some(memory.masses.len()).filter(|&length| length > 0);
        let vectors = masses.into_iter().chain(memory.slow.lengths()).map(|length| (length, unknowns));
        for (length, expected) in vectors.chain(memory.past.lengths().map(|length| (length, state))) {
            if length != expected {
                return Err(EquilibriumError::Length { name: "memory of a relaxation", length, expected });
            }
        }
        Ok(Self { memory, ..Self::new(options)? })
    }

    /// What it knows, to go on from.
    pub fn memory(&self) -> &RelaxationMemory {
        &self.memory
    }

    /// Finds the equilibrium at level `to` from the present state, which balances level `from`. What reaches its limit on the way
    /// breaks, the critical set first, with a balance between.
    ///
    /// It sets out from where the levels before point, if there are two or more, and once more from the present state where
    /// that leads astray. Held values that move go along, or from level to level within the first iterations. After an error the
    /// state is as before.
    ///
    /// # Errors
    /// [`EquilibriumError::NotRelaxed`] where the iterations do not suffice, [`EquilibriumError::Strayed`] where the motion leaves
    /// the bounds of the model, [`EquilibriumError::Ended`] where the observer breaks off, [`EquilibriumError::Force`].
    pub fn to_level<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        (from, to): (f64, f64),
        mut observer: impl FnMut(&Relaxing) -> ControlFlow<()>,
    ) -> Result<Relaxed, EquilibriumError> {
        let mut level = from;
        let mut sum: Option<Relaxed> = None;
        loop {
            let start = system.utilisation();
            let saved = system.save();
            let mut relaxed = self.balance(system, (level, to), &mut observer)?;
            let (mut at, mut tries) = (to, 0);
            while let Some(share) = nearer(start, system.utilisation()).filter(|_| tries < TRIES) {
                // Back to where the first limit is met.
                system.restore(&saved);
                at = level + share * (at - level);
                tries += 1;
                add(&mut sum, relaxed);
                relaxed = self.balance(system, (level, at), &mut observer)?;
            }
            system.commit();
            add(&mut sum, relaxed);
            let breaches = self.give_way(system, at, &mut sum, &mut observer)?;
            if let Some(sum) = &mut sum {
                sum.breaches.extend(breaches);
            }
            if at == to {
                return Ok(sum.unwrap_or_else(|| unreachable!("a level was balanced")));
            }
            level = at;
        }
    }

    /// Breaks what is beyond its limit, set by set, with a balance of the same level between.
    fn give_way<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        sum: &mut Option<Relaxed>,
        observer: &mut impl FnMut(&Relaxing) -> ControlFlow<()>,
    ) -> Result<Vec<Breach>, EquilibriumError> {
        let mut out = Vec::new();
        loop {
            let utilisation = system.utilisation();
            if utilisation < 1.0 {
                return Ok(out);
            }
            let (driving_force, start, before) = (system.driving_force(), system.save(), system.energy());
            let energy = system.break_critical();
            self.memory.past.distrust();
            let settled = Motion::new(self, system, (level, level)).settle(system, observer);
            let (relaxed, way) = settled.map_err(|cause| {
                system.restore(&start);
                match cause {
                    ended @ EquilibriumError::Ended { .. } => ended,
                    cause => EquilibriumError::GaveWay { step: out.len(), level, cause: Box::new(cause) },
                }
            })?;
            system.commit();
            let mut load = vec![0.0; way.len()];
            system.external(level, &mut load);
            let released = before - energy - system.energy() + dot(&load, &way);
            out.push(Breach { level, utilisation, driving_force, energy, released });
            add(sum, relaxed);
        }
    }

    /// Finds one equilibrium; nothing breaks, and the state is not yet kept.
    fn balance<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        (from, to): (f64, f64),
        mut observer: impl FnMut(&Relaxing) -> ControlFlow<()>,
    ) -> Result<Relaxed, EquilibriumError> {
        let start = system.save();
        let known = self.memory.past.stands_at(from, &start);
        self.memory.energies.stands_at(system, known, (from, to));
        let mut outcome = Motion::new(self, system, (from, to)).settle(system, &mut observer);
        if self.memory.past.points_on()
            && matches!(outcome, Err(EquilibriumError::Strayed { .. } | EquilibriumError::Force { .. }))
        {
            system.restore(&start);
            self.memory.past.distrust();
            self.memory.slow = SlowModes::default();
            outcome = Motion::new(self, system, (from, to)).settle(system, &mut observer);
        }
        match outcome {
            Ok((mut relaxed, way)) => {
                relaxed.release = self.memory.energies.found(system, (from, to), &start, way);
                self.memory.past.found(system, to, &self.memory.masses);
                Ok(relaxed)
            }
            Err(error) => {
                system.restore(&start);
                Err(error)
            }
        }
    }
}

/// Adds what one more balance took; all else is that of the last.
fn add(sum: &mut Option<Relaxed>, more: Relaxed) {
    let Some(sum) = sum else {
        *sum = Some(more);
        return;
    };
    sum.iterations += more.iterations;
    sum.evaluations += more.evaluations;
    sum.row_sums += more.row_sums;
    sum.rests += more.rests;
    sum.residuals.extend(more.residuals);
    (sum.level, sum.bound, sum.load, sum.release) = (more.level, more.bound, more.load, more.release);
}
