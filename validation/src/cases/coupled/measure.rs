//! What coupled runs leave behind, and what is measured on their curves.

use crate::judge::{Outcome, Solver};
use crate::support::marched::in_time;

/// Name of strips of shell in tables.
pub const SHELL: &str = "shell";
/// Name of solids of bonds in tables.
pub const SOLID: &str = "state-based solid";

/// Size and cost of a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Size {
    /// Particles of the fluid.
    pub particles: usize,
    /// Δx \[L\].
    pub spacing: f64,
    /// Steps of the fluid.
    pub steps: u64,
    /// Wall time \[s\].
    pub seconds: f64,
}

/// A curve in time, with the size of its run.
pub fn outcome<const N: usize>(size: Size, columns: [(&str, &str); N], rows: &[[f64; N]]) -> Outcome {
    let Size { particles, spacing, steps, seconds } = size;
    Outcome {
        solver: Solver::Explicit,
        curve: in_time(&columns, rows.iter().map(|row| row.to_vec()).collect()),
        particles,
        spacing,
        dof: 2 * particles,
        steps,
        threads: 1,
        wall_seconds: seconds,
        particle_steps_per_second: particles as f64 * steps as f64 / seconds.max(f64::MIN_POSITIVE),
        ..Outcome::default()
    }
}

/// Mean and standard deviation of values from an instant to another; none where there are none.
pub fn mean_and_deviation(times: &[f64], values: &[f64], [from, to]: [f64; 2]) -> Option<(f64, f64)> {
    let slack = 1e-9;
    let late: Vec<f64> = times
        .iter()
        .zip(values)
        .filter(|(t, _)| **t >= from - slack && **t <= to + slack)
        .map(|(_, value)| *value)
        .collect();
    if late.is_empty() || times.last().is_none_or(|&last| last < to - slack) {
        return None;
    }
    let count = late.len() as f64;
    let mean = late.iter().sum::<f64>() / count;
    let square = late.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count;
    Some((mean, square.sqrt()))
}

/// Time and value of the greatest value up to an instant.
pub fn peak(times: &[f64], values: &[f64], until: f64) -> Option<(f64, f64)> {
    let pairs = times.iter().copied().zip(values.iter().copied()).filter(|(t, _)| *t <= until);
    pairs.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The value at an instant, along the straight line between its neighbours.
pub fn value_at(times: &[f64], values: &[f64], at: f64) -> Option<f64> {
    let after = times.partition_point(|&t| t < at);
    let (&t1, &v1) = (times.get(after)?, values.get(after)?);
    let Some(before) = after.checked_sub(1) else { return (t1 == at).then_some(v1) };
    let (t0, v0) = (times[before], values[before]);
    Some(v0 + (v1 - v0) * (at - t0) / (t1 - t0))
}

/// The value at zero and the slope of a straight line through points, by least squares.
pub fn line(points: &[[f64; 2]]) -> [f64; 2] {
    let mean = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let moment = |k: usize| points.iter().map(|point| (point[0] - x) * (point[k] - [x, y][k])).sum::<f64>();
    let slope = moment(1) / moment(0);
    [y - slope * x, slope]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_peaks_and_values_of_a_curve() {
        let (times, values) = ([0.0, 1.0, 2.0, 3.0], [9.0, 1.0, 3.0, 2.0]);
        assert_eq!(mean_and_deviation(&times, &values, [1.0, 2.0]), Some((2.0, 1.0)));
        assert_eq!(mean_and_deviation(&times, &values, [1.0, 4.0]), None);
        assert_eq!(peak(&times[1..], &values[1..], 2.5), Some((2.0, 3.0)));
        assert_eq!(value_at(&times, &values, 2.5), Some(2.5));
        assert_eq!(value_at(&times, &values, 3.5), None);
    }
}
