//! One step of central differences: its instants, its spans, and the work done over it.

use serde::{Deserialize, Serialize};

/// A moment of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Instant {
    /// Time \[T\].
    pub time: f64,
    /// Load level λ \[–\]: scales driven loads and prescribed motions; one in a transient run.
    pub level: f64,
}

/// One step of central differences, from `from` to `to`.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Where the forces were evaluated.
    pub from: Instant,
    /// Where the configuration arrives.
    pub to: Instant,
    /// Span of the velocity update \[T\]: from the middle of the last step to the middle of this one.
    pub kick: f64,
    /// Mass-proportional damping c \[1/T\].
    pub damping: f64,
}

impl Step {
    /// Span of the configuration update \[T\].
    pub fn drift(&self) -> f64 {
        self.to.time - self.from.time
    }

    /// What damping leaves of velocities in the kick.
    pub fn decay(&self) -> Decay {
        let half = 0.5 * self.damping * self.kick;
        Decay { before: 1.0 - half, after: 1.0 / (1.0 + half) }
    }

    /// Impulse with which a support takes a mass m from one velocity to another under a force f, both along one axis: what the balance of
    /// the mass lacks, `m (v⁺ − v⁻) + κ (m c v̄ − f)`, of an inertia about an axis likewise \[F T\].
    #[inline]
    pub fn support_impulse(&self, mass: f64, [old, new]: [f64; 2], force: f64) -> f64 {
        let mean = 0.5 * (old + new);
        mass * (new - old) + self.kick * (mass * self.damping * mean - force)
    }
}

/// Damping proportional to mass over a kick κ: `1 − ½cκ` of a velocity before it, `1/(1 + ½cκ)` after it.
#[derive(Clone, Copy, Debug)]
pub struct Decay {
    /// Factor of the velocity before the kick \[–\].
    pub before: f64,
    /// Factor of the velocity with the kick \[–\].
    pub after: f64,
}

impl Decay {
    /// A velocity after the kick `push = κ f/m` \[L/T\].
    #[inline]
    pub fn kicked(self, old: f64, push: f64) -> f64 {
        (old * self.before + push) * self.after
    }
}

/// What one kick did.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Kinetic energy at `from`, with the mean of the velocities before and after the kick \[F L\].
    pub kinetic: f64,
    /// Work of loads and of supports over the kick \[F L\]; of the latter `m (v⁺ − v⁻)·v̄` on top of what forces lack, so that a
    /// motion that starts or stops at speed has its ½mv² counted.
    pub external: f64,
    /// Energy taken by mass-proportional damping over the kick \[F L\].
    pub dissipated: f64,
    /// Kinetic energy of the change of velocities, `½ Σ m (v⁺ − v⁻)²` \[F L\]; read after [`crate::Dynamics::kick`] alone.
    pub change: f64,
    /// Work of the internal forces f on that change, `κ Σ f·(v⁺ − v⁻)`, f as it resists \[F L\]; read there too.
    pub resisted: f64,
}

impl Work {
    /// By how much energies with the mean of the velocities exceed the one that central differences keep \[F L\].
    ///
    /// For forces linear in the place, at equal steps, they keep to round-off
    ///
    /// ```text
    /// ½ v⁻·M v⁺ + U − W,     W the sum of ½ v·(P + P′) over steps, P and P′ the impulses at both ends that are not internal
    /// ```
    ///
    /// The kinetic energy is greater by `⅛ Σ m (v⁺ − v⁻)²`, the work by `¼ Σ P·(v⁺ − v⁻)`. Both come and go, without a trend; they
    /// are small for motions of many steps, and as large as the energy itself where a support starts or stops at speed.
    pub(crate) fn ripple(&self) -> f64 {
        -0.25 * (self.change + self.resisted)
    }

    /// The same at the start, where a kick of half a span has been counted with the mean of its velocities.
    pub(crate) fn ripple_at_start(&self) -> f64 {
        -0.5 * self.resisted
    }
}
