//! Means of forces over the time between two records: an impact shorter than that is lost to the instants.
//!
//! A march kicks with the force of an instant over a span from the middle of the step before to the middle of the one behind. The
//! impulse between two records is the sum of force times span over the kicks between, and of the kicks at the records the half that
//! lies between: what the bodies got, to the last bit.

use serde::{Deserialize, Serialize};

/// Impulses of the columns of a run since the last record.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Impulses {
    /// When the last record was \[T\].
    recorded: f64,
    /// The end of the last step \[T\], and its length.
    now: f64,
    last: f64,
    /// By column that has a mean: the kicks since the last record, less the half of its own before it.
    sums: Vec<f64>,
}

impl Impulses {
    /// Of so many columns.
    pub fn new(columns: usize) -> Self {
        Self { sums: vec![0.0; columns], ..Self::default() }
    }

    /// Takes in the forces of the last step, which ended at a time; asked twice, the second time there is nothing to take.
    pub fn take(&mut self, time: f64, forces: impl Iterator<Item = f64>) {
        let step = time - self.now;
        if step > 0.0 {
            let span = 0.5 * (self.last + step);
            self.sums.iter_mut().zip(forces).for_each(|(sum, force)| *sum += span * force);
            (self.now, self.last) = (time, step);
        }
    }

    /// The mean of a column since the last record, with its force at present; at the first record that force.
    pub fn mean(&mut self, column: usize, force: f64) -> f64 {
        let (time, half) = (self.now - self.recorded, 0.5 * self.last * force);
        let Some(sum) = self.sums.get_mut(column) else { return force };
        let impulse = std::mem::replace(sum, -half) + half;
        if time > 0.0 { impulse / time } else { force }
    }

    /// All means have been read.
    pub fn recorded(&mut self) {
        self.recorded = self.now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A force that goes up and down between two records: the trapezoids of all its steps, whatever the steps.
    #[test]
    fn the_mean_is_that_of_trapezoids() {
        let force = |t: f64| t * t * (4.0 - t);
        let mut impulses = Impulses::new(1);
        let times = [0.0, 0.3, 0.7, 1.0, 1.6, 2.0];
        let mut means = vec![impulses.mean(0, force(0.0))];
        impulses.recorded();
        for (number, &time) in times.iter().enumerate().skip(1) {
            impulses.take(time, [force(times[number - 1])].into_iter());
            impulses.take(time, [f64::NAN].into_iter());
            if [1.0, 2.0].contains(&time) {
                means.push(impulses.mean(0, force(time)));
                impulses.recorded();
            }
        }
        let trapezoids = |range: std::ops::Range<usize>| -> f64 {
            range.map(|i| 0.5 * (force(times[i]) + force(times[i + 1])) * (times[i + 1] - times[i])).sum()
        };
        for (found, expected) in means.iter().zip([0.0, trapezoids(0..3), trapezoids(3..5)]) {
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
