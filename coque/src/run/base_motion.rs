//! What the base of a run in time moves by itself, added to what columns read where displacements to space are wanted.

use explicit_dynamics::Amplitude;
use sph_core::Vec3;

use crate::bodies::Probe;
use crate::scene::{Analysis, BaseResponse, Explicit, Measured, MovingBase, Take, Transient};

/// What moves with the base.
const MOVING: [Measured; 3] = [Measured::Displacement, Measured::Position, Measured::Velocity];

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

    /// Adds to a row, from the first column of the probes on, what it moves by at a time \[T\]; its integrals are found once, and only where a column moves with it.
    pub fn add_to(&self, row: &mut [f64], probes: &[Probe], time: f64) {
        if !probes.iter().any(|probe| MOVING.contains(&probe.of)) {
            return;
        }
        let [velocity, displacement] = self.amplitude.integrals(time);
        let mut at = 0;
        for probe in probes {
            if MOVING.contains(&probe.of) {
                let by = if probe.of == Measured::Velocity { velocity } else { displacement };
                let times = if probe.take == Take::Sum { probe.particles.len() as f64 } else { 1.0 };
                row[at] += probe.factor * times * by * self.acceleration.dot(&probe.direction);
            }
            at += 1 + usize::from(probe.of.has_mean());
        }
    }
}
