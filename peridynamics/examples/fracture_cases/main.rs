//! Dynamic cases of peridynamic solids, and what they measure.
//!
//! ```text
//! cargo run --release -p peridynamics --example fracture_cases -- [branching strip kalthoff kalthoff-space wave torsion cantilever]
//! ```

mod branching;
mod cantilever;
mod kalthoff;
mod measure;
mod rods;
mod strip;
mod support;

use peridynamics::Correction::{Even, None};
use peridynamics::Law::{BondBased, StateBased};
use peridynamics::Space;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |name: &str| asked.is_empty() || asked.iter().any(|one| one == name);
    if wanted("branching") {
        for (law, horizon, spacing, correction, by_work) in [
            (BondBased, 3.015, 5e-4, None, false),
            (BondBased, 4.015, 5e-4, None, false),
            (BondBased, 3.015, 5e-4, Even, false),
            (StateBased, 3.015, 5e-4, None, false),
            (StateBased, 3.015, 5e-4, None, true),
            (StateBased, 3.015, 5e-4, Even, false),
            (StateBased, 4.015, 5e-4, Even, false),
            (BondBased, 3.015, 2.5e-4, None, false),
            (BondBased, 3.015, 2.5e-4, Even, false),
            (BondBased, 4.015, 2.5e-4, Even, false),
            (StateBased, 3.015, 2.5e-4, Even, false),
        ] {
            branching::run(&branching::Case { law, horizon, spacing, correction, by_work })?;
        }
    }
    if wanted("kalthoff") {
        for (space, law, horizon, correction, by_work, speed) in [
            (Space::PlaneStress, BondBased, 3.015, None, false, 16.5),
            (Space::PlaneStress, BondBased, 4.015, None, false, 16.5),
            (Space::PlaneStress, StateBased, 3.015, None, false, 16.5),
            (Space::PlaneStress, StateBased, 4.015, None, false, 16.5),
            (Space::PlaneStress, StateBased, 4.015, None, true, 16.5),
            (Space::PlaneStress, BondBased, 3.015, Even, false, 16.5),
            (Space::PlaneStress, StateBased, 3.015, Even, false, 16.5),
            (Space::PlaneStress, BondBased, 4.015, None, false, 32.0),
            (Space::PlaneStress, StateBased, 4.015, None, false, 32.0),
            (Space::PlaneStrain, BondBased, 4.015, None, false, 32.0),
        ] {
            let spacing = 1e-3;
            kalthoff::run(&kalthoff::Case { space, law, horizon, spacing, correction, by_work, speed })?;
        }
    }
    if wanted("strip") {
        for law in [BondBased, StateBased] {
            for release in [0.9, 1.0, 1.5, 2.0, 3.0] {
                strip::run(law, release, Even)?;
            }
        }
    }
    if wanted("wave") {
        for (law, across, correction) in [
            (BondBased, 4, Even),
            (StateBased, 4, Even),
            (BondBased, 4, None),
            (StateBased, 4, None),
            (StateBased, 8, Even),
        ] {
            rods::wave(law, across, correction)?;
        }
    }
    if wanted("torsion") {
        for (law, across, degrees) in
            [(StateBased, 4, 70.0), (StateBased, 4, 1.0), (BondBased, 4, 70.0), (StateBased, 8, 70.0)]
        {
            rods::torsion(law, across, degrees)?;
        }
    }
    if wanted("cantilever") {
        for (law, across, by_work) in
            [(BondBased, 10, false), (StateBased, 10, false), (StateBased, 10, true), (BondBased, 20, false)]
        {
            cantilever::run(law, across, by_work)?;
        }
    }
    if wanted("kalthoff-space") {
        let (space, correction, spacing) = (Space::Solid, None, 1.5e-3);
        let (law, horizon, by_work, speed) = (BondBased, 3.015, false, 16.5);
        kalthoff::run(&kalthoff::Case { space, law, horizon, spacing, correction, by_work, speed })?;
    }
    Ok(())
}
