//! What is looked at when a run records: structures that get into walls, water at faces that are dry.

use explicit_dynamics::{BoundaryState, TwoClocks, Wetted};
use fluid_sph::Fluid;
use sph_core::Vec3;

use super::contact::{Contact, Entered};
use super::dry::Dry;
use crate::bodies::Body;
use crate::warning::{Warning, WarningKind};

/// The structures of a fluid, as they are looked at; nothing without structures.
#[derive(Clone, Debug, Default)]
pub(super) struct Watch {
    /// Names of the structures.
    pub names: Vec<String>,
    pub contact: Contact,
    pub dry: Vec<Dry>,
}

/// Places in the plane of a plane fluid.
pub(super) fn in_plane(dimensions: usize, places: &[Vec3]) -> Vec<Vec3> {
    let plane = |x: &Vec3| if dimensions == 2 { Vec3::new(x.x, x.y, 0.0) } else { *x };
    places.iter().map(plane).collect()
}

impl Watch {
    /// Looks at all of them at a time.
    pub fn look<S: Body + Wetted + ?Sized>(&mut self, time: f64, clocks: &TwoClocks<Fluid, S>) {
        if self.names.is_empty() {
            return;
        }
        let fluid = clocks.fluid();
        for (number, structure) in clocks.structures().enumerate() {
            let own = structure.configuration();
            let [present, rest] = [&own.present[..], own.rest].map(|of| in_plane(fluid.dimensions(), of));
            self.contact.look(time, number, fluid, &present, &rest);
            for dry in self.dry.iter_mut().filter(|dry| dry.structure == number) {
                let mut state = BoundaryState::default();
                structure.boundary(&mut state);
                let [at_dry, _] = dry.beside(&state, fluid.positions());
                dry.keep(time, at_dry);
            }
        }
    }

    /// What is doubtful about it.
    pub fn warnings(&self) -> Vec<Warning> {
        let entered =
            self.names.iter().zip(&self.contact.entered).filter(|(_, entered)| entered.since >= 0.0);
        let through = entered.map(|(name, entered)| {
            let Entered { since, wall, depth, at } = *entered;
            let message = format!(
                "{name}: at time {since:.4} it was in `{}`, at time {at:.4} as deep as {depth:.4}: structures and walls feel each other \
                 where a [[contact]] names a body and walls that are a basin or a block, so that from there on its motion and the \
                 forces on it are not what they would be; name that, hold it, or end the run before",
                self.contact.wall(wall as usize)
            );
            Warning::new(WarningKind::NoContact, message)
        });
        let wetted = self.dry.iter().filter(|dry| dry.since >= 0.0).map(|dry| {
            let message = format!(
                "{}: at time {:.4} water stood at its {}, which `wet` leaves dry ({} particles at most at a record): it feels no \
                 shell there and goes through it; use wet = \"both\"",
                self.names[dry.structure],
                dry.since,
                dry.word(),
                dry.most
            );
            Warning::new(WarningKind::DryFace, message)
        });
        through.chain(wetted).collect()
    }

    /// Numbers that change, for a state.
    pub fn state(&self) -> Vec<f64> {
        let entered = self.contact.entered.iter().flat_map(|e| [e.since, e.wall, e.depth, e.at]);
        entered.chain(self.dry.iter().flat_map(|dry| [dry.since, dry.most])).collect()
    }

    /// Puts numbers of [`Watch::state`] back; false, and nothing done, where there are others.
    pub fn set_state(&mut self, numbers: &[f64]) -> bool {
        let entered = 4 * self.contact.entered.len();
        if numbers.len() != entered + 2 * self.dry.len() {
            return false;
        }
        let (own, dry) = numbers.split_at(entered);
        for (entered, own) in self.contact.entered.iter_mut().zip(own.chunks_exact(4)) {
            *entered = Entered { since: own[0], wall: own[1], depth: own[2], at: own[3] };
        }
        for (face, own) in self.dry.iter_mut().zip(dry.chunks_exact(2)) {
            (face.since, face.most) = (own[0], own[1]);
        }
        true
    }
}
