//! The tangent of all bonds applied to a displacement, at any state.
//!
//! Of bonds that yield it is that of the elastic law, at what was kept of the flow. With M the direction of a bond, y its length, P its pull and δ the difference of the displacements of its ends,
//!
//! ```text
//! δe = M·δ      δθ̂ᵢ = (λ − μ) Vᵢ Σⱼ Dᵢⱼ δe      δP = c δe + δθ̂ᵢ Dᵢⱼ + δθ̂ⱼ Dⱼᵢ
//! δ(∂U/∂xᵢ) = −Σⱼ [δP M + (P/y)(δ − δe M)]
//! ```

use lanes::{Lanes, Reals, Sweep, Vector, widest};

use super::forces::{Scratch, downhill};
use super::network::{LANES, Network, Row};
use super::patterns::{Family, Number};
use super::present::{Own, Present, keep};
use crate::share::Share;

/// A state, and a displacement from it; their last places are `θ̂` and its change.
#[derive(Clone, Copy)]
struct Linear<'a> {
    network: &'a Network,
    rows: &'a [Row],
    along: &'a [Row],
    first: usize,
}

/// Four bonds at a state, and how they change.
struct Change<L: Lanes> {
    at: Present<L>,
    /// δ.
    difference: Vector<L, 3>,
    /// Last places of the displacement at the other ends.
    last: Reals<L>,
    /// `1/y`.
    inverse: Reals<L>,
    /// δe.
    extension: Reals<L>,
}

impl<L: Lanes> Change<L> {
    /// Of a node, at the state and as it moves, and the other ends of four of its bonds.
    #[inline(always)]
    fn of(lanes: L, own: &[Own<L>; 2], others: &[u32; LANES], rows: [&[Row]; 2]) -> Self {
        let at = Present::of(lanes, &own[0], others, rows[0]);
        let moved = Own::of(lanes, others, rows[1]);
        let difference = moved.at - own[1].at;
        let inverse = lanes.same(1.0) / at.length;
        let extension = at.reach.dot(difference) * inverse;
        Self { at, difference, last: moved.last, inverse, extension }
    }
}

/// Changes of dilatations of one chunk of nodes.
struct Dilate<'a> {
    at: Linear<'a>,
    out: &'a mut [f64],
}

impl Sweep for Dilate<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { at: Linear { network, rows, along, first }, out } = self;
        let Some(factors) = &network.dilatation else { return };
        for (i, value) in out.iter_mut().enumerate() {
            let node = first + i;
            let own = [Own::all(lanes, &rows[node]), Own::all(lanes, &along[node])];
            let family = network.family(node);
            let sum = if family.is_shifted {
                dilated::<L, true>(lanes, &own, &family, [rows, along])
            } else {
                dilated::<L, false>(lanes, &own, &family, [rows, along])
            };
            *value = factors[node] * sum.total();
        }
    }
}

/// δθ of a node, lane by lane.
#[inline(always)]
fn dilated<L: Lanes, const SHIFTED: bool>(
    lanes: L,
    own: &[Own<L>; 2],
    family: &Family<'_>,
    rows: [&[Row]; 2],
) -> Reals<L> {
    let shares = family.values::<SHIFTED>(Number::Own, true);
    let mut sum = lanes.same(0.0);
    for k in 0..family.len() {
        let bond = Change::of(lanes, own, &family.others(k), rows);
        sum += shares.of(lanes, k) * bond.extension;
    }
    sum
}

/// Changes of forces of one chunk of nodes; `DILATATION` where the law has one.
struct Chunk<'a, const DILATATION: bool> {
    at: Linear<'a>,
    out: &'a mut [Row],
}

impl<const DILATATION: bool> Sweep for Chunk<'_, DILATATION> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { at, out } = self;
        for (i, out) in out.iter_mut().enumerate() {
            let node = at.first + i;
            let family = at.network.family(node);
            *out = downhill(if family.is_shifted {
                at.pulled::<L, true, DILATATION>(lanes, node, &family)
            } else {
                at.pulled::<L, false, DILATATION>(lanes, node, &family)
            });
        }
    }
}

impl Linear<'_> {
    /// By how much more the bonds of a node pull it.
    #[inline(always)]
    fn pulled<L: Lanes, const SHIFTED: bool, const DILATATION: bool>(
        self,
        lanes: L,
        node: usize,
        family: &Family<'_>,
    ) -> Vector<L, 3> {
        let Self { network, rows, along, .. } = self;
        let own = [Own::all(lanes, &rows[node]), Own::all(lanes, &along[node])];
        let mut sum = lanes.vector([0.0; 3]);
        let first = network.packs_of(node).start;
        let lengths = family.values::<SHIFTED>(Number::Length, true);
        let stiffnesses = family.values::<SHIFTED>(Number::Stiffness, true);
        let near = family.values::<SHIFTED>(Number::Own, DILATATION);
        let far = family.values::<SHIFTED>(Number::Twin, DILATATION);
        for k in 0..family.len() {
            let bond = Change::of(lanes, &own, &family.others(k), [rows, along]);
            let stiffness = stiffnesses.of(lanes, k);
            let mut extension = bond.at.length - lengths.of(lanes, k);
            if let Some(flow) = &network.flow {
                extension = extension - flow.mean(lanes, first + k);
            }
            let mut pull = stiffness * extension;
            let mut more = stiffness * bond.extension;
            if DILATATION {
                let (here, there) = (near.of(lanes, k), far.of(lanes, k));
                pull += own[0].last * here + bond.at.last * there;
                more += own[1].last * here + bond.last * there;
            }
            let across = pull * bond.inverse;
            let along = (more - across * bond.extension) * bond.inverse;
            sum += bond.at.reach * along + bond.difference * across;
        }
        sum
    }
}

impl Network {
    /// `∂²U/∂x∂x` at the positions in `rows` times the displacements in `along`, of own nodes; the last places of both take dilatations,
    /// the rows behind those of the nodes the images.
    pub fn tangent(
        &mut self,
        rows: &mut [Row],
        along: &mut [Row],
        out: &mut [Row],
        scratch: &mut Scratch,
        share: &Share,
    ) {
        let nodes = share.own(self.len());
        share.send_places(rows);
        if self.dilatation.is_some() {
            self.dilate(rows, &mut scratch.dilatations, share);
            self.send_found(rows, share);
            self.take_found(rows, share);
        } else {
            self.take_places(rows, share);
        }
        share.exchange_places(along);
        if let Some(images) = &self.images {
            images.reflect(along);
        }
        if self.dilatation.is_some() {
            let (network, values) = (&*self, &mut scratch.dilatations);
            let (rows, at): (&[Row], &[Row]) = (rows, along);
            share.sweep(nodes.start, &mut values[nodes.clone()], |first, out: &mut [f64]| {
                widest(Dilate { at: Linear { network, rows, along: at, first }, out });
            });
            keep(along, values, share);
            self.send_found(along, share);
            self.take_found(along, share);
        }
        let (network, rows, along): (&Self, &[Row], &[Row]) = (self, rows, along);
        share.sweep(nodes.start, &mut out[nodes], |first, out: &mut [Row]| {
            let at = Linear { network, rows, along, first };
            match network.dilatation.is_some() {
                true => widest(Chunk::<true> { at, out }),
                false => widest(Chunk::<false> { at, out }),
            }
        });
    }
}
