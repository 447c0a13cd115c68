//! Several bodies that are marched: all of it is that of the systems on one clock.

use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, MassScaled, OutOfBounds, StableStep, Step, Work,
};

use super::body::Together;
use super::parts::Marched;
use crate::bodies::body::DynamicBody;

impl Dynamics for Together<Marched> {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.system.evaluate(at)
    }

    fn kick(&mut self, step: &Step) -> Work {
        match &mut self.joints {
            Some(joints) => joints.kick(&mut self.system, step),
            None => self.system.kick(step),
        }
    }

    fn drift(&mut self, step: &Step) {
        self.system.drift(step);
    }

    fn advance(&mut self, step: &Step) -> Work {
        if self.joints.is_none() {
            return self.system.advance(step);
        }
        self.evaluate(step.from);
        let work = self.kick(step);
        self.drift(step);
        work
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.system.stable_step(safety)
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        self.system.shortened(stable, safety)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        self.joints.as_ref().map_or(Ok(()), |joints| joints.held())?;
        self.system.within_bounds(bounds)
    }

    fn stop(&mut self) {
        self.system.stop();
    }

    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        self.system.linearised()
    }
}

impl DynamicBody for Together<Marched> {
    fn look(&mut self, time: f64) {
        self.system.systems_mut().iter_mut().for_each(|part| part.look(time));
    }
}
