//! A rigid body as a fluid wets it.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Wetted};
use sph_core::Vec3;

use crate::body::RigidBody;

/// The boundary of a body that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Wetted for RigidBody {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        let axes = self.motion.turn.axes();
        let arms = self.wetted.iter().flat_map(|surface| &surface.arms);
        out.points.clear();
        out.points.extend(arms.map(|arm| <[f64; 3]>::from(self.motion.pole + axes * arm)));
        out.middle.clear();
        out.normals.clear();
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.wetted {
            surface.take(load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.wetted {
            surface.add_impulses(&self.moving(), span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        let (axes, spin) = (self.motion.turn.axes(), self.spin());
        let velocity = |arm: &Vec3| <[f64; 3]>::from(self.motion.velocity + spin.cross(&(axes * arm)));
        out.clear();
        out.extend(self.wetted.iter().flat_map(|surface| &surface.arms).map(velocity));
    }
}
