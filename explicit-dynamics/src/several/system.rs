//! Several systems as one that is marched.

use super::acting::Acting;
use super::interaction::{Interaction, Joinable};
use crate::dynamics::{Bounds, Dynamics};
use crate::error::{MarchError, OutOfBounds};
use crate::linearised::MassScaled;
use crate::stable_step::StableStep;
use crate::step::{Instant, Step, Work};

/// Systems that take the same steps, and what they do to each other.
pub struct Several<S: ?Sized> {
    pub(super) systems: Vec<Box<S>>,
    pub(super) acting: Vec<Acting>,
}

impl<S: Joinable + ?Sized> Several<S> {
    /// Systems, with all that they do to each other; particles of each interaction ascend.
    pub fn new(systems: Vec<Box<S>>, interactions: Vec<Box<dyn Interaction>>) -> Self {
        Self { systems, acting: interactions.into_iter().map(Acting::new).collect() }
    }

    /// Takes up what each interaction kept with a state, after the systems have taken it up; false if it is that of others.
    pub fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        let fits = kept.len() == self.acting.len();
        fits && self.acting.iter_mut().zip(kept).all(|(acting, kept)| acting.take_up(&self.systems, kept))
    }

    /// Lets them act on each other at their present places and an instant; the energy of that \[F L\].
    fn act(&mut self, at: Instant) -> f64 {
        if self.acting.is_empty() {
            return 0.0;
        }
        self.systems.iter_mut().for_each(|system| system.release());
        self.acting.iter_mut().map(|acting| acting.act(&mut self.systems, at)).sum()
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

    /// What each interaction keeps with a state, in the order in which they were given.
    pub fn kept(&self) -> Vec<Vec<f64>> {
        self.acting.iter().map(|acting| acting.interaction().kept()).collect()
    }

    /// An interaction, in the order in which they were given.
    pub fn interaction(&self, number: usize) -> Option<&dyn Interaction> {
        self.acting.get(number).map(Acting::interaction)
    }

    /// What an interaction last exerted on a particle of a system \[F\].
    pub fn force_on(&self, interaction: usize, system: usize, particle: u32) -> [f64; 3] {
        self.acting.get(interaction).map_or([0.0; 3], |acting| acting.force_on(system, particle))
    }

    /// Energy that an interaction lost at a particle of a system until the last step \[F L\].
    pub fn lost_at(&self, interaction: usize, system: usize, particle: u32) -> f64 {
        self.acting.get(interaction).map_or(0.0, |acting| acting.lost_at(system, particle))
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
        let between = self.act(at);
        let own: f64 = self.systems.iter_mut().map(|system| system.evaluate(at)).sum();
        own + between
    }

    fn kick(&mut self, step: &Step) -> Work {
        for acting in &mut self.acting {
            acting.before(&self.systems);
        }
        let mut work = sum(self.systems.iter_mut().map(|system| system.kick(step)));
        for acting in &mut self.acting {
            acting.after(&self.systems, step.kick, &mut work);
        }
        work
    }

    fn drift(&mut self, step: &Step) {
        self.systems.iter_mut().for_each(|system| system.drift(step));
        self.acting.iter_mut().for_each(Acting::moved);
        self.acting.iter_mut().for_each(Acting::commit);
    }

    fn advance(&mut self, step: &Step) -> Work {
        if self.acting.is_empty() {
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
        if self.acting.is_empty() {
            return Ok(least);
        }
        let between: f64 = self.acting.iter().map(|acting| acting.fastest(&self.systems)).sum();
        let square = (2.0 * safety / least.dt).powi(2) + between;
        Ok(StableStep { dt: 2.0 * safety / square.sqrt(), ..least })
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        let own = self.systems.iter_mut().map(|system| system.shortened(stable, safety));
        let least = own.fold(stable, f64::min);
        self.acting
            .iter_mut()
            .fold(least, |least, acting| least.min(acting.shortened(&self.systems, stable, safety)))
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Configuration {
            self.acting.iter().try_for_each(|acting| acting.interaction().within_bounds())?;
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
