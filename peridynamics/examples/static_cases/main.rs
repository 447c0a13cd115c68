//! Static cases of peridynamic bodies beside closed forms: a bar in tension, a plate with a hole.
//!
//! `cargo run --release -p peridynamics --example static_cases`

mod bar;
mod blocks;
mod hole;

use std::error::Error;

use peridynamics::{Correction, Law};

const LAWS: [Law; 2] = [Law::BondBased, Law::StateBased];
const CORRECTIONS: [Correction; 3] = [Correction::None, Correction::EnergyFactor, Correction::Even];

fn main() -> Result<(), Box<dyn Error>> {
    println!("Bar in tension, over F l/(EA):  tip / gauge, apparent ν (0.25 and 0.3)");
    for law in LAWS {
        for correction in CORRECTIONS {
            let row = [3, 4].map(|across| bar::stretched(law, correction, across));
            let [three, four] = row;
            println!("{law:?} {correction:?}: {} | {}", show(three?), show(four?));
        }
    }
    println!("Plate with a hole: L2 error of the displacement, hoop strain over the exact one at r/R");
    for (law, correction) in LAWS.iter().flat_map(|&law| CORRECTIONS.map(|correction| (law, correction))) {
        for horizon in [1.5, 3.015] {
            let row = [5, 10].map(|resolution| hole::holed(law, correction, horizon, resolution));
            print!("{law:?} {correction:?} m = {horizon}:");
            for found in row {
                let hole::Holed { displacement, strain, at } = found?;
                print!("  {:.2} %, {strain:.3} at {at:.2}", 100.0 * displacement);
            }
            println!();
        }
    }
    Ok(())
}

fn show(found: bar::Stretched) -> String {
    format!("{:.3} / {:.3}, {:.3}", found.tip, found.gauge, found.poisson)
}
