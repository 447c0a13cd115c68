//! What belongs to the preload: a load or a support that says so, and is else what it was.

use std::ops::Range;

use sph_core::Vec3;

use crate::conditions::body::{Block, Body};
use crate::conditions::case::LoadCase;
use crate::conditions::cavity::Enclosed;
use crate::conditions::loads::{Load, LoadOnShare};
use crate::conditions::prescribed::{Motion, Rotation};
use crate::conditions::supports::{Holds, Support};
use crate::error::ShellError;
use crate::reference::Reference;

/// A load or a support whose motion belongs to the preload.
pub struct Preloaded<T>(pub T);

impl Load for Preloaded<Box<dyn Load>> {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.0.add(scale, body, forces);
    }

    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        self.0.stiffness(scale, body, put);
    }

    fn on_body(&self, number: usize, mass: f64) -> Option<[Vec3; 2]> {
        self.0.on_body(number, mass)
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        self.0.check(reference)
    }

    fn on_share(&self, own: &Range<usize>, reference: &Reference) -> Option<LoadOnShare> {
        self.0.on_share(own, reference)
    }

    fn enclosed(&self) -> Option<&Enclosed> {
        self.0.enclosed()
    }

    fn case(&self) -> LoadCase {
        LoadCase::Preload
    }
}

impl Support for Preloaded<Box<dyn Support>> {
    fn holds(&self) -> Holds {
        let holds = self.0.holds();
        let motion = holds.motion.map(Motion::preloaded);
        let rotation = holds.rotation.map(|rotation| Rotation { case: LoadCase::Preload, ..rotation });
        Holds { motion, rotation, ..holds }
    }
}
