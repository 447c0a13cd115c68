//! Static cases of peridynamic bodies beside closed forms: a bar in tension, a plate with a hole, a double
//! cantilever whose crack grows.
//!
//! `cargo run --release -p peridynamics --example static_cases [bar | hole | cantilever]`

mod bar;
mod blocks;
mod cantilever;
mod hole;

use std::error::Error;

use cantilever::{Cantilever, Grown, Released};
use peridynamics::{Correction, Law};

const LAWS: [Law; 2] = [Law::BondBased, Law::StateBased];
const CORRECTIONS: [Correction; 3] = [Correction::None, Correction::EnergyFactor, Correction::Even];

fn main() -> Result<(), Box<dyn Error>> {
    let wanted = std::env::args().nth(1);
    let chosen = |name: &str| wanted.as_deref().is_none_or(|wanted| wanted == name);
    if chosen("bar") {
        bars()?;
    }
    if chosen("hole") {
        holes()?;
    }
    if chosen("cantilever") {
        cantilevers()?;
    }
    Ok(())
}

fn bars() -> Result<(), Box<dyn Error>> {
    println!("Bar in tension, over F l/(EA):  tip / gauge, apparent ν (0.25 and 0.3)");
    for law in LAWS {
        for correction in CORRECTIONS {
            let row = [3, 4].map(|across| bar::stretched(law, correction, across));
            let [three, four] = row;
            println!("{law:?} {correction:?}: {} | {}", show(three?), show(four?));
        }
    }
    Ok(())
}

fn holes() -> Result<(), Box<dyn Error>> {
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

fn cantilevers() -> Result<(), Box<dyn Error>> {
    println!(
        "Double cantilever: G by compliance over the closed form at a/h; G over the input where the crack grows"
    );
    for law in LAWS {
        for across in [6, 10, 16] {
            let case = Cantilever { law, across };
            print!("{law:?}, {across} across an arm:");
            for Released { crack, ratio } in case.released()? {
                print!("  {ratio:.3} at {crack:.2}");
            }
            let Grown { rates, advance, spent, solved } = case.grown()?;
            let mean = rates.iter().sum::<f64>() / rates.len() as f64;
            let [least, most] = [f64::min, f64::max].map(|pick| rates.iter().copied().reduce(pick));
            print!("\n    grows at {mean:.3} ({:.3} to {:.3})", least.unwrap_or(0.0), most.unwrap_or(0.0));
            println!(", {advance:.0} spacings; bonds held {spent:.3} of the input; {solved} equilibria");
        }
    }
    Ok(())
}

fn show(found: bar::Stretched) -> String {
    format!("{:.3} / {:.3}, {:.3}", found.tip, found.gauge, found.poisson)
}
