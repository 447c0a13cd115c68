//! A column of water on a plate clamped at both ends, put there at once.

use std::error::Error;

use explicit_dynamics::{Order, Wetted};
use peridynamics::{Correction, Elastic, Law, Solid, Space, Support};
use sph_core::Vec3;
use sph_shell::{Clamped, Shell, Sides};

use crate::support::coupled::{
    Coupled, GRAVITY, ROWS, Strip, coupled, fill, march, raised, stations, water, wetting,
};

/// Span and depth of the water \[m\].
pub const WATER: [f64; 2] = [1.0, 2.0];
/// Of the plate \[m\].
pub const THICKNESS: f64 = 0.05;
const MATERIAL: Elastic = Elastic { young: 67.5e9, poisson: 0.34, density: 2700.0 };
/// Rows of nodes of a solid that are held behind each end.
const CLAMPED: usize = 3;

/// What the plate is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    Shell,
    Solid,
}

/// A run of the column.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    pub body: Body,
    /// Particles of the fluid over a thickness.
    pub layers: usize,
    /// Of the plate \[kg/m³\].
    pub density: f64,
    pub order: Order,
    pub impedance: bool,
    pub centred: bool,
    pub duration: f64,
}

impl Column {
    /// The plate with the default coupling.
    pub fn published(body: Body, layers: usize) -> Self {
        let order = Order::StructureFirst;
        let density = MATERIAL.density;
        Self { body, layers, density, order, impedance: true, centred: true, duration: 0.4 }
    }
}

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Sag {
    /// Time \[s\], deflection of the middle \[m\], kinetic and stored energy of the plate \[J/m\], missing
    /// energy of all \[J/m\].
    pub rows: Vec<[f64; 5]>,
    pub particles: usize,
    pub steps: u64,
    pub substeps: u64,
    pub most: u64,
    pub seconds: f64,
}

/// Runs the column.
///
/// # Errors
/// A motion that diverges.
pub fn sag(column: &Column) -> Result<Sag, Box<dyn Error>> {
    let dx = THICKNESS / column.layers as f64;
    let behind = ROWS as f64 * dx;
    let deep = if column.body == Body::Solid { 0.0 } else { -behind };
    let [span, depth] = WATER;
    let walls = vec![
        fill([-behind, deep], [0.0, 1.1 * depth], dx),
        fill([span, deep], [span + behind, 1.1 * depth], dx),
    ];
    let parts = water(dx, fill([0.0, 0.0], WATER, dx), 10.0 * (GRAVITY * depth).sqrt(), walls);
    match column.body {
        Body::Shell => {
            let cells = (span / dx).round() as usize;
            let y = -0.5 * THICKNESS;
            // From right to left: directors point up, into the water.
            let strip = Strip {
                line: stations([span, y], [0.0, y], cells),
                closed: false,
                young: MATERIAL.young,
                poisson: MATERIAL.poisson,
                thickness: THICKNESS,
                density: column.density,
                gravity: GRAVITY,
                held: vec![(vec![0, cells], Box::new(Clamped))],
            };
            let width = strip.width();
            let shell = strip.builder()?.wetted(wetting(dx, Sides::Front, &[])).build()?;
            // The middle lies between two stations where their number is even.
            let middle = [cells / 2, cells.div_ceil(2)];
            let way =
                move |shell: &Shell| -0.5 * middle.iter().map(|&i| shell.displacement(2 * i).y).sum::<f64>();
            marched(column, coupled(parts, vec![shell])?, width, way)
        }
        Body::Solid => {
            let solid = solid(column, dx)?;
            let half = 0.5 * THICKNESS;
            let near = |a: &usize| {
                let x = solid.block().positions[*a];
                (x.x - 0.5 * span).abs() < dx && (x.y + half).abs() < 0.6 * dx
            };
            let middle: Vec<usize> = (0..solid.len()).filter(near).collect();
            let way = move |solid: &Solid| {
                let sum: f64 =
                    middle.iter().map(|&a| solid.block().positions[a].y - solid.position(a).y).sum();
                sum / middle.len() as f64
            };
            marched(column, coupled(parts, vec![solid])?, dx, way)
        }
    }
}

/// A plate of layers of nodes, held beyond its ends.
fn solid(column: &Column, dx: f64) -> Result<Solid, Box<dyn Error>> {
    use crate::support::solids::{formulation, lattice, nodes, parts};
    let clamped = CLAMPED as f64 * dx;
    let origin = Vec3::new(-clamped, -THICKNESS, 0.0);
    let block = lattice(2, origin, [WATER[0] + 2.0 * clamped, column.layers as f64 * dx, dx], dx).block()?;
    let ends = nodes(&block, |x| x.x < 0.0 || x.x > WATER[0]);
    let weight = |a: usize| (a as u32, Vec3::y() * (-GRAVITY * column.density * block.volumes[a]));
    let forces = (0..block.len()).map(weight).collect();
    let young = raised(MATERIAL.young, column.layers);
    let material = Elastic { young, density: column.density, ..MATERIAL };
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let mut solid = Solid::new(peridynamics::Parts {
        supports: vec![peridynamics::Supported { nodes: ends, support: held }],
        loads: vec![peridynamics::AppliedLoad { forces, amplitude: explicit_dynamics::Amplitude::Constant }],
        ..parts(block, material, formulation(Space::PlaneStrain, Law::StateBased, Correction::Even))
    })?;
    solid.wet()?;
    Ok(solid)
}

fn marched<S: Wetted>(
    column: &Column,
    mut system: Coupled<S>,
    width: f64,
    way: impl Fn(&S) -> f64,
) -> Result<Sag, Box<dyn Error>> {
    let started = std::time::Instant::now();
    (system.order, system.impedance, system.centred) = (column.order, column.impedance, column.centred);
    let mut found = Sag { particles: system.fluid().len(), ..Sag::default() };
    let rows = &mut found.rows;
    found.steps = march(&mut system, [column.duration, 0.002], 0.0, |system, record| {
        let sunk = system.structures().next().map_or(f64::NAN, &way);
        let energy = system.energy(0).unwrap_or_default();
        rows.push([
            record.at.time,
            sunk,
            energy.kinetic / width,
            energy.internal / width,
            record.balance_error,
        ]);
    })?;
    (found.substeps, found.most) = (system.counts().substeps, system.counts().most);
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
