//! Several bodies as one: what is read, shown and kept of them.

use std::borrow::Cow;
use std::ops::Range;

use contact::NodalContact;
use sph_core::Vec3;

use super::glue::GluedBodies;
use super::jointed::JointedBodies;
use super::kept::{kept_between, take_up_between};
use super::layout::Layout;
use super::parts::Parts;
use crate::Warning;
use crate::bodies::body::{Body, Configuration, Diagnostics, Mismatch, StateArray};
use crate::bodies::point_numbers::POINT_NUMBERS;
use crate::bodies::{ContactNow, FieldRequest, FieldSource, GlueNow, Outline, Yielding};
use crate::scene::Measured;

/// Bodies that are solved together, with their places one behind the other.
pub(super) struct Together<S> {
    pub system: S,
    /// Joints of rigid bodies, in time.
    pub joints: Option<JointedBodies>,
    pub layout: Layout,
}

impl<S: Parts> Body for Together<S> {
    fn configuration(&self) -> Configuration<'_> {
        let mut present = Vec::with_capacity(self.layout.rest.len());
        self.system.each().iter().for_each(|part| present.extend(part.configuration().present));
        Configuration { rest: &self.layout.rest, present, cells: &self.layout.cells }
    }

    fn read(&self, of: Measured, particle: usize, along: &Vec3) -> f64 {
        let (body, own) = self.layout.place(particle);
        let glue = self.layout.glue.clone();
        match of {
            Measured::GlueForce => {
                glue.map(|number| self.system.force_on(number, body, own)).sum::<Vec3>().dot(along)
            }
            Measured::GlueGap => {
                let all = glue.filter_map(|number| self.system.glued(number));
                all.map(|glue| glue.gap(body, own as u32)).sum::<Vec3>().dot(along)
            }
            Measured::LinkForce => {
                let links = self.layout.links.clone();
                links.map(|number| self.system.force_on(number, body, own)).sum::<Vec3>().dot(along)
            }
            _ => self.system.read(&self.layout.contacts, of, [body, own], along),
        }
    }

    fn joints_exert(&self, body: usize, joint: Option<usize>) -> [Vec3; 2] {
        let name = self.layout.names.get(body);
        self.joints
            .as_ref()
            .zip(name)
            .map_or([Vec3::zeros(); 2], |(joints, name)| joints.exerted(name, joint))
    }

    fn counts_turns(&self, particle: usize) -> bool {
        let (body, own) = self.layout.place(particle);
        self.system.each().get(body).is_some_and(|part| part.counts_turns(own))
    }

    /// A column measures points of one body.
    fn point_numbers(&self, points: &[u32]) -> Vec<[f64; POINT_NUMBERS]> {
        let Some(&first) = points.first() else { return Vec::new() };
        let (body, own) = self.layout.point(first as usize);
        let before = first - own as u32;
        let points: Vec<u32> = points.iter().map(|point| point - before).collect();
        self.system.each().get(body).map_or_else(Vec::new, |part| part.point_numbers(&points))
    }

    /// Those of the first body.
    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        self.fields_of(0, shown)
    }

    fn bodies(&self) -> Vec<&str> {
        self.layout.names.iter().map(String::as_str).collect()
    }

    fn fields_of<'a>(&'a self, body: usize, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        let range = self.layout.forces.get(body).cloned();
        let forces = shown.forces.zip(range).map(|(forces, range)| &forces[range]);
        let (part, shown) = (self.system.each()[body], FieldRequest { forces, ..*shown });
        let own = if shown.contact {
            part.fields_with_contact(&shown, self.contact_fields(body))
        } else {
            part.fields(&shown)
        };
        let rest = &self.layout.rest[self.layout.particles[body].clone()];
        self.system.with_tools(&self.layout.contacts, (body, rest), own, shown.units)
    }

    fn place(&self, particle: usize) -> (usize, usize) {
        self.layout.place(particle)
    }

    fn nodal_contact(&self, body: usize) -> Vec<NodalContact> {
        let particles = self.layout.particles.get(body).map_or(0, Range::len);
        self.system.nodal_contact(&self.layout.contacts, body, particles)
    }

    fn stresses(&self, body: usize) -> Vec<[f64; 6]> {
        self.system.each().get(body).map_or_else(Vec::new, |part| part.stresses(0))
    }

    fn yielding(&self, body: usize) -> Vec<Yielding> {
        self.system.each().get(body).map_or_else(Vec::new, |part| part.yielding(0))
    }

    fn gaps(&self, body: usize, particles: &[u32]) -> Vec<f64> {
        self.system.gaps(&self.layout.contacts, body, particles)
    }

    fn contacts(&self) -> Vec<ContactNow> {
        self.system.contacts(&self.layout.contacts)
    }

    fn glue(&self) -> Vec<GlueNow> {
        let all = self.layout.glue.clone().filter_map(|number| self.system.glued(number));
        all.map(GluedBodies::now).collect()
    }

    fn has_tools(&self, body: usize) -> bool {
        let own = self.system.each().get(body).is_some_and(|part| part.has_tools(0));
        own || !self.system.tools_of(&self.layout.contacts, body).is_empty()
    }

    fn outlines(&self) -> Vec<Outline> {
        let parts = self.system.each().into_iter().zip(self.layout.names.iter().zip(&self.layout.particles));
        let named = |(part, (name, range)): (&dyn Body, (&String, &Range<usize>))| {
            let own = part.outlines().into_iter();
            own.map(|own| own.named(name, range.start)).collect::<Vec<_>>()
        };
        parts.flat_map(named).collect()
    }

    fn diagnostics(&self) -> Diagnostics {
        let named = |(part, name): (&&dyn Body, &String)| -> Vec<Warning> {
            let own = part.diagnostics().warnings.into_iter();
            own.map(|own| Warning::new(own.kind, format!("{name}: {}", own.message))).collect()
        };
        let warnings = self.system.each().iter().zip(&self.layout.names).flat_map(named).collect();
        Diagnostics { fluid: None, warnings }
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let parts = self.system.each().into_iter().zip(&self.layout.names);
        let named = |(part, name): (&'_ dyn Body, &String)| {
            let own = part.state().into_iter();
            let named = own.map(|array| StateArray {
                name: Cow::Owned(format!("{name}: {}", array.name)),
                numbers: Cow::Owned(array.numbers.into_owned()),
            });
            named.collect::<Vec<_>>()
        };
        parts.flat_map(named).chain(kept_between(&self.system.kept())).collect()
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        // Nothing is changed by the state of other bodies: what a part took up it gives back.
        let own: Vec<StateArray<'static>> = self.state().into_iter().map(owned).collect();
        let done = self.take_up(arrays);
        if done.is_err() {
            let _ = self.take_up(&own);
        }
        done
    }
}

impl<S: Parts> Together<S> {
    fn take_up(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let of = |name: &str| -> Vec<StateArray<'_>> {
            let start = format!("{name}: ");
            let own = arrays.iter().filter_map(|array| {
                let name = array.name.strip_prefix(&start)?;
                Some(StateArray { name: Cow::Owned(name.into()), numbers: Cow::Borrowed(&array.numbers) })
            });
            own.collect()
        };
        let parts: Vec<_> = self.layout.names.iter().map(|name| of(name)).collect();
        let mut bodies = self.system.each_mut();
        bodies.iter_mut().zip(&parts).try_for_each(|(body, own)| body.set_state(own))?;
        if take_up_between(&mut self.system, arrays) { Ok(()) } else { Err(Mismatch) }
    }
}

fn owned(array: StateArray<'_>) -> StateArray<'static> {
    StateArray { name: Cow::Owned(array.name.into_owned()), numbers: Cow::Owned(array.numbers.into_owned()) }
}
