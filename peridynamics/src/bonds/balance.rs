//! Weights of bonds for which uniform strains are in balance, at faces too.
//!
//! Under a uniform strain ε a bond pulls with `c r n·εn`, along n. A node is in balance with the tractions of an elastic solid
//! on the area `aᵢ` of the faces that it stands for when
//!
//! ```text
//! Σⱼ cᵢⱼ r n⊗n⊗n = −μ (aᵢ⊗1 + its two transposes)          Σⱼ (Vᵢ Dᵢⱼ + Vⱼ Dⱼᵢ) n = −aᵢ,   Σⱼ Dᵢⱼ r n⊗n = 1
//! ```
//!
//! c is the stiffness of the whole bond; the dilatation is exact at every node then. Inside, where `a = 0`, weights that even out
//! energies fulfil that by symmetry; within two horizons of a face they do not. They are changed as little as fulfils it
//! (`least_change`), no bond to a stiffness below zero. Forces that balance uniform strains do the work `½ V σ:ε` on them, so that
//! their energy stays exact in all, though not node by node.

use nalgebra::SVector;
use sph_core::Vec3;

use super::correction::{Shares, Weights};
use super::families::Families;
use super::least_change::Wanted;
use crate::error::SolidError;
use crate::material::Moduli;

/// Products of three directions in a plane and in space.
const CUBES: [&[usize]; 10] = [
    &[0, 0, 0],
    &[0, 0, 1],
    &[0, 1, 1],
    &[1, 1, 1],
    &[0, 0, 2],
    &[0, 1, 2],
    &[1, 1, 2],
    &[0, 2, 2],
    &[1, 2, 2],
    &[2, 2, 2],
];
const OF_PLANE: [&[usize]; 5] = [&[0, 0], &[1, 1], &[0, 1], &[0], &[1]];
const OF_SPACE: [&[usize]; 9] = [&[0, 0], &[1, 1], &[2, 2], &[0, 1], &[0, 2], &[1, 2], &[0], &[1], &[2]];

/// Where weights are to be in balance.
pub(crate) struct Balance<'a> {
    pub families: &'a Families,
    /// Places of nodes and images \[L\].
    pub positions: &'a [Vec3],
    /// Volumes that the body has of its nodes \[L³\].
    pub volumes: &'a [f64],
    /// Areas of faces that whole nodes stand for, outward \[L²\].
    pub areas: &'a [Vec3],
    /// Greatest spacing \[L\].
    pub spacing: f64,
    pub moduli: &'a Moduli,
}

impl Balance<'_> {
    /// Changes weights as little as brings uniform strains into balance.
    ///
    /// # Errors
    /// [`SolidError::Unbalanced`] where no weights do.
    pub fn bring(&self, weights: &mut Weights<'_>) -> Result<(), SolidError> {
        let plane = self.moduli.dimensions == 2;
        let mut shares = weights.all();
        let done =
            if plane { self.stiffnesses::<4>(&mut shares) } else { self.stiffnesses::<10>(&mut shares) };
        done?;
        match (shares.dilatation.is_empty(), plane) {
            (true, _) => {}
            (_, true) => self.dilatations(&mut shares, OF_PLANE)?,
            (_, false) => self.dilatations(&mut shares, OF_SPACE)?,
        }
        weights.take(shares);
        Ok(())
    }

    fn stiffnesses<const T: usize>(&self, weights: &mut Shares) -> Result<(), SolidError> {
        let products: [&[usize]; T] = std::array::from_fn(|q| CUBES[q]);
        let mu = self.moduli.mu / self.spacing;
        let row = |_: f64, area: &Vec3, axes: &[usize]| {
            let (a, b, c) = (axes[0], axes[1], axes[2]);
            let part = |one: usize, other: usize, third: usize| if other == third { area[one] } else { 0.0 };
            -mu * (part(a, b, c) + part(b, a, c) + part(c, a, b))
        };
        self.solve(&mut weights.deviatoric, products, row, true)
    }

    fn dilatations<const T: usize>(
        &self,
        weights: &mut Shares,
        products: [&'static [usize]; T],
    ) -> Result<(), SolidError> {
        let row = |volume: f64, area: &Vec3, axes: &[usize]| match *axes {
            [a] => -area[a],
            [a, b] if a == b => volume / self.spacing,
            _ => 0.0,
        };
        self.solve(&mut weights.dilatation, products, row, false)
    }

    /// Solves for the shares `Vᵢ` times a weight of each directed bond.
    fn solve<const T: usize>(
        &self,
        weights: &mut [f64],
        products: [&'static [usize]; T],
        row: impl Fn(f64, &Vec3, &[usize]) -> f64,
        positive: bool,
    ) -> Result<(), SolidError> {
        let families = self.families;
        let whole = families.whole(self.volumes);
        let rows = (0..families.len())
            .map(|node| SVector::from_fn(|q, _| row(whole[node], &self.areas[node], products[q])))
            .collect();
        let mut shares = weights.to_vec();
        for node in 0..families.len() {
            families.of(node).for_each(|bond| shares[bond] *= whole[node]);
        }
        let mut twins = families.twins();
        // Stiffnesses change in parts of their own; of dilatations some are nothing where a family is cut, and may become more.
        let mut mobility = Vec::with_capacity(shares.len());
        for node in 0..families.len() {
            for bond in families.of(node) {
                let both = shares[bond] + shares[twins.next(bond)];
                let seen = families.bond(node, bond);
                let volumes = whole[node] * families.volume(&seen);
                mobility.push(if positive { both.max(0.0) } else { volumes * seen.length });
            }
        }
        let near = self.near();
        let mut wanted = Wanted {
            near: &near,
            families,
            positions: self.positions,
            spacing: self.spacing,
            products,
            rows,
            lengths: (0..families.len())
                .flat_map(|node| families.bonds(node))
                .map(|bond| bond.length)
                .collect(),
            shares,
            mobility,
            positive,
        };
        wanted.solve().map_err(|_| {
            SolidError::Unbalanced(
                "no weights of its bonds do that; take a longer horizon or an even lattice",
            )
        })?;
        for node in 0..families.len() {
            families.of(node).for_each(|bond| weights[bond] = wanted.shares[bond] / whole[node]);
        }
        Ok(())
    }
}

impl Balance<'_> {
    /// Nodes in reach of those that have a face in theirs.
    fn near(&self) -> Vec<bool> {
        let mut faces = Vec::new();
        for axis in 0..self.moduli.dimensions {
            for sign in [-1.0, 1.0] {
                let on_face = |&node: &usize| sign * self.areas[node][axis] > 0.0;
                let node = (0..self.areas.len()).find(on_face);
                faces.extend(node.map(|node| (axis, self.positions[node][axis])));
            }
        }
        let depth = 2.0 * self.families.reach;
        let near = |x: &Vec3| faces.iter().any(|&(axis, at)| (x[axis] - at).abs() <= depth);
        self.positions[..self.families.len()].iter().map(near).collect()
    }
}
