//! couette: laminar flow between two cylinders, the inner of which turns; profile and torque are known.

use std::error::Error;
use std::f64::consts::{PI, TAU};

use explicit_dynamics::Amplitude;
use fluid_sph::{Fluid, Formulation, Motion, Parts, Rotation, Start, Wall};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Lattices, Outcome, Run, Variant};
use crate::support::fluids::{CORRECTED, DENSITY, KICKS, formulation, march, rows, water};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

/// Radii of the cylinders \[m\].
const RADII: [f64; 2] = [0.5, 1.0];
/// Rate of the inner one \[1/s\]: it moves at 1 m/s.
const RATE: f64 = 2.0;
/// Kinematic viscosity \[m²/s\]: a Reynolds number of 10 by the gap.
const VISCOSITY: f64 = 0.05;
/// Ten times the greatest speed \[m/s\].
const SOUND: f64 = 10.0;
/// The slowest part of the start falls as `exp(−π²νt/d²)`: to 4e-4 in this time \[s\].
const DURATION: f64 = 4.0;

const PROFILE: &str = "rms error of the profile";
const INNER: &str = "torque on the inner cylinder";
const OUTER: &str = "torque on the outer cylinder";

/// The cylinders, and how far profile and torque may be off.
pub fn case() -> Case {
    Case {
        name: "couette",
        title: "Laminar flow between cylinders, the inner of which turns",
        about: "Water starts at rest and is dragged by the inner cylinder until the flow is steady: u = A r + B/r, torque \
                4πμΩ R₁²R₂²/(R₂² − R₁²) a length. Errors of the profile in parts of the speed of the inner cylinder, over the last \
                second. No artificial viscosity: friction is that of ν alone.",
        citation: "closed form; Re = 10, laminar at any disturbance",
        variants: variants(),
        headline: Some(Headline::new(PROFILE, 0.1)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let coarse = Some([2.97, 6.4]);
    [
        (KICKS, 10, coarse, true),
        (KICKS, 20, None, false),
        (KICKS, 40, None, false),
        (CORRECTED, 10, Some([2.81, 5.7]), false),
        (CORRECTED, 20, None, false),
    ]
    .into_iter()
    .map(|(method, across, measured, quick)| {
        let run = move |across: usize| turned(across, formulation(method)).map_err(|e| e.to_string());
        Variant::study_on(method, &format!("d/Δx {across}"), Lattices::marched(across, 1, run))
            .quick_if(quick)
            .full_if(across > 20 || (across > 10 && method != KICKS))
            .judged(move |run, _| judged(measured, run))
    })
    .collect()
}

/// Particles about a spacing apart on a circle.
fn ring(radius: f64, spacing: f64) -> impl Iterator<Item = Vec3> {
    let count = (TAU * radius / spacing).round().max(1.0);
    (0..count as usize).map(move |i| {
        let angle = TAU * i as f64 / count;
        Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
    })
}

/// Speed along a circle \[m/s\].
fn exact(radius: f64) -> f64 {
    let [inner, outer] = RADII.map(|r| r * r);
    let share = RATE * inner / (outer - inner);
    share * (outer / radius - radius)
}

/// Torque of the fluid on the outer cylinder \[N\].
fn torque() -> f64 {
    let [inner, outer] = RADII.map(|r| r * r);
    4.0 * PI * DENSITY * VISCOSITY * RATE * inner * outer / (outer - inner)
}

/// What a friction μ∇u, whose stress is not symmetric, gives on the inner cylinder \[N\]: `2πR₁²μ|u'(R₁)|`.
fn gradient_torque() -> f64 {
    let [inner, outer] = RADII.map(|r| r * r);
    let slope = RATE * (inner + outer) / (outer - inner);
    2.0 * PI * inner * DENSITY * VISCOSITY * slope
}

fn turned(across: usize, formulation: Formulation) -> Result<Outcome, Box<dyn Error>> {
    let dx = (RADII[1] - RADII[0]) / across as f64;
    let formulation =
        Formulation { viscosity: 0.0, kinematic_viscosity: VISCOSITY, confined: true, ..formulation };
    let from = |k: usize| (k as f64 + 0.5) * dx;
    let positions = (0..across).flat_map(|k| ring(RADII[0] + from(k), dx)).collect();
    let deep = rows(&formulation);
    let inner = (0..deep).flat_map(|k| ring(RADII[0] - from(k), dx)).collect();
    let outer = (0..deep).flat_map(|k| ring(RADII[1] + from(k), dx)).collect();
    let angle = Amplitude::Table(vec![[0.0, 0.0], [2.0 * DURATION, 2.0 * DURATION]]);
    let turn = Rotation { centre: Vec3::zeros(), axis: Vec3::z(), by: RATE, angle: angle.into() };
    let turning = Motion { translation: None, rotation: Some(turn) };
    let parts = water(2, dx, positions, SOUND, formulation);
    let mut fluid = Fluid::new(Parts {
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        walls: vec![Wall { points: inner, motion: Some(turning) }, Wall { points: outer, motion: None }],
        ..parts
    })?;
    let (mut squares, mut seen, mut torques, mut records) = (0.0, 0_usize, [0.0; 2], 0.0);
    let marched = march(&mut fluid, DURATION, 0.05, |fluid, record| {
        if record.at.time > DURATION - 1.0 {
            for (place, velocity) in fluid.positions().iter().zip(fluid.velocities()) {
                let radius = place.norm();
                let along = (place.x * velocity.y - place.y * velocity.x) / radius;
                let off = (along - exact(radius)) / (RATE * RADII[0]);
                (squares, seen) = (squares + off * off, seen + 1);
            }
            for (wall, torque) in torques.iter_mut().enumerate() {
                *torque += fluid.wall_moment(wall, Vec3::zeros()).z;
            }
            records += 1.0;
        }
    });
    let figures = [
        (PROFILE, "%", 100.0 * (squares / seen as f64).sqrt()),
        (INNER, "N", -torques[0] / records),
        (OUTER, "N", torques[1] / records),
        ("balance", "%", marched.balanced.percent()),
        ("density error", "%", 100.0 * fluid.greatest_density_error()),
    ];
    Ok(marched.outcome(&mut fluid).showing(&figures))
}

fn judged(measured: Option<[f64; 2]>, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let profile = figure(run, PROFILE, "%")?;
    let outer = Metric::compared(OUTER, run.last(OUTER)?, "N", torque());
    let [profile, outer] = match measured {
        Some([at_profile, at_outer]) => [
            profile.near(
                at_profile,
                "walls are half a spacing from their first row, seen through means of the fluid",
            ),
            outer.near(at_outer, "the slope at the wall, by particles as far apart as a tenth of the gap"),
        ],
        None => [profile, outer]
            .map(|found| found.shown("finer than what was measured when the case was written")),
    };
    let inner = run.last(INNER)?;
    Ok(vec![
        profile,
        outer,
        Metric::compared(INNER, inner, "N", torque()).shown(
            "friction along the difference of velocities keeps no angular momentum: a wall that turns feels μ u', not \
             μ (u' − u/r)",
        ),
        Metric::compared("the same against that of μ u'", inner, "N", gradient_torque())
            .shown("what the form of friction gives on a wall that turns"),
        figure(run, "balance", "%")?
            .shown("friction at walls is recorded against mirrored velocities, their work against the walls' own"),
    ])
}
