//! fluid-corner: still water in a wedge of 30°, down to a tip in which not two particles find room side by side.

use std::error::Error;
use std::f64::consts::PI;

use fluid_sph::{Fluid, Parts, Wall};
use sph_core::{LineSide, Vec3, polyline_rows};

use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::support::fluids::{
    CORRECTED, DENSITY, GRAVITY, KICKS, PUBLISHED, filled, formulation, march, rows, water,
};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

/// Half the angle of the wedge \[rad\].
const HALF: f64 = 15.0 * PI / 180.0;
/// Depth of the water \[m\].
const DEPTH: f64 = 1.0;
/// Pressures are judged below so much of the depth.
const JUDGED: f64 = 0.85;

const LEAKED: &str = "particles behind a wall";
const LEVEL: &str = "level by pressures over that by mass";
const SCATTER: &str = "scatter of pressures";
const SPEED: &str = "greatest speed over √(gH)";
const KINETIC: &str = "kinetic energy at the end";

/// The wedge, and what its water has to keep.
pub fn case() -> Case {
    Case {
        name: "fluid-corner",
        title: "Still water in a corner of 30°",
        about: "A lattice of particles half a spacing or more from both walls settles in a wedge that stands on its tip, for ten \
                √(H/g). No particle may pass a wall; pressures have to tell one level, and motion to die. Over the last fifth of \
                the time each pressure tells the level p/ρg + y: their mean is held against that of the mass, their scatter in \
                parts of the depth. Oblique walls meet a lattice unevenly and leave gaps, which raise the level.",
        citation: "closed form p = ρg(level − y), level by the mass",
        variants: variants(),
        headline: Some(Headline::new(SCATTER, 0.1)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [(KICKS, 30, true), (KICKS, 60, false), (CORRECTED, 30, false), (PUBLISHED, 30, false)]
        .into_iter()
        .map(|(method, high, quick)| {
            let run = move || settled(method, high).map_err(|e| e.to_string());
            Variant::study(method, &format!("H/Δx {high}"), run).quick_if(quick).judged(judged)
        })
        .collect()
}

/// Distance from the nearer wall \[m\], negative behind it.
fn inside(place: &Vec3) -> f64 {
    place.y * libm::sin(HALF) - place.x.abs() * libm::cos(HALF)
}

fn settled(method: &str, high: usize) -> Result<Outcome, Box<dyn Error>> {
    let dx = DEPTH / high as f64;
    let formulation = formulation(method);
    let slope = libm::tan(HALF);
    let wide = ((DEPTH * slope) / dx).ceil() * dx;
    let mut positions = filled([-wide, 0.0, 0.0], [wide, DEPTH, 0.0], 2, dx);
    // The tip of the lattice: rounding must not decide who is in.
    positions.retain(|place| inside(place) > 0.499 * dx);
    // What water of this mass fills of the wedge.
    let level = (positions.len() as f64 * dx * dx / slope).sqrt();
    let edge = 1.3 * DEPTH;
    let line = [[-edge * slope, edge], [0.0, 0.0], [edge * slope, edge]];
    // Down one side and up the other the water is on the left.
    let points = polyline_rows(&line, LineSide::Right, dx, rows(&formulation))?;
    let sound = 20.0 * (GRAVITY * DEPTH).sqrt();
    let parts = water(2, dx, positions, sound, formulation);
    let mut fluid = Fluid::new(Parts { walls: vec![Wall { points, motion: None }], ..parts })?;
    let period = (DEPTH / GRAVITY).sqrt();
    let head = DENSITY * GRAVITY * DEPTH;
    let (mut leaked, mut sum, mut squares, mut count, mut fastest) = (0, 0.0, 0.0, 0.0, 0.0_f64);
    let marched = march(&mut fluid, 10.0 * period, 0.1 * period, |fluid, record| {
        leaked = leaked.max(fluid.positions().iter().filter(|place| inside(place) < 0.0).count());
        if record.at.time > 8.0 * period {
            for (place, pressure) in fluid.positions().iter().zip(fluid.pressures()) {
                if place.y < JUDGED * DEPTH {
                    // The level that a pressure tells, in parts of the depth.
                    let reported = pressure / head + place.y / DEPTH;
                    (sum, squares, count) = (sum + reported, squares + reported * reported, count + 1.0);
                }
            }
            let speed = fluid.velocities().iter().map(|v| v.norm()).fold(0.0, f64::max);
            fastest = fastest.max(speed / (GRAVITY * DEPTH).sqrt());
        }
    });
    let reported = sum / count;
    let weight = fluid.len() as f64 * fluid.mass() * GRAVITY;
    let figures = [
        (LEAKED, "-", leaked as f64),
        (LEVEL, "-", reported / level * DEPTH),
        (SCATTER, "%", 100.0 * (squares / count - reported * reported).max(0.0).sqrt()),
        (SPEED, "-", fastest),
        (KINETIC, "-", fluid.energies().kinetic / (0.5 * weight * DEPTH)),
        ("level by the mass", "m", level),
    ];
    Ok(marched.outcome(&mut fluid).showing(&figures))
}

fn judged(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    Ok(vec![
        figure(run, LEAKED, "-")?.within(0.0, "walls let no particle through, in a corner neither"),
        figure(run, SCATTER, "%")?
            .near(7.95, "a lattice that walls cut obliquely, not distinguished from its tip"),
        Metric::compared(LEVEL, run.last(LEVEL)?, "-", 1.0)
            .shown("a lattice that walls cut obliquely does not fill the wedge: the level is the higher"),
        figure(run, SPEED, "-")?.within(
            0.08,
            "2.4e-2 measured at 30 particles a height: single particles still find their places",
        ),
        figure(run, KINETIC, "-")?.within(
            1e-4,
            "3.1e-5 measured at 30 particles a height, that of still water between straight walls",
        ),
    ])
}
