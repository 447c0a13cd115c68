//! The energy that is set free between two levels: by it a snap is distinguished from a path.
//!
//! Along stable equilibria q(λ) the potential `E(λ) = U − λW`, W the work of the unit loads, changes by
//!
//! ```text
//! E′ = R − W      R = ∂U/∂λ at fixed unknowns, what the forces of prescribed values and of tools do on them in a unit of level, and what heat adds
//! ```
//!
//! Between two levels a step h apart, what the forces do by the trapezoidal rule exceeds what the potential gains by
//!
//! ```text
//! D = ½ h (E′₀ + E′₁) − (E₁ − E₀) = ½ h (R₀ + R₁) + ½ (λ₀ + λ₁) ΔW − ΔU
//! ```
//!
//! Under loads alone `E″ = −p·K⁻¹p < 0`: E′ goes one way, so that `D ≤ ½ |h| |ΔE′|`, whatever the path. The same holds of R as long as
//! it grows with λ. Forces of prescribed values fall along stable paths as well; where they do so no faster than k,
//! `D ≤ ¼ k h²`, and k is four times what they did in any step so far. A snap sets its energy free besides, however
//! small the step: beyond these bounds, no path of stable equilibria joins the two states, and under prescribed values none that is not
//! four times as steep as all before. A snap that sets free less than a step leaves open is not seen, none at all in a first level.

use serde::{Deserialize, Serialize};

use crate::Equilibrium;
use crate::vectors::dot;

/// Part of a step by which the level is changed to find R.
const NEARBY: f64 = 1e-4;
/// How much faster than in any step so far the forces of prescribed values may fall.
const STEEPER: f64 = 4.0;

/// Energy set free between two levels, and the most that a path of stable equilibria between them leaves over.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SnapEnergy {
    /// D \[F L\].
    pub energy: f64,
    /// Its bound \[F L\].
    pub most: f64,
}

impl SnapEnergy {
    /// Whether the state found lies on another branch than the one before.
    pub fn snapped(&self) -> bool {
        self.energy > self.most
    }
}

/// What is known of the energy at the last equilibrium and before.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Energies {
    /// Level, U and R.
    last: Option<[f64; 3]>,
    /// Greatest |ΔR/h| so far between states that one branch joins.
    steepest: f64,
}

impl Energies {
    /// Looks at the equilibrium where the system stands, unless it is the last one found; a step to another level follows.
    pub fn stands_at<E: Equilibrium + ?Sized>(&mut self, system: &mut E, known: bool, levels: (f64, f64)) {
        if !known || self.last.is_none_or(|[level, ..]| level != levels.0) {
            *self = Self { last: Some(seen(system, levels.0, levels.1 - levels.0)), steepest: 0.0 };
        }
    }

    /// Looks at the equilibrium that was found, a way (as [`Equilibrium::motion_to`] or sums of moves tell it) from the start.
    pub fn found<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        (from, to): (f64, f64),
        start: &[f64],
        way: Vec<f64>,
    ) -> SnapEnergy {
        let step = to - from;
        let after = seen(system, to, step);
        let [_, before_u, before_r] = self.last.replace(after).unwrap_or_default();
        let [_, after_u, after_r] = after;
        let work = unit_work(system, start, way, if to.abs() > from.abs() { to } else { from });
        let (slope, size) = ((after_r - before_r) / step, step.abs());
        let energy = 0.5 * (step * (before_r + after_r) + (from + to) * work) - (after_u - before_u);
        let one_way = 0.5 * size * (work.abs() + size * slope.max(0.0));
        let most = one_way.max(0.25 * STEEPER * self.steepest * size * size);
        let release = SnapEnergy { energy, most };
        if !release.snapped() {
            self.steepest = self.steepest.max(slope.abs());
        }
        release
    }
}

/// Level, U and R of the present state; R by a central difference over a small part of a step.
fn seen<E: Equilibrium + ?Sized>(system: &mut E, level: f64, step: f64) -> [f64; 3] {
    let (here, mut forces) = (system.save(), vec![0.0; system.unknowns()]);
    system.external(level, &mut forces);
    let energy = system.energy() + system.contact_energy();
    let by_level = system.has_moving_supports() || system.has_moving_tools();
    if !by_level && system.stress_forces(level + step) == 0.0 {
        return [level, energy, 0.0];
    }
    let mut energy_at = |level: f64| {
        system.internal(level, &mut forces);
        system.external(level, &mut forces);
        system.energy() + system.contact_energy()
    };
    let nearby = NEARBY * step;
    let difference = energy_at(level + nearby) - energy_at(level - nearby);
    system.restore(&here);
    [level, energy, 0.5 * difference / nearby]
}

/// Work of the unit loads on the way from a saved state to the present one, by Simpson's rule \[F L\].
fn unit_work<E: Equilibrium + ?Sized>(system: &mut E, start: &[f64], mut way: Vec<f64>, level: f64) -> f64 {
    let (here, mut force) = (system.save(), vec![0.0; way.len()]);
    system.restore(start);
    system.motion_to(&here, &mut way);
    way.iter_mut().for_each(|way| *way *= 0.5);
    let mut sum = 0.0;
    for weight in [1.0, 4.0, 1.0] {
        system.external_without_contact(level, &mut force);
        sum += weight * dot(&force, &way);
        system.transport(&mut way);
    }
    system.restore(&here);
    sum / (3.0 * level)
}
