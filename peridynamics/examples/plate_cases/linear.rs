//! The flat plate: its forces at 1.2 mm of small displacements, and the loads at which it buckles.

use std::ops::ControlFlow;

use implicit_statics::{
    BucklingOptions, Equilibrium, EquilibriumError, Newton, NewtonOptions, linear_buckling,
};
use peridynamics::{Parts, StaticSolid};
use sph_core::Block;

use crate::plate::{Edges, WAY, block, end_force, half_waves, parts, plate, supports};

/// Part of the way at which the plate is still linear to six digits.
const SMALL: f64 = 1e-4;

/// A critical load.
pub struct Critical {
    /// Load \[kN\].
    pub load: f64,
    /// Deflections of the mode, the largest one.
    pub shape: Vec<f64>,
}

/// Forces at both ends of a plate for the whole way, by a small part of it \[kN\].
pub fn stiffness(mut plate: StaticSolid) -> Result<[f64; 2], EquilibriumError> {
    Newton::new(&plate, &NewtonOptions::default())?.at_level(&mut plate, SMALL)?;
    plate.evaluate(SMALL);
    Ok([0, 1].map(|end| end_force(plate.solid(), end) / SMALL))
}

/// The same of the whole flat plate.
pub fn flat(spacing: f64, edges: Edges, way: f64) -> Result<[f64; 2], EquilibriumError> {
    let block = block(spacing);
    let supports = supports(&block, edges, way);
    stiffness(plate(parts(block, supports)))
}

/// The first critical load of a plate.
pub fn critical(parts: &Parts) -> Result<Critical, EquilibriumError> {
    let force = stiffness(plate(parts.clone()))?[1];
    let mut plate = plate(parts.clone());
    let options = BucklingOptions::new(1);
    let modes = linear_buckling(&mut plate, 0.0, &options, &mut |_| ControlFlow::Continue(()))?;
    let mode = &modes.modes[0];
    plate.update(&mode.shape);
    let solid = plate.solid();
    let deflections: Vec<f64> = (0..solid.len()).map(|node| solid.displacement(node).z).collect();
    let most = deflections.iter().fold(0.0_f64, |most, &w| if w.abs() > most.abs() { w } else { most });
    Ok(Critical { load: mode.level * force.abs(), shape: deflections.iter().map(|w| w / most).collect() })
}

/// The first critical load of the whole flat plate that is shortened.
pub fn buckling(spacing: f64, edges: Edges) -> Result<Critical, EquilibriumError> {
    let block = block(spacing);
    let supports = supports(&block, edges, -WAY);
    critical(&parts(block, supports))
}

/// Half-waves of a mode.
pub fn waves(block: &Block, critical: &Critical) -> usize {
    half_waves(block, |node| critical.shape[node])
}

/// Forces and critical loads for some spacings.
pub fn table(spacings: &[f64]) -> Result<(), EquilibriumError> {
    println!(
        "spacing  tension free     held  flat, held |  held   clamped  sides free | half-waves  ends differ by"
    );
    println!("theory        110.40   112.3      123.89 | 6.863    8.935      11.057 | 1 1 2");
    for &spacing in spacings {
        let cases = [(Edges::Free, WAY), (Edges::EndsKept, WAY), (Edges::Held, -WAY)];
        let forces =
            cases.iter().map(|&(edges, way)| flat(spacing, edges, way)).collect::<Result<Vec<_>, _>>()?;
        let buckled = [Edges::Held, Edges::Clamped, Edges::Free]
            .iter()
            .map(|&edges| buckling(spacing, edges))
            .collect::<Result<Vec<_>, _>>()?;
        let block = block(spacing);
        let waves: Vec<usize> = buckled.iter().map(|critical| waves(&block, critical)).collect();
        let uneven = forces.iter().map(|ends| ((ends[0] + ends[1]) / ends[1]).abs()).fold(0.0, f64::max);
        println!(
            "{spacing:7}   {:11.3} {:8.3} {:11.3} | {:5.4} {:8.4} {:10.4} | {waves:?} {uneven:.1e}",
            forces[0][1],
            forces[1][1],
            forces[2][1].abs(),
            buckled[0].load,
            buckled[1].load,
            buckled[2].load,
        );
    }
    Ok(())
}
