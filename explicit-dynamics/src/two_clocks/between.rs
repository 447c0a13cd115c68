//! What structures in a fluid do to each other.

use super::TwoClocks;
use crate::interface::{BoundaryDriven, Wetted};
use crate::several::{Acting, Interaction};

impl<F: BoundaryDriven, S: Wetted + ?Sized> TwoClocks<F, S> {
    /// Lets structures act on each other; particles of each interaction ascend.
    #[must_use]
    pub fn with_interactions(mut self, interactions: Vec<Box<dyn Interaction>>) -> Self {
        self.acting = interactions.into_iter().map(Acting::new).collect();
        self
    }

    /// What each interaction keeps with a state, in the order in which they were given.
    pub fn kept(&self) -> Vec<Vec<f64>> {
        self.acting.iter().map(|acting| acting.interaction().kept()).collect()
    }

    /// Takes that up, after the structures have taken up their states; false if it is that of others.
    pub fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        let fits = kept.len() == self.acting.len();
        fits && self.acting.iter_mut().zip(kept).all(|(acting, kept)| acting.take_up(&self.bodies, kept))
    }

    /// An interaction, in the order in which they were given.
    pub fn interaction(&self, number: usize) -> Option<&dyn Interaction> {
        self.acting.get(number).map(Acting::interaction)
    }

    /// What an interaction last exerted on a particle of a structure \[F\].
    pub fn force_on(&self, interaction: usize, structure: usize, particle: u32) -> [f64; 3] {
        self.acting.get(interaction).map_or([0.0; 3], |acting| acting.force_on(structure, particle))
    }

    /// Energy that an interaction lost at a particle of a structure until the last step \[F L\].
    pub fn lost_at(&self, interaction: usize, structure: usize, particle: u32) -> f64 {
        self.acting.get(interaction).map_or(0.0, |acting| acting.lost_at(structure, particle))
    }
}
