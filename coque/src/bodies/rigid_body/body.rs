//! A rigid body as a body: what can be measured on it, what it keeps, and what it offers analyses without time.

use std::borrow::Cow;

use contact::NodalContact;
use explicit_dynamics::Dynamics;
use rigid_body::{RestingBody, RigidBody};
use sph_core::Vec3;

use super::fields::fields;
use crate::bodies::body::{Body, Configuration, DynamicBody, Mismatch, StateArray, StaticBody, extent};
use crate::bodies::{FieldRequest, FieldSource, Outline};
use crate::scene::Measured;

impl Body for RigidBody {
    fn configuration(&self) -> Configuration<'_> {
        Configuration { rest: self.rest(), present: self.positions(), cells: self.cells() }
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        let supports = || if a == self.centre() as usize { self.reaction() } else { [Vec3::zeros(); 2] };
        match of {
            Measured::Displacement => (self.position(a) - self.rest()[a]).dot(along),
            Measured::Position => self.position(a).dot(along),
            Measured::Velocity => self.velocity(a).dot(along),
            Measured::Rotation => self.turned().dot(along),
            Measured::Reaction => supports()[0].dot(along),
            // About the origin.
            Measured::ReactionMoment => {
                let [force, moment] = supports();
                (self.position(a).cross(&force) + moment).dot(along)
            }
            // The checks leave a rigid body no other column of its own.
            _ => 0.0,
        }
    }

    fn counts_turns(&self, _: usize) -> bool {
        true
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields(self, shown)
    }

    fn nodal_contact(&self, _: usize) -> Vec<NodalContact> {
        vec![NodalContact::default(); self.len()]
    }

    /// Its surface.
    fn outlines(&self) -> Vec<Outline> {
        vec![Outline::of_cells(self.rest().len(), self.cells().to_vec(), 0.0, false)]
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let numbers = Cow::Owned(RigidBody::state(self));
        vec![StateArray { name: "place, turn and motion".into(), numbers }]
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let [state] = arrays else { return Err(Mismatch) };
        if self.take_up(&state.numbers) { Ok(()) } else { Err(Mismatch) }
    }
}

impl DynamicBody for RigidBody {}

impl Body for RestingBody {
    fn configuration(&self) -> Configuration<'_> {
        self.body().configuration()
    }

    fn read(&self, of: Measured, particle: usize, along: &Vec3) -> f64 {
        self.body().read(of, particle, along)
    }

    fn counts_turns(&self, _: usize) -> bool {
        true
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields(self.body(), shown)
    }

    fn nodal_contact(&self, body: usize) -> Vec<NodalContact> {
        self.body().nodal_contact(body)
    }

    fn outlines(&self) -> Vec<Outline> {
        self.body().outlines()
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        Body::state(self.body())
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        Body::set_state(self.body_mut(), arrays)
    }
}

impl StaticBody for RestingBody {
    fn refresh(&mut self, level: f64) -> f64 {
        self.evaluate(level)
    }

    fn functional(&self, particle: usize, along: Vec3) -> Vec<f64> {
        RestingBody::functional(self, particle as u32, &along)
    }

    /// A tenth of the size: turns are then small.
    fn linear_reach(&self) -> f64 {
        0.1 * extent(self.body().rest())
    }

    fn stable_step(&mut self) -> f64 {
        Dynamics::stable_step(self.body_mut(), 1.0).map_or(0.0, |step| step.dt)
    }
}
