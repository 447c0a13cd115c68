//! A square plate, clamped all round, under a column of water in space.

use std::error::Error;

use fluid_sph::Parts;
use implicit_statics::linear_response;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cloud, EndWeights, Plate, Vec3, basin_rows, lattice};
use sph_shell::{
    AppliedLoad, Clamped, Force, Load, Reach, Shell, ShellBuilder, Sides, StaticShell, Supported, Wetting,
};

use crate::support::coupled::{GRAVITY, ROWS, WATER, coupled, march, water};

/// Side of the plate, and depth of the water \[m\].
const SIZE: f64 = 1.0;
const THICKNESS: f64 = 0.05;
const YOUNG: f64 = 1e9;
const DENSITY: f64 = 2700.0;
/// Damping of the plate alone \[1/s\]: near critical for the plate with the water that moves with it.
const DAMPING: f64 = 1000.0;

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Sag {
    /// Time \[s\], deflection of the middle \[mm\], missing energy \[J\].
    pub rows: Vec<[f64; 3]>,
    /// That of the plate alone under the weights of both \[mm\].
    pub still: f64,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    pub seconds: f64,
}

fn plate(cells: usize, loads: Vec<Box<dyn Load>>) -> Result<ShellBuilder, Box<dyn Error>> {
    let flat = lattice(&Plate { lengths: [SIZE, SIZE] }, [cells + 1, cells + 1], EndWeights::Trapezoid)?;
    let lower = |x: &Vec3| Vec3::new(x.x, x.y, -0.5 * THICKNESS);
    let cloud = Cloud::from_cells(flat.positions.iter().map(lower).collect(), None, flat.cells)?;
    let on_edge = |x: &Vec3| [x.x, x.y].iter().any(|c| *c < 1e-9 || *c > SIZE - 1e-9);
    let edge = (0..cloud.len() as u32).filter(|&a| on_edge(&cloud.positions[a as usize])).collect();
    let applied = |load| AppliedLoad { load, amplitude: explicit_dynamics::Amplitude::Constant };
    Ok(Shell::builder(sph_shell::Parts {
        cloud,
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.3)?, THICKNESS)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: DENSITY,
        formulation: sph_shell::Formulation::StressPoint(Reach::Cell),
        supports: vec![Supported { particles: edge, support: Box::new(Clamped) }],
        loads: loads.into_iter().map(applied).collect(),
        threads: 1,
    }))
}

/// Runs the plate with so many particles of the fluid, and cells of the shell, along a side.
///
/// # Errors
/// A motion that diverges.
pub fn sag(cells: usize, duration: f64) -> Result<Sag, Box<dyn Error>> {
    let started = std::time::Instant::now();
    let dx = SIZE / cells as f64;
    let middle = |shell: &Shell| {
        let near = |a: &usize| {
            let x = shell.reference().cloud.positions[*a];
            [x.x, x.y].iter().all(|c| (c - 0.5 * SIZE).abs() < 0.51 * dx)
        };
        let all: Vec<f64> = (0..shell.len()).filter(near).map(|a| shell.displacement(a).z).collect();
        -1e3 * all.iter().sum::<f64>() / all.len() as f64
    };
    let masses = plate(cells, Vec::new())?.build()?.reference().masses.clone();
    let weight = |pressure: f64| -> Vec<Box<dyn Load>> {
        let shares = masses.iter().enumerate().map(|(a, &mass)| (a as u32, mass)).collect();
        vec![Box::new(Force { shares, total: -Vec3::z() * (pressure * SIZE * SIZE) })]
    };
    let own = DENSITY * GRAVITY * THICKNESS;
    let mut alone = StaticShell::new(plate(cells, weight(WATER * GRAVITY * SIZE + own))?.build()?);
    let motion = linear_response(&mut alone, 0.0)?;
    implicit_statics::Equilibrium::update(&mut alone, &motion);
    let mut found = Sag { still: middle(alone.shell()), ..Sag::default() };

    let free_edges = Vec::new();
    let wetting = Wetting { spacing: dx, rows: ROWS, sides: Sides::Front, plane: false, free_edges };
    let shell = plate(cells, weight(own))?.wetted(wetting).build()?;
    let behind = ROWS as f64 * dx;
    let (low, high) = (Vec3::new(0.0, 0.0, -behind), Vec3::new(SIZE, SIZE, 1.1 * SIZE));
    let walls = basin_rows(&low, &high, [false, false, false, false, true, true], 3, dx, ROWS)?;
    let centre = |i: usize| (i as f64 + 0.5) * dx;
    let positions = (0..cells)
        .flat_map(|i| (0..cells).flat_map(move |j| (0..cells).map(move |k| [i, j, k])))
        .map(|[i, j, k]| Vec3::new(centre(i), centre(j), centre(k)))
        .collect();
    let sound = 10.0 * (GRAVITY * SIZE).sqrt();
    let parts =
        Parts { dimensions: 3, gravity: -Vec3::z() * GRAVITY, ..water(dx, positions, sound, vec![walls]) };
    let mut system = coupled(parts, vec![shell])?;
    found.particles = system.fluid().len();
    let rows = &mut found.rows;
    found.steps = march(&mut system, [duration, 0.005], DAMPING, |system, record| {
        let sunk = system.structures().next().map_or(f64::NAN, middle);
        rows.push([record.at.time, sunk, record.balance_error]);
    })?;
    found.substeps = system.counts().substeps;
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
