//! Four bonds at the present: how far they reach, and the dilatations that follow from their extensions.

use std::ops::Range;

use lanes::{Lanes, Reals, Sweep, Vector, widest};

use super::network::{LANES, Network, Row};
use super::patterns::{Family, Number};
use crate::share::Share;

/// Least square of a present length \[L²\]: a bond that has collapsed pulls nowhere.
const COLLAPSED: f64 = 1e-200;

/// A row in all lanes: a place, and its last place.
#[derive(Clone, Copy)]
pub(super) struct Own<L: Lanes> {
    /// A place, or a displacement \[L\].
    pub at: Vector<L, 3>,
    /// The last place of the row.
    pub last: Reals<L>,
}

impl<L: Lanes> Own<L> {
    /// The same row in all lanes.
    #[inline(always)]
    pub fn all(lanes: L, row: &Row) -> Self {
        let [x, y, z, last] = lanes.spread(row);
        Self { at: Vector([x, y, z]), last }
    }

    /// The rows at the other ends of four bonds.
    #[inline(always)]
    pub fn of(lanes: L, others: &[u32; LANES], rows: &[Row]) -> Self {
        let [x, y, z, last] = lanes.read_columns(others.map(|other| &rows[other as usize]));
        Self { at: Vector([x, y, z]), last }
    }
}

/// Four bonds of a node at the present.
pub(super) struct Present<L: Lanes> {
    /// From the node to the other ends \[L\].
    pub reach: Vector<L, 3>,
    /// Length \[L\].
    pub length: Reals<L>,
    /// Last places of the rows at the other ends.
    pub last: Reals<L>,
}

impl<L: Lanes> Present<L> {
    /// Of a node and the other ends of four of its bonds.
    #[inline(always)]
    pub fn of(lanes: L, own: &Own<L>, others: &[u32; LANES], rows: &[Row]) -> Self {
        let other = Own::of(lanes, others, rows);
        let reach = other.at - own.at;
        Self { reach, length: reach.dot(reach).max(lanes.same(COLLAPSED)).sqrt(), last: other.last }
    }
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
        let Some(factors) = &network.dilatation else { return };
        for (i, value) in out.iter_mut().enumerate() {
            let node = first + i;
            let (own, family) = (Own::all(lanes, &rows[node]), network.family(node));
            let sum = if family.is_shifted {
                dilated::<L, true>(lanes, &own, &family, rows)
            } else {
                dilated::<L, false>(lanes, &own, &family, rows)
            };
            *value = factors[node] * sum.total();
        }
    }
}

/// θ of a node, lane by lane.
#[inline(always)]
fn dilated<L: Lanes, const SHIFTED: bool>(
    lanes: L,
    own: &Own<L>,
    family: &Family<'_>,
    rows: &[Row],
) -> Reals<L> {
    let lengths = family.values::<SHIFTED>(Number::Length, true);
    let shares = family.values::<SHIFTED>(Number::Own, true);
    let mut sum = lanes.same(0.0);
    for k in 0..family.len() {
        let bond = Present::of(lanes, own, &family.others(k), rows);
        sum += shares.of(lanes, k) * (bond.length - lengths.of(lanes, k));
    }
    sum
}

impl Network {
    /// Puts `(λ − μ) V θ` of own nodes into the last places of their rows, once places of ghosts are there.
    pub(super) fn dilate(&self, rows: &mut [Row], out: &mut [f64], share: &Share) {
        let mut find = |rows: &[Row], nodes: Range<usize>| {
            share.sweep(nodes.start, &mut out[nodes], |first, out: &mut [f64]| {
                widest(Dilate { network: self, rows, first, out })
            });
        };
        find(rows, share.inner());
        self.take_places(rows, share);
        share.outer(self.len()).into_iter().for_each(|nodes| find(rows, nodes));
        keep(rows, out, share);
    }
}

/// Puts a number of each own node into the last place of its row.
pub(super) fn keep(rows: &mut [Row], values: &[f64], share: &Share) {
    let own = share.own(values.len());
    share.sweep(own.start, &mut rows[own], |first, rows: &mut [Row]| {
        rows.iter_mut().zip(&values[first..]).for_each(|(row, value)| row[3] = *value);
    });
}
