//! An interaction with what it sees and exerts, and where its stiffness goes in the tangent.

use std::collections::HashMap;
use std::ops::Range;

use super::interaction::{Interaction, Joinable};

/// A motion of a place: unknowns of all systems, with its velocity for a unit of each.
type Moves = Vec<(usize, [f64; 3])>;

/// A place that shares a block with another.
#[derive(Clone, Copy)]
struct Partner {
    place: usize,
    pair: usize,
    turned: bool,
}

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
    /// Of each place those with which it shares a block, the number of the pair, and whether the block is turned round.
    partners: Vec<Vec<Partner>>,
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
            partners: Vec::new(),
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
        self.partners = partners(&self.pairs, self.places.len());
        let moves = self.moves(systems, first);
        let mut asked: Vec<(usize, usize)> = Vec::new();
        let ones = vec![[[1.0; 3]; 3]; self.pairs.len()];
        self.visit(&moves, &ones, |_, entry, _| asked.push(entry));
        let mut reached = vec![false; first.last().copied().unwrap_or(0)];
        asked.iter().for_each(|(row, column)| [row, column].into_iter().for_each(|&i| reached[i] = true));
        let among = |&(_, entry): &(usize, &(usize, usize))| reached[entry.0] && reached[entry.1];
        let known: HashMap<(usize, usize), usize> =
            pattern.iter().enumerate().filter(among).map(|(at, entry)| (*entry, at)).collect();
        self.own = asked.iter().filter(|entry| !known.contains_key(entry)).copied().collect();
        self.own.sort_unstable();
        self.own.dedup();
        let place = |entry: &(usize, usize)| match known.get(entry) {
            Some(&at) => at,
            None => pattern.len() + self.own.partition_point(|other| other < entry),
        };
        self.targets = asked.iter().map(place).collect();
    }

    /// Whether it joins other pairs of the present places at a level than before.
    pub fn changed<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], level: f64) -> bool {
        self.interaction.put(level);
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

    /// Lets it act on the systems at their present places and a level; its energy \[F L\].
    pub fn act<S: Joinable + ?Sized>(&mut self, systems: &mut [Box<S>], level: f64) -> f64 {
        self.interaction.put(level);
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
        self.add_blocks(systems, first, values, |blocks| self.interaction.stiffness(&self.places, blocks));
    }

    /// Adds its stiffness at places here with the forces of the places last evaluated ([`Interaction::stressed`]).
    pub fn add_stressed<S: Joinable + ?Sized>(
        &self,
        here: &[[f64; 3]],
        systems: &[Box<S>],
        first: &[usize],
        values: &mut [f64],
    ) {
        self.add_blocks(systems, first, values, |blocks| {
            self.interaction.stressed(here, &self.places, blocks)
        });
    }

    fn add_blocks<S: Joinable + ?Sized>(
        &self,
        systems: &[Box<S>],
        first: &[usize],
        values: &mut [f64],
        fill: impl FnOnce(&mut [[[f64; 3]; 3]]),
    ) {
        let moves = self.moves(systems, first);
        let mut blocks = vec![[[0.0; 3]; 3]; self.pairs.len()];
        fill(&mut blocks);
        self.visit(&moves, &blocks, |number, _, value| values[self.targets[number]] += value);
    }

    /// Adds what a unit of level adds to its forces at the places last evaluated.
    pub fn add_rates<S: Joinable + ?Sized>(&self, systems: &[Box<S>], first: &[usize], out: &mut [f64]) {
        let mut rates = vec![[0.0; 3]; self.places.len()];
        if !self.interaction.rates(&self.places, &mut rates) {
            return;
        }
        for (moves, rate) in self.moves(systems, first).iter().zip(&rates) {
            moves.iter().for_each(|(unknown, way)| out[*unknown] += dot(way, rate));
        }
    }

    /// Adds what a unit of level adds to its forces where supports lead places by these ways; nothing where they lead none.
    pub fn add_led<S: Joinable + ?Sized>(
        &self,
        ways: &[[f64; 3]],
        systems: &[Box<S>],
        first: &[usize],
        out: &mut [f64],
    ) {
        if ways.iter().flatten().all(|way| *way == 0.0) {
            return;
        }
        let mut blocks = vec![[[0.0; 3]; 3]; self.pairs.len()];
        self.interaction.stiffness(&self.places, &mut blocks);
        let mut rates = vec![[0.0; 3]; self.places.len()];
        for (&[a, b], block) in self.pairs.iter().zip(&blocks) {
            for i in 0..3 {
                rates[a][i] -= dot(&block[i], &ways[b]);
                if a != b {
                    rates[b][i] -= (0..3).map(|j| block[j][i] * ways[a][j]).sum::<f64>();
                }
            }
        }
        for (moves, rate) in self.moves(systems, first).iter().zip(&rates) {
            moves.iter().for_each(|(unknown, way)| out[*unknown] += dot(way, rate));
        }
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

    /// Hands every entry of the lower half to which blocks add, with its number and with what belongs to it, to `put`, some of them several
    /// times: of each place the rows `Bᵀ Σ K B` over all with which it shares a block, B how they move.
    fn visit(
        &self,
        moves: &[Moves],
        blocks: &[[[f64; 3]; 3]],
        mut put: impl FnMut(usize, (usize, usize), f64),
    ) {
        let most = moves.iter().flatten().fold(0, |most, (unknown, _)| most.max(unknown + 1));
        let (mut number, mut columns) = (0, Vec::new());
        let (mut met, mut resisted) = (vec![false; most], vec![[0.0; 3]; most]);
        for (left, partners) in moves.iter().zip(&self.partners) {
            for partner in partners {
                let block = &blocks[partner.pair];
                for (column, right) in &moves[partner.place] {
                    if !std::mem::replace(&mut met[*column], true) {
                        columns.push(*column);
                        resisted[*column] = [0.0; 3];
                    }
                    for k in 0..3 {
                        let row = match partner.turned {
                            true => [block[0][k], block[1][k], block[2][k]],
                            false => block[k],
                        };
                        resisted[*column][k] += dot(&row, right);
                    }
                }
            }
            columns.sort_unstable();
            for (row, left) in left {
                for &column in columns.iter().take_while(|column| **column <= *row) {
                    put(number, (*row, column), dot(left, &resisted[column]));
                    number += 1;
                }
            }
            columns.drain(..).for_each(|column| met[column] = false);
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

/// With which places each of so many shares a block.
fn partners(pairs: &[[usize; 2]], places: usize) -> Vec<Vec<Partner>> {
    let mut all = vec![Vec::new(); places];
    for (pair, &[a, b]) in pairs.iter().enumerate() {
        all[a].push(Partner { place: b, pair, turned: false });
        if a != b {
            all[b].push(Partner { place: a, pair, turned: true });
        }
    }
    all
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
