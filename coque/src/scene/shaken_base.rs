//! Bases that are shaken: a load on all bodies, in axes that go with their supports.

use super::analysis::{Analysis, Explicit, Transient};
use super::checked::Checked;
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
        self.loads.push(Load { amplitude, ..weight(acceleration) });
    }
}

impl Analysis {
    /// Accelerations of bases that are shaken.
    pub(crate) fn shaken_mut(&mut self) -> Vec<&mut [f64; 3]> {
        match self {
            Self::Harmonic(Harmonic { base: Some(base), .. }) => vec![&mut base.acceleration],
            Self::Explicit(Explicit { transient: Some(Transient { base: Some(base), .. }), .. }) => {
                vec![&mut base.acceleration]
            }
            Self::ResponseSpectrum(wanted) => {
                wanted.base.iter_mut().map(|base| &mut base.acceleration).collect()
            }
            Self::RandomVibration(wanted) => {
                wanted.base.iter_mut().map(|base| &mut base.acceleration).collect()
            }
            _ => Vec::new(),
        }
    }
}

impl Checked {
    /// The scene in which nothing but a base, by its number, shakes at level one, beside what preloads.
    pub(crate) fn shaken_by(&self, base: usize) -> Self {
        let mut scene = self.clone().into_scene();
        scene.is_load_set = true;
        let acceleration = scene.analysis.shaken_mut().get(base).map(|acceleration| **acceleration);
        scene.loads.retain(|load| load.preload);
        scene.loads.extend(acceleration.map(weight));
        Self::made_of(scene)
    }
}

/// The weight that all of a body has in axes that are accelerated.
fn weight(acceleration: [f64; 3]) -> Load {
    Load::weight_of_base(Gravity { acceleration: acceleration.map(|a| -a) })
}
