//! thin-partition: water of two depths on both sides of a wall of shell that is one to four spacings thick.

use std::error::Error;
use std::time::Instant;

use fluid_sph::{Fluid, Parts};
use sph_shell::{Clamped, Sides};

use crate::judge::{Case, Headline, Outcome, Run, Solver, Variant};
use crate::support::coupled::{
    GRAVITY, ROWS, Strip, WATER, fill, march, stations, structure, water, wetting,
};
use crate::{JudgeError, Metric};

const SPACING: f64 = 0.02;
/// Depths left and right, and widths of both \[m\].
const DEPTHS: [f64; 2] = [0.6, 0.3];
const WIDTH: f64 = 0.4;
/// Thicknesses in spacings: from one to three smoothing lengths.
const THICKNESSES: [f64; 4] = [1.0, 1.3, 2.0, 3.9];

const THRUST: &str = "thrust";
const LEAKED: &str = "particles on the wrong side";

/// The partition, its thrust in closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thin-partition",
        title: "A wall of shell thinner than the kernel, water on both sides",
        about: "The shell is held still between two depths of water. Its thickness goes from one \
                spacing, where the rows of points behind either face lie in the water on the other side, \
                to three smoothing lengths. The thrust is that of the difference of the two depths, and \
                no particle may pass.",
        citation: "½ ρ g (H₁² − H₂²)",
        variants: THICKNESSES
            .into_iter()
            .map(|ratio| {
                let run = move || hold(ratio).map_err(|error| error.to_string());
                Variant::study("shell", &format!("t = {ratio} Δx"), run).judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(THRUST, 1.0)),
        ..Case::default()
    }
}

fn hold(ratio: f64) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let (dx, thickness) = (SPACING, ratio * SPACING);
    let (behind, height) = (ROWS as f64 * dx, 0.8);
    let cells = (height / dx).round() as usize;
    let shell = Strip {
        line: stations([0.0, height], [0.0, 0.0], cells),
        closed: false,
        young: 1e9,
        poisson: 0.3,
        thickness,
        density: 1000.0,
        gravity: 0.0,
        held: vec![(vec![0, cells], Box::new(Clamped))],
    }
    .builder()?
    .wetted(wetting(dx, Sides::Both, &[]))
    .build()?;
    let face = 0.5 * thickness;
    let outer = face + WIDTH;
    let left = fill([-outer, 0.0], [-face, DEPTHS[0]], dx);
    let right = fill([face, 0.0], [outer, DEPTHS[1]], dx);
    let here = left.len();
    let walls = vec![
        fill([-outer - behind, -behind], [outer + behind, 0.0], dx),
        fill([-outer - behind, 0.0], [-outer, height], dx),
        fill([outer, 0.0], [outer + behind, height], dx),
    ];
    let sound = 10.0 * (GRAVITY * DEPTHS[0]).sqrt();
    let parts = water(dx, left.into_iter().chain(right).collect(), sound, walls);
    let mut fluid = Fluid::new(Parts { structures: vec![structure(&shell)], ..parts })?;
    let mut sum = (0.0, 0.0);
    let steps = march(&mut fluid, [1.0, 0.005], 0.0, |fluid, record| {
        if record.at.time > 0.5 {
            sum = (sum.0 + fluid.structure_force(0).x, sum.1 + 1.0);
        }
    })?;
    let wrong = |(number, x): (usize, &sph_core::Vec3)| (number < here) != (x.x < 0.0);
    let leaked = fluid.positions().iter().enumerate().filter(|&pair| wrong(pair)).count();
    let wall_seconds = started.elapsed().as_secs_f64();
    Ok(Outcome {
        particles: fluid.len(),
        spacing: dx,
        steps,
        wall_seconds,
        particle_steps_per_second: fluid.len() as f64 * steps as f64 / wall_seconds,
        ..Outcome::row(Solver::Explicit, &[(THRUST, "N/m", sum.0 / sum.1), (LEAKED, "-", leaked as f64)])
    })
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let [h1, h2] = DEPTHS;
    let exact = 0.5 * WATER * GRAVITY * (h1 * h1 - h2 * h2);
    Ok(vec![
        Metric::compared(THRUST, run.last(THRUST)?, "N/m", exact)
            .within(0.05 * exact, "a spacing is 3 % of the greater depth"),
        Metric::error(LEAKED, run.last(LEAKED)?, "-").within(0.0, "a wall lets no particle pass"),
    ])
}
