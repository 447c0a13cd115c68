//! A Galerkin solid with its cells and the forces of its supports.

use implicit_statics::Equilibrium;
use sph_core::{Cell, Vec3};
use sr_galerkin::{Galerkin, Supports};

use super::places::Places;
use super::recovery::{RECOVERED, all_of, in_space, recovered};
use crate::bodies::Yielding;

/// A Galerkin solid with what the application shows of it.
pub(crate) struct GalerkinSolid {
    pub(super) galerkin: Galerkin,
    /// Background cells by their corners, which are nodes; those that are not shown stand behind the others.
    hexahedra: Vec<[u32; 8]>,
    /// How many are shown.
    shown: usize,
    /// Their faces on the outside.
    pub(super) outer: Vec<Cell>,
    /// What its supports bear; none where nobody asks for it.
    pub(super) supports: Option<Supports>,
    /// Forces that supports exert, by node \[F\].
    pub(super) reactions: Vec<Vec3>,
    /// Plastic strain beyond which the table of hardening says nothing \[–\]; none of other curves.
    pub(super) data_until: Option<f64>,
    /// Space for forces on unknowns.
    pub(super) scratch: Vec<f64>,
}

impl GalerkinSolid {
    pub(super) fn new(
        galerkin: Galerkin,
        places: &Places,
        supports: Option<Supports>,
        data_until: Option<f64>,
    ) -> Self {
        let reactions = vec![Vec3::zeros(); galerkin.nodes()];
        let (hexahedra, shown, outer) = (places.cells.cells.clone(), places.shown(), places.outer());
        let scratch = vec![0.0; galerkin.unknowns()];
        Self { galerkin, hexahedra, shown, outer, supports, reactions, data_until, scratch }
    }

    /// The solid itself.
    pub fn galerkin(&self) -> &Galerkin {
        &self.galerkin
    }

    /// Degrees of freedom that no support holds.
    pub fn dof(&self) -> usize {
        self.galerkin.unknowns()
    }

    /// Background cells by their corners, but those that a surface leaves less than half of.
    pub fn hexahedra(&self) -> &[[u32; 8]] {
        &self.hexahedra[..self.shown]
    }

    /// Stress, strain and angle at the nodes.
    pub fn at_nodes(&self) -> Vec<[f64; RECOVERED]> {
        recovered(&self.hexahedra, self.galerkin.rest(), &self.galerkin.point_results(), all_of)
    }

    /// Stress `xx, yy, zz, xy, yz, zx` in space at the nodes \[F/L²\].
    pub fn stresses_at_nodes(&self) -> Vec<[f64; 6]> {
        let in_space = |point: &sr_galerkin::PointResult| in_space(point.stress, &point.axes);
        recovered(&self.hexahedra, self.galerkin.rest(), &self.galerkin.point_results(), in_space)
    }

    /// By node: the greatest plastic strain of the points of the cells round it, and its share of what they dissipated; empty where nothing
    /// yields.
    pub fn flowed_at_nodes(&self) -> Vec<Yielding> {
        let flowed = self.galerkin.flowed();
        if flowed.is_empty() {
            return Vec::new();
        }
        let none = Yielding { plastic_strain: 0.0, thickness: f64::INFINITY, dissipated: 0.0 };
        let mut out = vec![none; self.galerkin.nodes()];
        let points = flowed.len() / self.hexahedra.len();
        for (corners, own) in self.hexahedra.iter().zip(flowed.chunks(points)) {
            let most = own.iter().fold(0.0_f64, |most, [strain, _]| most.max(*strain));
            let lost: f64 = own.iter().map(|[_, lost]| lost).sum();
            for &node in corners {
                let of = &mut out[node as usize];
                of.plastic_strain = of.plastic_strain.max(most);
                of.dissipated += lost / corners.len() as f64;
            }
        }
        out
    }

    /// Forces that supports exert on nodes \[F\], if they are known.
    pub fn reactions(&self) -> Option<&[Vec3]> {
        self.supports.as_ref().map(|_| self.reactions.as_slice())
    }
}
