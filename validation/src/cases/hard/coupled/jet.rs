//! jet-on-a-free-shell: a block of water hits a strip that nothing holds; their momentum has to stay.

use std::error::Error;
use std::time::Instant;

use fluid_sph::{Parts, Start};
use sph_core::Vec3;
use sph_shell::{Shell, WetFaces};

use crate::cases::coupled::measure::{Size, outcome};
use crate::judge::{Case, Headline, Outcome, Run, Variant};
use crate::support::coupled::{Strip, coupled, fill, march, stations, water, wetting};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

/// Of the jet \[m/s\].
const SPEED: f64 = 2.0;
const SPACING: f64 = 0.01;
const CELLS: usize = 20;
const LENGTH: f64 = 0.2;
const END: f64 = 0.15;

const MOMENTUM: &str = "momentum gained";
const MOVED: &str = "speed of the shell";
const BALANCE: &str = "missing energy";

/// The jet, and what must not change.
pub fn case() -> Case {
    Case {
        name: "jet-on-a-free-shell",
        title: "A jet on a free strip of shell, two spacings thick",
        about: "No wall, no gravity: the momentum of water and shell is that of the jet at all times. \
                Pair forces are equal and opposite; what a shell of several steps feels beyond them, the \
                pressure of plane waves between two loads, goes back to the water in the same step. \
                Velocities of the shell stand half a step of its own behind its place, those of the water \
                half a step of the water: the impulse of the load between these instants is taken off.",
        citation: "momentum",
        variants: [("M = 1, soft", 1e5), ("M > 1, stiff", 1e7)]
            .into_iter()
            .map(|(grid, young)| {
                Variant::study("shell", grid, move || hit(young).map_err(|error| error.to_string()))
                    .judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(MOMENTUM, 1e-3)),
        ..Case::default()
    }
}

fn hit(young: f64) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let (dx, thickness) = (SPACING, 2.0 * SPACING);
    let strip = Strip {
        line: stations([0.5 * thickness, LENGTH], [0.5 * thickness, 0.0], CELLS),
        closed: false,
        young,
        poisson: 0.3,
        thickness,
        density: 1000.0,
        gravity: 0.0,
        held: Vec::new(),
    };
    let width = strip.width();
    let shell = strip.builder()?.wetted(wetting(dx, WetFaces::Both, &[0, CELLS])).build()?;
    let positions = fill([-0.1 - 2.0 * dx, 0.08], [-2.0 * dx, 0.12], dx);
    let parts = Parts {
        velocities: vec![Vec3::x() * SPEED; positions.len()],
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        ..water(dx, positions, 10.0 * SPEED, Vec::new())
    };
    let mut system = coupled(parts, vec![shell])?;
    let before = system.fluid().momentum().x;
    let of_shell = |shell: &Shell| -> f64 {
        let [_, rates] = shell.motion();
        rates.iter().zip(&shell.reference().masses).map(|(rate, mass)| mass * rate[0]).sum()
    };
    let mut rows = Vec::new();
    let steps = march(&mut system, [END, 0.001], 0.0, |system, record| {
        let shell = system.structures().next().map_or(0.0, of_shell) / width;
        let ahead = system.impulse_ahead(0).map_or(f64::NAN, |impulse| impulse[0]);
        let gained = (system.fluid().momentum().x + shell - ahead) / before - 1.0;
        let speed = shell / (1000.0 * thickness * LENGTH);
        rows.push([record.at.time, 100.0 * gained, speed, record.balance_error]);
    })?;
    let size = Size {
        particles: system.fluid().len(),
        spacing: dx,
        steps,
        seconds: started.elapsed().as_secs_f64(),
    };
    Ok(outcome(size, [("time", "s"), (MOMENTUM, "%"), (MOVED, "m/s"), (BALANCE, "J/m")], &rows))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, MOMENTUM, "%")?
            .within(1e-10, "what water and shell put on each other comes in pairs: rounding is left"),
        Metric::at_least(MOVED, run.last(MOVED)?, "m/s", 0.1).within(0.0, "the jet pushes the shell"),
        figure(run, BALANCE, "J/m")?.shown("of 8 J/m that the jet brings"),
    ])
}
