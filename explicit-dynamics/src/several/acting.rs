//! An interaction under way: the particles on which it acts, with room for their places, velocities and forces.

use std::ops::Range;

use super::interaction::{Interaction, Joinable, Places};
use crate::step::{Instant, Work};

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
    masses: Vec<f64>,
    /// Whether it exerts nothing in this step, whatever places are.
    rests: bool,
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
        let (places, forces, before, after, masses) = (room(), room(), room(), room(), Vec::new());
        Self { interaction, particles, ranges, places, forces, before, after, masses, rests: false }
    }

    /// Lets it act on the systems at their present places and an instant; its energy \[F L\].
    pub fn act<S: Joinable + ?Sized>(&mut self, systems: &mut [Box<S>], at: Instant) -> f64 {
        if self.rests {
            return 0.0;
        }
        self.interaction.put(at);
        self.see(systems);
        if self.interaction.damps() {
            read(systems, &self.particles, &self.ranges, &mut self.before);
            self.interaction.see(at, &self.before);
        }
        let Self { interaction, particles, ranges, places, forces, .. } = self;
        let energy = interaction.evaluate(places, forces);
        for ((system, particles), range) in systems.iter_mut().zip(&*particles).zip(&*ranges) {
            system.exert(particles, &forces[range.clone()]);
        }
        energy
    }

    /// Reads the present places.
    fn see<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) {
        let Self { particles, ranges, places, .. } = self;
        for ((system, particles), range) in systems.iter().zip(&*particles).zip(&*ranges) {
            system.places(particles, &mut places[range.clone()]);
        }
    }

    /// The step to take next, at most a stable one that was found with a safety.
    pub fn shortened<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], stable: f64, safety: f64) -> f64 {
        self.rests = self.interaction.rests();
        if self.rests {
            return stable;
        }
        self.see(systems);
        read(systems, &self.particles, &self.ranges, &mut self.before);
        if self.masses.is_empty() {
            self.masses = self.masses_of(systems);
        }
        let now = Places { at: &self.places, velocities: &self.before, masses: &self.masses };
        self.interaction.shortened(stable, safety, &now)
    }

    /// Takes note that the systems have moved.
    pub fn moved(&mut self) {
        self.interaction.moved();
    }

    /// What acts.
    pub fn interaction(&self) -> &dyn Interaction {
        &*self.interaction
    }

    /// Takes up what it kept with a state.
    pub fn take_up<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], kept: &[f64]) -> bool {
        self.rests = false;
        let masses = self.masses_of(systems);
        self.interaction.take_up(kept, &masses)
    }

    /// What it last exerted on a particle of a system \[F\].
    pub fn force_on(&self, system: usize, particle: u32) -> [f64; 3] {
        let at = self.particles[system].binary_search(&particle).ok().filter(|_| !self.rests);
        at.map_or([0.0; 3], |at| self.forces[self.ranges[system].start + at])
    }

    /// Energy lost at a particle of a system until the last step \[F L\].
    pub fn lost_at(&self, system: usize, particle: u32) -> f64 {
        let at = self.particles[system].binary_search(&particle).ok();
        at.map_or(0.0, |at| self.interaction.lost_at(self.ranges[system].start + at))
    }

    /// Makes its history that of the step that was taken.
    pub fn commit(&mut self) {
        self.interaction.commit();
    }

    /// Whether its work is no other than that of the forces on the systems.
    fn is_left_out(&self) -> bool {
        self.rests || self.interaction.is_external()
    }

    /// What it lost of the work of something prescribed is dissipated, and was no work of loads.
    fn count_external_loss(&self, work: &mut Work) {
        if !self.rests && self.interaction.is_external() {
            let lost = self.interaction.lost();
            work.dissipated += lost;
            work.external += lost;
        }
    }

    /// Reads the velocities before a kick.
    pub fn before<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) {
        if self.is_left_out() {
            return;
        }
        read(systems, &self.particles, &self.ranges, &mut self.before);
    }

    /// Takes its own work over a kick out of the external work, and counts what it resisted as internal forces do.
    pub fn after<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], kick: f64, work: &mut Work) {
        self.count_external_loss(work);
        if self.is_left_out() {
            return;
        }
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
        if self.interaction.damps() {
            work.dissipated -= kick * done;
            return;
        }
        work.dissipated += self.interaction.lost();
        work.resisted -= kick * gave_way;
    }

    /// A bound of the square of its highest frequency on the masses of the systems \[1/T²\].
    pub fn fastest<S: Joinable + ?Sized>(&self, systems: &[Box<S>]) -> f64 {
        self.interaction.fastest(&self.masses_of(systems))
    }

    /// A bound of the rate at which it lets motions of the systems decay \[1/T\].
    pub fn damping<S: Joinable + ?Sized>(&self, systems: &[Box<S>]) -> f64 {
        if self.interaction.damps() { self.interaction.damping(&self.masses_of(systems)) } else { 0.0 }
    }

    fn masses_of<S: Joinable + ?Sized>(&self, systems: &[Box<S>]) -> Vec<f64> {
        let all = systems.iter().zip(&self.particles);
        all.flat_map(|(system, particles)| system.masses(particles)).collect()
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
        self.interaction.resist(&self.places, &motion, &mut forces);
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
