//! What the base of a run in time moves by itself, added to what columns read where displacements to space are wanted.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

use crate::bodies::Probe;
use crate::scene::{Analysis, BaseResponse, Explicit, Measured, MovingBase, Take, Transient};

/// A base whose motion is added.
pub(crate) struct BaseMotion {
    acceleration: Vec3,
    amplitude: Amplitude,
}

impl BaseMotion {
    /// That of an analysis which asks for displacements to space.
    pub fn of(analysis: &Analysis) -> Option<Self> {
        let Analysis::Explicit(Explicit { transient: Some(Transient { base: Some(base), .. }), .. }) =
            analysis
        else {
            return None;
        };
        let MovingBase { acceleration, amplitude, response } = base;
        (*response == BaseResponse::Absolute)
            .then(|| Self { acceleration: Vec3::from(*acceleration), amplitude: amplitude.clone() })
    }

    /// What a column has more by it at a time \[T\].
    pub fn adds(&self, probe: &Probe, time: f64) -> f64 {
        let [velocity, displacement] = self.amplitude.integrals(time);
        let by = match probe.of {
            Measured::Displacement | Measured::Position => displacement,
            Measured::Velocity => velocity,
            _ => return 0.0,
        };
        let times = if probe.take == Take::Sum { probe.particles.len() as f64 } else { 1.0 };
        probe.factor * times * by * self.acceleration.dot(&probe.direction)
    }
}
