//! The gate in its tank: water, walls, and the gate as a strip of shell or as a solid of bonds.

use std::error::Error;

use explicit_dynamics::{Order, Wetted};
use fluid_sph::{Fluid, Formulation, Parts};
use peridynamics::{Correction, Elastic, Law, Solid, Space, Support};
use sph_core::Vec3;
use sph_shell::{Clamped, Shell, WetFaces};

use crate::support::coupled::{
    Coupled, GRAVITY, ROWS, Strip, coupled, fill, march, raised, stations, structure, water, wetting,
};

/// Water: width and depth \[m\].
pub const WATER: [f64; 2] = [0.1, 0.14];
/// Gate: length and thickness \[m\].
pub const GATE: [f64; 2] = [0.079, 0.005];
const DENSITY: f64 = 1100.0;
const POISSON: f64 = 0.4;
/// End of the floor, from which water falls \[m\].
const FLOOR: f64 = 0.7;
/// Cells of the shell along the gate.
const CELLS: usize = 40;
/// Where the level beside the gate is read, over the width of the tank.
const BESIDE: f64 = 0.9;
/// Depth of the clamp of a solid gate, in spacings.
const CLAMPED: usize = 3;

/// What the gate is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    Shell,
    Solid,
}

/// A run of the gate.
#[derive(Clone, Copy, Debug)]
pub struct Gate {
    pub body: Body,
    /// Δx \[m\].
    pub spacing: f64,
    /// Young's modulus \[Pa\].
    pub young: f64,
    /// α of the artificial viscosity.
    pub viscosity: f64,
    /// Sound speed of the water \[m/s\].
    pub sound: f64,
    /// Gap below the gate \[m\].
    pub clearance: f64,
    pub order: Order,
    pub impedance: bool,
    pub centred: bool,
    /// End \[s\].
    pub duration: f64,
}

impl Gate {
    /// The gate as published: 12 MPa, no gap.
    pub fn published(body: Body, spacing: f64, duration: f64) -> Self {
        Self {
            body,
            spacing,
            young: 12e6,
            viscosity: Formulation::default().viscosity,
            sound: 10.0 * (GRAVITY * WATER[1]).sqrt(),
            clearance: 0.0,
            order: Order::StructureFirst,
            impedance: true,
            centred: true,
            duration,
        }
    }
}

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Swing {
    /// Time \[s\], dx and dy of the lower end \[mm\], kinetic and stored energy of the gate \[J/m\], water
    /// that has left \[–\], level in the tank less that of the water left there \[mm\], missing energy of
    /// all \[J/m\], level beside the gate \[mm\].
    pub rows: Vec<[f64; 9]>,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    /// Greatest |ρ/ρ₀ − 1|.
    pub density_error: f64,
    /// Time the run took \[s\].
    pub seconds: f64,
}

/// Water and walls; the rigid wall over the gate begins at a height.
fn tank(gate: &Gate, above: f64) -> Parts {
    let dx = gate.spacing;
    let behind = ROWS as f64 * dx;
    let walls = vec![
        fill([-behind, -behind], [FLOOR, 0.0], dx),
        fill([-behind, 0.0], [0.0, 0.2], dx),
        fill([WATER[0], above], [WATER[0] + behind, above + 0.12], dx),
    ];
    let parts = water(dx, fill([0.0, 0.0], WATER, dx), gate.sound, walls);
    let formulation = Formulation { viscosity: gate.viscosity, ..Formulation::default() };
    Parts { formulation, ..parts }
}

fn strip(gate: &Gate) -> Result<(Shell, f64), Box<dyn Error>> {
    let x = WATER[0] + 0.5 * GATE[1];
    let strip = Strip {
        line: stations([x, GATE[0]], [x, gate.clearance], CELLS),
        closed: false,
        young: gate.young,
        poisson: POISSON,
        thickness: GATE[1],
        density: DENSITY,
        gravity: GRAVITY,
        held: vec![(vec![0], Box::new(Clamped))],
    };
    let width = strip.width();
    let shell = strip.builder()?.wetted(wetting(gate.spacing, WetFaces::Both, &[CELLS])).build()?;
    Ok((shell, width))
}

fn solid(gate: &Gate) -> Result<Solid, Box<dyn Error>> {
    use crate::support::solids::{formulation, lattice, nodes, parts};
    let dx = gate.spacing;
    let layers = (GATE[1] / dx).round() as usize;
    let clamped = CLAMPED as f64 * dx;
    let lengths = [GATE[1], GATE[0] - gate.clearance + clamped, dx];
    let origin = Vec3::new(WATER[0], gate.clearance, 0.0);
    let block = lattice(2, origin, lengths, dx).block()?;
    let top = nodes(&block, |x| x.y > GATE[0]);
    let weight =
        (0..block.len()).map(|a| (a as u32, Vec3::y() * (-GRAVITY * DENSITY * block.volumes[a]))).collect();
    let material = Elastic { young: raised(gate.young, layers), poisson: POISSON, density: DENSITY };
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let mut solid = Solid::new(peridynamics::Parts {
        supports: vec![peridynamics::Supported { nodes: top, support: held }],
        loads: vec![peridynamics::AppliedLoad {
            forces: weight,
            amplitude: explicit_dynamics::Amplitude::Constant,
        }],
        ..parts(block, material, formulation(Space::PlaneStrain, Law::StateBased, Correction::Even))
    })?;
    solid.wet()?;
    Ok(solid)
}

/// Runs the gate.
///
/// # Errors
/// A motion that diverges.
pub fn swing(gate: &Gate) -> Result<Swing, Box<dyn Error>> {
    match gate.body {
        Body::Shell => {
            let (shell, width) = strip(gate)?;
            let end = |shell: &Shell| shell.displacement(2 * CELLS);
            marched(gate, coupled(tank(gate, GATE[0]), vec![shell])?, width, end)
        }
        Body::Solid => {
            let solid = solid(gate)?;
            let low = gate.clearance + gate.spacing;
            let foot: Vec<usize> = (0..solid.len()).filter(|&a| solid.block().positions[a].y < low).collect();
            let end = move |solid: &Solid| {
                let sum: Vec3 = foot.iter().map(|&a| solid.position(a) - solid.block().positions[a]).sum();
                sum / foot.len() as f64
            };
            let above = GATE[0] + CLAMPED as f64 * gate.spacing;
            marched(gate, coupled(tank(gate, above), vec![solid])?, gate.spacing, end)
        }
    }
}

fn marched<S: Wetted + 'static>(
    gate: &Gate,
    mut system: Coupled<S>,
    width: f64,
    end: impl Fn(&S) -> Vec3,
) -> Result<Swing, Box<dyn Error>> {
    let started = std::time::Instant::now();
    (system.order, system.impedance, system.centred) = (gate.order, gate.impedance, gate.centred);
    let mut found = Swing { particles: system.fluid().len(), ..Swing::default() };
    let rows = &mut found.rows;
    found.steps = march(&mut system, [gate.duration, 0.002], 0.0, |system, record| {
        let way = system.structures().next().map_or_else(Vec3::zeros, &end);
        let energy = system.energy(0).unwrap_or_default();
        let fluid = system.fluid();
        let inside = fluid.positions().iter().filter(|x| x.x < WATER[0] && x.y > 0.0).count();
        let left = inside as f64 / fluid.len() as f64;
        let level: f64 = [0.15, 0.35, 0.55, 0.75]
            .map(|part| fluid.level_at(Vec3::new(part * WATER[0], 0.0, 0.0)))
            .iter()
            .sum::<f64>()
            / 4.0;
        rows.push([
            record.at.time,
            1e3 * way.x,
            1e3 * way.y,
            energy.kinetic / width,
            energy.internal / width,
            1.0 - left,
            1e3 * (level - WATER[1] * left),
            record.balance_error,
            1e3 * fluid.level_at(Vec3::new(BESIDE * WATER[0], 0.0, 0.0)),
        ]);
    })?;
    found.density_error = system.fluid().greatest_density_error();
    found.substeps = system.counts().substeps;
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}

/// Mean thrust on the gate, held where it stands, once the start-up wave has died down \[N/m\].
///
/// # Errors
/// A motion that diverges.
pub fn thrust(spacing: f64) -> Result<f64, Box<dyn Error>> {
    let gate = Gate::published(Body::Shell, spacing, 0.2);
    let (shell, _) = strip(&gate)?;
    let mut fluid = Fluid::new(Parts { structures: vec![structure(&shell)], ..tank(&gate, GATE[0]) })?;
    let mut sum = (0.0, 0.0);
    march(&mut fluid, [0.2, 0.001], 0.0, |fluid, record| {
        if record.at.time > 0.1 {
            sum = (sum.0 + fluid.structure_force(0).x, sum.1 + 1.0);
        }
    })?;
    Ok(sum.0 / sum.1)
}
