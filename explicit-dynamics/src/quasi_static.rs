//! Equilibria along a load path: a smooth ramp to each level, then a hold until the motion has died.

use std::ops::ControlFlow;

use crate::amplitude::smooth;
use crate::error::positive;
use crate::{Clock, Damping, Dynamics, KineticDamping, LinearisedDynamics, MarchError, Observer};

/// Ramp and hold. Loads are read after a hold: damping drags the reaction while a ramp runs.
#[derive(Clone, Debug)]
pub struct QuasiStatic {
    /// Load levels λ to stop at, in order; the path starts at nought.
    pub levels: Vec<f64>,
    /// Period T₁ of the lowest mode \[T\]: the unit of `ramp` and `hold`, and the base of the damping.
    pub period: f64,
    /// Ramp to each level, in periods.
    pub ramp: f64,
    /// Longest hold, in periods.
    pub hold: f64,
    /// How the motion dies.
    pub damping: Damping,
    /// Stop criterion: kinetic over internal energy.
    pub tolerance: f64,
    /// Fraction of the stable step to use.
    pub safety: f64,
}

/// How a level ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelReached {
    /// The level.
    pub level: f64,
    /// Whether the stop criterion was met within the hold.
    pub settled: bool,
    /// Kinetic over internal energy at the end of the hold.
    pub kinetic_over_internal: f64,
    /// Steps spent on the level.
    pub steps: u64,
}

/// Holds are looked at this many times a period.
const LOOKS_PER_PERIOD: f64 = 20.0;
/// Looks in a row that must find the motion dead: a swing is at rest for an instant wherever it turns.
const QUIET_LOOKS: usize = 2;
/// Steps a period beyond which the period is taken for a mistake: a run would never end.
const MOST_STEPS_A_PERIOD: f64 = 1e8;

impl QuasiStatic {
    /// Marches through all levels; one record at the start and one at the end of each hold.
    ///
    /// # Errors
    /// [`MarchError`] for options out of bounds and for divergence.
    pub fn march<S, O>(&self, system: &mut S, observer: &mut O) -> Result<Clock, MarchError>
    where
        S: Dynamics + LinearisedDynamics,
        O: Observer<S>,
    {
        positive("period", self.period)?;
        positive("ramp", self.ramp)?;
        positive("hold", self.hold)?;
        positive("tolerance", self.tolerance)?;
        let damping = self.damping.coefficient(self.period);
        let mut clock = Clock::start(system, 0.0, self.safety, damping)?;
        if self.period > MOST_STEPS_A_PERIOD * clock.dt {
            let bound = "at most 1e8 stable steps; check the units of period, density and stiffness";
            return Err(MarchError::Option { key: "period", value: self.period, bound });
        }
        if clock.recorded_step(system, observer, true, f64::INFINITY, |_| 0.0)?.is_break() {
            return Ok(clock);
        }
        for number in 0..self.levels.len() {
            if number > 0 {
                clock.estimate_step(system)?;
            }
            if self.one_level(&mut clock, system, observer, number)?.is_break() {
                break;
            }
        }
        Ok(clock)
    }

    fn one_level<S, O>(
        &self,
        clock: &mut Clock,
        system: &mut S,
        observer: &mut O,
        number: usize,
    ) -> Result<ControlFlow<()>, MarchError>
    where
        S: Dynamics + LinearisedDynamics,
        O: Observer<S>,
    {
        let to = self.levels[number];
        let from = if number == 0 { 0.0 } else { self.levels[number - 1] };
        let (start, first_step) = (clock.now.time, clock.steps);
        let ramp = self.ramp * self.period;
        let level = |time: f64| from + (to - from) * smooth((time - start) / ramp);
        while start + ramp - clock.now.time > 0.5 * clock.dt {
            clock.step(system, start + ramp - clock.now.time, level)?;
        }
        clock.now.level = to;
        let hold_end = clock.now.time + self.hold * self.period;
        let look = self.period / LOOKS_PER_PERIOD;
        let mut peaks = KineticDamping::default();
        let mut quiet = 0;
        loop {
            let look_end = clock.now.time + look;
            while clock.now.time < look_end {
                clock.step(system, f64::INFINITY, |_| to)?;
                if self.damping == Damping::Kinetic && peaks.peaked(clock.kinetic) {
                    system.stop();
                    clock.book_stop();
                }
            }
            system.force(clock.now, true);
            // Kinetic damping has just stopped the motion: its last peak is the measure of rest.
            let kinetic = if self.damping == Damping::Kinetic { peaks.peak } else { clock.kinetic };
            let ratio = kinetic / system.internal_energy().max(f64::MIN_POSITIVE);
            let below = ratio < self.tolerance && (self.damping != Damping::Kinetic || peaks.peak > 0.0);
            quiet = if below { quiet + 1 } else { 0 };
            if let Some(good) = clock.last_good() {
                // Most holds end early: half a level for the ramp, the rest approached.
                let within = 1.0 - 0.5 / (1.0 + (clock.now.time - start - ramp) / self.period);
                observer.progress((number as f64 + within) / self.levels.len() as f64, good);
            }
            let settled = quiet >= QUIET_LOOKS;
            if settled || clock.now.time >= hold_end {
                let steps = clock.steps - first_step;
                observer.level(&LevelReached { level: to, settled, kinetic_over_internal: ratio, steps });
                let flow = clock.recorded_step(system, observer, settled, f64::INFINITY, |_| to)?;
                clock.watch(system)?;
                return Ok(flow);
            }
        }
    }
}
