//! Damping proportional to mass, in the kick of particles and groups alike.

use explicit_dynamics::Step;

/// What damping leaves of a velocity: `1 − ½cκ` before the kick, `1/(1 + ½cκ)` after it.
#[derive(Clone, Copy)]
pub(crate) struct Decay {
    pub before: f64,
    pub after: f64,
}

impl Decay {
    pub fn of(step: &Step) -> Self {
        let half = 0.5 * step.damping * step.kick;
        Self { before: 1.0 - half, after: 1.0 / (1.0 + half) }
    }

    /// A velocity after the kick `push = κ f/m`.
    pub fn kicked(self, old: f64, push: f64) -> f64 {
        (old * self.before + push) * self.after
    }
}
