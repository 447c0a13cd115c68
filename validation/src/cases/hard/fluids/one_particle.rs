//! fluid-one-particle: a single particle falls, alone and on a floor.

use std::error::Error;

use fluid_sph::{Fluid, Parts, Start};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::support::fluids::{CORRECTED, GRAVITY, KICKS, PUBLISHED, basin, formulation, march, water};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const DX: f64 = 0.1;
const SOUND: f64 = 40.0;
/// From where it falls \[m\].
const HEIGHT: f64 = 0.8;

const FLIGHT: &str = "distance from free flight";
const LOWEST: &str = "lowest place";
const ENERGY: &str = "greatest energy over that at the start";

/// The particle, and what it has to keep.
pub fn case() -> Case {
    Case {
        name: "fluid-one-particle",
        title: "One particle alone",
        about: "Without a neighbour it has to fly by Newton's law, in parts of the way; over a floor it has to come to a stop above \
                it, and its energy to stay below what it fell with.",
        citation: "reference: the parabola, and the energy at the start",
        variants: variants(),
        headline: Some(Headline::new(FLIGHT, 1e-12)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for method in [KICKS, CORRECTED, PUBLISHED] {
        for dimensions in [2, 3] {
            let fly = move || flown(method, dimensions).map_err(|e| e.to_string());
            let fall = move || fallen(method, dimensions).map_err(|e| e.to_string());
            variants.push(Variant::study(method, &format!("free, {dimensions}D"), fly).judged(flies));
            variants.push(Variant::study(method, &format!("on a floor, {dimensions}D"), fall).judged(lands));
        }
    }
    variants.into_iter().map(Variant::quick).collect()
}

fn flown(method: &str, dimensions: usize) -> Result<Outcome, Box<dyn Error>> {
    let up = dimensions - 1;
    let parts = water(dimensions, DX, vec![Vec3::zeros()], SOUND, formulation(method));
    let gravity = parts.gravity;
    let mut thrown = Vec3::x() * 3.0;
    thrown[up] = 2.0;
    let mut fluid = Fluid::new(Parts { velocities: vec![thrown], start: Start::Uniform, ..parts })?;
    let mut off = 0.0_f64;
    let marched = march(&mut fluid, 1.0, 0.1, |fluid, record| {
        let time = record.at.time;
        let exact = thrown * time + gravity * (0.5 * time * time);
        off = off.max((fluid.positions()[0] - exact).norm());
    });
    Ok(marched.outcome(&mut fluid).showing(&[(FLIGHT, "-", off / thrown.norm())]))
}

fn fallen(method: &str, dimensions: usize) -> Result<Outcome, Box<dyn Error>> {
    let (up, formulation) = (dimensions - 1, formulation(method));
    let mut place = Vec3::from([0.5; 3]);
    place[up] = HEIGHT;
    let parts = water(dimensions, DX, vec![place], SOUND, formulation);
    let wall = basin([1.0; 3], dimensions, DX, &formulation)?;
    let mut fluid = Fluid::new(Parts { walls: vec![wall], start: Start::Uniform, ..parts })?;
    let start = fluid.mass() * GRAVITY * HEIGHT;
    let (mut lowest, mut most) = (f64::INFINITY, 0.0_f64);
    let marched = march(&mut fluid, 3.0, 0.01, |fluid, _| {
        let energies = fluid.energies();
        lowest = lowest.min(fluid.positions()[0][up]);
        most = most.max((energies.kinetic + energies.compression + energies.potential) / start);
    });
    let figures = [(LOWEST, "Δx", lowest / DX), (ENERGY, "-", most)];
    Ok(marched.outcome(&mut fluid).showing(&figures))
}

fn flies(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, FLIGHT, "-")?
            .within(1e-12, "both schemes are exact under a constant force: rounding of 10³ steps is left"),
    ])
}

fn lands(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        Metric::at_least(LOWEST, run.last(LOWEST)?, "Δx", 0.0).within(0.0, "a wall lets no particle pass"),
        Metric::compared(ENERGY, run.last(ENERGY)?, "-", 1.0).within(
            0.006,
            "what is shown are velocities half a step ahead of places: g Δt/2 of the speed, 2e-3 measured",
        ),
    ])
}
