//! Families: the nodes within the horizon of each node, with their partial volumes.

use sph_core::{CellList, Vec3};

use crate::error::SolidError;
use crate::formulation::Volumes;

/// Nodes closer than this part of the spacing coincide.
const COINCIDENT: f64 = 1e-6;

/// The family of each node at the start, others ascending: directed bonds, each pair twice.
#[derive(Clone, Debug)]
pub(crate) struct Families {
    /// First bond of each node, and the end.
    pub starts: Vec<u32>,
    /// The node at the other end.
    pub others: Vec<u32>,
    /// Length r \[L\].
    pub lengths: Vec<f64>,
    /// Partial volume V̄ of the other node inside the horizon \[L³\].
    pub volumes: Vec<f64>,
    /// Horizon δ \[L\].
    pub horizon: f64,
    /// δ' = δ + ½Δx, beyond which no part of a volume lies inside the horizon \[L\].
    pub reach: f64,
}

/// Where bonds come from: nodes, their volumes, and how far they reach.
pub(crate) struct Nodes<'a> {
    pub positions: &'a [Vec3],
    pub volumes: &'a [f64],
    /// Greatest spacing Δx \[L\].
    pub spacing: f64,
}

impl Families {
    /// Joins each node with those inside the horizon, given in spacings.
    ///
    /// # Errors
    /// [`SolidError::Horizon`], [`SolidError::Volume`], [`SolidError::Coincident`], [`SolidError::Alone`].
    pub fn new(nodes: &Nodes<'_>, horizon: f64, volumes: Volumes) -> Result<Self, SolidError> {
        if !(horizon >= 1.4 && horizon.is_finite()) {
            return Err(SolidError::Horizon(horizon));
        }
        let unsound = nodes.volumes.iter().position(|&volume| !(volume > 0.0 && volume.is_finite()));
        if let Some(node) = unsound {
            return Err(SolidError::Volume { node: node as u32, volume: nodes.volumes[node] });
        }
        let (dx, delta) = (nodes.spacing, horizon * nodes.spacing);
        let reach = delta + 0.5 * dx;
        let search = if volumes == Volumes::Partial { reach } else { delta };
        let list = CellList::new(nodes.positions, search);
        let mut out = Self {
            starts: vec![0],
            others: Vec::new(),
            lengths: Vec::new(),
            volumes: Vec::new(),
            horizon: delta,
            reach,
        };
        let mut near = Vec::new();
        for (i, x) in nodes.positions.iter().enumerate() {
            list.within(x, search, &mut near);
            for &j in near.iter().filter(|&&j| j as usize != i) {
                let r = (nodes.positions[j as usize] - x).norm();
                if r < COINCIDENT * dx {
                    return Err(SolidError::Coincident(i as u32, j));
                }
                let share = match volumes {
                    Volumes::Whole => 1.0,
                    Volumes::Partial => ((reach - r) / dx).clamp(0.0, 1.0),
                };
                if share > 0.0 {
                    out.others.push(j);
                    out.lengths.push(r);
                    out.volumes.push(share * nodes.volumes[j as usize]);
                }
            }
            if out.others.len() == out.starts[i] as usize {
                return Err(SolidError::Alone(i as u32));
            }
            out.starts.push(out.others.len() as u32);
        }
        Ok(out)
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Directed bonds of a node.
    pub fn of(&self, node: usize) -> std::ops::Range<usize> {
        self.starts[node] as usize..self.starts[node + 1] as usize
    }

    /// The bonds seen from their other ends, asked for bond by bond from the first.
    ///
    /// Distances are the same from both ends to the last bit, so that each bond has its twin; and since the nodes of a
    /// family ascend, the twins in a family are met in their order.
    pub fn twins(&self) -> Twins<'_> {
        Twins { families: self, next: self.starts.clone() }
    }
}

/// See [`Families::twins`].
pub(crate) struct Twins<'a> {
    families: &'a Families,
    /// The first bond of each family whose twin was not met.
    next: Vec<u32>,
}

impl Twins<'_> {
    /// The twin of the next bond.
    pub fn next(&mut self, bond: usize) -> usize {
        let next = &mut self.next[self.families.others[bond] as usize];
        *next += 1;
        *next as usize - 1
    }
}
