//! A peridynamic body as one of several that are marched together.

use explicit_dynamics::Joinable;
use sph_core::Vec3;

use crate::Solid;

impl Joinable for Solid {
    fn particles(&self) -> usize {
        self.len()
    }

    fn places(&self, nodes: &[u32], out: &mut [[f64; 3]]) {
        out.iter_mut().zip(nodes).for_each(|(out, &node)| *out = self.position(node as usize).into());
    }

    fn velocities(&self, nodes: &[u32], out: &mut [[f64; 3]]) {
        out.iter_mut().zip(nodes).for_each(|(out, &node)| *out = self.velocity(node as usize).into());
    }

    fn masses(&self, nodes: &[u32]) -> Vec<f64> {
        nodes.iter().map(|&node| self.masses[node as usize]).collect()
    }

    fn release(&mut self) {
        self.release_exerted();
    }

    fn exert(&mut self, nodes: &[u32], forces: &[[f64; 3]]) {
        self.add_exerted(nodes, forces);
    }

    fn unscaled(&self, nodes: &[u32], v: &[f64], out: &mut [[f64; 3]]) {
        for (out, &node) in out.iter_mut().zip(nodes) {
            let row = node as usize;
            *out = self.scaled(row, Vec3::new(v[3 * row], v[3 * row + 1], v[3 * row + 2])).into();
        }
    }

    fn add_scaled(&self, nodes: &[u32], forces: &[[f64; 3]], out: &mut [f64]) {
        for (&node, &force) in nodes.iter().zip(forces) {
            let row = node as usize;
            let scaled = self.scaled(row, force.into());
            (0..3).for_each(|k| out[3 * row + k] += scaled[k]);
        }
    }
}
