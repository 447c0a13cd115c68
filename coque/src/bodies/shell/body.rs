//! A shell as a body: what can be measured on it, what it keeps, and what it offers analyses without time.

use std::ops::DerefMut;

use contact::{FrontChange, NodalContact};
use explicit_dynamics::{Dynamics, Exert};
use sph_core::Vec3;
use sph_shell::{Formulation, LoadCase, PointResult, Shell, ShellError, StaticShell};

use super::balance::unbalanced;
use super::contacts::contacts;
use super::enclosed::pulling;
use super::fields::fields;
use super::linear_forces::{LinearForces, numbers};
use super::warnings::{among_preloaded_modes, between_lines};
use super::yielding::{warnings, yielding};
use crate::Warning;
use crate::bodies::body::{Body, Configuration, Diagnostics, DynamicBody, Mismatch, StateArray, StaticBody};
use crate::bodies::point_numbers::POINT_NUMBERS;
use crate::bodies::{
    ContactFields, ContactNow, FieldRequest, FieldSource, NotShared, Outline, Resultant, Yielding,
};
use crate::ranks::Ranks;
use crate::scene::Measured;

/// What a checkpoint calls the lists of a shell that touches itself.
const CONTACT: &str = "where contact was looked for";
/// What it calls the history of a shell with memory.
const HISTORY: &str = "history of the points";
/// What it calls the pressures of what a shell encloses.
const ENCLOSED: &str = "pressures of what is enclosed";

impl Body for Shell {
    fn configuration(&self) -> Configuration<'_> {
        let cloud = &self.reference().cloud;
        let present = (0..self.len()).map(|a| self.position(a)).collect();
        Configuration { rest: self.rest_positions(), present, cells: &cloud.cells }
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Displacement => self.displacement(a).dot(along),
            Measured::Position => self.position(a).dot(along),
            Measured::Reaction => self.reaction(a).dot(along),
            Measured::ContactMoment => self.position(a).cross(&self.tool_force(a)).dot(along),
            Measured::FrictionLoss => self.friction_loss(a),
            Measured::ContactForce => self.contact_force(a).dot(along),
            Measured::Director | Measured::Rotation => self.director(a).dot(along),
            Measured::ReactionMoment => {
                (self.position(a).cross(&self.reaction(a)) + self.reaction_moment(a)).dot(along)
            }
            Measured::SectionForce => of_row(&self.internal_force(a))[0].dot(along),
            Measured::SectionMoment => {
                let [force, couple] = of_row(&self.internal_force(a));
                (self.position(a).cross(&force) + self.director(a).cross(&couple)).dot(along)
            }
            Measured::Velocity => self.velocity(a).dot(along),
            Measured::EnclosedPressure => self.enclosed_at(a)[0],
            Measured::EnclosedVolume => self.enclosed_at(a)[1],
            Measured::BarForce => self.bar_at(a)[0],
            Measured::BarMoment => self.bar_at(a)[1],
            // The checks leave a shell no other column.
            _ => 0.0,
        }
    }

    fn point_numbers(&self, points: &[u32]) -> Vec<[f64; POINT_NUMBERS]> {
        let mut all = vec![PointResult::default(); self.reference().operator.points.len()];
        self.point_results(&mut all);
        points.iter().map(|&p| numbers(&mut all[p as usize])).collect()
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        let nodal = if shown.contact { self.contact_fields(0) } else { ContactFields::default() };
        fields(self, shown, nodal)
    }

    fn fields_with_contact<'a>(
        &'a self,
        shown: &FieldRequest<'a>,
        nodal: ContactFields,
    ) -> Box<dyn FieldSource + 'a> {
        fields(self, shown, nodal)
    }

    fn nodal_contact(&self, _body: usize) -> Vec<NodalContact> {
        if self.may_touch() { Shell::nodal_contact(self) } else { vec![NodalContact::default(); self.len()] }
    }

    fn yielding(&self, _body: usize) -> Vec<Yielding> {
        yielding(self)
    }

    fn gaps(&self, _body: usize, particles: &[u32]) -> Vec<f64> {
        self.contact_gaps(particles)
    }

    fn contacts(&self) -> Vec<ContactNow> {
        contacts(self)
    }

    fn has_tools(&self, _body: usize) -> bool {
        Shell::has_tools(self)
    }

    fn outlines(&self) -> Vec<Outline> {
        let cells = self.reference().cloud.cells.clone();
        let own = self.least_half_thickness().map(|half| Outline::of_cells(self.len(), cells, half, true));
        own.into_iter().collect()
    }

    fn diagnostics(&self) -> Diagnostics {
        let warnings = between_lines(self).into_iter().chain(warnings(self)).chain(pulling(self)).collect();
        Diagnostics { fluid: None, warnings }
    }

    fn support_resultant(&self) -> Option<Resultant> {
        let found = Shell::support_resultant(self, self.centroid());
        Some(Resultant { force: found.force.into(), moment: found.moment.into() })
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let [state, rates] = self.motion().map(<[[f64; 6]]>::as_flattened);
        let motion =
            [StateArray::new("positions and directors", state), StateArray::new("their rates", rates)];
        let kept = [
            (HISTORY, self.history()),
            (CONTACT, self.contact_state()),
            (ENCLOSED, self.enclosed_extremes()),
        ];
        let kept = kept.into_iter().filter(|(_, numbers)| !numbers.is_empty());
        let kept = kept.map(|(name, numbers)| StateArray { name: name.into(), numbers: numbers.into() });
        motion.into_iter().chain(kept).collect()
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let (motion, kept) = arrays.split_at_checked(2).ok_or(Mismatch)?;
        let [state, rates] = motion else { return Err(Mismatch) };
        if kept.iter().any(|array| ![HISTORY, CONTACT, ENCLOSED].contains(&&*array.name)) {
            return Err(Mismatch);
        }
        let of =
            |name: &str| kept.iter().find(|array| array.name == name).map_or(&[][..], |own| &own.numbers);
        let [history, contact, enclosed] = [HISTORY, CONTACT, ENCLOSED].map(of);
        let (state, left) = state.numbers.as_chunks::<6>();
        let (rates, over) = rates.numbers.as_chunks::<6>();
        let whole = left.is_empty() && over.is_empty();
        let motion = whole && self.take_up([state, rates]) && self.take_up_history(history);
        let fits = motion && self.take_up_contact(contact) && self.take_up_extremes(enclosed);
        if fits { Ok(()) } else { Err(Mismatch) }
    }
}

/// The two vectors of a row.
fn of_row([x, y, z, p, q, r]: &[f64; 6]) -> [Vec3; 2] {
    [Vec3::new(*x, *y, *z), Vec3::new(*p, *q, *r)]
}

/// Shares a shell.
fn shared(shell: &mut Shell, ranks: &Ranks) -> Result<(), NotShared> {
    shell.share(ranks.peers()).map_err(|refused| match refused {
        ShellError::NotShared(what) => NotShared::Part(what),
        _ => NotShared::Kind,
    })
}

impl DynamicBody for Shell {
    fn share(&mut self, ranks: &Ranks) -> Result<(), NotShared> {
        shared(self, ranks)
    }

    fn bring(&mut self) {
        Shell::bring(self);
    }

    fn push(&mut self, exert: Exert) -> Result<(), Exert> {
        Shell::push(self, exert);
        Ok(())
    }

    fn at_rest(&mut self) -> Option<Box<dyn StaticBody + '_>> {
        match self.formulation() {
            Formulation::StrongForm { .. } => None,
            _ => Some(Box::new(StaticShell::lent(self))),
        }
    }
}

impl<S: DerefMut<Target = Shell> + Send> Body for StaticShell<S> {
    fn configuration(&self) -> Configuration<'_> {
        self.shell().configuration()
    }

    fn read(&self, of: Measured, particle: usize, along: &Vec3) -> f64 {
        self.shell().read(of, particle, along)
    }

    fn point_numbers(&self, points: &[u32]) -> Vec<[f64; POINT_NUMBERS]> {
        self.shell().point_numbers(points)
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        self.shell().fields(shown)
    }

    fn fields_with_contact<'a>(
        &'a self,
        shown: &FieldRequest<'a>,
        nodal: ContactFields,
    ) -> Box<dyn FieldSource + 'a> {
        fields(self.shell(), shown, nodal)
    }

    fn nodal_contact(&self, body: usize) -> Vec<NodalContact> {
        Body::nodal_contact(self.shell(), body)
    }

    fn yielding(&self, body: usize) -> Vec<Yielding> {
        self.shell().yielding(body)
    }

    fn gaps(&self, body: usize, particles: &[u32]) -> Vec<f64> {
        self.shell().gaps(body, particles)
    }

    fn contacts(&self) -> Vec<ContactNow> {
        self.shell().contacts()
    }

    fn has_tools(&self, _body: usize) -> bool {
        self.shell().has_tools()
    }

    fn outlines(&self) -> Vec<Outline> {
        self.shell().outlines()
    }

    fn diagnostics(&self) -> Diagnostics {
        self.shell().diagnostics()
    }

    fn support_resultant(&self) -> Option<Resultant> {
        Body::support_resultant(self.shell())
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        self.shell().state()
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        Body::set_state(self.shell_mut(), arrays)
    }
}

impl<S: DerefMut<Target = Shell> + Send> StaticBody for StaticShell<S> {
    fn share(&mut self, ranks: &Ranks) -> Result<(), NotShared> {
        shared(self.shell_mut(), ranks)
    }

    fn refresh(&mut self, level: f64) -> f64 {
        self.evaluate(level);
        self.shell().stored_energy()
    }

    fn functional(&self, particle: usize, along: Vec3) -> Vec<f64> {
        StaticShell::functional(self, &[particle as u32], along)
    }

    fn opens_and_closes(&self) -> bool {
        self.shell().may_touch()
    }

    fn slips(&self) -> bool {
        self.shell().has_friction()
    }

    fn linear_reach(&self) -> f64 {
        self.shell().thickness()
    }

    fn stable_step(&mut self) -> f64 {
        Dynamics::stable_step(self.shell_mut(), 1.0).map_or(0.0, |step| step.dt)
    }

    fn skew_load_share(&self) -> f64 {
        StaticShell::skew_load_share(self)
    }

    fn doubtful_modes(&self, count: usize) -> Option<Warning> {
        among_preloaded_modes(self.shell(), count)
    }

    fn begin_preload(&mut self) -> bool {
        let any = self.has_preload() || !self.stress_counted_by_level() && unbalanced(self);
        if any {
            self.set_case(LoadCase::Preload);
        }
        any
    }

    fn end_preload(&mut self) {
        self.set_case(LoadCase::Loading);
    }

    fn freeze_contact(&mut self, level: f64) {
        StaticShell::freeze_contact(self, level);
    }

    fn first_change(&mut self, motion: &[f64]) -> Option<FrontChange> {
        StaticShell::first_change(self, motion)
    }

    /// Reactions of all particles, then strains and resultants of all sampling points (`LinearForces`).
    fn forces(&self) -> Vec<f64> {
        LinearForces::of(self.shell()).numbers()
    }
}
