//! Every strain measure, by name.

use crate::log_strain::Logarithmic;
use crate::strain::{GreenLagrange, StrainMeasure, StretchCorrected};

/// Every strain measure, in the order shown to users.
pub fn strain_measures() -> [&'static dyn StrainMeasure; 3] {
    [&StretchCorrected, &GreenLagrange, &Logarithmic]
}

/// The strain measure of a given name.
pub fn strain_measure(name: &str) -> Option<&'static dyn StrainMeasure> {
    strain_measures().into_iter().find(|m| m.name() == name)
}
