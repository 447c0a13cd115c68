//! A shell as a structure that a fluid wets.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Wetted};

use crate::Shell;

/// The boundary of a shell that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Wetted for Shell {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.loading.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        match &self.loading.wetted {
            Some(surface) => surface.places(&self.motion.state, out),
            None => *out = BoundaryState::default(),
        }
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.loading.wetted {
            surface.take(&self.motion.state, load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.loading.wetted {
            surface.impedance_impulses(&self.motion.rates, span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        match &self.loading.wetted {
            Some(surface) => surface.velocities(&self.motion.rates, out),
            None => out.clear(),
        }
    }

    fn particles(&self) -> usize {
        self.len()
    }
}
