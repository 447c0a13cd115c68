//! What is asked of a body beside others, and of all of them whatever they are solved by.

use std::any::Any;
use std::ops::Range;

use contact::NodalContact;
use mesh_io::FieldWriter;
use sph_core::Vec3;

use super::contact::TouchingBodies;
use super::glue::GluedBodies;
use super::on_tool::OnTool;
use crate::bodies::body::{Body, DynamicBody, StaticBody};
use crate::bodies::tool_shapes;
use crate::bodies::{ContactNow, FieldSource, Part};
use crate::scene::Measured;
use crate::scene::units::Units;

/// A body that is marched beside others; whoever made it may read it again by its type.
pub(in crate::bodies) trait MarchedPart:
    DynamicBody + explicit_dynamics::Joinable + Any
{
}

impl<B: DynamicBody + explicit_dynamics::Joinable + Any> MarchedPart for B {}

/// A body whose equilibria are sought beside others.
pub(in crate::bodies) trait BalancedPart: StaticBody + implicit_statics::Joinable {}

impl<B: StaticBody + implicit_statics::Joinable> BalancedPart for B {}

/// Bodies marched together.
pub(super) type Marched = explicit_dynamics::Several<dyn MarchedPart>;
/// Bodies balanced together.
pub(super) type Balanced = implicit_statics::Several<dyn BalancedPart>;

/// Bodies one behind the other; of what they do to each other some interactions are contacts.
pub(in crate::bodies) trait Parts: Send {
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

    /// An interaction, if it is glue, of which a fluid has none.
    fn glued(&self, _interaction: usize) -> Option<&GluedBodies> {
        None
    }

    /// Energy that an interaction lost at a particle of a body \[F L\].
    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64;

    /// What each interaction keeps with a state.
    fn kept(&self) -> Vec<Vec<f64>>;

    /// Takes that up; false if it is that of others.
    fn take_up(&mut self, kept: &[&[f64]]) -> bool;

    /// One quantity at a particle of a body, what others do to it included.
    fn read(&self, contacts: &Range<usize>, of: Measured, [body, particle]: [usize; 2], along: &Vec3) -> f64 {
        let bodies = self.each();
        let Some(part) = bodies.get(body) else { return 0.0 };
        let of_body = part.read(of, particle, along);
        let force = || contacts.clone().map(|contact| self.force_on(contact, body, particle)).sum::<Vec3>();
        match of {
            Measured::FrictionLoss => {
                let lost = contacts.clone().map(|contact| self.lost_at(contact, body, particle));
                lost.sum::<f64>() + of_body
            }
            Measured::ContactForce => force().dot(along) + of_body,
            Measured::ContactMoment => {
                let axes = [Vec3::x(), Vec3::y(), Vec3::z()];
                let place = Vec3::from(axes.map(|axis| part.read(Measured::Position, particle, &axis)));
                place.cross(&force()).dot(along) + of_body
            }
            _ => of_body,
        }
    }

    /// What each of so many particles of a body feels of contact.
    fn nodal_contact(&self, contacts: &Range<usize>, body: usize, particles: usize) -> Vec<NodalContact> {
        let mut nodal = self.each().get(body).map_or_else(Vec::new, |part| part.nodal_contact(0));
        // A body other than a shell touches nothing by itself.
        nodal.resize(particles, NodalContact::default());
        for contact in contacts.clone().filter_map(|number| self.touching(number)) {
            contact.nodal_contact(body, &mut nodal);
        }
        let tools = self.tools_of(contacts, body);
        if let Some(part) = self.each().get(body).filter(|_| !tools.is_empty()) {
            let places = part.configuration().present;
            tools.iter().for_each(|tool| tool.nodal_contact(&places, &mut nodal));
        }
        nodal
    }

    /// Gaps at some particles of a body \[L\].
    fn gaps(&self, contacts: &Range<usize>, body: usize, particles: &[u32]) -> Vec<f64> {
        let parts = self.each();
        let mut gaps = parts.get(body).map_or_else(Vec::new, |part| part.gaps(0, particles));
        let places = |number: usize| parts[number].configuration().present;
        let between = contacts.clone().filter_map(|number| self.touching(number));
        for own in between.filter_map(|contact| contact.gaps(body, particles, places)) {
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap = gap.min(own));
        }
        for tool in self.tools_of(contacts, body) {
            let own = tool.gaps(particles, &places(body));
            gaps.iter_mut().zip(own).for_each(|(gap, own)| *gap = gap.min(own));
        }
        gaps
    }

    /// What a solid and its tools do to each other.
    fn tools_of(&self, contacts: &Range<usize>, body: usize) -> Vec<&OnTool> {
        let tools = contacts.clone().filter_map(|number| self.on_tool(number));
        tools.filter(|tool| tool.body == body).collect()
    }

    /// The fields of a body with the tools that a solid may touch, whose particles are at these places at rest \[L\].
    fn with_tools<'a>(
        &'a self,
        contacts: &Range<usize>,
        (body, rest): (usize, &'a [Vec3]),
        own: Box<dyn FieldSource + 'a>,
        units: Units,
    ) -> Box<dyn FieldSource + 'a> {
        let tools = self.tools_of(contacts, body);
        if tools.is_empty() {
            return own;
        }
        let stood: Vec<_> = tools.iter().map(|tool| (tool.shape, tool.stood)).collect();
        Box::new(move |part: Part, to: &mut dyn FieldWriter| match part {
            Part::Tools => tool_shapes::write(&stood, rest, &units, to),
            part => own.write(part, to),
        })
    }

    /// All contacts with what they do now.
    fn contacts(&self, contacts: &Range<usize>) -> Vec<ContactNow> {
        let parts = self.each();
        let own = |(body, part): (usize, &&dyn Body)| {
            part.contacts().into_iter().map(move |own| ContactNow { body, ..own })
        };
        let places = |number: usize| parts[number].configuration().present;
        let between = contacts.clone().filter_map(|number| self.touching(number));
        let between = between.map(|contact| contact.now(places));
        let on_tools = contacts.clone().filter_map(|number| self.on_tool(number));
        let on_tools = on_tools.map(|tool| tool.now(|| places(tool.body)));
        parts.iter().enumerate().flat_map(own).chain(between).chain(on_tools).collect()
    }
}

impl Parts for Marched {
    fn each(&self) -> Vec<&dyn Body> {
        self.systems().iter().map(|part| part.as_ref() as &dyn Body).collect()
    }

    fn each_mut(&mut self) -> Vec<&mut dyn Body> {
        self.systems_mut().iter_mut().map(|part| part.as_mut() as &mut dyn Body).collect()
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

    fn glued(&self, interaction: usize) -> Option<&GluedBodies> {
        (self.interactions().get(interaction)? as &dyn Any).downcast_ref()
    }

    fn lost_at(&self, interaction: usize, body: usize, particle: usize) -> f64 {
        self.interactions().lost_at(interaction, body, particle as u32)
    }

    fn kept(&self) -> Vec<Vec<f64>> {
        self.interactions().kept()
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

    fn glued(&self, interaction: usize) -> Option<&GluedBodies> {
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
