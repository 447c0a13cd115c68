//! Several systems as one that is marched.

use super::interaction::{Interaction, Joinable};
use super::interactions::Interactions;
use crate::dynamics::{Bounds, Dynamics};
use crate::error::{MarchError, OutOfBounds};
use crate::linearised::MassScaled;
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};

/// Systems that take the same steps, and what they do to each other.
pub struct Several<S: ?Sized> {
    pub(super) systems: Vec<Box<S>>,
    pub(super) interactions: Interactions,
}

impl<S: Joinable + ?Sized> Several<S> {
    /// Systems, with all that they do to each other; particles of each interaction ascend.
    pub fn new(systems: Vec<Box<S>>, interactions: Vec<Box<dyn Interaction>>) -> Self {
        Self { systems, interactions: Interactions::new(interactions) }
    }

    /// Takes up what each interaction kept with a state, after the systems have taken it up; false if it is that of others.
    pub fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        self.interactions.take_up(&self.systems, kept)
    }
}

impl<S: ?Sized> Several<S> {
    /// The systems in their order.
    pub fn systems(&self) -> &[Box<S>] {
        &self.systems
    }

    /// The same, to put them into other states.
    pub fn systems_mut(&mut self) -> &mut [Box<S>] {
        &mut self.systems
    }

    /// What they do to each other.
    pub fn interactions(&self) -> &Interactions {
        &self.interactions
    }
}

/// What all kicks did together, in their order.
fn sum(works: impl Iterator<Item = Work>) -> Work {
    works.fold(Work::default(), |sum, part| Work {
        kinetic: sum.kinetic + part.kinetic,
        external: sum.external + part.external,
        dissipated: sum.dissipated + part.dissipated,
        change: sum.change + part.change,
        resisted: sum.resisted + part.resisted,
    })
}

impl<S: Joinable + ?Sized> Dynamics for Several<S> {
    fn evaluate(&mut self, at: Instant) -> f64 {
        let between = self.interactions.act(&mut self.systems, at);
        let own: f64 = self.systems.iter_mut().map(|system| system.evaluate(at)).sum();
        own + between
    }

    fn kick(&mut self, step: &Step) -> Work {
        self.interactions.before(&self.systems);
        let mut work = sum(self.systems.iter_mut().map(|system| system.kick(step)));
        self.interactions.after(&self.systems, step.kick, &mut work);
        work
    }

    fn drift(&mut self, step: &Step) {
        self.systems.iter_mut().for_each(|system| system.drift(step));
        self.interactions.stepped();
    }

    fn advance(&mut self, step: &Step) -> Work {
        if self.interactions.is_empty() {
            return sum(self.systems.iter_mut().map(|system| system.advance(step)));
        }
        // The work of what they do to each other takes the velocities behind the kick, which a drift may carry on.
        self.evaluate(step.from);
        let work = self.kick(step);
        self.drift(step);
        work
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        let mut least = StableStep { dt: f64::INFINITY, holds: u64::MAX };
        for system in &mut self.systems {
            let StableStep { dt, holds } = system.stable_step(safety)?;
            least = StableStep { dt: least.dt.min(dt), holds: least.holds.min(holds) };
        }
        let dt = self.interactions.stable_step(&self.systems, least.dt, safety);
        Ok(StableStep { dt, ..least })
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        let own = self.systems.iter_mut().map(|system| system.shortened(stable, safety));
        let least = own.fold(stable, f64::min);
        least.min(self.interactions.shortened(&self.systems, stable, safety))
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            self.interactions.within_bounds()?;
        }
        let mut first = 0;
        for system in &self.systems {
            system.within_bounds(bounds).map_err(|found| match found {
                OutOfBounds::Speed { particle, speed, bound } => {
                    OutOfBounds::Speed { particle: first + particle, speed, bound }
                }
                range @ OutOfBounds::Range(_) => range,
            })?;
            first += system.particles();
        }
        Ok(())
    }

    fn stop(&mut self) {
        self.systems.iter_mut().for_each(|system| system.stop());
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        let all = self.systems.iter_mut().all(|system| system.linearised().is_some());
        if all { Some(self) } else { None }
    }
}
