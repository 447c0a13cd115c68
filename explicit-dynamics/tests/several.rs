//! Several systems on one clock: two masses on a spring between them against the closed form; what is kept.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use explicit_dynamics::{
    Bounds, Dynamics, Event, Instant, Interaction, Joinable, LinearisedDynamics, March, MarchError,
    MassScaled, OutOfBounds, Several, StableStep, Step, Transient, Work, lanczos_step,
};

/// A free mass, on a spring to the ground if it has one.
struct Mass {
    mass: f64,
    ground: f64,
    x: [f64; 3],
    v: [f64; 3],
    exerted: [f64; 3],
}

impl Mass {
    fn new(mass: f64, ground: f64, x: [f64; 3]) -> Self {
        Self { mass, ground, x, v: [0.0; 3], exerted: [0.0; 3] }
    }
}

impl Dynamics for Mass {
    fn evaluate(&mut self, _: Instant) -> f64 {
        0.5 * self.ground * self.x.iter().map(|x| x * x).sum::<f64>()
    }
    fn kick(&mut self, step: &Step) -> Work {
        let mut work = Work::default();
        for k in 0..3 {
            let (internal, old) = (self.ground * self.x[k], self.v[k]);
            self.v[k] += step.kick * (self.exerted[k] - internal) / self.mass;
            let mean = 0.5 * (old + self.v[k]);
            work.kinetic += 0.5 * self.mass * mean * mean;
            work.external += step.kick * self.exerted[k] * mean;
            work.change += 0.5 * self.mass * (self.v[k] - old).powi(2);
            work.resisted += step.kick * internal * (self.v[k] - old);
        }
        work
    }
    fn drift(&mut self, step: &Step) {
        (0..3).for_each(|k| self.x[k] += step.drift() * self.v[k]);
    }
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        if self.ground == 0.0 { Ok(StableStep { dt: 1e3, holds: 9 }) } else { lanczos_step(self, safety) }
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let speed = self.v.iter().map(|v| v.abs()).fold(0.0, f64::max);
        if speed < 1e3 { Ok(()) } else { Err(OutOfBounds::Speed { particle: 0, speed, bound: 1e3 }) }
    }
    fn stop(&mut self) {
        self.v = [0.0; 3];
    }
    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl LinearisedDynamics for Mass {
    fn unknowns(&self) -> usize {
        3
    }
    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        (0..3).for_each(|k| out[k] = self.ground / self.mass * v[k]);
    }
}

impl MassScaled for Mass {
    fn out_of_balance(&self, out: &mut [f64]) {
        (0..3).for_each(|k| out[k] = (self.exerted[k] - self.ground * self.x[k]) / self.mass.sqrt());
    }
    fn rates(&self, out: &mut [f64]) {
        (0..3).for_each(|k| out[k] = self.v[k] * self.mass.sqrt());
    }
    fn displaced(&self) -> f64 {
        self.mass.sqrt() * self.x.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

impl Joinable for Mass {
    fn particles(&self) -> usize {
        1
    }
    fn places(&self, _: &[u32], out: &mut [[f64; 3]]) {
        out.fill(self.x);
    }
    fn velocities(&self, _: &[u32], out: &mut [[f64; 3]]) {
        out.fill(self.v);
    }
    fn masses(&self, particles: &[u32]) -> Vec<f64> {
        vec![self.mass; particles.len()]
    }
    fn release(&mut self) {
        self.exerted = [0.0; 3];
    }
    fn exert(&mut self, _: &[u32], forces: &[[f64; 3]]) {
        (0..3).for_each(|k| self.exerted[k] += forces[0][k]);
    }
    fn unscaled(&self, _: &[u32], v: &[f64], out: &mut [[f64; 3]]) {
        out[0] = std::array::from_fn(|k| v[k] / self.mass.sqrt());
    }
    fn add_scaled(&self, _: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        (0..3).for_each(|k| out[k] += forces[0][k] / self.mass.sqrt());
    }
}

/// `½ k |x − y|²`.
struct Tie(f64);

impl Interaction for Tie {
    fn particles(&self) -> Vec<Vec<u32>> {
        vec![vec![0], vec![0]]
    }
    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        let apart: [f64; 3] = std::array::from_fn(|k| places[1][k] - places[0][k]);
        forces[0] = apart.map(|u| self.0 * u);
        forces[1] = apart.map(|u| -self.0 * u);
        0.5 * self.0 * apart.iter().map(|u| u * u).sum::<f64>()
    }
    fn resist(&self, _: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        self.evaluate_of(motion, forces);
    }
    fn fastest(&self, masses: &[f64]) -> f64 {
        self.0 * (1.0 / masses[0] + 1.0 / masses[1])
    }
}

impl Tie {
    fn evaluate_of(&self, motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        for k in 0..3 {
            let pull = self.0 * (motion[1][k] - motion[0][k]);
            (forces[0][k], forces[1][k]) = (-pull, pull);
        }
    }
}

const K: f64 = 3.0;

fn joined() -> Several<Mass> {
    let mut masses =
        vec![Box::new(Mass::new(1.0, 0.0, [1.0, 0.5, 0.0])), Box::new(Mass::new(2.0, 0.0, [0.0; 3]))];
    masses[1].v = [0.3, 0.0, -0.2];
    Several::new(masses, vec![Box::new(Tie(K))])
}

/// ω² = k (1/m₁ + 1/m₂): the stable step is that of it, the distance its cosine to second order; momentum is kept to rounding, the energy
/// of the spring is internal and nothing is external.
#[test]
fn two_masses_on_a_spring_swing_as_they_should() {
    let omega = (1.5 * K).sqrt();
    let mut several = joined();
    let StableStep { dt, holds } = several.stable_step(1.0).unwrap();
    assert!((dt * omega / 2.0 - 1.0).abs() < 1e-5 && holds == 9, "{dt} {holds}");
    let duration = 7.0;
    let mut errors = Vec::new();
    for safety in [0.02, 0.01] {
        let mut several = joined();
        let plan = Transient { duration, record_every: duration / 4.0, damping: 0.0, safety };
        let mut march = March::start(plan, &mut several).unwrap();
        let mut last = None;
        while let Some(record) = march.next_record(&mut several).unwrap() {
            let places = [0, 1].map(|i| several.systems()[i].x[1]);
            last = Some((record, places));
        }
        let (record, places) = last.unwrap();
        // Rounding of some thousand steps.
        let missed = record.energy.external.abs().max(record.balance_error.abs());
        assert!(missed < 1e-12, "{missed:e}");
        let [one, two] = [0, 1].map(|i| &several.systems()[i]);
        for k in 0..3 {
            let momentum = one.mass * one.v[k] + two.mass * two.v[k];
            assert!((momentum - 2.0 * [0.3, 0.0, -0.2][k]).abs() < 1e-12);
        }
        // Along y they start at rest, half apart.
        let exact = 0.5 * libm::cos(omega * duration);
        errors.push((places[0] - places[1] - exact).abs());
    }
    let order = libm::log2(errors[0] / errors[1]);
    assert!((order - 2.0).abs() < 0.1, "{errors:?}");
}

/// The tangent in mass-scaled coordinates has the square of the frequency on the mode, nothing on a common motion.
#[test]
fn the_tangent_of_joined_masses_is_theirs() {
    let mut several = joined();
    let [a, b] = [1.0_f64, 2.0_f64.sqrt()];
    let mut out = [0.0; 6];
    several.apply(&[a, 0.0, 0.0, b, 0.0, 0.0], &mut out);
    assert!(out.iter().all(|f| f.abs() < 1e-14), "{out:?}");
    let mode = [0.0, b, 0.0, 0.0, -a, 0.0];
    several.apply(&mode, &mut out);
    out.iter().zip(mode).for_each(|(f, v)| assert!((f - 1.5 * K * v).abs() < 1e-14));
}

/// Beside another that is slower a system marches to the bits that it has alone; the order of both changes nothing.
#[test]
fn a_system_beside_another_marches_to_its_own_bits() {
    let one = || Box::new(Mass::new(1.0, 9.0, [1.0, 0.5, 0.0]));
    let other = || Box::new(Mass::new(1.0, 4.0, [0.1, 0.5, 0.7]));
    let marched = |systems: Vec<Box<Mass>>| {
        let mut several = Several::new(systems, Vec::new());
        let plan = Transient { duration: 5.0, record_every: 1.0, damping: 0.1, safety: 0.3 };
        let mut march = March::start(plan, &mut several).unwrap();
        while march.advance(&mut several).unwrap() != Event::End {}
        several.systems().iter().map(|system| [system.x, system.v]).collect::<Vec<_>>()
    };
    let (alone, both, turned) =
        (marched(vec![one()]), marched(vec![one(), other()]), marched(vec![other(), one()]));
    assert_eq!(alone[0], both[0]);
    assert_eq!([both[0], both[1]], [turned[1], turned[0]]);
}

/// Whoever is out of bounds is counted through.
#[test]
fn particles_are_numbered_through() {
    let mut several = joined();
    several.systems_mut()[1].v = [2e3, 0.0, 0.0];
    let found = several.within_bounds(Bounds::Motion).unwrap_err();
    assert_eq!(found, OutOfBounds::Speed { particle: 1, speed: 2e3, bound: 1e3 });
    several.stop();
    assert!(several.within_bounds(Bounds::Motion).is_ok());
}
