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
    /// Where each entry that it adds to stands in the pattern, in the order in which [`Acting::visit`] hands them out.
    targets: Vec<usize>,
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
            targets: Vec::new(),
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
        let moves = self.moves(systems, first);
        let mut asked: Vec<(usize, usize)> = Vec::new();
        let ones = vec![[[1.0; 3]; 3]; self.pairs.len()];
        self.visit(&moves, &ones, |_, entry, _| asked.push(entry));
        let known: HashMap<(usize, usize), usize> =
            pattern.iter().enumerate().map(|(at, entry)| (*entry, at)).collect();
        self.own = asked.iter().filter(|entry| !known.contains_key(entry)).copied().collect();
        self.own.sort_unstable();
        self.own.dedup();
        let place = |entry: &(usize, usize)| match known.get(entry) {
            Some(&at) => at,
            None => pattern.len() + self.own.partition_point(|other| other < entry),
        };
        self.targets = asked.iter().map(place).collect();
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

    /// Energy lost at a particle of a system until the last commit \[F L\].
    pub fn lost_at(&self, system: usize, particle: u32) -> f64 {
        let at = self.particles[system].binary_search(&particle).ok();
        at.map_or(0.0, |at| self.interaction.lost_at(self.ranges[system].start + at))
    }

    /// Takes up a history that it gave.
    pub fn recall(&mut self, history: &[f64]) {
        self.interaction.recall(history);
    }

    /// Makes its history that of an accepted state.
    pub fn commit(&mut self) {
        self.interaction.commit(&self.places);
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
        let mut blocks = vec![[[0.0; 3]; 3]; self.pairs.len()];
        self.interaction.stiffness(&self.places, &mut blocks);
        self.visit(&moves, &blocks, |number, _, value| values[self.targets[number]] += value);
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

    /// Hands every entry of the lower half to which a block adds, with its number and with what belongs to it, to `put`, some of them several
    /// times. Blocks of zero are passed over.
    fn visit(
        &self,
        moves: &[Moves],
        blocks: &[[[f64; 3]; 3]],
        mut put: impl FnMut(usize, (usize, usize), f64),
    ) {
        let mut number = 0;
        for (&[a, b], block) in self.pairs.iter().zip(blocks) {
            if *block == [[0.0; 3]; 3] {
                number += match a == b {
                    true => moves[a].len() * (moves[a].len() + 1) / 2,
                    false => moves[a].len() * moves[b].len(),
                };
                continue;
            }
            for (i, left) in &moves[a] {
                let row =
                    [0, 1, 2].map(|k| left[0] * block[0][k] + left[1] * block[1][k] + left[2] * block[2][k]);
                for (j, right) in &moves[b] {
                    // A block off the diagonal stands for its transpose as well; one on it has both halves.
                    if a == b && i < j {
                        continue;
                    }
                    let twice = if a != b && i == j { 2.0 } else { 1.0 };
                    put(number, (*i.max(j), *i.min(j)), twice * dot(&row, right));
                    number += 1;
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
