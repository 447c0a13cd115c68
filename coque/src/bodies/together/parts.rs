//! What is asked of a body beside others, and of all of them whatever they are solved by.

use std::any::Any;

use sph_core::Vec3;

use super::contact::TouchingBodies;
use super::on_tool::OnTool;
use crate::bodies::body::{Body, DynamicBody, StaticBody};

/// A body that is marched beside others.
pub(in crate::bodies) trait MarchedPart: DynamicBody + explicit_dynamics::Joinable {}

impl<B: DynamicBody + explicit_dynamics::Joinable> MarchedPart for B {}

/// A body whose equilibria are sought beside others.
pub(in crate::bodies) trait BalancedPart: StaticBody + implicit_statics::Joinable {}

impl<B: StaticBody + implicit_statics::Joinable> BalancedPart for B {}

/// Bodies marched together.
pub(super) type Marched = explicit_dynamics::Several<dyn MarchedPart>;
/// Bodies balanced together.
pub(super) type Balanced = implicit_statics::Several<dyn BalancedPart>;

/// Bodies one behind the other.
pub(super) trait Parts: Send {
    /// Each of them.
    fn each(&self) -> Vec<&dyn Body>;

    /// The same, to put them into other states.
    fn each_mut(&mut self) -> Vec<&mut dyn Body>;

    /// What an interaction last exerted on a particle of a body \[F\].
    fn force_on(&self, interaction: usize, body: usize, particle: usize) -> Vec3;

    /// An interaction, if it is a contact.
    fn touching(&self, interaction: usize) -> Option<&TouchingBodies>;

    /// An interaction, if it is that of a solid and a tool.
    fn on_tool(&self, interaction: usize) -> Option<&OnTool>;

    /// Energy that an interaction lost at a particle of a body \[F L\].
    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64;

    /// What each interaction keeps with a state.
    fn kept(&self) -> Vec<Vec<f64>>;

    /// Takes that up; false if it is that of others.
    fn take_up(&mut self, kept: &[&[f64]]) -> bool;
}

impl Parts for Marched {
    fn each(&self) -> Vec<&dyn Body> {
        self.systems().iter().map(|part| part.as_ref() as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.systems_mut().iter_mut().map(|part| part.as_mut() as &mut dyn Body).collect()
    }

    fn force_on(&self, interaction: usize, body: usize, particle: usize) -> Vec3 {
        Marched::force_on(self, interaction, body, particle as u32).into()
    }

    fn touching(&self, interaction: usize) -> Option<&TouchingBodies> {
        (Marched::interaction(self, interaction)? as &dyn Any).downcast_ref()
    }

    fn on_tool(&self, interaction: usize) -> Option<&OnTool> {
        (Marched::interaction(self, interaction)? as &dyn Any).downcast_ref()
    }

    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64 {
        Marched::lost_at(self, interaction, body, particle as u32)
    }

    fn kept(&self) -> Vec<Vec<f64>> {
        Marched::kept(self)
    }

    fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        Marched::take_up(self, kept)
    }
}

impl Parts for Balanced {
    fn each(&self) -> Vec<&dyn Body> {
        self.systems().iter().map(|part| part.as_ref() as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.systems_mut().iter_mut().map(|part| part.as_mut() as &mut dyn Body).collect()
    }

    fn force_on(&self, interaction: usize, body: usize, particle: usize) -> Vec3 {
        Balanced::force_on(self, interaction, body, particle as u32).into()
    }

    fn touching(&self, interaction: usize) -> Option<&TouchingBodies> {
        (Balanced::interaction(self, interaction)? as &dyn Any).downcast_ref()
    }

    fn on_tool(&self, interaction: usize) -> Option<&OnTool> {
        (Balanced::interaction(self, interaction)? as &dyn Any).downcast_ref()
    }

    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64 {
        Balanced::lost_at(self, interaction, body, particle as u32)
    }

    fn kept(&self) -> Vec<Vec<f64>> {
        Balanced::kept(self)
    }

    fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        Balanced::take_up(self, kept)
    }
}
