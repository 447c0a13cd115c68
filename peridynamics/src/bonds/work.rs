//! The work done on bonds, `∫ f de` along the way of each: what breaks bonds of a state-based body by their energy. What a bond that
//! yields took for that is part of it.

use std::ops::Range;

use parallel::{ByChunk, CHUNK};

use super::intact::Bond;
use super::network::{LANES, Network, Row};
use crate::share::Share;

/// The work on each bond up to the present, by chunks of nodes.
#[derive(Clone, Debug)]
pub(crate) struct Works {
    /// A bit for each lane of each pack: the bond is whole and may break.
    pub lanes: Vec<u8>,
    chunks: Vec<Chunk>,
}

#[derive(Clone, Debug)]
struct Chunk {
    /// First lane of its nodes.
    first: usize,
    bonds: Vec<Worked>,
    /// Lanes beyond their limit, ascending.
    beyond: Vec<u32>,
}

/// Work on one directed bond.
#[derive(Clone, Copy, Debug, Default)]
struct Worked {
    /// Done up to the last evaluation \[F L\].
    done: f64,
    /// Pull \[F\] and extension \[L\] at the last evaluation.
    pull: f64,
    extension: f64,
    /// Beyond this the bond breaks \[F L\].
    limit: f64,
}

impl Worked {
    /// Work up to a state not far from that of the last evaluation, by the mean of the pulls \[F L\].
    fn up_to(&self, pull: f64, extension: f64) -> f64 {
        self.done + 0.5 * (pull + self.pull) * (extension - self.extension)
    }
}

impl Works {
    /// No work done; `limits` of lanes.
    pub fn new(network: &Network, lanes: Vec<u8>, limits: &dyn Fn(&Bond) -> f64) -> Self {
        let chunk = |number: usize| {
            let nodes = number * CHUNK..((number + 1) * CHUNK).min(network.len());
            let first = network.lanes_of(nodes.start).start;
            let of = |(_, bond): (usize, Bond)| Worked { limit: limits(&bond), ..Worked::default() };
            let bonds = nodes.flat_map(|node| network.bonds_of(node)).map(of).collect();
            Chunk { first, bonds, beyond: Vec::new() }
        };
        Self { lanes, chunks: (0..network.len().div_ceil(CHUNK)).map(chunk).collect() }
    }

    /// Adds the work from the last evaluation to this one on bonds of own nodes, and notes the stretched ones beyond their limit.
    pub fn add(&mut self, network: &Network, rows: &[Row], share: &Share) {
        let lanes = &self.lanes;
        let one = |first: usize, ByChunk(own): ByChunk<'_, Chunk>| {
            let Some(chunk) = own.first_mut() else { return };
            chunk.beyond.clear();
            for node in first..(first + CHUNK).min(network.len()) {
                for (lane, bond) in network.bonds_of(node) {
                    if lanes[lane / LANES] & (1 << (lane % LANES)) == 0 {
                        continue;
                    }
                    let worked = &mut chunk.bonds[lane - chunk.first];
                    let extension = bond.extension(node, rows);
                    let pull = network.pull(node, &bond, extension, rows);
                    worked.done = worked.up_to(pull, extension);
                    (worked.pull, worked.extension) = (pull, extension);
                    if extension > 0.0 && worked.done > worked.limit {
                        chunk.beyond.push(lane as u32);
                    }
                }
            }
        };
        let chunks = share.chunks_of(network.len());
        share.sweep(chunks.start * CHUNK, ByChunk(&mut self.chunks[chunks]), one);
    }

    /// `√(work/limit)` of a stretched bond were the work added up to these rows, zero of others; nothing is added.
    pub fn utilisation(&self, network: &Network, node: usize, lane: usize, rows: &[Row]) -> f64 {
        let chunk = &self.chunks[node / CHUNK];
        let (bond, worked) = (network.bond(node, lane), &chunk.bonds[lane - chunk.first]);
        let extension = bond.extension(node, rows);
        let done = worked.up_to(network.pull(node, &bond, extension, rows), extension);
        if extension > 0.0 { (done.max(0.0) / worked.limit).sqrt() } else { 0.0 }
    }

    /// Lanes of bonds in these chunks that went beyond their limit in the last evaluation, ascending.
    pub fn beyond(&self, own: Range<usize>) -> impl Iterator<Item = u32> {
        self.chunks[own].iter().flat_map(|chunk| chunk.beyond.iter().copied())
    }

    /// Work, pull and extension of each lane, one behind the other.
    pub fn state(&self) -> Vec<f64> {
        let of = |bond: &Worked| [bond.done, bond.pull, bond.extension];
        self.chunks.iter().flat_map(|chunk| chunk.bonds.iter().flat_map(of)).collect()
    }

    /// Whether a state has a number for each.
    pub fn fits(&self, state: &[f64]) -> bool {
        state.len() == 3 * LANES * self.lanes.len()
    }

    /// Takes up a state that fits.
    pub fn take_up(&mut self, state: &[f64]) {
        let bonds = self.chunks.iter_mut().flat_map(|chunk| chunk.bonds.iter_mut());
        for (bond, numbers) in bonds.zip(state.chunks_exact(3)) {
            [bond.done, bond.pull, bond.extension] = [numbers[0], numbers[1], numbers[2]];
        }
    }

    /// Brings the work on all bonds to all.
    pub fn bring(&mut self, network: &Network, share: &Share) {
        let mut state = self.state();
        share.bring_lists(&network.starts, &mut state, 3 * LANES);
        self.take_up(&state);
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        self.lanes.len() * (1 + LANES * size_of::<Worked>())
    }
}
