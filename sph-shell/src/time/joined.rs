//! The shell as one of several bodies that are marched together.

use explicit_dynamics::Joinable;

use crate::Shell;
use crate::motion::row_of;
use crate::packs::Row;

impl Joinable for Shell {
    fn particles(&self) -> usize {
        self.len()
    }

    fn places(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        out.iter_mut().zip(particles).for_each(|(out, &number)| *out = self.place_numbered(number));
    }

    fn velocities(&self, particles: &[u32], out: &mut [[f64; 3]]) {
        let of = |&number: &u32| match row_of(number, self.len()) {
            (a, 0) => self.velocity(a).into(),
            (a, _) => self.director_rate(a).into(),
        };
        out.iter_mut().zip(particles).for_each(|(out, number)| *out = of(number));
    }

    /// Whatever moves with a particle, it does: an inertia of its own is a bound. Of a director that is its rotary inertia.
    fn masses(&self, particles: &[u32]) -> Vec<f64> {
        let of = |&number: &u32| match row_of(number, self.len()) {
            (a, 0) => self.reference.masses[a],
            (a, _) => self.reference.inertias[a],
        };
        particles.iter().map(of).collect()
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
        for (out, &number) in out.iter_mut().zip(particles) {
            let (a, place) = row_of(number, self.len());
            *out = std::array::from_fn(|k| rates[a][place + k]);
        }
    }

    fn add_scaled(&self, particles: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        let mut rows = vec![[0.0; 6]; self.len()];
        for (&number, force) in particles.iter().zip(forces) {
            let (a, place) = row_of(number, self.len());
            (0..3).for_each(|k| rows[a][place + k] += force[k]);
        }
        self.dependents.ties.condense(&self.motion.state, &mut rows, |_, _| ());
        for (a, out) in out.chunks_exact_mut(6).enumerate() {
            out.iter_mut().zip(self.free_part(a, |a| rows[a])).for_each(|(sum, part)| *sum += part);
        }
    }
}
