//! Bonds ready for the sweep: four to a pack, the packs of a node one behind the other.
//!
//! Nodes whose bonds are alike but for rounding share one list of packs, a *pattern*: other ends counted from the node, lengths,
//! stiffnesses and shares in dilatations. Each node has what its own numbers differ by, in units of the last place, so that all bits
//! are its own: of a lattice 4 bytes a bond (pairwise; state-based 8) in place of 20 (36). A node like no other has a pattern of its
//! own and no differences, as has one whose bonds break.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use super::correction::Weights;
use super::families::Families;
use super::flow::Flow;
use super::heat::BondHeat;
use super::images::Images;
pub(crate) use super::images::Row;
use super::patterns::{Family, Like, Packs, Shifts};
use crate::material::Moduli;
use sph_core::Vec3;

pub(crate) use lanes::{LANES, Pack};

/// Directed bonds with all that their forces need.
#[derive(Clone, Debug)]
pub(crate) struct Network {
    /// First pack of each node, and the end.
    pub starts: Vec<u32>,
    /// What the packs of each node are like.
    likes: Vec<Like>,
    pub(super) patterns: Packs,
    shifts: Shifts,
    /// `(λ − μ) Vᵢ` of each node \[F L\], of a law with a dilatation.
    pub dilatation: Option<Vec<f64>>,
    /// Directed bonds.
    pub bonds: usize,
    /// What planes of symmetry make of the nodes: rows of images stand behind those of the nodes.
    pub images: Option<Arc<Images>>,
    /// What of the extensions is plastic, where bonds yield.
    pub flow: Option<Box<Flow>>,
    /// How lengths go with heat, of a body that is warmed; its packs have numbers of their own.
    pub heat: Option<Box<BondHeat>>,
}

impl Network {
    /// Packs the bonds of all families; their lengths at rest are their own, or those between other places of nodes and images.
    ///
    /// A bond has the stiffness `Vᵢ Cᵢⱼ + Vⱼ Cⱼᵢ`, the same from both ends, on a plane of symmetry part of it ([`Images`]), and the shares
    /// Dᵢⱼ and Dⱼᵢ in the dilatations of its own and of the other node.
    pub fn new(families: &Families, weights: &Weights<'_>, places: Option<&[Vec3]>, moduli: &Moduli) -> Self {
        let volumes = &families.volumes;
        let factor = |node: usize| (moduli.lambda - moduli.mu) * volumes[node] / families.share(node);
        let state_based = weights.has_dilatation();
        let mut out = Self::empty(state_based.then(|| (0..families.len()).map(factor).collect()));
        (out.bonds, out.images) = (families.others.len(), families.images.clone());
        let packs = (0..families.len()).map(|node| families.of(node).len().div_ceil(LANES)).sum();
        out.shifts.reserve(packs, state_based);
        let (mut known, mut packs) = (BTreeMap::new(), Packs::default());
        for node in 0..families.len() {
            let part = families.share(node);
            packs.clear();
            for (k, bond) in families.bonds(node).enumerate() {
                let [own, twin] = weights.of_both(&bond);
                let stiffness =
                    part * (volumes[node] * own.deviatoric + volumes[bond.other] * twin.deviatoric);
                let shares = [own, twin].map(|share| part * share.dilatation);
                let length = places.map_or(bond.length, |at| (at[bond.other] - at[node]).norm());
                packs.put(
                    k,
                    bond.other as i32 - node as i32,
                    length,
                    stiffness,
                    state_based.then_some(shares),
                );
            }
            out.add(&packs, &mut known);
        }
        out.patterns.shrink();
        out
    }

    /// Without nodes.
    pub fn empty(dilatation: Option<Vec<f64>>) -> Self {
        Self {
            starts: vec![0],
            likes: Vec::new(),
            patterns: Packs::default(),
            shifts: Shifts::default(),
            dilatation,
            bonds: 0,
            images: None,
            flow: None,
            heat: None,
        }
    }

    /// Adds the packs of the next node; `known` tells of patterns by what they look like which node had them first.
    pub fn add(&mut self, packs: &Packs, known: &mut BTreeMap<u64, u32>) {
        let node = self.len() as u32;
        self.starts.push(self.packs() as u32 + packs.len() as u32);
        let look = packs.look();
        if let Some(&first) = known.get(&look) {
            let pattern = self.likes[first as usize].pattern;
            let length = self.packs_of(first as usize).len();
            let pattern_packs = pattern as usize..pattern as usize + length;
            if let Some(like) = self.shifts.add(&self.patterns, pattern_packs, packs) {
                self.likes[first as usize] = Like::shared(pattern);
                self.likes.push(like);
                return;
            }
        }
        known.entry(look).or_insert(node);
        self.likes.push(Like::own(self.patterns.append(packs)));
    }

    /// The node that a number means, or is an image of.
    #[inline]
    pub fn source(&self, number: usize) -> usize {
        self.images.as_ref().map_or(number, |images| images.source(number))
    }

    /// Rows of the nodes, with those of images behind them.
    pub fn extended<'a>(&self, rows: &'a [Row]) -> Cow<'a, [Row]> {
        Images::extended_rows(self.images.as_deref(), rows)
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of packs.
    pub fn packs(&self) -> usize {
        self.starts.last().map_or(0, |&end| end as usize)
    }

    /// Packs of a node.
    #[inline(always)]
    pub fn packs_of(&self, node: usize) -> Range<usize> {
        self.starts[node] as usize..self.starts[node + 1] as usize
    }

    /// What the packs of a node hold.
    #[inline(always)]
    pub fn family(&self, node: usize) -> Family<'_> {
        let count = self.packs_of(node).len();
        Family::of(node, count, self.likes[node], &self.patterns, &self.shifts)
    }

    /// Takes all that it carries from a directed bond.
    pub fn sever(&mut self, lane: usize) {
        let node = self.node_of(lane);
        let packs = self.packs_of(node);
        if !self.likes[node].is_own() {
            let own = self.family(node).exact();
            self.likes[node] = Like::own(self.patterns.append(&own));
        }
        let first = self.likes[node].pattern as usize;
        self.patterns.sever(first + lane / LANES - packs.start, lane % LANES);
    }

    /// Gives all packs numbers of their own, in their order; returns the lengths at which they pull with nothing \[L\].
    pub(super) fn take_apart(&mut self) -> &mut [Pack] {
        let mut packs = Packs::default();
        let likes = (0..self.len()).map(|node| Like::own(packs.append(&self.family(node).exact()))).collect();
        (self.likes, self.patterns, self.shifts) = (likes, packs, Shifts::default());
        self.patterns.lengths_mut()
    }

    /// Pairs of nodes with the stiffness of the whole bonds between them, images counted with their nodes \[F/L\].
    pub fn pairs(&self) -> Vec<(u32, u32, f64)> {
        let mut out = Vec::with_capacity(self.bonds / 2);
        for node in 0..self.len() {
            for (_, bond) in self.bonds_of(node) {
                let other = self.source(bond.other);
                if bond.stiffness == 0.0 || other == node {
                    continue;
                }
                // Both ends have the bond. With images each is half of it: one to an image is met at the image of this end, and one of a node on a
                // plane, of which a part belongs to the body, is met on both sides of the plane.
                if self.images.is_some() {
                    out.push((node as u32, other as u32, 0.5 * bond.stiffness));
                } else if node < other {
                    out.push((node as u32, other as u32, bond.stiffness));
                }
            }
        }
        out
    }

    /// Memory of the packs \[bytes\].
    pub fn bytes(&self) -> usize {
        let flow = self.flow.as_ref().map_or(0, |flow| flow.bytes());
        let heat = self.heat.as_ref().map_or(0, |heat| heat.bytes());
        self.patterns.bytes() + self.shifts.bytes() + size_of_val(&self.likes[..]) + flow + heat
    }
}
