//! A shell as a structure that a fluid wets.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Wetted};
use sph_core::Vec3;

use crate::Shell;
use crate::error::ShellError;
use crate::wetted::surface::Surface;
use crate::wetted::wetting::Wetting;

/// The boundary of a shell that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Shell {
    /// Lays points over the wet faces, through which a fluid acts on the shell from now on; it acts on nothing else.
    ///
    /// # Errors
    /// [`ShellError`] for a shell about an origin, a spacing or rows out of bounds, for edges that are none, and in a plane problem for a
    /// shell that is no strip across the plane.
    pub fn wet(&mut self, wetting: &Wetting) -> Result<(), ShellError> {
        if self.reference.origin != Vec3::zeros() {
            return Err(ShellError::WetFromAfar);
        }
        let surface = Surface::new(&self.reference.cloud, self.thickness(), wetting)?;
        if self.external.is_empty() {
            self.external = vec![[0.0; 6]; self.len()];
        }
        self.wetted = Some(Box::new(surface));
        Ok(())
    }
}

impl Wetted for Shell {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        match &self.wetted {
            Some(surface) => surface.places(&self.state, out),
            None => *out = BoundaryState::default(),
        }
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.wetted {
            surface.take(&self.state, load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.wetted {
            surface.impedance_impulses(&self.rates, span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        match &self.wetted {
            Some(surface) => surface.velocities(&self.rates, out),
            None => out.clear(),
        }
    }

    fn particles(&self) -> usize {
        self.len()
    }
}
