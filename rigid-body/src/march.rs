//! A rigid body in time: forces, kick, drift, its steps; in mass-scaled coordinates its tangent applied to a vector.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, LinearisedDynamics, MarchError, MassScaled, OutOfBounds, StableStep, Step,
    Work,
};
use nalgebra::Vector6;
use sph_core::{Vec3, rotated};

use crate::body::{Motion, RigidBody};
use crate::conditions::{RotationHold, Wrench};
use crate::forces::stacked;

/// Turn of a body in a step, at most \[rad\]: the error of the rule over a turn is a twelfth of its square.
const TURN: f64 = 0.02;
/// Rounds of the midpoint rule: each gains a factor of the turn in a step, whatever steps are chosen.
const ROUNDS: usize = 40;
/// Steps for which the bound of its springs holds: as for any spectrum that changes slowly.
const HOLDS: u64 = 5000;

impl Dynamics for RigidBody {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.evaluate_at(at)
    }

    fn kick(&mut self, step: &Step) -> Work {
        let kick = step.kick;
        let push = self.external - self.internal;
        let [old, old_spin] = [self.motion.velocity, self.motion.spin];
        let [new, new_spin] = self.kicked(step, &push);
        let supported = self.is_supported();
        (self.motion.velocity, self.motion.spin) = (new, new_spin);
        let [mean, mean_spin] = [(old + new) * 0.5, self.spin_of(&((old_spin + new_spin) * 0.5))];
        let [change, change_spin] = [new - old, self.spin_of(&(new_spin - old_spin))];
        let energy =
            |v: &Vec3, w: &Vec3| 0.5 * (self.mass * v.norm_squared() + w.dot(&self.inertia_times(w)));
        let kinetic = energy(&mean, &mean_spin);
        let (internal, external) = (self.internal, self.external);
        let mut work = Work {
            kinetic,
            external: kick * (external.force.dot(&mean) + external.moment.dot(&mean_spin)),
            dissipated: 2.0 * kick * step.damping * kinetic,
            change: energy(&change, &change_spin),
            resisted: kick * (internal.force.dot(&change) + internal.moment.dot(&change_spin)),
        };
        if supported {
            // What the balance of the body lacks, its supports exert.
            let lacking = |change: Vec3, mean: Vec3, push: Vec3| change + (mean * step.damping - push) * kick;
            let impulse = Wrench {
                force: lacking(change * self.mass, mean * self.mass, push.force),
                moment: lacking(new_spin - old_spin, (old_spin + new_spin) * 0.5, push.moment),
            };
            if kick > 0.0 {
                self.borne = Wrench { force: impulse.force / kick, moment: impulse.moment / kick };
            }
            if self.hold.moves() || kick == 0.0 {
                work.external += impulse.force.dot(&mean) + impulse.moment.dot(&mean_spin);
            }
        }
        work
    }

    fn drift(&mut self, step: &Step) {
        self.motion = self.drifted(self.motion, step.drift());
    }

    /// That of its springs on the masses of their particles, of what its wet points resist, its present turns and the longest step.
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        let particles: Vec<u32> = self.springs.iter().map(|spring| spring.particle).collect();
        let mut once = particles.clone();
        once.sort_unstable();
        once.dedup();
        let masses = self.masses_with(&once);
        let mut sums = vec![0.0; once.len()];
        for spring in &self.springs {
            sums[once.partition_point(|&other| other < spring.particle)] += spring.stiffness;
        }
        let square = sums.iter().zip(&masses).map(|(sum, mass)| sum / mass).fold(0.0, f64::max);
        let dt = self.turning_step().min(self.longest).min(2.0 * safety / square.sqrt()).min(self.wet_step());
        Ok(StableStep { dt, holds: HOLDS })
    }

    fn shortened(&mut self, stable: f64, _safety: f64) -> f64 {
        stable.min(self.turning_step())
    }

    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let speed = self.motion.velocity.norm() + self.motion.spin.norm();
        let (particle, bound) = (self.centre() as usize, f64::MAX);
        match speed.is_finite() {
            true => Ok(()),
            false => Err(OutOfBounds::Speed { particle, speed: f64::INFINITY, bound }),
        }
    }

    fn stop(&mut self) {
        (self.motion.velocity, self.motion.spin) = (Vec3::zeros(), Vec3::zeros());
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl RigidBody {
    fn is_supported(&self) -> bool {
        !self.hold.held.basis().is_empty() || self.hold.rotation != RotationHold::Free
    }

    /// Velocity and moment of momentum behind a kick, of what pushes it, its supports put in.
    pub(crate) fn kicked(&self, step: &Step, push: &Wrench) -> [Vec3; 2] {
        let (kick, decay) = (step.kick, step.decay());
        let kicked = |old: &Vec3, push: &Vec3| (old * decay.before + push * kick) * decay.after;
        let mut new = kicked(&self.motion.velocity, &(push.force / self.mass));
        let mut new_spin = self.resisted(&kicked(&self.motion.spin, &push.moment));
        if self.is_supported() {
            new = self.hold.free_part(&new);
            self.prescribe(step, &mut new, &mut new_spin);
        }
        [new, new_spin]
    }

    /// A motion as the drift of a span leaves it.
    pub(crate) fn drifted(&self, mut motion: Motion, dt: f64) -> Motion {
        motion.pole += motion.velocity * dt;
        let axes = motion.turn.axes();
        match self.hold.rotation {
            RotationHold::Free => {
                let theta = self.middle_spin(&axes.tr_mul(&motion.spin), dt) * dt;
                motion.turned += axes * theta;
                motion.turn = motion.turn.turned_about_own(&theta);
            }
            _ => {
                let spin = axes * axes.tr_mul(&motion.spin).component_div(&self.moments);
                let theta = spin * dt;
                motion.turned += theta;
                motion.turn = motion.turn.turned(&theta);
                let axes = motion.turn.axes();
                motion.spin = axes * self.moments.component_mul(&axes.tr_mul(&spin));
            }
        }
        motion
    }

    /// Takes up an impulse at once, but for what supports hold.
    pub(crate) fn strike(&mut self, impulse: &Wrench) {
        self.motion.velocity += self.hold.free_part(&impulse.force) / self.mass;
        self.motion.spin += self.resisted(&impulse.moment);
    }

    /// The step that turns it by a fiftieth of a radian: by its moment of momentum over the least inertia, which a free motion keeps \[T\].
    fn turning_step(&self) -> f64 {
        TURN * self.moments.min() / self.motion.spin.norm()
    }

    /// The step in which sound takes its motion away at most: that of `ρ₀c₀A` of the points next to its faces on the masses that move with them. Twice as
    /// long a one would be stable \[T\].
    fn wet_step(&self) -> f64 {
        let Some(surface) = &self.wetted else { return f64::INFINITY };
        let (arms, resistance) = surface.at_faces();
        let least = self.masses_at(&arms).into_iter().fold(f64::INFINITY, f64::min);
        least / resistance
    }

    /// Puts in what supports prescribe: velocities that bring the body where they have it after the drift.
    fn prescribe(&self, step: &Step, velocity: &mut Vec3, spin: &mut Vec3) {
        let dt = step.drift();
        if !self.hold.moves() || dt == 0.0 {
            return;
        }
        let target = self.rest[self.centre() as usize] + self.hold.displacement(step.to);
        let missing = (target - self.motion.pole) / dt;
        *velocity += missing - self.hold.free_part(&missing);
        let turn = |at| self.hold.rotation_at(at);
        if let (Some(from), Some(to)) = (turn(step.from), turn(step.to)) {
            *spin = self.inertia_times(&((to - from) / dt));
        }
    }

    /// Spin in principal axes by which a free motion of this moment of momentum in them turns over a step: `Ω½ = J₀⁻¹ exp(−½Δt Ω½) Qᵀ L`.
    fn middle_spin(&self, momentum: &Vec3, dt: f64) -> Vec3 {
        let mut middle = momentum.component_div(&self.moments);
        for _ in 0..ROUNDS {
            let next = rotated(momentum, &(middle * (-0.5 * dt))).component_div(&self.moments);
            let settled = next == middle;
            middle = next;
            if settled {
                break;
            }
        }
        middle
    }

    /// A motion of mass-scaled coordinates, in which turns go by principal axes: `M^{-½} v` without what supports hold.
    pub(crate) fn unscaled_motion(&self, v: &[f64]) -> [Vec3; 2] {
        let place = self.hold.free_part(&Vec3::new(v[0], v[1], v[2])) / self.mass.sqrt();
        let turn = self.free_scaled(Vec3::new(v[3], v[4], v[5])).component_div(&self.moments.map(f64::sqrt));
        [place, self.motion.turn.axes() * turn]
    }

    /// Force and moment in mass-scaled coordinates: `M^{-½} f` without what supports hold.
    pub(crate) fn scaled_wrench(&self, wrench: &Wrench) -> Vector6<f64> {
        let place = self.hold.free_part(&wrench.force) / self.mass.sqrt();
        let own = self.motion.turn.axes().tr_mul(&wrench.moment);
        stacked(&place, &self.free_scaled(own.component_div(&self.moments.map(f64::sqrt))))
    }

    /// How far it would give way to a wrench of this size by itself, without supports: the square of what that is in mass-scaled motions.
    pub(crate) fn yields_to(&self, wrench: &Wrench) -> f64 {
        let own = self.motion.turn.axes().tr_mul(&wrench.moment);
        wrench.force.norm_squared() / self.mass + own.component_mul(&own).component_div(&self.moments).sum()
    }

    /// What supports leave of a mass-scaled turn.
    fn free_scaled(&self, turn: Vec3) -> Vec3 {
        match self.hold.rotation {
            RotationHold::Free => turn,
            RotationHold::About(axis) => {
                let own = self.motion.turn.axes().tr_mul(&axis);
                let along = self.moments.map(f64::sqrt).component_mul(&own).normalize();
                along * along.dot(&turn)
            }
            RotationHold::Fixed => Vec3::zeros(),
        }
    }
}

impl LinearisedDynamics for RigidBody {
    fn unknowns(&self) -> usize {
        6
    }

    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        let [place, turn] = self.unscaled_motion(v);
        let forces = self.stiffness() * stacked(&place, &turn);
        let [force, moment] = [0, 3].map(|k| Vec3::new(forces[k], forces[k + 1], forces[k + 2]));
        out.copy_from_slice(self.scaled_wrench(&Wrench { force, moment }).as_slice());
    }
}

impl MassScaled for RigidBody {
    fn out_of_balance(&self, out: &mut [f64]) {
        out.copy_from_slice(self.scaled_wrench(&(self.external - self.internal)).as_slice());
    }

    fn rates(&self, out: &mut [f64]) {
        let own =
            self.motion.turn.axes().tr_mul(&self.motion.spin).component_div(&self.moments.map(f64::sqrt));
        out.copy_from_slice(stacked(&(self.motion.velocity * self.mass.sqrt()), &own).as_slice());
    }

    fn displaced(&self) -> f64 {
        let moved = self.motion.pole - self.rest[self.centre() as usize];
        let turned = self.motion.turned;
        (self.mass * moved.norm_squared() + turned.dot(&self.inertia_times(&turned))).sqrt()
    }
}
