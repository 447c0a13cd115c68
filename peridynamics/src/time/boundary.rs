//! A peridynamic body as a structure that a fluid wets.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad, BoundaryState, Wetted};
use sph_core::Vec3;

use crate::Solid;
use crate::error::SolidError;
use crate::wetted::Surface;

/// The boundary of a solid that is dry.
static DRY: BoundaryLayout = BoundaryLayout { points: 0, areas: Vec::new(), thin: None };

impl Solid {
    /// Puts the solid into a fluid, which acts on its nodes from now on; they should be as far apart as the particles of the
    /// fluid. In a plane forces per depth act on its thickness.
    ///
    /// # Errors
    /// [`SolidError::WetSheets`] for a plate of two sheets.
    pub fn wet(&mut self) -> Result<(), SolidError> {
        if self.rest.len() > self.block.len() {
            return Err(SolidError::WetSheets);
        }
        if self.external.is_empty() {
            self.external = vec![Vec3::zeros(); self.rest.len()];
        }
        self.wetted = Some(Box::new(Surface::new(&self.block)));
        Ok(())
    }
}

impl Wetted for Solid {
    fn boundary_layout(&self) -> &BoundaryLayout {
        self.wetted.as_ref().map_or(&DRY, |surface| &surface.layout)
    }

    fn boundary(&self, out: &mut BoundaryState) {
        match &self.wetted {
            Some(surface) => surface.places(&self.rows, out),
            None => *out = BoundaryState::default(),
        }
    }

    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        if let Some(surface) = &mut self.wetted {
            surface.take(&self.rows, load);
        }
    }

    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        if let Some(surface) = &self.wetted {
            surface.impedance_impulses(&self.rates, span, impulses);
        }
    }

    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        out.clear();
        if self.wetted.is_some() {
            out.extend(self.rates.iter().map(|rate| [rate[0], rate[1], rate[2]]));
        }
    }

    fn particles(&self) -> usize {
        self.len()
    }
}
