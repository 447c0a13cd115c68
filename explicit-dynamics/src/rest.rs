//! Whether a motion has come to rest: what is out of balance, and how far it still has to go.
//!
//! Little kinetic energy does not say that a shell is near its equilibrium: a motion damped far beyond the critical
//! ratio creeps towards it with hardly any, and a period given too short ends a check before anything has happened. What
//! is missing shows in the forces. In mass-scaled coordinates (`M^½ q`) let `a` be
//! the force out of balance, `v` the velocity and `u` the displacement. Along a mode of circular frequency ω
//! equilibrium is `‖a‖/ω²` away, whatever the damping and whatever the period the march was given:
//!
//! ```text
//! out of balance   ‖a‖ ‖u‖ / 2U            2U/‖u‖ is the load along the way: for one mode, the load
//! remaining displacement         √(‖a‖²/ω⁴ + ‖v‖²/ω²) / ‖u‖
//! ω²               the lesser of a·K̂a/a·a and v·K̂v/v·v, K̂ the mass-scaled tangent of the present state
//! ```
//!
//! For a single mode both are the error of the displacement. The first sees modes that are stiff, of which little
//! displacement is missing but much force; the second soft ones, of which much displacement is missing but little force.

use serde::{Deserialize, Serialize};

use crate::linearised::MassScaled;

/// Modes slower than this many periods cannot move within a hold: a tangent softer than theirs, or none, counts as theirs.
const SLOWEST_PERIODS: f64 = 100.0;

/// Sizes that what is missing at rest is measured by: the greatest at the end of any level so far, and at present.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sizes {
    /// Displacement `‖M^½ u‖` \[M^½ L\].
    pub displaced: f64,
    /// Load along it, `2U/‖M^½ u‖` \[F/M^½\].
    pub load: f64,
}

/// What is missing at rest, as shares of the answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Missing {
    /// Force out of balance over load \[–\].
    pub out_of_balance: f64,
    /// Way left over displacement \[–\].
    pub remaining_displacement: f64,
}

impl Missing {
    /// Finds what is missing in the present state, whose forces have just been evaluated, with its internal energy
    /// \[F L\], the period \[T\] of its march and the sizes of the levels before, which take in the present ones. The
    /// forces of the system are those of another state afterwards.
    pub fn find(system: &mut dyn MassScaled, internal: f64, period: f64, sizes: &mut Sizes) -> Self {
        let displaced = system.displaced();
        if displaced > 0.0 {
            sizes.displaced = sizes.displaced.max(displaced);
            sizes.load = sizes.load.max(2.0 * internal / displaced);
        }
        let mut force = vec![0.0; system.unknowns()];
        let mut velocity = force.clone();
        system.out_of_balance(&mut force);
        system.rates(&mut velocity);
        let slowest = std::f64::consts::TAU / (SLOWEST_PERIODS * period);
        let softest = quotient(system, &force).min(quotient(system, &velocity)).max(slowest * slowest);
        let (force, velocity) = (system.dot(&force, &force), system.dot(&velocity, &velocity));
        let way = (force / (softest * softest) + velocity / softest).sqrt();
        Self {
            out_of_balance: share(force.sqrt(), sizes.load),
            remaining_displacement: share(way, sizes.displaced),
        }
    }

    /// Whether no more than this share is missing.
    pub fn within(&self, accuracy: f64) -> bool {
        self.out_of_balance <= accuracy && self.remaining_displacement <= accuracy
    }
}

/// How a level ended.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LevelReached {
    /// The level.
    pub level: f64,
    /// Whether the stop criterion was met within the hold.
    pub settled: bool,
    /// Kinetic over internal energy at the end of the hold.
    pub kinetic_over_internal: f64,
    /// What was missing at the end of the hold.
    pub missing: Missing,
    /// Steps spent on the level.
    pub steps: u64,
    /// Evaluations of the forces: steps, and what checks took beside them.
    pub evaluations: u64,
    /// The period by which the level went, the one given or the one found \[T\].
    pub period: f64,
}

/// The period of the mode of which the present motion holds most: that of Rayleigh's quotient of the velocities \[T\]. None of a
/// body that does not move, or that a motion along its velocities would not bring back.
pub(crate) fn period_of_motion(system: &mut dyn MassScaled) -> Option<f64> {
    let mut velocity = vec![0.0; system.unknowns()];
    system.rates(&mut velocity);
    period(quotient(system, &velocity))
}

/// The same of the last step, by what it changed of the force out of balance, which was `before`: with loads and supports that
/// stand still this holds the stiffness of loads that follow the body, and of directors under stress, as well.
pub(crate) fn period_of_step(system: &mut dyn MassScaled, before: &[f64], dt: f64) -> Option<f64> {
    let mut velocity = vec![0.0; before.len()];
    let mut after = vec![0.0; before.len()];
    system.rates(&mut velocity);
    system.out_of_balance(&mut after);
    after.iter_mut().zip(before).for_each(|(after, before)| *after = before - *after);
    let change = system.dot(&velocity, &after);
    period(change / (dt * system.dot(&velocity, &velocity)))
}

/// The period of the square of a circular frequency, if it is one.
fn period(square: f64) -> Option<f64> {
    (square > 0.0 && square.is_finite()).then(|| std::f64::consts::TAU / square.sqrt())
}

/// `x·K̂x/x·x`: the square of a circular frequency; infinite along nothing.
fn quotient(system: &mut dyn MassScaled, x: &[f64]) -> f64 {
    let length = system.dot(x, x);
    if length == 0.0 {
        return f64::INFINITY;
    }
    let mut image = vec![0.0; x.len()];
    system.apply(x, &mut image);
    system.dot(x, &image) / length
}

/// Of nothing, nothing is missing.
fn share(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
