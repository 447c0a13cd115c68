//! A wedge of two plates that goes into water at a constant speed.

use std::error::Error;
use std::f64::consts::PI;

use explicit_dynamics::Amplitude;
use fluid_sph::{Parts, Start};
use sph_core::Vec3;
use sph_shell::{Held, Moved, Shell, Support, WetFaces};

use crate::support::coupled::{ROWS, Strip, coupled, fill, march, stations, water, wetting};

/// Half of the width of the wedge \[m\].
const HALF: f64 = 0.6;
/// Rise of the plates towards their outer ends \[rad\].
const RISE: f64 = PI / 18.0;
pub const THICKNESS: f64 = 0.04;
/// Downwards \[m/s\].
const SPEED: f64 = 30.0;
/// Cells of the shell along a plate.
const CELLS: usize = 40;
/// Water: half of its width, and its depth \[m\]. In half of either the plate bends 5 to 7 % more.
const WATER: [f64; 2] = [3.0, 2.2];
/// Places that are watched: middle of a plate (B), three quarters along (C), as parts of its length.
const B: f64 = 0.5;
const C: f64 = 0.75;

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Entry {
    /// Time from contact \[ms\], deflection at B against the rigid motion \[mm\], pressures at the apex and
    /// at C \[MPa\], means of three columns, that of the one column at C, missing energy of all \[J/m\].
    pub rows: Vec<[f64; 6]>,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    pub density_error: f64,
    pub seconds: f64,
}

/// A plate from the apex to its outer end, as it goes down; the director at the apex is held or free.
fn plate(
    from: [f64; 2],
    to: [f64; 2],
    held: bool,
    spacing: f64,
    until: f64,
) -> Result<Shell, Box<dyn Error>> {
    let moved = || -> Box<dyn Support> {
        Box::new(Moved {
            direction: -Vec3::y(),
            by: SPEED * until,
            amplitude: Amplitude::Table(vec![[0.0, 0.0], [until, 1.0]]),
        })
    };
    let mut supports: Vec<(Vec<usize>, Box<dyn Support>)> = vec![(vec![0, CELLS], moved())];
    supports.push((vec![0, CELLS], Box::new(Held { displacement: vec![Vec3::x()], director: None })));
    if held {
        let along = Vec3::new(to[0] - from[0], to[1] - from[1], 0.0);
        supports.push((vec![0], Box::new(Held { displacement: Vec::new(), director: Some(along) })));
    }
    let mut shell = Strip {
        line: stations(from, to, CELLS),
        closed: false,
        young: 67.5e9,
        poisson: 0.34,
        thickness: THICKNESS,
        density: 2700.0,
        gravity: 0.0,
        held: supports,
    }
    .builder()?
    .wetted(wetting(spacing, WetFaces::Front, &[CELLS]))
    .build()?;
    for a in 0..shell.len() {
        shell.set_rate(a, -Vec3::y() * SPEED, Vec3::zeros());
    }
    Ok(shell)
}

/// A wedge and its water.
#[derive(Clone, Copy, Debug)]
pub struct Wedge {
    /// Particles over the thickness of a plate.
    pub layers: usize,
    /// Whether the plates are joined at the apex, or hinged there.
    pub joined: bool,
    /// Sound speed of the water \[m/s\].
    pub sound: f64,
}

/// Runs the wedge.
///
/// # Errors
/// A motion that diverges.
pub fn entry(wedge: &Wedge, duration: f64) -> Result<Entry, Box<dyn Error>> {
    let started = std::time::Instant::now();
    let Wedge { layers, joined, sound } = *wedge;
    let dx = THICKNESS / layers as f64;
    let (sine, cosine) = (libm::sin(RISE), libm::cos(RISE));
    // The wet faces meet at the surface of the water.
    let up = 0.5 * THICKNESS / cosine;
    let end = [HALF, up + HALF * sine / cosine];
    let until = duration + 1e-4;
    // One plate, and a wall in the plane of symmetry.
    let bodies = vec![plate([0.0, up], end, joined, dx, until)?];
    let [half, depth] = WATER;
    let behind = ROWS as f64 * dx;
    let walls = vec![
        fill([-behind, -depth - behind], [half + behind, -depth], dx),
        fill([-behind, -depth], [0.0, 0.3], dx),
        fill([half, -depth], [half + behind, 0.3], dx),
    ];
    let parts = Parts {
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        ..water(dx, fill([0.0, -depth], [half, 0.0], dx), sound, walls)
    };
    let mut system = coupled(parts, bodies)?;
    let mut found = Entry { particles: system.fluid().len(), ..Entry::default() };
    let rows = &mut found.rows;
    found.steps = march(&mut system, [duration, 2e-5], 0.0, |system, record| {
        let time = record.at.time;
        let station = (B * CELLS as f64).round() as usize;
        let bent = system
            .structures()
            .next()
            .map_or(f64::NAN, |shell: &Shell| shell.displacement(2 * station).y + SPEED * time);
        let pressures = system.fluid().structure_pressures(0);
        // The first row of the front face comes first, from the apex outwards.
        let columns = pressures.len() / ROWS;
        let at = |part: f64| {
            let middle = (part * columns as f64) as usize;
            let near = &pressures[middle.saturating_sub(1)..(middle + 2).min(columns)];
            1e-6 * near.iter().sum::<f64>() / near.len() as f64
        };
        let alone = 1e-6 * pressures[(C * columns as f64) as usize];
        rows.push([1e3 * time, 1e3 * bent, at(0.0), at(C), alone, record.balance_error]);
    })?;
    found.substeps = system.counts().substeps;
    found.density_error = system.fluid().greatest_density_error();
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
