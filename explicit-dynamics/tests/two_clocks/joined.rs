//! The mass on a spring as one on which others act.

use explicit_dynamics::{Joinable, LinearisedDynamics, MassScaled};

use crate::model::Spring;

impl LinearisedDynamics for Spring {
    fn unknowns(&self) -> usize {
        1
    }
    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        out[0] = self.stiffness / self.mass * v[0];
    }
}

impl MassScaled for Spring {
    fn out_of_balance(&self, out: &mut [f64]) {
        out[0] = (self.exerted - self.stiffness * self.x) / self.mass.sqrt();
    }
    fn rates(&self, out: &mut [f64]) {
        out[0] = self.v * self.mass.sqrt();
    }
    fn displaced(&self) -> f64 {
        self.mass.sqrt() * self.x.abs()
    }
}

impl Joinable for Spring {
    fn particles(&self) -> usize {
        1
    }
    fn places(&self, _: &[u32], out: &mut [[f64; 3]]) {
        out.fill([self.x, 0.0, 0.0]);
    }
    fn velocities(&self, _: &[u32], out: &mut [[f64; 3]]) {
        out.fill([self.v, 0.0, 0.0]);
    }
    fn masses(&self, particles: &[u32]) -> Vec<f64> {
        vec![self.mass; particles.len()]
    }
    fn release(&mut self) {
        self.exerted = 0.0;
    }
    fn exert(&mut self, _: &[u32], forces: &[[f64; 3]]) {
        self.exerted += forces[0][0];
    }
    fn unscaled(&self, _: &[u32], v: &[f64], out: &mut [[f64; 3]]) {
        out[0] = [v[0] / self.mass.sqrt(), 0.0, 0.0];
    }
    fn add_scaled(&self, _: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        out[0] += forces[0][0] / self.mass.sqrt();
    }
}
