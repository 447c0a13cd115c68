//! Particles without unknowns of their own: those that move as one with others, and those that hang on cells.

use sph_core::Vec3;

use crate::conditions::body::Body;
use crate::junction::group::Junctions;
use crate::packs::Row;
use crate::reference::Reference;
use crate::ties::list::Ties;

/// What ties particles to each other; empty where nothing does.
pub(crate) struct Dependents {
    /// Sheets that meet along lines, and rigid bodies.
    pub junctions: Junctions,
    /// Particles that hang on cells of other sheets.
    pub ties: Ties,
}

impl Dependents {
    /// Whether every particle moves by itself.
    pub fn is_empty(&self) -> bool {
        self.junctions.is_empty() && self.ties.is_empty()
    }

    /// Particles that move with others or bear them: all those of groups, what hangs and the corners it hangs on, each once or more.
    pub fn bound(&self) -> Vec<u32> {
        let of_groups = self.junctions.groups.iter().flat_map(|group| &group.particles);
        let hanging = self.ties.hanging.iter();
        let of_ties = hanging.flat_map(|hanging| hanging.corners.iter().chain([&hanging.particle]));
        of_groups.chain(of_ties).copied().collect()
    }

    /// What loads see of a shell in a state.
    pub fn loaded<'a>(&'a self, reference: &'a Reference, state: &'a [Row]) -> Body<'a> {
        Body { reference, state, masses: self.ties.weighing_masses(reference) }
    }

    /// Mass of a particle or of the group it stands for \[M\].
    pub fn moving_mass(&self, reference: &Reference, particle: usize) -> f64 {
        let alone = || self.ties.moving_masses(reference)[0][particle];
        self.junctions.of(particle).map_or_else(alone, |group| group.mass)
    }

    /// Rotary inertia of modes over t²/12, of a group about an axis; the mass of a particle of one section \[M\].
    pub fn turning_mass(
        &self,
        reference: &Reference,
        thickness: f64,
        state: &[Row],
        particle: usize,
        axis: impl Fn() -> Vec3,
    ) -> f64 {
        let section = 12.0 / thickness.powi(2);
        let hung = |a: usize| self.ties.turning.get(a).map_or(0.0, |turning| turning * section);
        let own = |a: usize| {
            reference.rotary.get(a).map_or(reference.masses[a], |rotary| rotary * section) + hung(a)
        };
        let Some(group) = self.junctions.of(particle) else { return own(particle) };
        match group.modal_about(state, &axis()) {
            None => group.mass_about(&axis(), state, own),
            Some(inertia) => inertia * section,
        }
    }
}
