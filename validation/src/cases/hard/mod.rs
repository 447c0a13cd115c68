//! The hard cases: every known way to break a shell, a solid or a particle method, with the defaults everywhere.
//!
//! A case that fails stays in the table, asserted as it is, with the cause.

mod bodies;
mod causes;
mod coupled;
mod crease;
mod disorder;
mod energy_drift;
mod fluids;
mod frames;
mod galerkin;
mod hemisphere_in_time;
mod large;
mod loads;
mod noise;
mod numbers;
mod point_driven;
mod same_bits;
mod solids;
mod spin;
mod step_estimate;
mod step_limit;
mod strong_form;
mod sudden;
mod thickness;
mod unstructured;
mod zero_energy;

use crate::Case;

/// Every hard case, in the order of the survival table.
#[rustfmt::skip] // one line a case
pub fn all() -> Vec<Case> {
    vec![
        disorder::case(),
        thickness::case(),
        large::case(),
        loads::case(),
        bodies::case(),
        unstructured::case(),
        crease::case(),
        frames::case(),
        hemisphere_in_time::case(),
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
        strong_form::case(),
        solids::tension::case(),
        solids::same_damage::case(),
        solids::pieces::case(),
        galerkin::solids::case(),
        galerkin::refusals::case(),
        fluids::sloshing::case(),
        fluids::corner::case(),
        fluids::one_particle::case(),
        fluids::jet::case(),
        fluids::kernel_width::case(),
        fluids::refused::case(),
        coupled::fluid_first::case(),
        coupled::light::case(),
        coupled::thin::case(),
        coupled::jet::case(),
        coupled::drop::case(),
    ]
}
