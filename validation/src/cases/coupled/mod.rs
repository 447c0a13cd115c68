//! Structures that stand in fluids: first alone, then in the fluid; a new case is a file or folder, a line
//! here, and one in the list.

mod baffle;
mod box_in_waves;
mod clamped_strip;
pub mod column;
mod floating_box;
mod floating_cylinder;
mod gate;
mod gate_alone;
mod irregular_waves;
pub mod measure;
mod paddle_on_hinge;
mod plate;
mod plate_in_water;
mod regular_waves;
mod ring;
mod rolling_box;
mod scenes;
mod source_settings;
mod sprung_floor;
mod square;
mod turek_hron;
mod wave_flume;
mod wedge;
mod wedge_entry;
mod wedge_on_spring;

use super::finer;
use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    vec![
        clamped_strip::case(),
        turek_hron::case(),
        gate_alone::case(),
        column::case(),
        ring::case(),
        square::case(),
        gate::case(),
        plate::case(),
        wedge::case(),
        baffle::case(),
        scenes::case(),
        source_settings::case(),
        sprung_floor::case(),
        plate_in_water::case(),
        floating_box::case(),
        floating_cylinder::case(),
        paddle_on_hinge::case(),
        wedge_entry::case(),
        wedge_on_spring::case(),
        wave_flume::case(),
        irregular_waves::case(),
        box_in_waves::case(),
        rolling_box::case(),
        finer::leaning_wall(measure::SHELL),
    ]
}
