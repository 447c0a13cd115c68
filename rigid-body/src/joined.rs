//! A rigid body as one of several that are marched together.

use explicit_dynamics::Joinable;
use sph_core::Vec3;

use crate::body::RigidBody;
use crate::conditions::Wrench;

impl Joinable for RigidBody {
    fn particles(&self) -> usize {
        self.len()
    }

    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        let axes = self.motion.turn.axes();
        for (out, &a) in out.iter_mut().zip(particles) {
            *out = (self.motion.pole + axes * self.arms[a as usize]).into();
        }
    }

    fn velocities(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        let (axes, spin) = (self.motion.turn.axes(), self.spin());
        for (out, &a) in out.iter_mut().zip(particles) {
            *out = (self.motion.velocity + spin.cross(&(axes * self.arms[a as usize]))).into();
        }
    }

    fn masses(&self, particles: &[u32]) -> Vec<f64> {
        self.masses_with(particles)
    }

    fn release(&mut self) {
        self.release_exerted();
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        self.add_exerted(particles, forces);
    }

    fn unscaled(&self, particles: &[u32], v: &[f64], out: &mut [[f64; 3]]) {
        let (axes, [place, turn]) = (self.motion.turn.axes(), self.unscaled_motion(v));
        for (out, &a) in out.iter_mut().zip(particles) {
            *out = (place + turn.cross(&(axes * self.arms[a as usize]))).into();
        }
    }

    fn add_scaled(&self, particles: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        let (axes, mut wrench) = (self.motion.turn.axes(), Wrench::default());
        for (&a, &force) in particles.iter().zip(forces) {
            wrench.add(&Vec3::from(force), &(axes * self.arms[a as usize]));
        }
        let scaled = self.scaled_wrench(&wrench);
        out.iter_mut().zip(scaled.iter()).for_each(|(sum, part)| *sum += part);
    }
}
