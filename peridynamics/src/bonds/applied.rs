//! The tangent of all bonds applied to a displacement, at any state.
//!
//! With M the direction of a bond, y its length, P its pull and δ the difference of the displacements of its ends,
//!
//! ```text
//! δe = M·δ      δθ̂ᵢ = (λ − μ) Vᵢ Σⱼ Dᵢⱼ δe      δP = c δe + δθ̂ᵢ Dᵢⱼ + δθ̂ⱼ Dⱼᵢ
//! δ(∂U/∂xᵢ) = −Σⱼ [δP M + (P/y)(δ − δe M)]
//! ```

use sph_core::lanes::{Lanes, Sweep, widest};

use super::forces::Scratch;
use super::network::{LANES, Network, Row};
use super::present::{Present, in_chunks, keep, present, spread};

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
    difference: [L::Four; 3],
    /// Last places of the displacement at the other ends.
    last: L::Four,
    /// `1/y`.
    inverse: L::Four,
    /// δe.
    extension: L::Four,
}

#[inline(always)]
fn change<L: Lanes>(
    lanes: L,
    own: &[[L::Four; 4]; 2],
    others: &[u32; LANES],
    rows: [&[Row]; 2],
) -> Change<L> {
    let at = present(lanes, &own[0], others, rows[0]);
    let [x, y, z, last] = lanes.columns(others.map(|other| &rows[1][other as usize]));
    let difference = [lanes.sub(x, own[1][0]), lanes.sub(y, own[1][1]), lanes.sub(z, own[1][2])];
    let part = |axis: usize| lanes.mul(at.reach[axis], difference[axis]);
    let inverse = lanes.div(lanes.splat(1.0), at.length);
    let extension = lanes.mul(lanes.add(lanes.add(part(0), part(1)), part(2)), inverse);
    Change { at, difference, last, inverse, extension }
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
        let Some(dilatation) = &network.dilatation else { return };
        for (i, value) in out.iter_mut().enumerate() {
            let node = first + i;
            let own = [spread(lanes, &rows[node]), spread(lanes, &along[node])];
            let packs = network.packs_of(node);
            let mut sum = lanes.splat(0.0);
            for (others, share) in network.others[packs.clone()].iter().zip(&dilatation.own[packs]) {
                let bond = change(lanes, &own, others, [rows, along]);
                sum = lanes.add(sum, lanes.mul(lanes.load(share), bond.extension));
            }
            *value = dilatation.factors[node] * lanes.total(sum);
        }
    }
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
        let Self { at: Linear { network, rows, along, first }, out } = self;
        for (i, out) in out.iter_mut().enumerate() {
            let node = first + i;
            let own = [spread(lanes, &rows[node]), spread(lanes, &along[node])];
            let mut sum = [lanes.splat(0.0); 3];
            let packs = network.packs_of(node);
            let [here, there] = network.shares(packs.clone());
            let elastic = network.lengths[packs.clone()].iter().zip(&network.stiffness[packs.clone()]);
            let bonds = network.others[packs].iter().zip(elastic).zip(here.iter().zip(there));
            for ((others, (rest, stiffness)), (here, there)) in bonds {
                let bond = change(lanes, &own, others, [rows, along]);
                let stiffness = lanes.load(stiffness);
                let mut pull = lanes.mul(stiffness, lanes.sub(bond.at.length, lanes.load(rest)));
                let mut more = lanes.mul(stiffness, bond.extension);
                if DILATATION {
                    let (here, there) = (lanes.load(here), lanes.load(there));
                    let both = |own, last| lanes.add(lanes.mul(own, here), lanes.mul(last, there));
                    pull = lanes.add(pull, both(own[0][3], bond.at.last));
                    more = lanes.add(more, both(own[1][3], bond.last));
                }
                let across = lanes.mul(pull, bond.inverse);
                let along = lanes.mul(lanes.sub(more, lanes.mul(across, bond.extension)), bond.inverse);
                for axis in 0..3 {
                    let one = lanes.mul(along, bond.at.reach[axis]);
                    let other = lanes.mul(across, bond.difference[axis]);
                    sum[axis] = lanes.add(sum[axis], lanes.add(one, other));
                }
            }
            *out = [-lanes.total(sum[0]), -lanes.total(sum[1]), -lanes.total(sum[2]), 0.0];
        }
    }
}

impl Network {
    /// `∂²U/∂x∂x` at the positions in `rows` times the displacements in `along`; the last places of both take dilatations,
    /// the rows behind those of the nodes the images.
    pub fn tangent(
        &self,
        rows: &mut [Row],
        along: &mut [Row],
        out: &mut [Row],
        scratch: &mut Scratch,
        threads: usize,
    ) {
        if let Some(images) = &self.images {
            images.place(rows);
            images.reflect(along);
        }
        if self.dilatation.is_some() {
            let values = &mut scratch.dilatations;
            self.dilate(rows, values, threads);
            let (rows, at): (&[Row], &[Row]) = (rows, along);
            in_chunks(values, threads, |first, out| {
                widest(Dilate { at: Linear { network: self, rows, along: at, first }, out });
            });
            keep(along, values, threads);
            if let Some(images) = &self.images {
                images.carry(along);
            }
        }
        let (rows, along): (&[Row], &[Row]) = (rows, along);
        in_chunks(out, threads, |first, out| {
            let at = Linear { network: self, rows, along, first };
            match self.dilatation.is_some() {
                true => widest(Chunk::<true> { at, out }),
                false => widest(Chunk::<false> { at, out }),
            }
        });
    }
}
