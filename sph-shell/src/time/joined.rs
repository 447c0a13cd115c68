//! The shell as one of several bodies that are marched together.

use explicit_dynamics::Joinable;

use crate::Shell;
use crate::packs::Row;

impl Joinable for Shell {
    fn particles(&self) -> usize {
        self.len()
    }

    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        let of = |&a: &u32| self.position(a as usize).into();
        out.iter_mut().zip(particles).for_each(|(out, a)| *out = of(a));
    }

    fn velocities(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        let of = |&a: &u32| self.velocity(a as usize).into();
        out.iter_mut().zip(particles).for_each(|(out, a)| *out = of(a));
    }

    /// Whatever moves with a particle, it does: an inertia of its own is a bound.
    fn masses(&self, particles: &[u32]) -> Vec<f64> {
        particles.iter().map(|&a| self.reference.masses[a as usize]).collect()
    }

    fn release(&mut self) {
        self.loading.release();
    }

    fn exert(&mut self, particles: &[u32], forces: &[[f64; 3]]) {
        let count = self.len();
        self.loading.exert(particles, forces, count);
    }

    fn unscaled(&self, particles: &[u32], v: &[f64], out: &mut [[f64; 3]]) {
        let mut rates: Vec<Row> = (0..self.len()).map(|a| self.unscaled(a, v)).collect();
        self.dependents.ties.follow(&self.motion.state, &mut rates);
        for (out, &a) in out.iter_mut().zip(particles) {
            let row = &rates[a as usize];
            *out = [row[0], row[1], row[2]];
        }
    }

    fn add_scaled(&self, particles: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        let mut rows = vec![[0.0; 6]; self.len()];
        for (&a, force) in particles.iter().zip(forces) {
            (0..3).for_each(|k| rows[a as usize][k] += force[k]);
        }
        self.dependents.ties.condense(&self.motion.state, &mut rows, |_, _| ());
        for (a, out) in out.chunks_exact_mut(6).enumerate() {
            out.iter_mut().zip(self.free_part(a, |a| rows[a])).for_each(|(sum, part)| *sum += part);
        }
    }
}
