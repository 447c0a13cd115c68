//! Families: the nodes within the horizon of each node, with their partial volumes.

use std::borrow::Cow;
use std::sync::Arc;

use sph_core::{CellList, Vec3};

use super::images::Images;
use crate::error::SolidError;
use crate::formulation::Volumes;
use crate::mirror::Mirror;

/// Nodes closer than this part of the spacing coincide.
const COINCIDENT: f64 = 1e-6;

/// The family of each node at the start, others ascending: directed bonds, each pair twice.
///
/// Four bytes a bond: lengths and partial volumes are worked out from the places and volumes of nodes when they are asked for.
#[derive(Clone, Debug)]
pub(crate) struct Families {
    /// First bond of each node, and the end.
    pub starts: Vec<u32>,
    /// The node at the other end; numbers beyond the nodes are images.
    pub others: Vec<u32>,
    /// Places of nodes, and of images behind them \[L\].
    pub places: Vec<Vec3>,
    /// Volumes of whole nodes and of images \[L³\].
    pub volumes: Vec<f64>,
    /// Horizon δ \[L\].
    pub horizon: f64,
    /// δ' = δ + ½Δx, beyond which no part of a volume lies inside the horizon \[L\].
    pub reach: f64,
    /// Greatest spacing Δx \[L\].
    spacing: f64,
    /// How much of a volume counts.
    rule: Volumes,
    /// What planes of symmetry make of the nodes.
    pub images: Option<Arc<Images>>,
}

/// A directed bond as its node sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub node: usize,
    /// The node at the other end, or an image.
    pub other: usize,
    /// From the node to the other end \[L\].
    pub across: Vec3,
    /// Length r \[L\].
    pub length: f64,
}

impl Seen {
    /// Direction n, towards the other end.
    pub fn direction(&self) -> Vec3 {
        self.across / self.length
    }
}

/// Where bonds come from: nodes, their volumes, and how far they reach.
pub(crate) struct Nodes<'a> {
    pub positions: &'a [Vec3],
    pub volumes: &'a [f64],
    /// Greatest spacing Δx \[L\].
    pub spacing: f64,
    pub mirrors: &'a [Mirror],
}

impl Families {
    /// Joins each node with those inside the horizon, given in spacings.
    ///
    /// # Errors
    /// [`SolidError::Horizon`], [`SolidError::Volume`], [`SolidError::Coincident`], [`SolidError::Alone`],
    /// [`SolidError::Mirror`].
    pub fn new(nodes: &Nodes<'_>, horizon: f64, volumes: Volumes) -> Result<Self, SolidError> {
        if !(horizon >= 1.4 && horizon.is_finite()) {
            return Err(SolidError::Horizon(horizon));
        }
        let invalid = nodes.volumes.iter().position(|&volume| !(volume > 0.0 && volume.is_finite()));
        if let Some(node) = invalid {
            return Err(SolidError::Volume { node: node as u32, volume: nodes.volumes[node] });
        }
        let (dx, delta) = (nodes.spacing, horizon * nodes.spacing);
        let reach = delta + 0.5 * dx;
        let search = if volumes == Volumes::Partial { reach } else { delta };
        let images = Images::new(nodes.positions, nodes.mirrors, dx, search)?.map(Arc::new);
        let mut out = Self {
            starts: vec![0],
            others: Vec::new(),
            places: nodes.positions.to_vec(),
            volumes: nodes.volumes.to_vec(),
            horizon: delta,
            reach,
            spacing: dx,
            rule: volumes,
            images,
        };
        if let Some(images) = &out.images {
            (out.places, out.volumes) = (images.extended(nodes.positions, true), images.whole(nodes.volumes));
        }
        let list = CellList::new(&out.places, search);
        let mut near = Vec::new();
        for (i, x) in nodes.positions.iter().enumerate() {
            list.within(x, search, &mut near);
            for &j in near.iter().filter(|&&j| j as usize != i) {
                let r = out.seen(i, j as usize).length;
                if r < COINCIDENT * dx {
                    return Err(SolidError::Coincident(i as u32, j));
                }
                if out.part(r) > 0.0 {
                    out.others.push(j);
                }
            }
            if out.others.len() == out.starts[i] as usize {
                return Err(SolidError::Alone(i as u32));
            }
            out.starts.push(out.others.len() as u32);
        }
        Ok(out)
    }

    /// The part of a volume at this distance that lies inside the horizon.
    fn part(&self, length: f64) -> f64 {
        match self.rule {
            Volumes::Whole => 1.0,
            Volumes::Partial => ((self.reach - length) / self.spacing).clamp(0.0, 1.0),
        }
    }

    /// Partial volume V̄ of the other node of a bond inside the horizon \[L³\].
    pub fn volume(&self, bond: &Seen) -> f64 {
        self.volume_at(bond.other, bond.length)
    }

    /// That of a node or an image at this distance \[L³\].
    pub fn volume_at(&self, other: usize, length: f64) -> f64 {
        self.part(length) * self.volumes[other]
    }

    /// The bond of a node with another, or with an image.
    pub fn seen(&self, node: usize, other: usize) -> Seen {
        let across = self.places[other] - self.places[node];
        Seen { node, other, across, length: across.norm() }
    }

    /// A bond by its number.
    pub fn bond(&self, node: usize, bond: usize) -> Seen {
        self.seen(node, self.others[bond] as usize)
    }

    /// The bonds of a node, others ascending.
    pub fn bonds(&self, node: usize) -> impl Iterator<Item = Seen> + Clone + '_ {
        self.of(node).map(move |bond| self.bond(node, bond))
    }

    /// A bond as its other end sees it; its length has the same bits but for images.
    pub fn back(&self, bond: &Seen) -> Seen {
        let Seen { node, other, length, .. } = *bond;
        match &self.images {
            Some(images) => self.seen(images.source(other), images.seen_back(node, other)),
            None => Seen { node: other, other: node, across: self.places[node] - self.places[other], length },
        }
    }

    /// The number of a bond.
    pub fn number(&self, bond: &Seen) -> usize {
        let family = self.of(bond.node);
        family.start + self.others[family].partition_point(|&other| (other as usize) < bond.other)
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Directed bonds of a node.
    pub fn of(&self, node: usize) -> std::ops::Range<usize> {
        self.starts[node] as usize..self.starts[node + 1] as usize
    }

    /// Places with those of images behind them.
    pub fn extended<'a>(&self, positions: &'a [Vec3]) -> Cow<'a, [Vec3]> {
        self.images
            .as_ref()
            .map_or(Cow::Borrowed(positions), |images| images.extended(positions, true).into())
    }

    /// The same of directions.
    pub fn reflected<'a>(&self, directions: &'a [Vec3]) -> Cow<'a, [Vec3]> {
        self.images
            .as_ref()
            .map_or(Cow::Borrowed(directions), |images| images.extended(directions, false).into())
    }

    /// Volumes of whole nodes and of images, from those that the body has of them.
    pub fn whole<'a>(&self, volumes: &'a [f64]) -> Cow<'a, [f64]> {
        self.images.as_ref().map_or(Cow::Borrowed(volumes), |images| images.whole(volumes).into())
    }

    /// The node that a number means, or is an image of.
    pub fn source(&self, number: usize) -> usize {
        self.images.as_ref().map_or(number, |images| images.source(number))
    }

    /// The part of a node that belongs to the body.
    pub fn share(&self, node: usize) -> f64 {
        self.images.as_ref().map_or(1.0, |images| images.share(node))
    }

    /// The bonds seen from their other ends, asked for bond by bond from the first.
    ///
    /// Distances are the same from both ends to the last bit, so that each bond has its twin; and since the nodes of a
    /// family ascend, the twins in a family are met in their order. The twins of images are looked for.
    pub fn twins(&self) -> Twins<'_> {
        Twins { families: self, next: self.starts.clone(), node: 0 }
    }
}

/// See [`Families::twins`].
pub(crate) struct Twins<'a> {
    families: &'a Families,
    /// The first bond of each family whose twin was not met.
    next: Vec<u32>,
    /// The node whose bonds are asked for.
    node: usize,
}

impl Twins<'_> {
    /// The twin of the next bond.
    pub fn next(&mut self, bond: usize) -> usize {
        let families = self.families;
        while bond >= families.of(self.node).end {
            self.node += 1;
        }
        let other = families.others[bond] as usize;
        if let Some(images) = &families.images {
            let (source, back) = (images.source(other), images.seen_back(self.node, other) as u32);
            let family = families.of(source);
            return family.start + families.others[family].partition_point(|&seen| seen < back);
        }
        let next = &mut self.next[other];
        *next += 1;
        *next as usize - 1
    }
}
