//! Courses of loads and prescribed motions in time.

use schemars::JsonSchema;
use serde::Deserialize;

/// Variation of a load in time.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub enum Amplitude {
    /// One throughout.
    #[default]
    Constant,
    /// Linear from zero to one over this time \[T\].
    Ramp(f64),
    /// Quintic from zero to one over this time, without velocity and acceleration at its ends \[T\].
    Smooth(f64),
    /// Straight lines between `[time, factor]`.
    Table(Vec<[f64; 2]>),
    /// Sine of time.
    Sine {
        /// Period \[T\].
        period: f64,
    },
}
