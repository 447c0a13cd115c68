//! The line search of steps under load.

use super::Newton;
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError};

/// A line search sets in when `|δ·r|` along the step `δ` does not fall to this share \[matthies1979, crisfield1991\].
const SLACK: f64 = 0.8;
/// Trials of one line search.
const TRIALS: usize = 6;

impl Newton {
    /// Moves along `motion` by the whole of it, or by the share where `|motion·r|` has fallen enough.
    ///
    /// Only an overshoot (change of sign of `motion·r`, the slope of the potential) is shortened.
    pub(super) fn search<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        motion: &[f64],
    ) -> Result<f64, EquilibriumError> {
        let start = dot(motion, &self.residual);
        let saved = system.save();
        let mut share = 1.0;
        let mut scaled = motion.to_vec();
        for _ in 0..TRIALS {
            self.advance(system, &scaled);
            let slope = self.residual(system, level).map_or(f64::NAN, |_| dot(motion, &self.residual));
            if slope.abs() <= SLACK * start.abs() || slope * start > 0.0 {
                return Ok(share);
            }
            let crossing = start / (start - slope); // of the straight line between the slopes at 0 and here
            share *= if crossing.is_finite() { crossing.clamp(0.1, 0.9) } else { 0.5 };
            self.go_back(system, &saved);
            for (scaled, motion) in scaled.iter_mut().zip(motion) {
                *scaled = share * motion;
            }
        }
        self.advance(system, &scaled);
        Ok(share)
    }
}
