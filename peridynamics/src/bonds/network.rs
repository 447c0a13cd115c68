//! Bonds ready for the sweep: four to a pack, the packs of a node one behind the other.

use std::borrow::Cow;
use std::sync::Arc;

use super::correction::Weights;
use super::families::Families;
use super::flow::Flow;
use super::heat::BondHeat;
use super::images::Images;
pub(crate) use super::images::Row;
use crate::material::Moduli;

pub(crate) use lanes::{LANES, Pack};

/// Directed bonds with all that their forces need.
#[derive(Clone, Debug)]
pub(crate) struct Network {
    /// First pack of each node, and the end.
    pub starts: Vec<u32>,
    /// The nodes at the other ends, beyond the nodes images; lanes that only fill up a pack repeat one and have no stiffness.
    pub others: Vec<[u32; LANES]>,
    /// Lengths r at which bonds pull with nothing, those at rest but for heat \[L\].
    pub lengths: Vec<Pack>,
    /// `Vᵢ Cᵢⱼ + Vⱼ Cⱼᵢ`, the same from both ends \[F/L\]; zero once broken. On a plane of symmetry part of it: see [`Images`].
    pub stiffness: Vec<Pack>,
    /// What a law with a dilatation has beside.
    pub dilatation: Option<Dilatation>,
    /// Directed bonds.
    pub bonds: usize,
    /// What planes of symmetry make of the nodes: rows of images stand behind those of the nodes.
    pub images: Option<Arc<Images>>,
    /// What of the extensions is plastic, where bonds yield.
    pub flow: Option<Box<Flow>>,
    /// How lengths go with heat, of a body that is warmed.
    pub heat: Option<Box<BondHeat>>,
}

/// Dilatations per extension, and what they stress.
#[derive(Clone, Debug)]
pub(crate) struct Dilatation {
    /// Dᵢⱼ, the share of a bond in the dilatation of its own node \[1/L\]; zero once broken.
    pub own: Vec<Pack>,
    /// Dⱼᵢ, its share in that of the other node \[1/L\]; zero once broken.
    pub twin: Vec<Pack>,
    /// `(λ − μ) Vᵢ` of each node \[F L\].
    pub factors: Vec<f64>,
}

impl Network {
    /// Packs the bonds of all families.
    pub fn new(families: &Families, weights: &Weights, volumes: &[f64], moduli: &Moduli) -> Self {
        let state_based = !weights.dilatation.is_empty();
        let volumes = &*families.whole(volumes);
        let factor = |node: usize| (moduli.lambda - moduli.mu) * volumes[node] / families.share(node);
        let mut out = Self {
            starts: vec![0],
            others: Vec::new(),
            lengths: Vec::new(),
            stiffness: Vec::new(),
            dilatation: state_based.then(|| Dilatation {
                own: Vec::new(),
                twin: Vec::new(),
                factors: (0..families.len()).map(factor).collect(),
            }),
            bonds: families.others.len(),
            images: families.images.clone(),
            flow: None,
            heat: None,
        };
        let packs = (0..families.len()).map(|node| families.of(node).len().div_ceil(LANES)).sum();
        out.reserve(packs);
        let mut twins = families.twins();
        for node in 0..families.len() {
            let part = families.share(node);
            for first in families.of(node).step_by(LANES) {
                let end = families.of(node).end;
                let of = |value: &dyn Fn(usize) -> f64| -> Pack {
                    std::array::from_fn(|lane| if first + lane < end { value(first + lane) } else { 0.0 })
                };
                let filled = |lane: usize| (first + lane).min(end - 1);
                let twins: [usize; LANES] =
                    std::array::from_fn(|lane| if first + lane < end { twins.next(first + lane) } else { 0 });
                let twin = |bond: usize| twins[bond - first];
                out.others.push(std::array::from_fn(|lane| families.others[filled(lane)]));
                out.lengths.push(std::array::from_fn(|lane| families.lengths[filled(lane)]));
                out.stiffness.push(of(&|bond| {
                    let other = families.others[bond] as usize;
                    let [own, back] = [
                        volumes[node] * weights.deviatoric[bond],
                        volumes[other] * weights.deviatoric[twin(bond)],
                    ];
                    part * (own + back)
                }));
                if let Some(dilatation) = &mut out.dilatation {
                    dilatation.own.push(of(&|bond| part * weights.dilatation[bond]));
                    dilatation.twin.push(of(&|bond| part * weights.dilatation[twin(bond)]));
                }
            }
            out.starts.push(out.others.len() as u32);
        }
        out
    }

    /// Makes room for so many packs.
    fn reserve(&mut self, packs: usize) {
        self.others.reserve_exact(packs);
        self.lengths.reserve_exact(packs);
        self.stiffness.reserve_exact(packs);
        if let Some(dilatation) = &mut self.dilatation {
            dilatation.own.reserve_exact(packs);
            dilatation.twin.reserve_exact(packs);
        }
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

    /// Packs of a node.
    #[inline(always)]
    pub fn packs_of(&self, node: usize) -> std::ops::Range<usize> {
        self.starts[node] as usize..self.starts[node + 1] as usize
    }

    /// Shares of packs in the dilatations of the near and the far node; any numbers without a dilatation, to be ignored.
    #[inline(always)]
    pub(super) fn shares(&self, packs: std::ops::Range<usize>) -> [&[Pack]; 2] {
        match &self.dilatation {
            Some(dilatation) => [&dilatation.own[packs.clone()], &dilatation.twin[packs]],
            None => [&self.lengths[packs.clone()], &self.lengths[packs]],
        }
    }

    /// Pairs of nodes with the stiffness of the whole bonds between them, images counted with their nodes \[F/L\].
    pub fn pairs(&self) -> Vec<(u32, u32, f64)> {
        let mut out = Vec::with_capacity(self.bonds / 2);
        for node in 0..self.len() {
            for pack in self.packs_of(node) {
                for (&number, &own) in self.others[pack].iter().zip(&self.stiffness[pack]) {
                    let other = self.source(number as usize);
                    if own == 0.0 || other == node {
                        continue;
                    }
                    // Both ends have the bond. With images each is half of it: one to an image is met at the image of this end, and one of a node
                    // on a plane, of which a part belongs to the body, is met on both sides of the plane.
                    if self.images.is_some() {
                        out.push((node as u32, other as u32, 0.5 * own));
                    } else if node < other {
                        out.push((node as u32, other as u32, own));
                    }
                }
            }
        }
        out
    }

    /// Memory of the packs \[bytes\].
    pub fn bytes(&self) -> usize {
        let arrays = if self.dilatation.is_some() { 4 } else { 2 };
        let flow = self.flow.as_ref().map_or(0, |flow| flow.bytes());
        self.others.len() * (size_of::<[u32; LANES]>() + arrays * size_of::<Pack>()) + flow
    }
}
