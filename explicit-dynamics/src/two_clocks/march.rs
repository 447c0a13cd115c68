//! Two clocks as one system: loads to the structures, their steps, their new places and velocities to the fluid.

use crate::dynamics::{Bounds, Dynamics};
use crate::error::{MarchError, OutOfBounds, OutOfRange};
use crate::interface::{BoundaryDriven, Wetted};
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};
use crate::two_clocks::{Order, TwoClocks};

/// Part of the way that a boundary point may go in one step which the speed of the last step is allowed to ask for.
const ADVANCE: f64 = 0.25;

impl<F: BoundaryDriven, S: Wetted + ?Sized> Dynamics for TwoClocks<F, S> {
    fn evaluate(&mut self, at: Instant) -> f64 {
        let stored = self.fluid.evaluate(at);
        self.hand_loads();
        self.structures.iter_mut().fold(stored, |sum, structure| {
            structure.energy.internal = structure.body.evaluate(at);
            sum + structure.energy.internal
        })
    }

    fn kick(&mut self, step: &Step) -> Work {
        let work = self.kick_fluid(step);
        self.structures.iter_mut().fold(work, |sum, structure| add(sum, structure.kick(step)))
    }

    fn drift(&mut self, step: &Step) {
        if self.order == Order::FluidFirst {
            self.drift_fluid_first(step);
        }
        for structure in &mut self.structures {
            let count = structure.drift(step);
            self.counts.substeps += count;
            self.counts.most = self.counts.most.max(count);
        }
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
        for structure in &mut self.structures {
            let (kinetic, count) = structure.advance(step);
            work = add(work, structure.settle(kinetic));
            self.counts.substeps += count;
            self.counts.most = self.counts.most.max(count);
        }
        self.hand_back();
        if self.order == Order::StructureFirst {
            self.drift_fluid_behind(step);
        }
        work
    }

    /// The step of the fluid, at most a quarter of the way that a boundary point may go, over its speed in the last
    /// step; structures have steps of their own.
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        let StableStep { dt, .. } = self.fluid.stable_step(safety)?;
        let mut speed = 0.0_f64;
        for structure in &mut self.structures {
            structure.estimate(safety)?;
            speed = speed.max(structure.fastest().1);
        }
        let bound = ADVANCE * self.fluid.greatest_displacement() / speed;
        self.counts.shortened += u64::from(bound < dt);
        Ok(StableStep { dt: dt.min(bound), holds: 1 })
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        self.fluid.within_bounds(bounds)?;
        let mut before = self.fluid.particles();
        for (number, structure) in self.structures.iter().enumerate() {
            structure.body.within_bounds(bounds).map_err(|found| match found {
                OutOfBounds::Speed { particle, speed, bound } => {
                    OutOfBounds::Speed { particle: before + particle, speed, bound }
                }
                OutOfBounds::Range(found) => {
                    let place = format!("{} (structure {number})", found.place);
                    OutOfRange { place, ..found }.into()
                }
            })?;
            before += structure.body.particles();
        }
        Ok(())
    }

    fn stop(&mut self) {
        self.fluid.stop();
        for structure in &mut self.structures {
            structure.body.stop();
            structure.velocities.fill([0.0; 3]);
            structure.seen.fill([0.0; 3]);
        }
    }
}

impl<F: BoundaryDriven, S: Wetted + ?Sized> TwoClocks<F, S> {
    /// The forces that the fluid has just found, with the velocities with which it saw the points.
    fn hand_loads(&mut self) {
        let impedance = if self.impedance { self.fluid.impedance() } else { 0.0 };
        for (number, structure) in self.structures.iter_mut().enumerate() {
            structure.load(self.fluid.boundary_forces(number), impedance, self.centred);
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
        for (number, structure) in self.structures.iter_mut().enumerate() {
            let (end, velocities) = structure.expected(step.drift());
            self.fluid.set_boundary(number, end, velocities);
        }
        self.fluid.drift(&undamped(step));
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
