//! The hard cases: every known way to break a shell or a particle method, with the defaults everywhere.
//!
//! A case that fails stays in the table, asserted as it is, with the cause.

mod bare;
mod energy_drift;
mod noise;
mod numbers;
mod point_driven;
mod same_bits;
mod spin;
mod step_estimate;
mod step_limit;
mod sudden;
mod zero_energy;

use crate::Case;

/// Every hard case, in the order of the survival table.
#[rustfmt::skip]
pub fn all() -> Vec<Case> {
    vec![
        zero_energy::case(),
        noise::case(),
        point_driven::case(),
        energy_drift::case(),
        step_limit::case(),
        step_estimate::case(),
        spin::case(),
        sudden::case(),
        numbers::case(),
        same_bits::case(),
    ]
}
