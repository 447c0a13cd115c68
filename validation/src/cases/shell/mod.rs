//! The usual cases of shells; a new one is a file, a line here, and one in the list.

mod bracket;
mod buckling;
mod cantilever_by_spectrum;
mod cantilever_end_shear;
mod cantilever_in_noise;
mod cantilever_shaken;
mod clamped_cap;
mod deck_in_quake;
mod external_pressure;
mod framed_plate;
mod heat;
mod heavy_end;
pub mod hemisphere;
pub mod hemisphere_large;
mod hook;
mod hub_turned;
mod i_beams;
mod initial_stress;
mod joined_cantilevers;
mod junctions;
pub mod open_cylinder;
pub mod panel;
mod panel_laminated;
mod panel_snap_back;
mod patch_test;
mod pinched_cylinder;
pub mod pinched_cylinder_large;
pub mod plate;
mod plate_frequencies;
mod plate_on_gas;
mod ply_strength;
pub mod point_load_smoothness;
mod ring;
mod ring_green_lagrange;
mod sandwich_panel;
mod scordelis_lo;
mod shortened;
mod stepped_plate;
mod stiffened_plate;
mod struck_strip;
mod thin_ring;
mod tubes;
mod turned;
mod twisted_beam;
mod two_span_cases;

use super::family;
use crate::Case;

/// Every case, in the order of table and report.
pub fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    cases.extend(family(
        "Strips and rings",
        [ring::case(), ring_green_lagrange::case(), thin_ring::case(), cantilever_end_shear::case()],
    ));
    cases.extend(family("Panels", [panel::case(), panel_snap_back::case(), panel_laminated::case()]));
    cases.extend(family(
        "Linear shells",
        [scordelis_lo::case(), pinched_cylinder::case(), hemisphere::case(), twisted_beam::case()],
    ));
    cases.extend(family(
        "Frames and sections",
        [
            junctions::case(),
            i_beams::case(),
            hook::case(),
            tubes::case(),
            bracket::case(),
            heavy_end::case(),
            cantilever_shaken::case(),
            cantilever_by_spectrum::case(),
            cantilever_in_noise::case(),
            deck_in_quake::case(),
        ],
    ));
    cases.extend(family(
        "Plates",
        [
            plate::case(),
            plate_frequencies::case(),
            plate_on_gas::case(),
            stepped_plate::case(),
            framed_plate::case(),
            initial_stress::case(),
            heat::case(),
            sandwich_panel::case(),
            ply_strength::case(),
            two_span_cases::case(),
            hub_turned::case(),
            joined_cantilevers::case(),
        ],
    ));
    cases.extend(family(
        "Stability of shells",
        [
            buckling::case(),
            stiffened_plate::case(),
            shortened::case(),
            clamped_cap::case(),
            external_pressure::case(),
        ],
    ));
    cases.extend(family(
        "Shells through large rotations",
        [
            hemisphere_large::case(),
            open_cylinder::case(),
            pinched_cylinder_large::case(),
            point_load_smoothness::case(),
        ],
    ));
    cases.extend(family("Invariance of shells", [turned::case(), patch_test::case(), struck_strip::case()]));
    cases
}
