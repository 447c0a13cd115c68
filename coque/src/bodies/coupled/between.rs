//! The structures of a fluid as bodies that do something to each other.

use std::any::Any;

use sph_core::Vec3;

use super::body::Clocks;
use crate::bodies::body::Body;
use crate::bodies::together::{OnTool, Parts, TouchingBodies};

impl Parts for Clocks {
    fn each(&self) -> Vec<&dyn Body> {
        self.structures().map(|part| part as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.structures_mut().map(|part| part as &mut dyn Body).collect()
    }

    fn force_on(&self, interaction: usize, body: usize, particle: usize) -> Vec3 {
        self.interactions().force_on(interaction, body, particle as u32).into()
    }

    fn touching(&self, interaction: usize) -> Option<&TouchingBodies> {
        (self.interactions().get(interaction)? as &dyn Any).downcast_ref()
    }

    fn on_tool(&self, interaction: usize) -> Option<&OnTool> {
        (self.interactions().get(interaction)? as &dyn Any).downcast_ref()
    }

    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64 {
        self.interactions().lost_at(interaction, body, particle as u32)
    }

    fn kept(&self) -> Vec<Vec<f64>> {
        self.interactions().kept()
    }

    fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        Clocks::take_up(self, kept)
    }
}
