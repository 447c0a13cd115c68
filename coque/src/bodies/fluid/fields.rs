//! What a fluid and its walls show of a state: their particles with pressures and what else they have.
//!
//! Places and velocities are written to the last bit, the rest in single precision.

use std::io;

use fluid_sph::Fluid;
use mesh_io::{At, Connectivity, FieldWriter, Kind, Values, rows};
use sph_core::Vec3;

use crate::bodies::{FieldRequest, FieldSource, Part};
use crate::scene::units::{Quantity, Units};

/// What the fields of a fluid show of its present state.
pub(in crate::bodies) fn of_fluid<'a>(
    fluid: &'a Fluid,
    shown: &FieldRequest<'a>,
) -> Box<dyn FieldSource + 'a> {
    let units = shown.units;
    Box::new(move |_: Part, to: &mut dyn FieldWriter| write_fluid(fluid, &units, to))
}

/// What the fields of some walls show, by the numbers that the fluid gives them.
pub(in crate::bodies) fn of_walls<'a>(
    fluid: &'a Fluid,
    walls: std::ops::Range<usize>,
    shown: &FieldRequest<'a>,
) -> Box<dyn FieldSource + 'a> {
    let units = shown.units;
    Box::new(move |_: Part, to: &mut dyn FieldWriter| write_walls(fluid, walls.clone(), &units, to))
}

fn write_fluid(fluid: &Fluid, units: &Units, to: &mut dyn FieldWriter) -> io::Result<()> {
    let positions = fluid.positions();
    particles(positions, to)?;
    let velocities = fluid.velocities();
    let displacement = rows(positions.len(), |a| <[f64; 3]>::from(fluid.displacement(a)));
    to.numbers(
        At::Points,
        "displacement",
        &units.symbol(Quantity::Length),
        &[],
        Values::Double(&displacement),
    )?;
    let velocity = rows(positions.len(), |a| <[f64; 3]>::from(velocities[a]));
    to.numbers(At::Points, "velocity", &units.symbol(Quantity::Speed), &[], Values::Double(&velocity))?;
    let (pressures, densities, surface) = (fluid.pressures(), fluid.densities(), fluid.free_surface());
    numbers(to, "pressure", &units.symbol(Quantity::Stress), &pressures)?;
    numbers(to, "density", &units.symbol(Quantity::Density), densities)?;
    // Of the internal energy what compression stores: what friction heats is in the ledger of the whole fluid.
    let stored = densities.iter().map(|&density| density * fluid.liquid().compression(density));
    numbers(to, "compression_energy", &units.symbol(Quantity::Stress), &stored.collect::<Vec<_>>())?;
    let marks: Vec<f64> = surface.iter().map(|&marked| f64::from(u8::from(marked))).collect();
    numbers(to, "free_surface", &units.symbol(Quantity::Ratio), &marks)?;
    if !fluid.passed().is_empty() {
        let here: Vec<f64> = (0..positions.len()).map(|a| f64::from(u8::from(fluid.is_here(a)))).collect();
        numbers(to, "in_flow", &units.symbol(Quantity::Ratio), &here)?;
    }
    sizes(fluid, positions.len(), units, to)
}

fn write_walls(
    fluid: &Fluid,
    walls: std::ops::Range<usize>,
    units: &Units,
    to: &mut dyn FieldWriter,
) -> io::Result<()> {
    let (mut positions, mut pressures) = (Vec::new(), Vec::new());
    for wall in walls {
        positions.extend(fluid.wall_positions(wall).iter().map(|x| fluid.within(*x)));
        pressures.extend_from_slice(&fluid.wall_pressures(wall));
    }
    particles(&positions, to)?;
    numbers(to, "wall_pressure", &units.symbol(Quantity::Stress), &pressures)?;
    sizes(fluid, positions.len(), units, to)
}

/// Particles alone.
fn particles(positions: &[Vec3], to: &mut dyn FieldWriter) -> io::Result<()> {
    let points = rows(positions.len(), |a| <[f64; 3]>::from(positions[a]));
    let cell = |a: usize| (Kind::Vertex, [a as u32; 8]);
    to.geometry(&points, Connectivity { count: positions.len(), cell: &cell })
}

/// What each particle stands for at rest: a volume, in a plane an area.
fn sizes(fluid: &Fluid, count: usize, units: &Units, to: &mut dyn FieldWriter) -> io::Result<()> {
    let (name, quantity) = match fluid.dimensions() {
        2 => ("area", Quantity::Area),
        _ => ("volume", Quantity::Volume),
    };
    let size = fluid.spacing().powi(fluid.dimensions() as i32);
    numbers(to, name, &units.symbol(quantity), &vec![size; count])
}

fn numbers(to: &mut dyn FieldWriter, name: &str, unit: &str, values: &[f64]) -> io::Result<()> {
    let all = rows(values.len(), |a| [values[a] as f32]);
    to.numbers(At::Points, name, unit, &[], Values::Single(&all))
}
