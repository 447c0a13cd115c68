//! How a load varies in time.

use serde::{Deserialize, Serialize};

/// Variation of a load in time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "scene", derive(schemars::JsonSchema))]
pub enum Amplitude {
    /// One throughout.
    #[default]
    Constant,
    /// Linear from zero to one over this time, one after \[T\].
    Ramp(f64),
    /// Quintic from zero to one over this time, without velocity and acceleration at its ends, `s³(10 − 15s + 6s²)` \[T\].
    Smooth(f64),
    /// Straight lines between `[time, factor]`, times ascending; constant before and after.
    Table(Vec<[f64; 2]>),
    /// Sine of time, `sin(2πt/T)`.
    Sine {
        /// Period \[T\].
        period: f64,
        /// Time in which it grows to its size, by the factor of `smooth`; left out, none \[T\].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        growth: Option<f64>,
    },
}

impl Amplitude {
    /// The factor at a time \[T\].
    pub fn value(&self, time: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Ramp(duration) => (time / duration).clamp(0.0, 1.0),
            Self::Smooth(duration) => smooth(time / duration),
            Self::Sine { period, growth } => {
                let sine = libm::sin(std::f64::consts::TAU * time / period);
                growth.map_or(sine, |growth| sine * smooth(time / growth))
            }
            Self::Table(points) => table(points, time),
        }
    }
}

/// The quintic `s³(10 − 15s + 6s²)` on \[0, 1\].
pub(crate) fn smooth(s: f64) -> f64 {
    let s = s.clamp(0.0, 1.0);
    s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
}

fn table(points: &[[f64; 2]], time: f64) -> f64 {
    let after = points.partition_point(|&[t, _]| t <= time);
    match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
        (Some(&[t0, v0]), Some(&[t1, v1])) => v0 + (v1 - v0) * (time - t0) / (t1 - t0),
        (Some(&[_, v]), None) | (None, Some(&[_, v])) => v,
        (None, None) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amplitudes_take_the_values_they_name() {
        assert_eq!(Amplitude::Constant.value(7.0), 1.0);
        assert_eq!(Amplitude::Ramp(2.0).value(0.5), 0.25);
        assert_eq!(Amplitude::Ramp(2.0).value(5.0), 1.0);
        assert_eq!(Amplitude::Smooth(2.0).value(1.0), 0.5);
        for (time, value) in [(1.0, 1.0), (2.0, 0.0), (3.0, -1.0)] {
            assert!((Amplitude::Sine { period: 4.0, growth: None }.value(time) - value).abs() < 1e-15);
        }
        let grown = Amplitude::Sine { period: 4.0, growth: Some(2.0) };
        assert!((grown.value(1.0) - 0.5).abs() < 1e-15 && (grown.value(5.0) - 1.0).abs() < 1e-14);
        let table = Amplitude::Table(vec![[1.0, 2.0], [3.0, 6.0]]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 9.0].map(|t| table.value(t)), [2.0, 2.0, 4.0, 6.0, 6.0]);
    }

    #[test]
    fn smooth_starts_and_ends_without_velocity_or_acceleration() {
        // The quintic deviates from its end values by 10 s³ + O(s⁴).
        let s = 1e-3;
        assert!((smooth(s) - 10.0 * s * s * s).abs() < 16.0 * s * s * s * s);
        assert!((1.0 - smooth(1.0 - s) - 10.0 * s * s * s).abs() < 16.0 * s * s * s * s);
    }
}
