//! What is enclosed as a load: its factor is the share of the content that is in.

use crate::conditions::body::{Block, Body};
use crate::conditions::cavity::Enclosed;
use crate::conditions::loads::Load;
use crate::conditions::spread::check_cells;
use crate::error::ShellError;
use crate::reference::Reference;

impl Load for Enclosed {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.exert(scale, body, forces);
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.stiffness_in_cells(scale, body, put);
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        check_cells("what is enclosed", self.cells(), &reference.cloud)
    }

    fn enclosed(&self) -> Option<&Enclosed> {
        Some(self)
    }
}
