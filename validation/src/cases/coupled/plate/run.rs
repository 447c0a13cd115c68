//! A dam breaks on an elastic plate that stands on the floor.

use std::error::Error;

use sph_core::Vec3;
use sph_shell::{Clamped, Shell, Sides};

use crate::support::coupled::{GRAVITY, ROWS, Strip, coupled, fill, march, stations, water, wetting};

/// Water: width and depth \[m\].
pub const WATER: [f64; 2] = [0.146, 0.292];
/// Length and height of the tank \[m\].
const TANK: [f64; 2] = [0.584, 0.7];
/// Plate: near face, height, thickness \[m\].
pub const PLATE: [f64; 3] = [0.292, 0.08, 0.012];
/// Cells of the shell along the plate.
const CELLS: usize = 20;

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Tip {
    /// Time \[s\], way of the upper end downstream \[mm\], kinetic and stored energy of the plate \[J/m\],
    /// missing energy of all \[J/m\].
    pub rows: Vec<[f64; 5]>,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    pub density_error: f64,
    pub seconds: f64,
}

/// Runs the plate with so many particles of the fluid over its thickness.
///
/// # Errors
/// A motion that diverges.
pub fn tip(layers: usize, duration: f64) -> Result<Tip, Box<dyn Error>> {
    let started = std::time::Instant::now();
    let [near, height, thickness] = PLATE;
    let dx = thickness / layers as f64;
    let behind = ROWS as f64 * dx;
    let walls = vec![
        fill([-behind, -behind], [TANK[0] + behind, 0.0], dx),
        fill([-behind, 0.0], [0.0, TANK[1]], dx),
        fill([TANK[0], 0.0], [TANK[0] + behind, TANK[1]], dx),
    ];
    let parts = water(dx, fill([0.0, 0.0], WATER, dx), 20.0 * (GRAVITY * WATER[1]).sqrt(), walls);
    let x = near + 0.5 * thickness;
    let strip = Strip {
        // Downwards: directors point against the water.
        line: stations([x, height], [x, 0.0], CELLS),
        closed: false,
        young: 1e6,
        poisson: 0.0,
        thickness,
        density: 2500.0,
        gravity: GRAVITY,
        held: vec![(vec![CELLS], Box::new(Clamped))],
    };
    let width = strip.width();
    let shell = strip.builder()?.wetted(wetting(dx, Sides::Both, &[0])).build()?;
    let mut system = coupled(parts, vec![shell])?;
    let mut found = Tip { particles: system.fluid().len(), ..Tip::default() };
    let rows = &mut found.rows;
    found.steps = march(&mut system, [duration, 0.005], 0.0, |system, record| {
        let way = system.structures().next().map_or_else(Vec3::zeros, |shell: &Shell| shell.displacement(0));
        let energy = system.energy(0).unwrap_or_default();
        rows.push([
            record.at.time,
            1e3 * way.x,
            energy.kinetic / width,
            energy.internal / width,
            record.balance_error,
        ]);
    })?;
    found.substeps = system.counts().substeps;
    found.density_error = system.fluid().greatest_density_error();
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
