//! The sweep over all bonds: dilatations, then forces `∂U/∂x`, energy, and which bonds go beyond their limit.
//!
//! A bond of extension e along M pulls its node with `(c e + θ̂ᵢ Dᵢⱼ + θ̂ⱼ Dⱼᵢ) M`, c its stiffness and
//! `θ̂ = (λ − μ) V θ`. Each direction of a bond is worked out at its own node. The extension is the same from both ends to
//! the last bit, and so is the pull: forces sum to zero but for rounding, and a bond breaks at both ends in one step. Where bonds
//! yield, e of the first term is the mean of the elastic parts that both ends have ([`super::flow`]).

use std::ops::Range;

use lanes::{Lanes, Reals, Sweep, Vector, widest};
use parallel::{ByChunk, CHUNK};

use super::network::{LANES, Network, Row};
use super::patterns::{Family, Number};
use super::present::{Own, Present};
use crate::share::Share;

/// Which bonds may break, and beyond which stretch.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    /// A bit for each lane of each pack: the bond is whole and may break.
    pub lanes: Vec<u8>,
    /// Greatest stretch.
    pub tension: f64,
    /// Least stretch; −∞ where none breaks under compression.
    pub compression: f64,
}

/// What the sweep works with beside the bonds, by chunks of nodes.
#[derive(Clone, Debug)]
pub(crate) struct Scratch {
    /// `(λ − μ) V θ` of each node; empty without a dilatation.
    pub(super) dilatations: Vec<f64>,
    /// Energy of each chunk.
    energies: Vec<f64>,
    /// Lanes of packs that go beyond their limit, of each chunk.
    beyond: Vec<Vec<u32>>,
}

impl Scratch {
    pub fn new(network: &Network) -> Self {
        let chunks = network.len().div_ceil(CHUNK);
        Self {
            dilatations: if network.dilatation.is_some() { vec![0.0; network.len()] } else { Vec::new() },
            energies: vec![0.0; chunks],
            beyond: vec![Vec::new(); chunks],
        }
    }

    /// Lanes `4 · pack + lane` of bonds of own nodes that went beyond their limit in the last sweep, ascending.
    pub fn beyond(&self, own: Range<usize>) -> impl Iterator<Item = u32> {
        self.beyond[own].iter().flatten().copied()
    }
}

/// Adds up one chunk of nodes; `DILATATION` where the law has one, `FLOW` where bonds yield.
struct Chunk<'a, const DILATATION: bool, const FLOW: bool, const ENERGY: bool, const WATCH: bool> {
    network: &'a Network,
    rows: &'a [Row],
    first: usize,
    forces: &'a mut [Row],
    watch: Option<&'a Watch>,
    beyond: &'a mut Vec<u32>,
}

impl<const DILATATION: bool, const FLOW: bool, const ENERGY: bool, const WATCH: bool> Sweep
    for Chunk<'_, DILATATION, FLOW, ENERGY, WATCH>
{
    /// Stored energy.
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> f64 {
        let Self { network, rows, first, forces, watch, beyond } = self;
        let mut energy = 0.0;
        let at = At { network, rows, watch };
        for (i, force) in forces.iter_mut().enumerate() {
            let node = first + i;
            let family = network.family(node);
            let (sum, stored) = if family.is_shifted {
                at.node::<L, true, DILATATION, FLOW, ENERGY, WATCH>(lanes, node, &family, beyond)
            } else {
                at.node::<L, false, DILATATION, FLOW, ENERGY, WATCH>(lanes, node, &family, beyond)
            };
            *force = downhill(sum);
            if ENERGY {
                // Half of each bond's energy belongs to each of its ends, and each bond is met at both.
                energy += 0.25 * stored.total();
                if let Some(factors) = &network.dilatation
                    && factors[node] != 0.0
                {
                    energy += 0.5 * rows[node][3] * rows[node][3] / factors[node];
                }
            }
        }
        energy
    }
}

/// Where nodes are, and what their bonds are held against.
#[derive(Clone, Copy)]
struct At<'a> {
    network: &'a Network,
    rows: &'a [Row],
    watch: Option<&'a Watch>,
}

impl At<'_> {
    /// What the bonds of a node pull it with, and four times the energy that they store, lane by lane.
    #[inline(always)]
    fn node<
        L: Lanes,
        const SHIFTED: bool,
        const DILATATION: bool,
        const FLOW: bool,
        const ENERGY: bool,
        const WATCH: bool,
    >(
        self,
        lanes: L,
        node: usize,
        family: &Family<'_>,
        beyond: &mut Vec<u32>,
    ) -> (Vector<L, 3>, Reals<L>) {
        let Self { network, rows, watch } = self;
        let none = lanes.same(0.0);
        let flow = network.flow.as_deref().filter(|_| FLOW);
        let [low, high] =
            watch.map_or([none; 2], |watch| [watch.compression, watch.tension].map(|s| lanes.same(s)));
        let own = Own::all(lanes, &rows[node]);
        let (mut sum, mut stored) = (lanes.vector([0.0; 3]), none);
        let returned = flow.map_or([none; 2], |flow| flow.trial[node].map(|value| lanes.same(value)));
        let start = network.packs_of(node).start;
        let lengths = family.values::<SHIFTED>(Number::Length, true);
        let stiffnesses = family.values::<SHIFTED>(Number::Stiffness, true);
        let here = family.values::<SHIFTED>(Number::Own, DILATATION);
        let there = family.values::<SHIFTED>(Number::Twin, DILATATION);
        for k in 0..family.len() {
            let others = &family.others(k);
            let bond = Present::of(lanes, &own, others, rows);
            let rest = lengths.of(lanes, k);
            let extension = bond.length - rest;
            let stiffness = stiffnesses.of(lanes, k);
            let mut pull;
            if FLOW && let Some(flow) = flow {
                let [near, far] = flow.elastic(lanes, start + k, returned, others, extension);
                // The sum first: the same from both ends, and without flow that of an elastic bond.
                pull = stiffness * ((near + far) * 0.5);
                if ENERGY {
                    stored += stiffness * near * near;
                }
            } else {
                pull = stiffness * extension;
                if ENERGY {
                    stored += pull * extension;
                }
            }
            if DILATATION {
                // The sum of the two products first: the same from both ends.
                pull += own.last * here.of(lanes, k) + bond.last * there.of(lanes, k);
            }
            // One quotient in place of three: the pull over the length, times the reach along each axis.
            sum += bond.reach * (pull / bond.length);
            if WATCH && let Some(watch) = watch {
                let over = extension.outside(low * rest, high * rest);
                let over = over & watch.lanes[start + k];
                if over != 0 {
                    note(over, start + k, beyond);
                }
            }
        }
        (sum, stored)
    }
}

/// `∂U/∂x` of a node as a row: minus what its bonds pull it with.
#[inline(always)]
pub(super) fn downhill<L: Lanes>(pull: Vector<L, 3>) -> Row {
    let [x, y, z] = pull.totals();
    [-x, -y, -z, 0.0]
}

/// Notes the bonds of a pack that are beyond their limit.
#[cold]
#[inline(never)]
fn note(over: u8, pack: usize, beyond: &mut Vec<u32>) {
    beyond.extend((0..LANES).filter(|lane| over & (1 << lane) != 0).map(|lane| (LANES * pack + lane) as u32));
}

/// What one sweep does.
#[derive(Clone, Copy)]
pub(crate) struct Wanted<'a> {
    /// Whether the stored energy is summed.
    pub energy: bool,
    /// Limits that bonds are held against, if any.
    pub watch: Option<&'a Watch>,
    /// Whose bonds are swept.
    pub share: &'a Share,
}

impl Network {
    /// Internal forces `∂U/∂x` of own nodes at the positions in `rows`, whose last places take the dilatations, and those behind
    /// the nodes' the images; returns the stored energy of all \[F L\], zero unless wanted. Bonds between own nodes are swept while
    /// those of others are on their way.
    pub fn evaluate(
        &mut self,
        rows: &mut [Row],
        forces: &mut [Row],
        scratch: &mut Scratch,
        wanted: Wanted<'_>,
    ) -> f64 {
        let share = wanted.share;
        share.send_places(rows);
        if self.dilatation.is_some() {
            self.find(rows, &mut scratch.dilatations, share);
        }
        let sweep = match (self.dilatation.is_some(), self.flow.is_some()) {
            (false, _) => Self::with::<false, false>,
            (true, false) => Self::with::<true, false>,
            (true, true) => Self::with::<true, true>,
        };
        sweep(self, rows, forces, scratch, wanted, share.inner());
        match self.dilatation.is_some() {
            true => self.take_found(rows, share),
            false => self.take_places(rows, share),
        }
        for nodes in share.outer(self.len()) {
            sweep(self, rows, forces, scratch, wanted, nodes);
        }
        if !wanted.energy {
            return 0.0;
        }
        let [stored] =
            share.sum(scratch.energies[share.chunks_of(self.len())].iter().map(|energy| [*energy]));
        stored
    }

    /// Finds `(λ − μ) V θ` of own nodes, and what flows, and sends them.
    fn find(&mut self, rows: &mut [Row], dilatations: &mut [f64], share: &Share) {
        match self.flow.take() {
            Some(mut flow) => {
                self.try_flow(&mut flow, rows, dilatations, share);
                self.flow = Some(flow);
            }
            None => self.dilate(rows, dilatations, share),
        }
        self.send_found(rows, share);
    }

    /// The sweep of a law.
    fn with<const DILATATION: bool, const FLOW: bool>(
        &self,
        rows: &[Row],
        forces: &mut [Row],
        scratch: &mut Scratch,
        wanted: Wanted<'_>,
        nodes: Range<usize>,
    ) {
        let sweep = match (wanted.energy, wanted.watch.is_some()) {
            (false, false) => Self::sweep::<DILATATION, FLOW, false, false>,
            (true, false) => Self::sweep::<DILATATION, FLOW, true, false>,
            (false, true) => Self::sweep::<DILATATION, FLOW, false, true>,
            (true, true) => Self::sweep::<DILATATION, FLOW, true, true>,
        };
        sweep(self, rows, forces, scratch, wanted, nodes);
    }

    fn sweep<const DILATATION: bool, const FLOW: bool, const ENERGY: bool, const WATCH: bool>(
        &self,
        rows: &[Row],
        forces: &mut [Row],
        scratch: &mut Scratch,
        wanted: Wanted<'_>,
        nodes: Range<usize>,
    ) {
        type Parts<'a> = (&'a mut [Row], (ByChunk<'a, f64>, ByChunk<'a, Vec<u32>>));
        let chunk = |first: usize, (forces, (ByChunk(energy), ByChunk(beyond))): Parts<'_>| {
            let ([energy, ..], [beyond, ..]) = (energy, beyond) else { return };
            beyond.clear();
            *energy = widest(Chunk::<DILATATION, FLOW, ENERGY, WATCH> {
                network: self,
                rows,
                first,
                forces,
                watch: wanted.watch,
                beyond,
            });
        };
        let chunks = nodes.start / CHUNK..nodes.end.div_ceil(CHUNK);
        let (energies, beyond) = (&mut scratch.energies[chunks.clone()], &mut scratch.beyond[chunks]);
        let lists = (&mut forces[nodes.clone()], (ByChunk(energies), ByChunk(beyond)));
        wanted.share.sweep(nodes.start, lists, chunk);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bonds::patterns::Packs;
    use lanes::Plain;
    use std::collections::BTreeMap;

    /// Bonds of uneven families, some of them broken, one of these between nodes that coincide.
    fn network(nodes: usize, state_based: bool) -> Network {
        let share = |k: usize| 0.1 + ((k * 7919) % 1000) as f64 / 1000.0;
        let mut out = Network::empty(state_based.then(|| (0..nodes).map(share).collect()));
        let (mut known, mut packs) = (BTreeMap::new(), Packs::default());
        for node in 0..nodes {
            packs.clear();
            for k in 0..LANES * (1 + node % 5) {
                let at = (node + 1 + 3 * (k / LANES) + k % LANES) % nodes;
                let number = 31 * node + k;
                let whole = if number.is_multiple_of(6) { 0.0 } else { share(number) };
                let shares = state_based.then_some([whole, 1.1 * whole]);
                packs.put(k, at as i32 - node as i32, share(at), whole, shares);
                out.bonds += 1;
            }
            out.add(&packs, &mut known);
        }
        out
    }

    fn swept<const DILATATION: bool>(plain: bool, network: &Network, rows: &[Row]) -> (Vec<u64>, Vec<u32>) {
        let lanes_of = vec![0b1011; network.packs()];
        let watch = Watch { lanes: lanes_of, tension: 0.2, compression: -0.1 };
        let (mut forces, mut beyond) = (vec![[0.0; 4]; rows.len()], Vec::new());
        let chunk = Chunk::<DILATATION, false, true, true> {
            network,
            rows,
            first: 0,
            forces: &mut forces,
            watch: Some(&watch),
            beyond: &mut beyond,
        };
        let energy = if plain { chunk.run(Plain) } else { widest(chunk) };
        (forces.iter().flatten().chain([&energy]).map(|x| x.to_bits()).collect(), beyond)
    }

    #[test]
    fn the_widest_lanes_give_the_bits_of_plain_loops_and_broken_bonds_are_harmless() {
        let nodes = 60;
        let mut rows: Vec<Row> =
            (0..nodes).map(|k| [0.3, 0.7, 0.9, 0.1].map(|part| libm::sin(part * (k * k) as f64))).collect();
        // Node 1 is at the other end of the first bond of node 0, which is broken.
        rows[1] = rows[0];
        let (pairwise, state_based) = (network(nodes, false), network(nodes, true));
        let plain = [swept::<false>(true, &pairwise, &rows), swept::<true>(true, &state_based, &rows)];
        for (bits, beyond) in &plain {
            assert!(bits.iter().all(|&bits| f64::from_bits(bits).is_finite()));
            assert!(!beyond.is_empty());
        }
        assert!(plain[0] == swept::<false>(false, &pairwise, &rows));
        assert!(plain[1] == swept::<true>(false, &state_based, &rows));
    }
}
