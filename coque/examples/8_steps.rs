//! Steps: a run that is led from outside, step by step: read in between, changed, ended when enough is known.
//!
//! A strip is clamped at one end and lifted by a small dead force P at the other, all at once: undamped it would swing about its static
//! deflection for ever, up to twice of it. Here the program watches how fast the particles are, and whenever they have passed a peak it stops
//! them all. What is left of the energy is ever less, and the strip comes to rest where the beam does:
//!
//! ```text
//! stop when   Σ ẋ_a² has passed a peak        u(L) = P L³/3EI at rest
//! ```
//!
//! A [`Simulation`] is a loop that is written by whoever leads it: [`Simulation::advance`] goes on to the next [`Event`], between two
//! of them [`Simulation::body`] is read and [`Simulation::set_state`] puts another state in its place. `coque run` is such a loop
//! as well, which reads nothing.
//!
//! `cargo run --release -p coque --example 8_steps`; before: `7_own_body`. This is the last; the table
//! "To add …" of ARCHITECTURE.md tells where each kind of extension goes once it is to stay.

use std::borrow::Cow;
use std::error::Error;

use coque::scene::Measured;
use coque::{Body, Event, Scene, Simulation, StateArray};
use sph_core::Vec3;

const SCENE: &str = r#"
title = "A strip that is let go, and stopped by whoever leads the run"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [10.0, 1.0], particles = [21, 3] }
material.elastic = { young = 1.2e6, poisson = 0.0, density = 1.0 }
section.homogeneous.thickness = 0.5
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1", force = { total = [0.0, 0.0, 0.1] } }]
analysis.explicit.transient = { duration = 10.0, record_every = 1.0 }
"#;

/// P L³/3EI with EI = 12500 N m² \[m\].
const BEAM: f64 = 0.1 * 1000.0 / (3.0 * 12500.0);
/// Shear adds t²/2κL², 1.5e-3, of the deflection, and twenty cells along the strip take 6e-4 of it: 8.8e-4 were measured.
const TOLERANCE: f64 = 3e-3;
/// Share of the first peak at which the strip counts as at rest.
const REST: f64 = 1e-12;

/// Sum of the squares of the velocities: all particles but those at edges have one mass.
fn speed(body: &dyn Body) -> f64 {
    let particles = 0..body.configuration().rest.len();
    let square = |a: usize| body.read(Measured::Velocity, a, &Vec3::z()).powi(2);
    particles.map(square).sum()
}

/// The state of a body with all its rates set to zero.
fn stopped(body: &dyn Body) -> Vec<StateArray<'static>> {
    let own = |array: StateArray<'_>| {
        let rates = array.name == "their rates";
        let numbers = array.numbers.iter().map(|number| if rates { 0.0 } else { *number }).collect();
        StateArray { name: Cow::Owned(array.name.into_owned()), numbers: Cow::Owned(numbers) }
    };
    body.state().into_iter().map(own).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut simulation = Simulation::new(Scene::parse(SCENE, "strip.toml")?.build(1)?);
    let tip = simulation.body().configuration().rest.len() - 1;
    let (mut before, mut first, mut stops, mut steps) = (0.0, 0.0, 0, 0);
    println!("{:>6} {:>8} {:>10} {:>12} {:>10}", "stops", "steps", "time", "u(L) / beam", "peak");
    loop {
        match simulation.advance()? {
            Event::Step => steps += 1,
            Event::Record => continue,
            Event::End => break,
        }
        let now = speed(simulation.body());
        if now >= before {
            before = now;
            continue;
        }
        simulation.set_state(&stopped(simulation.body()))?;
        if stops == 0 {
            first = before;
        }
        stops += 1;
        let share = before / first;
        before = 0.0;
        let at_rest = share < REST;
        if at_rest || (stops as u32).is_power_of_two() {
            let deflection = simulation.body().read(Measured::Displacement, tip, &Vec3::z()) / BEAM;
            let time = simulation.stands_at().time;
            println!("{stops:>6} {steps:>8} {time:>10.4} {deflection:>12.6} {share:>10.1e}");
        }
        if at_rest {
            break;
        }
    }
    let off = simulation.body().read(Measured::Displacement, tip, &Vec3::z()) / BEAM - 1.0;
    let outcome = simulation.finish();
    println!("{}", outcome.summary.ended);
    if off.abs() < TOLERANCE { Ok(()) } else { Err(format!("off by {off:.1e}").into()) }
}
