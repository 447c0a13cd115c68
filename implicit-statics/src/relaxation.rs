//! Adaptive dynamic relaxation: equilibrium by a fictitious motion, without a factor of the tangent.
//!
//! The unknowns move with a fictitious step of one and masses that keep it stable. By Gerschgorin `ω² ≤ max Σⱼ|K_ij|/M_i`, and
//! central differences are stable for ω < 2, hence `M_i = Λ/4 Σⱼ|K_ij|` with Λ a little above one \[underwood1983\].

use std::ops::ControlFlow;

use crate::error::require;
use crate::options::{Damping, RelaxationOptions};
use crate::vectors::{dot, norm};
use crate::{Equilibrium, EquilibriumError};

/// Iterations between two looks at the bounds of the model, and two reports.
const REPORT: usize = 100;
/// Damping below which a step stays an oscillation: critical damping of a frequency of two would stop it.
const MOST_DAMPING: f64 = 1.9;

/// How an equilibrium was relaxed.
#[derive(Debug, Clone, PartialEq)]
pub struct Relaxed {
    /// Load level \[–\].
    pub level: f64,
    /// Iterations: moves of the unknowns.
    pub iterations: usize,
    /// Evaluations of the forces.
    pub evaluations: usize,
    /// Row sums taken.
    pub row_sums: usize,
    /// Times the motion began again from rest.
    pub rests: usize,
    /// ‖external − internal‖ of the first state and of those told to the observer, the last included \[F\].
    pub residuals: Vec<f64>,
    /// Bound that the last one met \[F\].
    pub bound: f64,
}

/// Where a relaxation stands, told every hundred iterations.
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

/// Finds the equilibrium at level `to` from the present state, which balances level `from`.
///
/// Held values that move go from level to level within the first iterations. After an error the state is as before.
///
/// # Errors
/// [`EquilibriumError::NotRelaxed`] where the iterations do not suffice, [`EquilibriumError::Strayed`] where the motion leaves
/// the bounds of the model, [`EquilibriumError::Ended`] where the observer breaks off, [`EquilibriumError::Force`].
pub fn relax<E: Equilibrium + ?Sized>(
    system: &mut E,
    options: &RelaxationOptions,
    (from, to): (f64, f64),
    observer: impl FnMut(&Relaxing) -> ControlFlow<()>,
) -> Result<Relaxed, EquilibriumError> {
    require(options.tolerance > 0.0, "relaxation tolerance", options.tolerance, "positive")?;
    require(options.iterations > 0, "relaxation iterations", options.iterations as f64, "one at least")?;
    require(options.safety >= 1.0, "relaxation safety", options.safety, "one at least")?;
    let saved = system.save();
    let outcome = Motion::new(system, options, (from, to)).settle(system, observer);
    match &outcome {
        Ok(_) => system.accept(),
        Err(_) => system.restore(&saved),
    }
    outcome
}

/// The fictitious motion.
struct Motion<'a> {
    options: &'a RelaxationOptions,
    levels: (f64, f64),
    /// Iterations within which held values go from level to level.
    ramp: usize,
    /// M \[F/L, times the square of a step\].
    masses: Vec<f64>,
    /// The last move \[L\].
    velocity: Vec<f64>,
    /// external − internal \[F\].
    force: Vec<f64>,
    /// Work of the force on the move that follows, before that \[F L\].
    power: f64,
    internal: Vec<f64>,
    /// Whether the motion begins from rest.
    rests: bool,
    /// The force that brought prescribed values about at the start \[F\].
    driving: f64,
    counts: Counts,
}

#[derive(Default)]
struct Counts {
    evaluations: usize,
    row_sums: usize,
    rests: usize,
}

impl<'a> Motion<'a> {
    fn new<E: Equilibrium + ?Sized>(
        system: &mut E,
        options: &'a RelaxationOptions,
        levels: (f64, f64),
    ) -> Self {
        let zero = || vec![0.0; system.unknowns()];
        let mut motion = Self {
            options,
            levels,
            ramp: 0,
            masses: zero(),
            velocity: zero(),
            force: zero(),
            power: 0.0,
            internal: zero(),
            rests: true,
            driving: 0.0,
            counts: Counts::default(),
        };
        if system.held_values_move() {
            motion.ramp = options.ramp;
            system.internal(levels.0, &mut motion.internal);
            motion.driving = system.driving_force();
            motion.counts.evaluations += 1;
        }
        motion
    }

    /// The level at which held values stand.
    fn level(&self, iteration: usize) -> f64 {
        let (from, to) = self.levels;
        if iteration < self.ramp { from + (to - from) * iteration as f64 / self.ramp as f64 } else { to }
    }

    fn settle<E: Equilibrium + ?Sized>(
        mut self,
        system: &mut E,
        mut observer: impl FnMut(&Relaxing) -> ControlFlow<()>,
    ) -> Result<Relaxed, EquilibriumError> {
        let level = self.levels.1;
        let mut residuals = Vec::new();
        self.weigh(system, self.level(0));
        let mut last = f64::INFINITY;
        for iterations in 0.. {
            let (residual, scale) = self.evaluate(system, iterations)?;
            let first = residuals.first().copied().unwrap_or(residual);
            let bound = self.options.tolerance * if scale > 0.0 { scale } else { first };
            let arrived = iterations > self.ramp || (self.ramp == 0 && residual == 0.0);
            let found = residual <= bound && arrived;
            let ends = iterations == self.options.iterations;
            if found || ends || iterations.is_multiple_of(REPORT) {
                residuals.push(residual);
                if let Err(found) = system.within_bounds() {
                    return Err(EquilibriumError::Strayed { level, iterations, found });
                }
            }
            if found {
                let Counts { evaluations, row_sums, rests } = self.counts;
                return Ok(Relaxed { level, iterations, evaluations, row_sums, rests, residuals, bound });
            }
            if ends {
                return Err(EquilibriumError::NotRelaxed { level, iterations, residual, bound });
            }
            let told = Relaxing { level, iterations, residual, bound };
            if iterations.is_multiple_of(REPORT) && observer(&told).is_break() {
                return Err(EquilibriumError::Ended { level, iterations, residual });
            }
            let stiffness = self.stiffness();
            if stiffness > 4.0 && residual > last {
                self.weigh(system, self.level(iterations));
                self.rests = true;
            }
            last = residual;
            match self.options.damping {
                Damping::Kinetic => self.push(),
                Damping::Rayleigh => self.kick((2.0 * stiffness.max(0.0).sqrt()).min(MOST_DAMPING)),
            }
            self.power = dot(&self.velocity, &self.force);
            system.carry(&mut self.velocity);
        }
        unreachable!("the loop ends by its bound")
    }

    /// Norm of `external − internal` \[F\], and of the forces that it is measured by.
    fn evaluate<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        iterations: usize,
    ) -> Result<(f64, f64), EquilibriumError> {
        let level = self.level(iterations);
        system.internal(level, &mut self.internal);
        let driving = system.driving_force().max(self.driving);
        system.external(level, &mut self.force);
        self.counts.evaluations += 1;
        let scale = norm(&self.force).max(driving);
        self.force.iter_mut().zip(&self.internal).for_each(|(force, internal)| *force -= internal);
        match self.force.iter().position(|force| !force.is_finite()) {
            None => Ok((norm(&self.force), scale)),
            Some(unknown) => {
                let name = system.name_unknown(unknown);
                Err(EquilibriumError::Force { step: iterations, level, name })
            }
        }
    }

    /// Takes masses from the present stiffness, never less than they were.
    fn weigh<E: Equilibrium + ?Sized>(&mut self, system: &mut E, level: f64) {
        let mut sums = vec![0.0; self.masses.len()];
        system.row_sums(level, &mut sums);
        self.counts.row_sums += 1;
        let largest = sums.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (mass, sum) in self.masses.iter_mut().zip(sums) {
            // an unknown without stiffness has no frequency: any mass will do
            let sum = if sum > 0.0 { sum } else { largest };
            *mass = mass.max(0.25 * self.options.safety * sum);
        }
    }

    /// `v·Kv / v·Mv` along the last move, by the change of force: Rayleigh's quotient ω², at most 4/Λ while the masses suit.
    fn stiffness(&self) -> f64 {
        if self.rests {
            return 0.0;
        }
        let mass: f64 = self.velocity.iter().zip(&self.masses).map(|(v, mass)| mass * v * v).sum();
        if mass > 0.0 { (self.power - dot(&self.velocity, &self.force)) / mass } else { 0.0 }
    }

    /// One kick; where the force has turned against the motion, back to the peak of its energy, to begin again from rest.
    ///
    /// The power falls from P₀ > 0 to P₁ < 0 along the last move: the peak lies P₀/(P₀ − P₁) of the way. From the end of the
    /// move instead, fast modes that overshoot by half a kick turn the force again at once, and slow ones never get under way.
    fn push(&mut self) {
        let power = dot(&self.velocity, &self.force);
        if self.rests || power >= 0.0 {
            self.kick(0.0);
            return;
        }
        let back = (power / (power - self.power)).clamp(0.0, 1.0);
        self.velocity.iter_mut().for_each(|v| *v *= -back);
        self.rests = true;
        self.counts.rests += 1;
    }

    /// `v ← [(1 − ½c) v + M⁻¹F]/(1 + ½c)`; from rest half a kick without damping.
    fn kick(&mut self, damping: f64) {
        let (half, share) = if self.rests { (0.0, 0.5) } else { (0.5 * damping, 1.0) };
        for (i, v) in self.velocity.iter_mut().enumerate() {
            let old = if self.rests { 0.0 } else { *v };
            *v = ((1.0 - half) * old + share * self.force[i] / self.masses[i]) / (1.0 + half);
        }
        self.rests = false;
    }
}
