//! Contact of fragments: nodes without a whole bond repel each other at short range, and walls repel nodes.
//!
//! ```text
//! U = ½ k (d − Y)²  of two nodes at a distance Y < d        k = c Vᵢ Vⱼ/d,  c = 2n(n+2) μ/m
//! ```
//!
//! with c the constant of pairwise bonds in n dimensions, `m = ∫ r dV` of a whole family (\[silling2005\]), and d the distance
//! of contact, at most the length that a broken bond had: two nodes that touch resist as a bond of that length would. Programs
//! of particles take `15 c Vᵢ Vⱼ/δ`, five times as much where `δ = 3d`, and with it nearly half of the step. A wall is a mirror: a node at a height z over
//! it is repelled by its image at Y = 2z. It gives way and never lets go: the force grows on the other side.
//!
//! Two equal masses M that touch add at most `2k/M` to an eigenvalue of the mass-scaled stiffness. Of nodes no closer to each
//! other than d at most six in a plane and twelve in space touch one, and pull along an axis with three and four times k;
//! so contact adds at most 2·3 or 2·4 times `k/M`, and a wall `4k/M` at most.

use std::ops::Range;

use parallel::{ByChunk, CHUNK};
use sph_core::{CellList, Vec3};

use super::intact::Whole;
use super::network::{Network, Row};
use crate::contact::Contact;
use crate::error::SolidError;
use crate::material::{Elastic, Moduli};
use crate::share::Share;

/// How far beyond contact pairs are listed, over the distance of contact: a wide list is made anew less often.
const SKIN: f64 = 0.5;

/// Repulsion of nodes without a whole bond.
#[derive(Clone, Debug)]
pub(crate) struct Repulsion {
    /// d \[L\].
    distance: f64,
    /// `k/(Vᵢ Vⱼ)` \[F/L⁷\].
    stiffness: f64,
    walls: Vec<[Vec3; 2]>,
    volumes: Vec<f64>,
    /// Bound of what contact adds to eigenvalues of the mass-scaled stiffness \[1/T²\].
    spectrum: f64,
    /// Nodes near each other that never had a bond: the first of each own node, and the end; ascending.
    starts: Vec<u32>,
    near: Vec<u32>,
    /// Where the nodes were when they were listed \[L\]; empty before.
    listed: Vec<Vec3>,
    /// Energy of each chunk of nodes.
    energies: Vec<f64>,
}

/// The body that contact belongs to.
pub(crate) struct Touching<'a> {
    pub network: &'a Network,
    pub bonds: &'a Whole,
    pub rows: &'a [Row],
    pub share: &'a Share,
}

impl Repulsion {
    /// The repulsion of the nodes of a body.
    ///
    /// # Errors
    /// [`SolidError::Limit`].
    pub fn new(
        contact: &Contact,
        moduli: &Moduli,
        material: &Elastic,
        volumes: &[f64],
        [spacing, horizon, thickness]: [f64; 3],
    ) -> Result<Self, SolidError> {
        if !(contact.distance > 0.0 && contact.distance <= 1.0) {
            let bound =
                "it must be positive and at most one spacing, so that a body at rest is not in contact";
            return Err(SolidError::Limit {
                what: "the distance of contact",
                value: contact.distance,
                bound,
            });
        }
        let mut walls = contact.walls.clone();
        for [_, normal] in &mut walls {
            let length = normal.norm();
            if !(length > 0.0 && length.is_finite()) {
                let bound = "it must point to the side of the body";
                return Err(SolidError::Limit {
                    what: "the length of a wall's normal",
                    value: length,
                    bound,
                });
            }
            *normal /= length;
        }
        let d = moduli.dimensions as f64;
        let pi = std::f64::consts::PI;
        let m = if moduli.dimensions == 3 {
            pi * horizon.powi(4)
        } else {
            thickness * 2.0 / 3.0 * pi * horizon.powi(3)
        };
        let distance = contact.distance * spacing;
        let stiffness = 2.0 * d * (d + 2.0) * moduli.mu / (m * distance);
        // The stiffest pair over the lighter mass.
        let greatest = volumes.iter().fold(0.0_f64, |most, &volume| most.max(volume));
        let pairs = if moduli.dimensions == 3 { 8.0 } else { 6.0 };
        let factor = pairs + 4.0 * walls.len() as f64;
        Ok(Self {
            distance,
            stiffness,
            spectrum: factor * stiffness * greatest / material.density,
            walls,
            volumes: volumes.to_vec(),
            starts: Vec::new(),
            near: Vec::new(),
            listed: Vec::new(),
            energies: vec![0.0; volumes.len().div_ceil(CHUNK)],
        })
    }

    /// Bound of what contact adds to eigenvalues of the mass-scaled stiffness \[1/T²\].
    pub fn spectrum(&self) -> f64 {
        self.spectrum
    }

    /// Energy of a pair whose bond of this length broke, at the present distance \[F L\].
    pub fn of_broken(&self, [a, b]: [usize; 2], length: f64, present: f64) -> f64 {
        let depth = (self.distance.min(length) - present).max(0.0);
        0.5 * self.stiffness * (self.volumes[a] * self.volumes[b]) * depth * depth
    }

    /// Adds `∂U/∂x` of contact to the forces of own nodes; returns the energy of all if it is wanted \[F L\]. Places of all nodes are here.
    pub fn add(&mut self, body: &Touching<'_>, forces: &mut [Row], wanted: bool) -> f64 {
        let Touching { share, .. } = body;
        let (own, chunks) = (share.own(self.volumes.len()), share.chunks_of(self.volumes.len()));
        self.list(body, own.clone());
        let mut energies = std::mem::take(&mut self.energies);
        let one = |first: usize, (forces, ByChunk(energy)): (&mut [Row], ByChunk<'_, f64>)| {
            let of = |(i, force): (usize, &mut Row)| self.on_node(first + i, own.start, body, force);
            let sum: f64 = forces.iter_mut().enumerate().map(of).sum();
            energy.iter_mut().for_each(|energy| *energy = sum);
        };
        share.sweep(own.start, (&mut forces[own.clone()], ByChunk(&mut energies[chunks.clone()])), one);
        self.energies = energies;
        if !wanted {
            return 0.0;
        }
        let [energy] = share.sum(self.energies[chunks].iter().map(|energy| [*energy]));
        energy
    }

    /// Adds the force on one node, of those listed from the first; returns its half of the energy.
    fn on_node(&self, node: usize, listed: usize, body: &Touching<'_>, force: &mut Row) -> f64 {
        let Touching { network, bonds, rows, .. } = body;
        let mut energy = 0.0;
        let x = place(&rows[node]);
        let mut repel = |other: usize, distance: f64| {
            let from = x - place(&rows[other]);
            let square = from.norm_squared();
            if square >= distance * distance || square == 0.0 {
                return;
            }
            let (length, k) = (square.sqrt(), self.stiffness * (self.volumes[node] * self.volumes[other]));
            let depth = distance - length;
            energy += 0.25 * k * depth * depth;
            for axis in 0..3 {
                force[axis] -= k * depth * from[axis] / length;
            }
        };
        for lane in bonds.broken(network.packs_of(node)) {
            let bond = network.bond(node, lane);
            repel(bond.other, self.distance.min(bond.length));
        }
        let [start, end] = [0, 1].map(|next| self.starts[node - listed + next] as usize);
        for &other in &self.near[start..end] {
            repel(other as usize, self.distance);
        }
        for [on, normal] in &self.walls {
            let depth = self.distance - 2.0 * (x - on).dot(normal);
            if depth > 0.0 {
                let k = self.stiffness * self.volumes[node] * self.volumes[node];
                energy += 0.25 * k * depth * depth;
                (0..3).for_each(|axis| force[axis] -= k * depth * normal[axis]);
            }
        }
        energy
    }

    /// Lists the pairs near each other of own nodes, once any node has moved by half of the skin.
    fn list(&mut self, body: &Touching<'_>, own: Range<usize>) {
        let skin = SKIN * self.distance;
        let count = self.volumes.len();
        let moved = |(old, row): (&Vec3, &Row)| (place(row) - old).norm_squared() > 0.25 * skin * skin;
        if self.listed.len() == count && !self.listed.iter().zip(body.rows).any(moved) {
            return;
        }
        self.listed.clear();
        self.listed.extend(body.rows[..count].iter().map(place));
        let reach = self.distance + skin;
        let cells = CellList::new(&self.listed, reach);
        (self.starts, self.near) = (vec![0], Vec::new());
        let mut around = Vec::new();
        for node in own {
            cells.within(&self.listed[node], reach, &mut around);
            let bonded = |other: u32| {
                let mut bonds = body.network.bonds_of(node);
                bonds.any(|(lane, bond)| body.bonds.is_bond(lane) && bond.other == other as usize)
            };
            let strangers = around.iter().filter(|&&other| other as usize != node && !bonded(other));
            self.near.extend(strangers);
            self.starts.push(self.near.len() as u32);
        }
    }
}

fn place(row: &Row) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
