//! floating-cylinder: a cylinder that is let go above its place at rest and swings, against the published solution of the same.
//!
//! ```text
//!  |         .-.         |
//!  |~~~~~~~~(  ↕)~~~~~~~~|
//!  |         `-´         |
//!  └─────────────────────┘
//! ```

use std::sync::OnceLock;

use benchmarks_ref::floating_box::crossings;
use benchmarks_ref::floating_cylinder::{Tank, released};

use super::floating_box::heights;
use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, GREY, Line, ORANGE, Series};
use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::RIGID;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/meshes/floating-cylinder.toml");
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/meshes/floating-cylinder.obj");
const TWO: &str = "two half swings";
const FIRST: &str = "time of the first quarter";
const LOW: &str = "first depth over the start";
const HIGH: &str = "second height over the start";
const TWO_FREE: &str = "two half swings, in deep water without ends";
const LOW_FREE: &str = "first depth over the start, in deep water without ends";
/// Radius \[m\], gravity \[m/s²\], height over its place at rest at the start \[m\].
const RADIUS: f64 = 0.0762;
const GRAVITY: f64 = 9.81;
const RAISED: f64 = 0.0254;
/// The tank of the scene \[m\]: half of its length, depth.
const TANK: [f64; 2] = [2.28125, 0.7625];
/// Pieces and steps of the tank, multipoles of the water without ends.
const SIZE: f64 = 0.04;
const STEPS: (f64, usize) = (0.02, 580);
const MULTIPOLES: usize = 12;

/// Two spacings, their references, and how far they may differ.
pub fn case() -> Case {
    let swinging = |grid: &str| {
        Variant::scene(RIGID, SCENE, grid)
            .set("bodies.float.rigid.geometry.mesh.file", format!("'{FILE}'"))
            .unsettled()
            .full_if(true)
            .judged(|run, _| swings(run))
    };
    // A column of particles below the middle again.
    let [low, high] = [-2.284_375, 2.284_375];
    let finer = swinging("12 spacings of radius")
        .set("bodies.water.fluid.geometry.block.spacing", 0.00625)
        .set("bodies.water.fluid.geometry.block.lengths", "[4.56875, 0.7625]")
        .set("bodies.water.fluid.geometry.block.origin", format!("[{low}, -0.7879]"))
        .set("bodies.tank.walls.geometry.basin.min", format!("[{low}, -0.7879]"))
        .set("bodies.tank.walls.geometry.basin.max", format!("[{high}, 0.2]"));
    Case {
        name: "floating-cylinder",
        title: "A cylinder that floats",
        about: "A circular cylinder half as dense as water is let go a third of its radius above its place at rest, swings and sends out waves. When it goes through that place and how far \
                it swings is known for deep water without ends, by Maskell and Ursell, whom the experiment of Ito confirmed; linear potential flow by boundary elements says what the tank changes.",
        citation: "linear potential flow [ursell1949, ursell1964, maskell1970], benchmarks-ref/src/floating_cylinder; experiment [ito1977] after [yeung1982]",
        variants: vec![swinging("6 spacings of radius"), finer],
        headline: Some(Headline::new(TWO, 0.1)),
        figures,
        ..Case::default()
    }
}

/// Times \[s\] and heights over the one at the start in this tank, and in deep water without ends.
fn theory() -> &'static [Vec<[f64; 2]>; 2] {
    static ROWS: OnceLock<[Vec<[f64; 2]>; 2]> = OnceLock::new();
    ROWS.get_or_init(|| {
        let [half, depth] = TANK.map(|length| length / RADIUS);
        let tank = Tank { half, depth }.released(SIZE, STEPS.0, STEPS.1).unwrap_or_default();
        let times: Vec<f64> = tank.iter().map(|row| row[0]).collect();
        let free = released(&times, MULTIPOLES).unwrap_or_default();
        let second = (RADIUS / GRAVITY).sqrt();
        let free = times.into_iter().zip(free).map(|(time, height)| [time, height]).collect();
        [tank, free].map(|rows: Vec<[f64; 2]>| {
            rows.into_iter().map(|[time, height]| [time * second, height]).collect()
        })
    })
}

/// Time of the first quarter, time from then to the third crossing, greatest depth before the second and greatest height before the third.
fn swings_of(rows: &[[f64; 2]]) -> Option<[f64; 4]> {
    let [first, second, third, ..] = crossings(rows)[..] else { return None };
    let most = |from: f64, to: f64| {
        let within = rows.iter().filter(|[time, _]| *time >= from && *time <= to);
        within.map(|[_, height]| height.abs()).fold(0.0, f64::max)
    };
    Some([first, third - first, most(first, second), most(second, third)])
}

fn swings(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = swings_of(&heights(run, RAISED)?);
    let [tank, deep] = theory().each_ref().map(|rows| swings_of(rows).unwrap_or([f64::NAN; 4]));
    let part = |name: &str, k: usize, unit: &str, of: [f64; 4], part: f64, reason: &str| {
        Metric::compared(name, found.map(|found| found[k]), unit, of[k]).within(part * of[k], reason)
    };
    let period = "a third of the radius is not small: with half of it 12 spacings are −.1 and −.1 % off; artificial viscosity takes .5 % with 6 spacings, sound and how particles lie at the start as \
                  much; measured 1.2 and .5 % of two half swings, .8 and −.3 % of the quarter; asked 3 %";
    let depth = "the amplitude takes 3 %, artificial viscosity 1.7 % with 6 spacings, particles at the start some 3 % either way; measured −5.7 and −3.1 %; asked 15 %";
    let height = "by then what is left of the motion is a third, and the same half millimetre counts three times; measured −6.4 and −8.4 %; asked 25 %";
    Ok(vec![
        part(TWO, 1, "s", tank, 0.03, period),
        part(FIRST, 0, "s", tank, 0.03, period),
        part(LOW, 2, "-", tank, 0.15, depth),
        part(HIGH, 3, "-", tank, 0.25, height),
        part(
            TWO_FREE,
            1,
            "s",
            deep,
            0.05,
            "the tank, ten radii deep, adds 1.6 %; measured 2.8 and 2.2 %; asked 3 % and the tank",
        ),
        part(LOW_FREE, 2, "-", deep, 0.2, "the tank takes 2.3 %; measured −7.8 and −5.3 %; asked 20 %"),
    ])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let Some(first) = runs.iter().next() else { return Ok(Vec::new()) };
    let points = |rows: Vec<[f64; 2]>| rows.into_iter().map(|[t, y]| (t, y)).collect::<Vec<_>>();
    let [tank, free] = theory().clone();
    let mut series = vec![
        Series::line("deep water without ends", points(free), GREY, Line::Dashed),
        Series::line("the same in the tank", points(tank), BLACK, Line::Dashed),
    ];
    for (run, colour) in runs.iter().zip([BLUE, ORANGE]) {
        series.push(Series::line(&run.variant.grid, points(heights(run, RAISED)?), colour, Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: first.variant.method.clone(),
        caption: "Height over the place at rest, over the one at the start.".into(),
        x: Axis::linear("t [s]"),
        y: Axis::linear("Z/Z₀"),
        series,
    })])
}
