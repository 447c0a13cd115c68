//! Curves of hardening as yield curves of solids.

use shell_kinematics::Hardening;
use solid_kinematics::YieldCurve;

/// A curve of hardening, the same as of shells.
#[derive(Clone, Debug)]
pub struct Hardened(pub Hardening);

impl YieldCurve for Hardened {
    fn at(&self, strain: f64) -> [f64; 2] {
        [self.0.stress(strain), self.0.slope(strain)]
    }

    fn stored(&self, strain: f64) -> f64 {
        self.0.stored(strain)
    }
}
