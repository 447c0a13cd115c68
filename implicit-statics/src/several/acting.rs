//! An interaction with what it sees and exerts, and where its stiffness goes in the tangent.

use std::collections::HashMap;
use std::ops::Range;

use super::interaction::{Interaction, Joinable};

/// A motion of a place: unknowns of all systems, with its velocity for a unit of each.
type Moves = Vec<(usize, [f64; 3])>;

/// An interaction under way.
pub(super) struct Acting {
    interaction: Box<dyn Interaction>,
    /// Particles of each system.
    particles: Vec<Vec<u32>>,
    /// Where those of each system stand among all.
    ranges: Vec<Range<usize>>,
    places: Vec<[f64; 3]>,
    forces: Vec<[f64; 3]>,
    pairs: Vec<[usize; 2]>,
    /// Entries that no system has of itself.
    pub own: Vec<(usize, usize)>,
    /// Where each entry that it adds to stands in the pattern.
    entries: HashMap<(usize, usize), usize>,
}

impl Acting {
    /// An interaction of systems whose unknowns begin at these numbers, and whose patterns together are this.
    pub fn new<S: Joinable + ?Sized>(
        interaction: Box<dyn Interaction>,
        systems: &[Box<S>],
        first: &[usize],
        pattern: &[(usize, usize)],
    ) -> Self {
        let particles = interaction.particles();
        let mut count = 0;
        let range = |of: &Vec<u32>| {
            count += of.len();
            count - of.len()..count
        };
        let ranges = particles.iter().map(range).collect();
        let room = || vec![[0.0; 3]; count];
        let (places, forces) = (room(), room());
        let mut acting = Self {
            interaction,
            particles,
            ranges,
            places,
            forces,
            pairs: Vec::new(),
            own: Vec::new(),
            entries: HashMap::new(),
        };
        acting.enter(systems, first, pattern);
        acting
    }

    /// Finds where its blocks stand in the pattern of all that stands before it, and which entries it adds behind that.
    pub fn enter<S: Joinable + ?Sized>(
        &mut self,
        systems: &[Box<S>],
        first: &[usize],
        pattern: &[(usize, usize)],
    ) {
        self.pairs = self.interaction.pairs();
        self.entries.clear();
        let moves = self.moves(systems, first);
        for &[a, b] in &self.pairs {
            for (i, _) in &moves[a] {
                self.entries.extend(moves[b].iter().map(|(j, _)| ((*i.max(j), *i.min(j)), usize::MAX)));
            }
        }
        for (number, entry) in pattern.iter().enumerate() {
            if let Some(at) = self.entries.get_mut(entry) {
                *at = number;
            }
        }
        let missing = self.entries.iter().filter(|(_, at)| **at == usize::MAX).map(|(entry, _)| *entry);
        self.own = missing.collect();
        self.own.sort_unstable();
        for (number, entry) in self.own.iter().enumerate() {
            self.entries.insert(*entry, pattern.len() + number);
        }
    }

    /// Whether it joins other pairs of the present places than before.
    pub fn changed<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) -> bool {
        self.see(systems);
        self.interaction.pairs_changed(&self.places)
    }

    /// What it last exerted on a particle of a system \[F\].
    pub fn force_on(&self, system: usize, particle: u32) -> [f64; 3] {
        let at = self.particles[system].binary_search(&particle).ok();
        at.map_or([0.0; 3], |at| self.forces[self.ranges[system].start + at])
    }

    /// Where the systems are now.
    pub fn seen<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) -> Vec<[f64; 3]> {
        self.see(systems);
        self.places.clone()
    }

    /// What acts.
    pub fn interaction(&self) -> &dyn Interaction {
        &*self.interaction
    }

    /// Takes up what it kept with a state.
    pub fn take_up(&mut self, kept: &[f64]) -> bool {
        self.interaction.take_up(kept)
    }

    /// Reads the present places.
    fn see<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) {
        let Self { particles, ranges, places, .. } = self;
        for ((system, particles), range) in systems.iter().zip(&*particles).zip(&*ranges) {
            system.places(particles, &mut places[range.clone()]);
        }
    }

    /// Lets it act on the systems at their present places; its energy \[F L\].
    pub fn act<S: Joinable + ?Sized>(&mut self, systems: &mut [Box<S>]) -> f64 {
        self.see(systems);
        let Self { interaction, particles, ranges, places, forces, .. } = self;
        let energy = interaction.evaluate(places, forces);
        for ((system, particles), range) in systems.iter_mut().zip(&*particles).zip(&*ranges) {
            system.exert(particles, &forces[range.clone()]);
        }
        energy
    }

    /// Adds its stiffness at the places last evaluated to the values of a tangent.
    pub fn add_stiffness<S: Joinable + ?Sized>(
        &self,
        systems: &[Box<S>],
        first: &[usize],
        values: &mut [f64],
    ) {
        let moves = self.moves(systems, first);
        self.visit(&moves, |entry, value| values[self.entries[&entry]] += value);
    }

    /// Adds to bounds of the spectrum what it adds to the sums over rows: of each place the largest of its three axes, so that no turn
    /// makes it more.
    pub fn add_row_sums<S: Joinable + ?Sized>(&self, systems: &[Box<S>], first: &[usize], out: &mut [f64]) {
        let mut blocks = vec![[[0.0; 3]; 3]; self.pairs.len()];
        self.interaction.stiffness(&self.places, &mut blocks);
        let mut sums = vec![[0.0; 3]; self.places.len()];
        for (&[a, b], block) in self.pairs.iter().zip(&blocks) {
            for i in 0..3 {
                for j in 0..3 {
                    sums[a][i] += block[i][j].abs();
                    if a != b {
                        sums[b][j] += block[i][j].abs();
                    }
                }
            }
        }
        for (moves, sum) in self.moves(systems, first).iter().zip(&sums) {
            let most = sum.iter().copied().fold(0.0, f64::max);
            moves.iter().for_each(|(unknown, way)| out[*unknown] += most * dot(way, way));
        }
    }

    /// Hands every entry of the lower half with what belongs to it to `put`, some of them several times.
    fn visit(&self, moves: &[Moves], mut put: impl FnMut((usize, usize), f64)) {
        let mut blocks = vec![[[0.0; 3]; 3]; self.pairs.len()];
        self.interaction.stiffness(&self.places, &mut blocks);
        for (&[a, b], block) in self.pairs.iter().zip(&blocks) {
            for (i, left) in &moves[a] {
                for (j, right) in &moves[b] {
                    let value = dot(left, &block.map(|row| dot(&row, right)));
                    // A block off the diagonal stands for its transpose as well; one on it has both halves.
                    match a == b {
                        true if i < j => {}
                        true => put((*i, *j), value),
                        false if i == j => put((*i, *j), 2.0 * value),
                        false => put((*i.max(j), *i.min(j)), value),
                    }
                }
            }
        }
    }

    /// How each place moves.
    fn moves<S: Joinable + ?Sized>(&self, systems: &[Box<S>], first: &[usize]) -> Vec<Moves> {
        let mut all = Vec::with_capacity(self.places.len());
        for ((system, particles), first) in systems.iter().zip(&self.particles).zip(first) {
            for &particle in particles {
                let own = system.motion_of(particle).into_iter();
                all.push(own.map(|(unknown, way)| (first + unknown, way)).collect());
            }
        }
        all
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
