//! A peridynamic body as one of several whose equilibria are sought together.

use std::ops::DerefMut;

use implicit_statics::Joinable;

use super::StaticSolid;
use crate::Solid;

impl<S: DerefMut<Target = Solid>> Joinable for StaticSolid<S> {
    fn places(&self, nodes: &[u32], out: &mut [[f64; 3]]) {
        out.iter_mut().zip(nodes).for_each(|(out, &node)| *out = self.solid().position(node as usize).into());
    }

    fn put(&mut self, level: f64) {
        StaticSolid::put(self, level);
    }

    fn release(&mut self) {
        self.solid_mut().release_exerted();
    }

    fn exert(&mut self, nodes: &[u32], forces: &[[f64; 3]]) {
        self.solid_mut().add_exerted(nodes, forces);
    }

    fn motion_of(&self, node: u32) -> Vec<(usize, [f64; 3])> {
        self.directions(node as usize).map(|(unknown, direction)| (unknown, direction.into())).collect()
    }
}
