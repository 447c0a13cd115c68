//! Several bodies as one: what is read, shown and kept of them.

use std::borrow::Cow;
use std::ops::Range;

use contact::NodalContact;
use mesh_io::FieldWriter;
use sph_core::Vec3;

use super::contact::TouchingBodies;
use super::layout::Layout;
use super::on_tool::OnTool;
use super::parts::Parts;
use crate::Warning;
use crate::bodies::body::{Body, Configuration, Diagnostics, Mismatch, StateArray};
use crate::bodies::sampled::POINT_NUMBERS;
use crate::bodies::tool_shapes;
use crate::bodies::{ContactNow, FieldRequest, FieldSource, Outline, Part};
use crate::scene::Measured;

/// Bodies that are solved together, with their places one behind the other.
pub(super) struct Together<S> {
    pub system: S,
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
        let of_body = self.system.each().get(body).map_or(0.0, |part| part.read(of, own, along));
        if of == Measured::FrictionLoss {
            let between = self.layout.contacts.clone();
            return between.map(|contact| self.system.lost_at(contact, body, own)).sum::<f64>() + of_body;
        }
        if !matches!(of, Measured::ContactForce | Measured::ContactMoment) {
            return of_body;
        }
        let force: Vec3 =
            self.layout.contacts.clone().map(|contact| self.system.force_on(contact, body, own)).sum();
        let place = |part: &dyn Body| {
            let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
            Vec3::from(axes.map(|axis| part.read(Measured::Position, own, &axis)))
        };
        match self.system.each().get(body) {
            Some(part) if of == Measured::ContactMoment => place(*part).cross(&force).dot(along) + of_body,
            _ => force.dot(along) + of_body,
        }
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
        if self.tools_of(body).next().is_none() {
            return own;
        }
        let stood: Vec<_> = self.tools_of(body).map(|tool| (tool.shape, tool.stood)).collect();
        let rest = &self.layout.rest[self.layout.particles[body].clone()];
        Box::new(move |part: Part, to: &mut dyn FieldWriter| match part {
            Part::Tools => tool_shapes::write(&stood, rest, &shown.units, to),
            part => own.write(part, to),
        })
    }

    fn place(&self, particle: usize) -> (usize, usize) {
        self.layout.place(particle)
    }

    fn nodal_contact(&self, body: usize) -> Vec<NodalContact> {
        let mut nodal = self.system.each().get(body).map_or_else(Vec::new, |part| part.nodal_contact(0));
        // A body other than a shell touches nothing by itself.
        nodal.resize(self.layout.particles.get(body).map_or(0, Range::len), NodalContact::default());
        self.touching().for_each(|contact| contact.nodal_contact(body, &mut nodal));
        let mut tools = self.tools_of(body).peekable();
        if tools.peek().is_some() {
            let places = self.system.each()[body].configuration().present;
            tools.for_each(|tool| tool.nodal_contact(&places, &mut nodal));
        }
        nodal
    }

    fn gaps(&self, body: usize, particles: &[u32]) -> Vec<f64> {
        let parts = self.system.each();
        let mut gaps = parts.get(body).map_or_else(Vec::new, |part| part.gaps(0, particles));
        let places = |number: usize| parts[number].configuration().present;
        for own in self.touching().filter_map(|contact| contact.gaps(body, particles, places)) {
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap = gap.min(own));
        }
        for tool in self.tools_of(body) {
            let own = tool.gaps(particles, &places(body));
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap = gap.min(own));
        }
        gaps
    }

    fn contacts(&self) -> Vec<ContactNow> {
        let parts = self.system.each();
        let own = |(body, part): (usize, &&dyn Body)| {
            part.contacts().into_iter().map(move |own| ContactNow { body, ..own })
        };
        let places = |number: usize| parts[number].configuration().present;
        let between = self.touching().map(|contact| contact.now(places));
        let on_tools = self.on_tools().map(|tool| tool.now(|| places(tool.body)));
        parts.iter().enumerate().flat_map(own).chain(between).chain(on_tools).collect()
    }

    fn has_tools(&self, body: usize) -> bool {
        let own = self.system.each().get(body).is_some_and(|part| part.has_tools(0));
        own || self.tools_of(body).next().is_some()
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
        let kept = self.system.kept().into_iter().enumerate().filter(|(_, kept)| !kept.is_empty());
        let kept = kept
            .map(|(number, numbers)| StateArray { name: between(number).into(), numbers: numbers.into() });
        parts.flat_map(named).chain(kept).collect()
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
    /// The contacts between the bodies.
    fn touching(&self) -> impl Iterator<Item = &TouchingBodies> {
        self.layout.contacts.clone().filter_map(|number| self.system.touching(number))
    }

    /// What solids and their tools do to each other.
    fn on_tools(&self) -> impl Iterator<Item = &OnTool> {
        self.layout.contacts.clone().filter_map(|number| self.system.on_tool(number))
    }

    /// The same of one body.
    fn tools_of(&self, body: usize) -> impl Iterator<Item = &OnTool> {
        self.on_tools().filter(move |tool| tool.body == body)
    }

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
        let kept = |number: usize| -> &[f64] {
            let own = arrays.iter().find(|array| array.name == between(number));
            own.map_or(&[], |array| &array.numbers)
        };
        let kept: Vec<&[f64]> = (0..self.system.kept().len()).map(kept).collect();
        if self.system.take_up(&kept) { Ok(()) } else { Err(Mismatch) }
    }
}

/// Name of what an interaction keeps.
fn between(number: usize) -> String {
    format!("between bodies, {number}")
}

fn owned(array: StateArray<'_>) -> StateArray<'static> {
    StateArray { name: Cow::Owned(array.name.into_owned()), numbers: Cow::Owned(array.numbers.into_owned()) }
}
