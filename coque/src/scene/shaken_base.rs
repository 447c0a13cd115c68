//! A base that is shaken: a load on all of the body, in axes that go with its supports.

use super::analysis::Analysis;
use super::harmonic::Harmonic;
use super::loads::{Gravity, Load};
use super::problem::Scene;

impl Scene {
    /// Makes the load of what shakes the supports, a weight, in place of one that was made before.
    pub(super) fn shake_base(&mut self) {
        self.loads.retain(|load| !load.of_base);
        let Analysis::Harmonic(Harmonic { base: Some(base), .. }) = &self.analysis else { return };
        let gravity = Gravity { acceleration: base.acceleration.map(|a| -a) };
        self.loads.push(Load::weight_of_base(gravity));
    }
}
