//! The fictitious motion to one level.

use std::ops::ControlFlow;

use super::{Relaxation, RelaxationMemory, Relaxed, Relaxing, SnapEnergy};
use crate::newton::ROUNDING;
use crate::options::{Damping, RelaxationOptions};
use crate::vectors::{dot, norm};
use crate::{Equilibrium, EquilibriumError};

/// Iterations between two looks at the bounds of the model, and two reports.
const REPORT: usize = 100;
/// Iterations between two searches for the slow modes, and between two moves that are taken for them.
const SEARCH: usize = 100;
const SAMPLE: usize = 25;
/// Perturbation of a difference of forces, as a part of the way between two levels.
const PERTURBATION: f64 = 1e-4;
/// Damping below which a step stays an oscillation: critical damping of a frequency of two would stop it.
const MOST_DAMPING: f64 = 1.9;

pub(super) struct Motion<'a> {
    options: &'a RelaxationOptions,
    memory: &'a mut RelaxationMemory,
    levels: (f64, f64),
    /// Iterations within which held values go from level to level.
    ramp: usize,
    /// The last move \[L\].
    velocity: Vec<f64>,
    /// external − internal \[F\].
    force: Vec<f64>,
    /// M̃⁻¹ times it \[L\].
    acceleration: Vec<f64>,
    /// Work of the force on the move that follows, before that \[F L\].
    power: f64,
    internal: Vec<f64>,
    /// Sum of the moves \[L\].
    way: Vec<f64>,
    /// Whether the motion begins from rest.
    rests: bool,
    /// The force that brought prescribed values about at the start \[F\].
    driving: f64,
    /// Residual that is the rounding of what heat exerts \[F\].
    rounding: f64,
    counts: Counts,
}

#[derive(Default)]
struct Counts {
    evaluations: usize,
    row_sums: usize,
    rests: usize,
}

impl<'a> Motion<'a> {
    /// Puts the system where the levels before point.
    pub fn new<E: Equilibrium + ?Sized>(
        relaxation: &'a mut Relaxation,
        system: &mut E,
        levels: (f64, f64),
    ) -> Self {
        let zero = || vec![0.0; system.unknowns()];
        let mut motion = Self {
            options: &relaxation.options,
            memory: &mut relaxation.memory,
            levels,
            ramp: 0,
            velocity: zero(),
            force: zero(),
            acceleration: zero(),
            power: 0.0,
            internal: zero(),
            way: zero(),
            rests: true,
            driving: 0.0,
            rounding: 0.0,
            counts: Counts::default(),
        };
        if system.has_moving_supports() || system.has_moving_tools() {
            motion.ramp = if levels.0 == levels.1 { 0 } else { motion.options.ramp };
            system.internal(levels.0, &mut motion.internal);
            motion.driving = system.driving_force();
            motion.counts.evaluations += 1;
        }
        // What heat drives is known by its rate: the loads are none of it.
        motion.rounding = ROUNDING * system.stress_forces(levels.1);
        if motion.rounding > 0.0 {
            let mut rate = vec![0.0; system.unknowns()];
            system.load_rate(levels.1, &mut rate);
            motion.driving = motion.driving.max(levels.1.abs() * norm(&rate));
        }
        match motion.memory.past.predict(system, levels.1) {
            Some(way) if system.reach(&way) == 1.0 => {
                system.update(&way);
                (motion.way, motion.ramp) = (way, 0);
            }
            // It would leap through what it may touch.
            Some(_) => motion.memory.past.distrust(),
            None => {}
        }
        motion
    }

    /// The level at which held values stand.
    fn level(&self, iteration: usize) -> f64 {
        let (from, to) = self.levels;
        if iteration < self.ramp { from + (to - from) * iteration as f64 / self.ramp as f64 } else { to }
    }

    /// Moves until the level balances; gives the sum of the moves as well \[L\].
    pub fn settle<E: Equilibrium + ?Sized>(
        mut self,
        system: &mut E,
        observer: &mut impl FnMut(&Relaxing) -> ControlFlow<()>,
    ) -> Result<(Relaxed, Vec<f64>), EquilibriumError> {
        let (level, allowed) = (self.levels.1, self.options.iterations);
        let mut residuals = Vec::new();
        if self.memory.masses.is_empty() {
            self.memory.masses = vec![0.0; self.velocity.len()];
            self.weigh(system, self.level(0));
        }
        let mut last = f64::INFINITY;
        for iterations in 0.. {
            let (residual, scale) = self.evaluate(system, iterations)?;
            let first = residuals.first().copied().unwrap_or(residual);
            let load = if scale > 0.0 { scale } else { first };
            let bound = (self.options.tolerance * load).max(self.options.force).max(self.rounding);
            let at_start = residual <= self.rounding || self.memory.past.points_on();
            let arrived = iterations > self.ramp || (self.ramp == 0 && at_start);
            let found = residual <= bound && arrived;
            let ends = iterations == allowed;
            if found || ends || iterations.is_multiple_of(REPORT) {
                residuals.push(residual);
                if let Err(found) = system.within_bounds() {
                    return Err(EquilibriumError::Strayed { level, iterations, found });
                }
            }
            if found {
                let Counts { evaluations, row_sums, rests } = self.counts;
                let release = SnapEnergy::default();
                let relaxed = Relaxed {
                    level,
                    iterations,
                    evaluations,
                    row_sums,
                    rests,
                    residuals,
                    bound,
                    load,
                    release,
                    breaches: Vec::new(),
                };
                return Ok((relaxed, self.way));
            }
            if ends {
                return Err(EquilibriumError::NotRelaxed { level, iterations, residual, bound });
            }
            let reported = Relaxing { level, iterations, residual, bound };
            if iterations.is_multiple_of(REPORT) && observer(&reported).is_break() {
                return Err(EquilibriumError::Ended { level, iterations, residual });
            }
            let stiffness = self.stiffness();
            if stiffness > 4.0 && residual > last {
                self.weigh(system, self.level(iterations));
                self.rests = true;
            }
            last = residual;
            self.learn(system, iterations);
            match self.options.damping {
                Damping::Kinetic => self.push(),
                Damping::Rayleigh => self.kick((2.0 * stiffness.max(0.0).sqrt()).min(MOST_DAMPING)),
            }
            self.power = dot(&self.velocity, &self.force);
            self.way.iter_mut().zip(&self.velocity).for_each(|(way, v)| *way += v);
            system.transport(&mut self.velocity);
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

    /// Takes masses from the present stiffness, never less than they were; slow modes were those of other masses.
    fn weigh<E: Equilibrium + ?Sized>(&mut self, system: &mut E, level: f64) {
        let mut sums = vec![0.0; self.memory.masses.len()];
        system.row_sums(level, &mut sums);
        self.counts.row_sums += 1;
        let largest = sums.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (mass, sum) in self.memory.masses.iter_mut().zip(sums) {
            // an unknown without stiffness has no frequency: any mass will do
            let sum = if sum > 0.0 { sum } else { largest };
            *mass = mass.max(0.25 * self.options.safety * sum);
        }
        self.memory.slow = Default::default();
    }

    /// Takes moves to find slow modes in, and looks for them: at once where some are known, then every so many iterations.
    fn learn<E: Equilibrium + ?Sized>(&mut self, system: &mut E, iterations: usize) {
        let Some(since) = iterations.checked_sub(self.ramp) else { return };
        if since > 0 && since.is_multiple_of(SAMPLE) {
            self.memory.slow.sample(&self.velocity);
        }
        if since.is_multiple_of(SEARCH) && (since > 0 || self.memory.slow.known()) {
            self.search(system, self.level(iterations));
            self.rests = true;
        }
    }

    /// Finds the slow modes in the present state, whose force is known: a difference of forces for each.
    fn search<E: Equilibrium + ?Sized>(&mut self, system: &mut E, level: f64) {
        let largest = |v: &[f64]| v.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let Self { memory, force, acceleration: displaced, velocity: step, internal, way, counts, .. } = self;
        memory.reach = memory.reach.max(largest(way));
        let (reach, here) = (PERTURBATION * memory.reach, system.save());
        memory.slow.renew(&memory.masses, |motion, image| {
            let size = reach / largest(motion);
            step.iter_mut().zip(motion).for_each(|(step, motion)| *step = size * motion);
            system.update(step);
            system.internal(level, internal);
            system.external(level, displaced);
            system.restore(&here);
            counts.evaluations += 1;
            for (i, image) in image.iter_mut().enumerate() {
                *image = (force[i] - (displaced[i] - internal[i])) / size;
            }
        });
    }

    /// `v·Kv / v·M̃v` along the last move, by the change of force: Rayleigh's quotient ω², at most 4 while the masses suit.
    fn stiffness(&self) -> f64 {
        if self.rests {
            return 0.0;
        }
        let masses = &self.memory.masses;
        let heavy: f64 = self.velocity.iter().zip(masses).map(|(v, mass)| mass * v * v).sum();
        let mass = heavy - self.memory.slow.lightness();
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

    /// `v ← [(1 − ½c) v + M̃⁻¹F]/(1 + ½c)`; from rest half a kick without damping.
    fn kick(&mut self, damping: f64) {
        let half = 0.5 * damping;
        let (keeps, takes) =
            if self.rests { (0.0, 0.5) } else { ((1.0 - half) / (1.0 + half), 1.0 / (1.0 + half)) };
        let pairs = self.force.iter().zip(&self.memory.masses);
        self.acceleration.iter_mut().zip(pairs).for_each(|(a, (force, mass))| *a = force / mass);
        self.memory.slow.deflate(&self.force, &mut self.acceleration, (keeps, takes));
        for (v, a) in self.velocity.iter_mut().zip(&self.acceleration) {
            *v = keeps * *v + takes * a;
        }
        self.rests = false;
    }
}
