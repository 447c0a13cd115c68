//! An interaction under way: the particles on which it acts, with room for their places, velocities and forces.

use std::ops::Range;

use super::interaction::{Interaction, Joinable};
use crate::step::Work;

/// An interaction with what it sees and exerts.
pub(super) struct Acting {
    interaction: Box<dyn Interaction>,
    /// Particles of each system.
    particles: Vec<Vec<u32>>,
    /// Where those of each system stand among all.
    ranges: Vec<Range<usize>>,
    places: Vec<[f64; 3]>,
    forces: Vec<[f64; 3]>,
    before: Vec<[f64; 3]>,
    after: Vec<[f64; 3]>,
}

impl Acting {
    pub fn new(interaction: Box<dyn Interaction>) -> Self {
        let particles = interaction.particles();
        let mut count = 0;
        let range = |of: &Vec<u32>| {
            count += of.len();
            count - of.len()..count
        };
        let ranges = particles.iter().map(range).collect();
        let room = || vec![[0.0; 3]; count];
        Self { interaction, particles, ranges, places: room(), forces: room(), before: room(), after: room() }
    }

    /// Lets it act on the systems at their present places; its energy \[F L\].
    pub fn act<S: Joinable + ?Sized>(&mut self, systems: &mut [Box<S>]) -> f64 {
        let Self { interaction, particles, ranges, places, forces, .. } = self;
        for ((system, particles), range) in systems.iter().zip(&*particles).zip(&*ranges) {
            system.places(particles, &mut places[range.clone()]);
        }
        let energy = interaction.evaluate(places, forces);
        for ((system, particles), range) in systems.iter_mut().zip(&*particles).zip(&*ranges) {
            system.exert(particles, &forces[range.clone()]);
        }
        energy
    }

    /// Reads the velocities before a kick.
    pub fn before<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) {
        read(systems, &self.particles, &self.ranges, &mut self.before);
    }

    /// Takes its own work over a kick out of the external work, and counts what it resisted as internal forces do.
    pub fn after<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], kick: f64, work: &mut Work) {
        read(systems, &self.particles, &self.ranges, &mut self.after);
        let mut done = 0.0;
        let mut gave_way = 0.0;
        for ((force, before), after) in self.forces.iter().zip(&self.before).zip(&self.after) {
            for k in 0..3 {
                done += force[k] * 0.5 * (before[k] + after[k]);
                gave_way += force[k] * (after[k] - before[k]);
            }
        }
        work.external -= kick * done;
        work.resisted -= kick * gave_way;
    }

    /// A bound of the square of its highest frequency on the masses of the systems \[1/T²\].
    pub fn fastest<S: Joinable + ?Sized>(&self, systems: &[Box<S>]) -> f64 {
        let mut masses = Vec::with_capacity(self.places.len());
        for (system, particles) in systems.iter().zip(&self.particles) {
            masses.extend(particles.iter().map(|&particle| system.mass(particle)));
        }
        self.interaction.fastest(&masses)
    }

    /// Adds its tangent in mass-scaled coordinates, those of each system behind those before it.
    pub fn add_tangent<S: Joinable + ?Sized>(
        &self,
        systems: &[Box<S>],
        unknowns: &[Range<usize>],
        v: &[f64],
        out: &mut [f64],
    ) {
        let mut motion = vec![[0.0; 3]; self.places.len()];
        let mut forces = motion.clone();
        for (number, system) in systems.iter().enumerate() {
            let own = &mut motion[self.ranges[number].clone()];
            system.unscaled(&self.particles[number], &v[unknowns[number].clone()], own);
        }
        self.interaction.resist(&motion, &mut forces);
        for (number, system) in systems.iter().enumerate() {
            let own = &forces[self.ranges[number].clone()];
            system.add_scaled(&self.particles[number], own, &mut out[unknowns[number].clone()]);
        }
    }
}

/// Velocities of the particles on which it acts.
fn read<S: Joinable + ?Sized>(
    systems: &[Box<S>],
    particles: &[Vec<u32>],
    ranges: &[Range<usize>],
    out: &mut [[f64; 3]],
) {
    for ((system, particles), range) in systems.iter().zip(particles).zip(ranges) {
        system.velocities(particles, &mut out[range.clone()]);
    }
}
