//! A single oscillator, of which every answer is known.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, LinearisedDynamics, MarchError, MassScaled, OutOfBounds, StableStep, Step,
    Work, lanczos_step,
};

/// `m ẍ + k x = level · load`.
pub struct Oscillator {
    pub m: f64,
    pub k: f64,
    pub load: f64,
    pub x: f64,
    pub v: f64,
    f: f64,
    external: f64,
}

impl Oscillator {
    pub fn new(x: f64, v: f64, load: f64) -> Self {
        Self { m: 2.0, k: 8.0, load, x, v, f: 0.0, external: 0.0 }
    }
}

impl Dynamics for Oscillator {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.external = at.level * self.load;
        self.f = self.external - self.k * self.x;
        0.5 * self.k * self.x * self.x
    }
    fn kick(&mut self, step: &Step) -> Work {
        let half = 0.5 * step.damping * step.kick;
        let old = self.v;
        self.v = (old * (1.0 - half) + step.kick * self.f / self.m) / (1.0 + half);
        let mean = 0.5 * (old + self.v);
        Work {
            kinetic: 0.5 * self.m * mean * mean,
            external: step.kick * self.external * mean,
            dissipated: step.kick * step.damping * self.m * mean * mean,
            change: 0.5 * self.m * (self.v - old) * (self.v - old),
            resisted: step.kick * (self.external - self.f) * (self.v - old),
        }
    }
    fn drift(&mut self, step: &Step) {
        self.x += step.drift() * self.v;
    }
    fn stop(&mut self) {
        self.v = 0.0;
    }
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let (particle, speed, bound) = (0, self.v.abs(), 1e3);
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }
    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl LinearisedDynamics for Oscillator {
    fn unknowns(&self) -> usize {
        1
    }
    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        out[0] = self.k / self.m * v[0];
    }
}

impl MassScaled for Oscillator {
    fn out_of_balance(&self, out: &mut [f64]) {
        out[0] = self.f / self.m.sqrt();
    }
    fn rates(&self, out: &mut [f64]) {
        out[0] = self.m.sqrt() * self.v;
    }
    fn displaced(&self) -> f64 {
        self.m.sqrt() * self.x.abs()
    }
}
