//! What acts on a body beside its loads: pressures that follow its surface, functions, other bodies.

use explicit_dynamics::{Exert, Push};
use sph_core::Vec3;

use crate::Solid;
use crate::error::SolidError;
use crate::following::FollowingPressure;

impl Solid {
    /// Lets a pressure follow its surface from now on, in marches: statics have no stiffness of it.
    ///
    /// # Errors
    /// [`SolidError::NoSuchNode`] for a surface that other nodes carry.
    pub fn follow(&mut self, pressure: FollowingPressure) -> Result<(), SolidError> {
        let (surface, count) = (&pressure.surface, self.block.len());
        let mut bearers = (0..surface.vertices.len()).flat_map(|vertex| surface.bearers(vertex));
        if let Some(&(node, _)) = bearers.find(|(node, _)| *node as usize >= count) {
            return Err(SolidError::NoSuchNode { what: "a pressure that follows", node, count });
        }
        self.external.resize(self.rest.len(), Vec3::zeros());
        self.following.push(pressure);
        Ok(())
    }

    /// Takes away what other bodies exert.
    pub(crate) fn release_exerted(&mut self) {
        self.exerted.clear();
    }

    /// Adds what other bodies exert on some of its nodes, from now on until that is taken away.
    pub(crate) fn add_exerted(&mut self, nodes: &[u32], forces: &[[f64; 3]]) {
        self.external.resize(self.rest.len(), Vec3::zeros());
        self.exerted.extend(nodes.iter().copied().zip(forces.iter().map(|&force| force.into())));
    }

    /// Lets a function exert forces on all nodes from now on, in marches.
    pub fn push(&mut self, exert: Exert) {
        self.external.resize(self.rest.len(), Vec3::zeros());
        self.push = Some(Box::new(Push::new(self.block.len(), exert)));
    }
}
