//! References of what shells are made of: heat, plies, flow.

use super::Entry;

macro_rules! data {
    ($name:literal) => {
        include_str!(concat!("../../data/", $name, ".json"))
    };
}

/// Shells that are heated, of plies, that yield.
#[rustfmt::skip]
pub(super) const SHELLS: &[Entry] = &[
    Entry { name: "heated_shells", quantity: "changes of temperature at which held plates buckle, curvature of two metals, temperature and heat of a fin, temperatures of a quenched plate, one a row",
        uncertainty: "exact for thin plates, for sections of two plies and for fins alike across; rounding of the printed digits, 1e-10",
        json: data!("heated_shells") },
    Entry { name: "ply_strength", quantity: "factor on the load of plies and laminates until the first ply fails, by two criteria, one a row",
        uncertainty: "exact within classical lamination; rounding of the printed digits, 1e-10",
        json: data!("ply_strength") },
    Entry { name: "plasticity_hemisphere", quantity: "displacements under the forces of a hemisphere with linear hardening against load",
        uncertainty: "two meshes of CalculiX within .13 % in the mean, .4 % at most", json: data!("plasticity_hemisphere") },
    Entry { name: "plasticity_square_plate", quantity: "pressure on a square plate without hardening against the deflection of its centre",
        uncertainty: "four meshes of CalculiX: .2 % to 20 mm, 2 % to 30, 3 % and too high beyond", json: data!("plasticity_square_plate") },
    Entry { name: "plasticity_scordelis_roof", quantity: "load on a roof without hardening against deflections, past its limit",
        uncertainty: "one mesh of CalculiX: 3 %, the limit load likely 2 % high", json: data!("plasticity_scordelis_roof") },
    Entry { name: "plasticity_pinched_cylinder", quantity: "force on a pinched cylinder with linear hardening against its way",
        uncertainty: "one mesh of CalculiX: 5 to 10 % in the first 10, 3 % beyond 60", json: data!("plasticity_pinched_cylinder") },
    Entry { name: "plasticity_cook_membrane", quantity: "force on Cook's membrane with linear hardening against the way of its corner",
        uncertainty: "two meshes of CalculiX within .14 % in the mean, .9 % at most", json: data!("plasticity_cook_membrane") },
];
