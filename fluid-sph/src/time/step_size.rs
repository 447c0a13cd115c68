//! The stable step: signals, accelerations, friction and boundaries bound it.

use explicit_dynamics::{MarchError, StableStep};

use crate::fluid::{Fluid, StepBounds};

/// Part of the step of a quiet column below which a step has collapsed.
pub(super) const COLLAPSED: f64 = 1e-4;

impl Fluid {
    /// The step of the present state, times a safety; its forces are kept for the evaluation to come.
    pub(super) fn find_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.refresh();
        let h = self.momentum.kernel.h;
        let quotient = |a: f64, b: f64| if b > 0.0 { a / b } else { f64::INFINITY };
        self.bounds = StepBounds {
            force: quotient(h, self.force_sum.square.sqrt()).sqrt(),
            sound: h / self.force_sum.signal,
            friction: quotient(0.125 * h * h, self.formulation.kinematic_viscosity),
            boundary: quotient(0.25 * h, self.boundary.speed()),
        };
        let StepBounds { force, sound, friction, boundary } = self.bounds;
        // A bound that is no number must not vanish in a minimum: the fluid is refused by its bounds then.
        let dt = safety * (self.formulation.courant * force.min(sound)).min(friction).min(boundary);
        let good = dt > 0.0 && dt.is_finite() && !force.is_nan() && !sound.is_nan();
        if good { Ok(StableStep { dt, holds: 1 }) } else { Err(MarchError::NoStableStep(dt)) }
    }

    /// Whether the last step was next to nothing; it and its bound \[T\].
    pub(super) fn collapsed(&self) -> Option<(f64, f64)> {
        let quiet = self.momentum.kernel.h / self.liquid.sound_speed;
        let least = self.bounds.force.min(self.bounds.sound);
        (least > 0.0 && least < COLLAPSED * quiet).then_some((least, COLLAPSED * quiet))
    }
}
