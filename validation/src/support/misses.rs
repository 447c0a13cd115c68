//! Misses that are known: shown beside what was asked, and judged, so that a change is seen.

use crate::Metric;
use crate::metric_names::KNOWN;

/// A miss that is known: by how much, and why. It is judged like what is asked, so that a change is seen.
#[derive(Clone, Copy, Debug)]
pub struct Miss {
    /// What was measured.
    pub measured: f64,
    /// How far a value may be from that before it has to be looked at again.
    pub margin: f64,
    /// What it comes from, as far as known.
    pub cause: &'static str,
}

/// Part of a known miss by which it may change before it has to be looked at again.
const DRIFT: f64 = 0.1;

impl Miss {
    /// The miss of a value that should be `asked`.
    pub fn of(asked: f64, measured: f64, cause: &'static str) -> Self {
        Self { measured, margin: DRIFT * (measured - asked).abs(), cause }
    }

    /// Asks that a value miss what is asked as it is known to.
    pub fn judged(&self, name: &str, value: Option<f64>, unit: &str) -> Metric {
        let name = format!("{KNOWN}: {name}");
        Metric::compared(name, value, unit, self.measured).within(self.margin, self.cause)
    }
}

/// Asks that a value lie between bounds, or that it miss them as it is known to.
pub fn between(
    name: &str,
    value: Option<f64>,
    unit: &str,
    [low, high]: [f64; 2],
    reason: &str,
    miss: Option<Miss>,
) -> Vec<Metric> {
    let found = Metric::compared(name, value, unit, 0.5 * (low + high));
    match miss {
        None => vec![found.within(0.5 * (high - low), reason)],
        Some(miss) => {
            let words = format!("asked {low} to {high} {unit}, {reason}; known to miss it: {}", miss.cause);
            vec![found.shown(words), miss.judged(name, value, unit)]
        }
    }
}
