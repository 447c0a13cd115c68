//! plank-dropped-into-water: a free solid of bonds, half as dense as water, falls into it and floats.

use std::error::Error;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use peridynamics::{AppliedLoad, Correction, Elastic, Law, Solid, Space};
use sph_core::Vec3;

use crate::cases::coupled::measure::{Size, mean_and_deviation, outcome};
use crate::judge::{Case, Headline, Outcome, Run, Variant};
use crate::support::coupled::{GRAVITY, ROWS, coupled, fill, march, water};
use crate::support::solids::{formulation, lattice, parts};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const SPACING: f64 = 0.02;
/// Tank and depth of the water, plank \[m\].
const TANK: [f64; 2] = [1.0, 0.5];
const PLANK: [f64; 2] = [0.3, 0.1];
/// Height of the fall \[m\].
const FALL: f64 = 0.1;
const DENSITY: f64 = 500.0;
const END: f64 = 4.0;

const HEIGHT: &str = "height of the plank's middle";
const TOTAL: &str = "missing energy";
const DENSEST: &str = "density error";

/// The plank, and where it has to float.
pub fn case() -> Case {
    Case {
        name: "plank-dropped-into-water",
        title: "A plank falls into water and floats",
        about: "Nothing holds the plank. It floats with its middle in the surface, which its draught has \
                lifted by 15 mm.",
        citation: "Archimedes",
        variants: vec![
            Variant::study("state-based solid", "15×5", || fall().map_err(|error| error.to_string()))
                .judged(|run, _| judged(run)),
        ],
        headline: Some(Headline::new(HEIGHT, 1.0)),
        ..Case::default()
    }
}

fn fall() -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let dx = SPACING;
    let origin = Vec3::new(0.5 * (TANK[0] - PLANK[0]), TANK[1] + FALL, 0.0);
    let block = lattice(2, origin, [PLANK[0], PLANK[1], dx], dx).block()?;
    let weight = |a: usize| (a as u32, -Vec3::y() * (GRAVITY * DENSITY * block.volumes[a]));
    let forces = (0..block.len()).map(weight).collect();
    let material = Elastic { young: 1e6, poisson: 0.3, density: DENSITY };
    let mut plank = Solid::new(peridynamics::Parts {
        loads: vec![AppliedLoad { forces, amplitude: Amplitude::Constant }],
        ..parts(block, material, formulation(Space::PlaneStrain, Law::StateBased, Correction::Even))
    })?;
    plank.wet()?;
    let (behind, [width, depth]) = (ROWS as f64 * dx, TANK);
    let walls = vec![
        fill([-behind, -behind], [width + behind, 0.0], dx),
        fill([-behind, 0.0], [0.0, 2.0 * depth], dx),
        fill([width, 0.0], [width + behind, 2.0 * depth], dx),
    ];
    let sound = 10.0 * (GRAVITY * depth).sqrt();
    let mut system = coupled(water(dx, fill([0.0, 0.0], TANK, dx), sound, walls), vec![plank])?;
    let middle =
        |plank: &Solid| (0..plank.len()).map(|a| plank.position(a).y).sum::<f64>() / plank.len() as f64;
    let mut rows = Vec::new();
    let steps = march(&mut system, [END, 0.02], 0.0, |system, record| {
        let height = system.structures().next().map_or(f64::NAN, middle);
        let densest = system.fluid().greatest_density_error();
        rows.push([record.at.time, height, record.balance_error, 100.0 * densest]);
    })?;
    let size = Size {
        particles: system.fluid().len(),
        spacing: dx,
        steps,
        seconds: started.elapsed().as_secs_f64(),
    };
    Ok(outcome(size, [("time", "s"), (HEIGHT, "m"), (TOTAL, "J/m"), (DENSEST, "%")], &rows))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let late = mean_and_deviation(&run.column("time")?, &run.column(HEIGHT)?, [2.0, END]);
    let floats = TANK[1] + DENSITY / 1000.0 * PLANK[0] * PLANK[1] / TANK[0];
    Ok(vec![
        Metric::compared(HEIGHT, late.map(|found| found.0), "m", floats)
            .within(SPACING, "a spacing: the mean from 2 to 4 s, while it still bobs"),
        figure(run, TOTAL, "J/m")?.shown("of 30 J/m that the plank brings"),
        figure(run, DENSEST, "%")?.shown("the slap of a flat face is a peak of sound"),
    ])
}
