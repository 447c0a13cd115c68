//! A base that is shaken: a load on all bodies, in axes that go with their supports.

use super::analysis::{Analysis, Explicit, Transient};
use super::harmonic::Harmonic;
use super::loads::{Gravity, Load};
use super::problem::Scene;

impl Scene {
    /// Makes the load of what shakes the supports, a weight, in place of one that was made before.
    pub(super) fn shake_base(&mut self) {
        self.loads.retain(|load| !load.of_base);
        let (acceleration, amplitude) = match &self.analysis {
            Analysis::Harmonic(Harmonic { base: Some(base), .. }) => (base.acceleration, None),
            Analysis::Explicit(Explicit { transient: Some(Transient { base: Some(base), .. }), .. }) => {
                (base.acceleration, Some(base.amplitude.clone()))
            }
            _ => return,
        };
        let gravity = Gravity { acceleration: acceleration.map(|a| -a) };
        self.loads.push(Load { amplitude, ..Load::weight_of_base(gravity) });
    }
}
