//! Four bonds at the present: how far they reach, and the dilatations that follow from their extensions.

use rayon::prelude::*;
use sph_core::lanes::{Lanes, Sweep, widest};

use super::network::{LANES, NODE_CHUNK, Network, Row};

/// Least square of a present length \[L²\]: a bond that has collapsed pulls nowhere.
const COLLAPSED: f64 = 1e-200;

/// Four bonds of a node at the present.
pub(super) struct Present<L: Lanes> {
    /// From the node to the other ends \[L\].
    pub reach: [L::Four; 3],
    /// Length \[L\].
    pub length: L::Four,
    /// Last places of the rows at the other ends.
    pub last: L::Four,
}

/// A row in all lanes.
#[inline(always)]
pub(super) fn spread<L: Lanes>(lanes: L, row: &Row) -> [L::Four; 4] {
    row.map(|place| lanes.splat(place))
}

#[inline(always)]
pub(super) fn present<L: Lanes>(
    lanes: L,
    own: &[L::Four; 4],
    others: &[u32; LANES],
    rows: &[Row],
) -> Present<L> {
    let [x, y, z, last] = lanes.columns(others.map(|other| &rows[other as usize]));
    let [x, y, z] = [lanes.sub(x, own[0]), lanes.sub(y, own[1]), lanes.sub(z, own[2])];
    let square = lanes.add(lanes.add(lanes.mul(x, x), lanes.mul(y, y)), lanes.mul(z, z));
    let length = lanes.sqrt(lanes.max(square, lanes.splat(COLLAPSED)));
    Present { reach: [x, y, z], length, last }
}

/// Dilatations `(λ − μ) V θ` of one chunk of nodes.
struct Dilate<'a> {
    network: &'a Network,
    rows: &'a [Row],
    first: usize,
    out: &'a mut [f64],
}

impl Sweep for Dilate<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { network, rows, first, out } = self;
        let Some(dilatation) = &network.dilatation else { return };
        for (i, value) in out.iter_mut().enumerate() {
            let node = first + i;
            let own = spread(lanes, &rows[node]);
            let packs = network.packs_of(node);
            let mut sum = lanes.splat(0.0);
            let shares = &dilatation.own[packs.clone()];
            for ((others, rest), share) in
                network.others[packs.clone()].iter().zip(&network.lengths[packs]).zip(shares)
            {
                let bond = present(lanes, &own, others, rows);
                let extension = lanes.sub(bond.length, lanes.load(rest));
                sum = lanes.add(sum, lanes.mul(lanes.load(share), extension));
            }
            *value = dilatation.factors[node] * lanes.total(sum);
        }
    }
}

impl Network {
    /// Puts `(λ − μ) V θ` of all nodes into the last places of their rows.
    pub(super) fn dilate(&self, rows: &mut [Row], out: &mut [f64], threads: usize) {
        let at: &[Row] = rows;
        in_chunks(out, threads, |first, out| widest(Dilate { network: self, rows: at, first, out }));
        keep(rows, out, threads);
        if let Some(images) = &self.images {
            images.carry(rows);
        }
    }
}

/// Puts a number of each node into the last place of its row.
pub(super) fn keep(rows: &mut [Row], values: &[f64], threads: usize) {
    let one = |(row, value): (&mut Row, &f64)| row[3] = *value;
    if threads > 1 {
        rows.par_iter_mut().zip(values).with_min_len(NODE_CHUNK).for_each(one);
    } else {
        rows.iter_mut().zip(values).for_each(one);
    }
}

/// Hands out chunks of nodes with the number of their first.
pub(super) fn in_chunks<T: Send>(
    out: &mut [T],
    threads: usize,
    work: impl Fn(usize, &mut [T]) + Sync + Send,
) {
    let one = |(number, out): (usize, &mut [T])| work(number * NODE_CHUNK, out);
    if threads > 1 {
        out.par_chunks_mut(NODE_CHUNK).enumerate().for_each(one);
    } else {
        out.chunks_mut(NODE_CHUNK).enumerate().for_each(one);
    }
}
