//! The body as one of several whose equilibria are sought together.

use implicit_statics::{Equilibrium, Joinable};
use sph_core::Vec3;

use crate::body::Galerkin;

impl Joinable for Galerkin {
    fn places(&self, nodes: &[u32], out: &mut [[f64; 3]]) {
        let of = |&node: &u32| (self.rest()[node as usize] + self.displacement(node as usize)).into();
        out.iter_mut().zip(nodes).for_each(|(out, node)| *out = of(node));
    }

    fn put(&mut self, level: f64) {
        Galerkin::put(self, level);
    }

    fn release(&mut self) {
        self.exerted.clear();
    }

    /// Nodes move with the parameters of all whose shape functions reach them: a force on one is spread by the same numbers.
    fn exert(&mut self, nodes: &[u32], forces: &[[f64; 3]]) {
        self.exerted.resize(self.parameters.len(), 0.0);
        for (&node, &force) in nodes.iter().zip(forces) {
            let shape = &self.space.nodal[node as usize];
            for (&other, phi) in shape.nodes.iter().zip(&shape.values) {
                self.space.images.add(&mut self.exerted, other, &(Vec3::from(force) * *phi));
            }
        }
    }

    fn motion_of(&self, node: u32) -> Vec<(usize, [f64; 3])> {
        let along = [Vec3::x(), Vec3::y(), Vec3::z()].map(|axis| self.functional(&[node], axis));
        let moves = (0..self.unknowns()).map(|i| (i, [0, 1, 2].map(|k| along[k][i])));
        moves.filter(|(_, way)| *way != [0.0; 3]).collect()
    }
}
