//! Two clocks as one system: loads to the structures, their steps, their new places and velocities to the fluid.

use std::ops::Range;

use crate::dynamics::{Bounds, Dynamics};
use crate::error::{MarchError, OutOfBounds, OutOfRange};
use crate::interface::{BoundaryDriven, Wetted};
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};
use crate::two_clocks::{Coupled, Course, Order, OwnClock, TwoClocks};

/// Part of the way that a boundary point may go in one step which the speed of the last step is allowed to ask for.
const ADVANCE: f64 = 0.25;

impl<F: BoundaryDriven, S: Wetted + ?Sized + 'static> Dynamics for TwoClocks<F, S> {
    fn evaluate(&mut self, at: Instant) -> f64 {
        let stored = self.fluid.evaluate(at);
        self.hand_loads();
        let stored = stored + self.interactions.act(&mut self.bodies, at);
        self.each().fold(stored, |sum, (structure, body)| {
            structure.energy.internal = body.evaluate(at);
            sum + structure.energy.internal
        })
    }

    fn kick(&mut self, step: &Step) -> Work {
        let shown = step.kick == 0.0;
        let mut work = self.kick_fluid(step);
        self.interactions.before(&self.bodies);
        for group in self.groups() {
            let own = self.course(&group, step).step(self.structures[group.start].clock.last);
            let span = if shown { 0.0 } else { own.kick };
            let braced = Step { kick: span, ..own };
            self.brace(&braced);
            for k in group {
                work = add(work, self.structures[k].kick(&mut *self.bodies[k], &own, shown));
            }
            self.interactions.after(&self.bodies, span, &mut work);
            if let Some(bracing) = &self.bracing {
                bracing.settle(&mut self.bodies, &braced, &mut work);
            }
        }
        add(work, std::mem::take(&mut self.between))
    }

    fn drift(&mut self, step: &Step) {
        if self.order == Order::FluidFirst {
            self.drift_fluid_first(step);
        }
        self.groups().for_each(|group| self.march(group, step, true));
        self.hand_back();
        if self.order == Order::StructureFirst {
            self.drift_fluid_behind(step);
        }
    }

    fn advance(&mut self, step: &Step) -> Work {
        self.fluid.evaluate(step.from);
        self.hand_loads();
        let mut work = self.kick_fluid(step);
        if self.order == Order::FluidFirst {
            self.drift_fluid_first(step);
        }
        for group in self.groups() {
            self.march(group.clone(), step, false);
            for structure in &mut self.structures[group] {
                work = add(work, structure.settle(structure.energy.kinetic));
            }
        }
        self.hand_back();
        if self.order == Order::StructureFirst {
            self.drift_fluid_behind(step);
        }
        add(work, std::mem::take(&mut self.between))
    }

    /// The step of the fluid, at most a quarter of the way that a boundary point may go, over its speed in the last
    /// step; structures have steps of their own.
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        let StableStep { dt, .. } = self.fluid.stable_step(safety)?;
        self.estimate(safety)?;
        let speed = self.structures.iter().map(|structure| structure.fastest().1).fold(0.0, f64::max);
        let bound = ADVANCE * self.fluid.greatest_displacement() / speed;
        self.counts.shortened += u64::from(bound < dt);
        Ok(StableStep { dt: dt.min(bound), holds: 1 })
    }

    /// That of the fluid: what shortens the steps of structures divides it into more of them.
    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        self.safety = safety;
        self.groups().for_each(|group| self.ask(&group));
        stable
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        self.fluid.within_bounds(bounds)?;
        self.bracing.as_ref().map_or(Ok(()), |bracing| bracing.within_bounds())?;
        if bounds == Bounds::Configuration {
            self.interactions.within_bounds()?;
        }
        let mut before = self.fluid.particles();
        for (number, body) in self.bodies.iter().enumerate() {
            body.within_bounds(bounds).map_err(|found| match found {
                OutOfBounds::Speed { particle, speed, bound } => {
                    OutOfBounds::Speed { particle: before + particle, speed, bound }
                }
                OutOfBounds::Range(found) => {
                    let place = format!("{} (structure {number})", found.place);
                    OutOfRange { place, ..found }.into()
                }
            })?;
            before += body.particles();
        }
        Ok(())
    }

    fn stop(&mut self) {
        self.fluid.stop();
        for (structure, body) in self.each() {
            body.stop();
            structure.velocities.fill([0.0; 3]);
            structure.seen.fill([0.0; 3]);
        }
    }
}

impl<F: BoundaryDriven, S: Wetted + ?Sized + 'static> TwoClocks<F, S> {
    /// Whether no structure does anything to another.
    fn are_free(&self) -> bool {
        self.interactions.is_empty() && self.bracing.is_none()
    }

    /// Structures that take the same steps: each its own, or all where some do anything to each other.
    fn groups(&self) -> impl Iterator<Item = Range<usize>> + use<F, S> {
        let count = self.structures.len();
        let size = if self.are_free() { 1 } else { count.max(1) };
        (0..count).step_by(size).map(move |first| first..first + size)
    }

    /// Renews stable steps that have lapsed, those of a group together.
    fn estimate(&mut self, safety: f64) -> Result<(), MarchError> {
        for group in self.groups() {
            if self.structures[group.clone()].iter().all(|structure| !structure.lapsed()) {
                continue;
            }
            let mut least = f64::INFINITY;
            for k in group.clone() {
                self.structures[k].estimate(&mut *self.bodies[k], safety)?;
                least = least.min(self.structures[k].clock.stable);
            }
            let stable = self.interactions.stable_step(&self.bodies, least, safety);
            self.structures[group].iter_mut().for_each(|structure| structure.clock.stable = stable);
        }
        Ok(())
    }

    /// Asks how long the next step of a group may be.
    fn ask(&mut self, group: &Range<usize>) {
        let stable = self.structures[group.start].clock.stable;
        let bodies = self.bodies[group.clone()].iter_mut();
        let own = bodies.map(|body| body.shortened(stable, self.safety)).fold(stable, f64::min);
        let most = own.min(self.interactions.shortened(&self.bodies, stable, self.safety));
        self.structures[group.clone()].iter_mut().for_each(|structure| structure.most = most);
    }

    /// The steps of a group within one of the fluid, as far as is known at its start.
    fn course(&self, group: &Range<usize>, whole: &Step) -> Course {
        let own = &self.structures[group.clone()];
        let count = own.iter().map(|structure| structure.clock.count(whole)).max().unwrap_or(1);
        let mut course = Course::new(whole, count);
        course.shorten(own[0].most, own[0].clock.stable);
        course
    }

    /// All steps of a group within one of the fluid; the first kick may be done.
    fn march(&mut self, group: Range<usize>, whole: &Step, kicked: bool) {
        for k in group.clone() {
            self.structures[k].depart(&*self.bodies[k]);
        }
        let mut course = self.course(&group, whole);
        loop {
            let first = course.done() == 0;
            let OwnClock { last, stable, .. } = self.structures[group.start].clock;
            let step = course.step(last);
            let most = self.structures[group.start].most;
            if most < stable {
                self.slowed.take(most / stable, step.from.time);
            }
            self.one_step(&group, &step, first, first && kicked);
            if !course.next() {
                break;
            }
            self.ask(&group);
            course.shorten(self.structures[group.start].most, stable);
        }
        for k in group {
            self.structures[k].arrive(&*self.bodies[k], whole, &course);
            self.counts.substeps += course.done();
            self.counts.most = self.counts.most.max(course.done());
        }
    }

    /// One step of a group, the first of one of the fluid or not; its kick may be done.
    fn one_step(&mut self, group: &Range<usize>, step: &Step, first: bool, kicked: bool) {
        if self.are_free() && !kicked {
            return group.clone().for_each(|k| self.structures[k].advance(&mut *self.bodies[k], step, first));
        }
        if !kicked {
            // The work of what they do to each other takes the velocities behind the kick, which a drift may carry on.
            self.interactions.act(&mut self.bodies, step.from);
            self.interactions.before(&self.bodies);
            self.bodies[group.clone()].iter_mut().for_each(|body| {
                body.evaluate(step.from);
            });
            self.brace(step);
            for k in group.clone() {
                self.structures[k].kick_off(&mut *self.bodies[k], step, first);
            }
            self.interactions.after(&self.bodies, step.kick, &mut self.between);
            if let Some(bracing) = &self.bracing {
                bracing.settle(&mut self.bodies, step, &mut self.between);
            }
        }
        for k in group.clone() {
            self.structures[k].drift(&mut *self.bodies[k], step);
        }
        self.interactions.stepped();
    }

    /// Adds what constraints exert to the forces of a kick.
    fn brace(&mut self, step: &Step) {
        if let Some(bracing) = &mut self.bracing {
            bracing.brace(&mut self.bodies, step);
        }
    }

    /// The forces that the fluid has just found, with the velocities with which it saw the points.
    fn hand_loads(&mut self) {
        let impedance = if self.impedance { self.fluid.impedance() } else { 0.0 };
        let Self { fluid, structures, bodies, centred, .. } = self;
        for (number, (structure, body)) in structures.iter_mut().zip(bodies).enumerate() {
            structure.load(&mut **body, fluid.boundary_forces(number), impedance, *centred);
        }
    }

    /// The kick of the fluid, with the impulses on the structures that belong to it.
    fn kick_fluid(&mut self, step: &Step) -> Work {
        for (number, structure) in self.structures.iter_mut().enumerate() {
            structure.kicked(self.fluid.boundary_forces(number), step.kick);
        }
        self.fluid.kick(&undamped(step))
    }

    /// The fluid takes back what the structures resisted beyond its forces.
    fn hand_back(&mut self) {
        if self.impedance {
            let fluid = &mut self.fluid;
            for (number, structure) in self.structures.iter_mut().enumerate() {
                structure.hand_back(|impulses| fluid.apply_reactions(number, impulses));
            }
        }
    }

    /// The fluid goes with the new velocities of the structures.
    fn drift_fluid_behind(&mut self, step: &Step) {
        for (number, structure) in self.structures.iter_mut().enumerate() {
            let (end, velocities) = structure.arrived();
            self.fluid.set_boundary(number, end, velocities);
        }
        self.fluid.drift(&undamped(step));
    }

    /// The fluid goes with the old velocities of the structures.
    fn drift_fluid_first(&mut self, step: &Step) {
        let Self { fluid, structures, bodies, .. } = self;
        for (number, (structure, body)) in structures.iter_mut().zip(bodies).enumerate() {
            let (end, velocities) = structure.expected(&**body, step.drift());
            fluid.set_boundary(number, end, velocities);
        }
        self.fluid.drift(&undamped(step));
    }

    /// Each structure with its body.
    fn each(&mut self) -> impl Iterator<Item = (&mut Coupled, &mut S)> {
        self.structures.iter_mut().zip(self.bodies.iter_mut().map(|body| &mut **body))
    }
}

/// A step of the fluid, which the damping of a scene leaves alone.
fn undamped(step: &Step) -> Step {
    Step { damping: 0.0, ..*step }
}

fn add(a: Work, b: Work) -> Work {
    Work {
        kinetic: a.kinetic + b.kinetic,
        external: a.external + b.external,
        dissipated: a.dissipated + b.dissipated,
        change: a.change + b.change,
        resisted: a.resisted + b.resisted,
    }
}
