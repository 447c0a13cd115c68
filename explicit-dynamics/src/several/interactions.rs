//! All that several systems do to each other.

use std::ops::Range;

use super::acting::Acting;
use super::interaction::{Interaction, Joinable};
use crate::error::OutOfBounds;
use crate::step::{Instant, Work};

/// The interactions of several systems, in the order in which they were given.
#[derive(Default)]
pub struct Interactions {
    acting: Vec<Acting>,
}

impl Interactions {
    /// An interaction.
    pub fn get(&self, number: usize) -> Option<&dyn Interaction> {
        self.acting.get(number).map(Acting::interaction)
    }

    /// What an interaction last exerted on a particle of a system \[F\].
    pub fn force_on(&self, interaction: usize, system: usize, particle: u32) -> [f64; 3] {
        self.acting.get(interaction).map_or([0.0; 3], |acting| acting.force_on(system, particle))
    }

    /// Energy that an interaction lost at a particle of a system until the last step \[F L\].
    pub fn lost_at(&self, interaction: usize, system: usize, particle: u32) -> f64 {
        self.acting.get(interaction).map_or(0.0, |acting| acting.lost_at(system, particle))
    }

    /// What each of them keeps with a state.
    pub fn kept(&self) -> Vec<Vec<f64>> {
        self.acting.iter().map(|acting| acting.interaction().kept()).collect()
    }
}

impl Interactions {
    /// Interactions whose particles ascend.
    pub(crate) fn new(interactions: Vec<Box<dyn Interaction>>) -> Self {
        Self { acting: interactions.into_iter().map(Acting::new).collect() }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.acting.is_empty()
    }

    /// Takes up what each kept with a state, after the systems have taken it up; false if it is that of others.
    pub(crate) fn take_up<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], kept: &[&[f64]]) -> bool {
        let fits = kept.len() == self.acting.len();
        fits && self.acting.iter_mut().zip(kept).all(|(acting, kept)| acting.take_up(systems, kept))
    }

    /// Lets systems act on each other at their present places and an instant; the energy of that \[F L\].
    pub(crate) fn act<S: Joinable + ?Sized>(&mut self, systems: &mut [Box<S>], at: Instant) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        systems.iter_mut().for_each(|system| system.release());
        self.acting.iter_mut().map(|acting| acting.act(systems, at)).sum()
    }

    /// Reads velocities before a kick.
    pub(crate) fn before<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>]) {
        self.acting.iter_mut().for_each(|acting| acting.before(systems));
    }

    /// Takes their own work over a kick out of the external work, and counts what they resisted as internal forces do.
    pub(crate) fn after<S: Joinable + ?Sized>(&mut self, systems: &[Box<S>], kick: f64, work: &mut Work) {
        self.acting.iter_mut().for_each(|acting| acting.after(systems, kick, work));
    }

    /// Takes note of a step that the systems have taken.
    pub(crate) fn stepped(&mut self) {
        self.acting.iter_mut().for_each(Acting::moved);
        self.acting.iter_mut().for_each(Acting::commit);
    }

    /// The step to take next, at most a stable one that was found with a safety.
    pub(crate) fn shortened<S: Joinable + ?Sized>(
        &mut self,
        systems: &[Box<S>],
        stable: f64,
        safety: f64,
    ) -> f64 {
        let each = self.acting.iter_mut().map(|acting| acting.shortened(systems, stable, safety));
        each.fold(stable, f64::min)
    }

    /// The stable step of systems that have this one without them: `λ_max(A + B) ≤ λ_max(A) + λ_max(B)`, and with rates of decay λ the root of
    /// `s² (Δt/Δt₀)² + λ Δt = s²`.
    pub(crate) fn stable_step<S: Joinable + ?Sized>(
        &self,
        systems: &[Box<S>],
        alone: f64,
        safety: f64,
    ) -> f64 {
        if self.is_empty() {
            return alone;
        }
        let between: f64 = self.acting.iter().map(|acting| acting.fastest(systems)).sum();
        let undamped = 2.0 * safety / ((2.0 * safety / alone).powi(2) + between).sqrt();
        let rate: f64 = self.acting.iter().map(|acting| acting.damping(systems)).sum();
        if rate == 0.0 {
            return undamped;
        }
        let half = 0.5 * rate / (safety * safety);
        1.0 / ((undamped.powi(-2) + half * half).sqrt() + half)
    }

    /// Refuses a state outside the range of one of them.
    pub(crate) fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.acting.iter().try_for_each(|acting| acting.interaction().within_bounds())
    }

    /// Adds their tangent in mass-scaled coordinates, those of each system where its unknowns stand.
    pub(super) fn add_tangent<S: Joinable + ?Sized>(
        &self,
        systems: &[Box<S>],
        unknowns: &[Range<usize>],
        v: &[f64],
        out: &mut [f64],
    ) {
        self.acting.iter().for_each(|acting| acting.add_tangent(systems, unknowns, v, out));
    }
}
