//! wave-in-a-bar: one sine of velocity runs along a slender bar at √(E/ρ).

use std::error::Error;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Instant;

use benchmarks_ref::waves::bar;
use explicit_dynamics::Amplitude;
use peridynamics::{Correction, Elastic, Law, Parts, Solid, Space, Support, Supported};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::support::marched::{march, marched, method};
use crate::support::solids::{formulation, lattice, nodes, parts};
use crate::{JudgeError, Metric};

const LENGTH: f64 = 0.2;
const WIDTH: f64 = 0.002;
/// Of the sine \[s\].
const PERIOD: f64 = 1e-5;
/// Its height \[m/s\].
const SPEED: f64 = 2.0;
/// Times between which the wave is followed \[s\].
const TIMES: [f64; 2] = [1.5e-5, 3e-5];
const MATERIAL: Elastic = Elastic { young: 210e9, poisson: 0.25, density: 7850.0 };

const FRONT: &str = "speed of the front";
const CROSSING: &str = "speed of the crossing";

/// The bar, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "wave-in-a-bar",
        title: "One sine of velocity along a bar four nodes across",
        about: "The places of the front, at half the height of the peak, and of the crossing behind it, at 15 and at 30 µs, give \
                two speeds of the wave. Uncorrected bars are as much too soft or too stiff as their surfaces: those runs are \
                what a change is noticed by.",
        citation: "√(E/ρ); bending of the front by the inertia across is .1 % here",
        variants: variants(),
        headline: Some(Headline::new(FRONT, 0.2)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    use Correction::{Even, None as Bare};
    use Law::{BondBased, StateBased};
    [
        (BondBased, 4, Even, None, true),
        (StateBased, 4, Even, None, false),
        (BondBased, 4, Bare, Some(-14.7), false),
        (StateBased, 4, Bare, Some(20.6), false),
        (StateBased, 8, Even, None, false),
    ]
    .into_iter()
    .map(|(law, across, correction, known, quick)| {
        let run = move || wave(law, across, correction).map_err(|e| e.to_string());
        let corrected = if correction == Even { "corrected" } else { "uncorrected" };
        let grid = format!("{across} across, {corrected}");
        Variant::study(method(law), &grid, run)
            .quick_if(quick)
            .full_if(across > 4)
            .judged(move |run, runs| judged(known, run, runs))
    })
    .collect()
}

fn wave(law: Law, across: usize, correction: Correction) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let dx = WIDTH / across as f64;
    let block = lattice(3, Vec3::zeros(), [LENGTH, WIDTH, WIDTH], dx).block()?;
    let end = nodes(&block, |x| x.x < dx);
    // The way of one sine of velocity: 1 − cos, there and back.
    let way = |i: usize| {
        let part = i as f64 / 200.0;
        [PERIOD * part, 0.5 * (1.0 - libm::cos(2.0 * PI * part))]
    };
    let driven = Support::Moved {
        direction: Vec3::x(),
        by: SPEED * PERIOD / PI,
        amplitude: Amplitude::Table((0..=200).map(way).collect()),
    };
    let mut body = Solid::new(Parts {
        supports: vec![Supported { nodes: end, support: driven }],
        ..parts(block, MATERIAL, formulation(Space::Solid, law, correction))
    })?;
    let section = across * across;
    let mut places = Vec::new();
    let steps = march(&mut body, TIMES[1], TIMES[0], |body, record| {
        if record.at.time > 0.5 * TIMES[0] {
            let mean = |first: usize| {
                (first..first + section).map(|node| body.velocity(node).x).sum::<f64>() / section as f64
            };
            let profile: Vec<f64> = (0..body.len()).step_by(section).map(mean).collect();
            places.extend(place(&profile).map(|at| (record.at.time, at.map(|column| column * dx))));
        }
        ControlFlow::Continue(())
    })?;
    let [(t0, from), (t1, to)] = places[..] else { return Err("no wave is in the bar".into()) };
    let [front, crossing] = [0, 1].map(|k| (to[k] - from[k]) / (t1 - t0));
    Ok(marched(&body, steps, started, &[(FRONT, "m/s", front), (CROSSING, "m/s", crossing)]))
}

/// Where a profile of velocities falls to half of its peak, ahead of it, and to zero, behind it, in spacings.
fn place(profile: &[f64]) -> Option<[f64; 2]> {
    let peak = (0..profile.len()).max_by(|&a, &b| profile[a].total_cmp(&profile[b]))?;
    let between = |inner: usize, outer: usize, level: f64| {
        let part = (profile[inner] - level) / (profile[inner] - profile[outer]);
        inner as f64 + 0.5 + (outer as f64 - inner as f64) * part
    };
    let half = 0.5 * profile[peak];
    let ahead = (peak + 1..profile.len()).find(|&i| profile[i] <= half)?;
    let behind = (0..peak).rev().find(|&i| profile[i] <= 0.0)?;
    Some([between(ahead - 1, ahead, half), between(behind + 1, behind, 0.0)])
}

fn judged(known: Option<f64>, run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let exact = bar(MATERIAL.young, MATERIAL.density);
    let [front, crossing] = [FRONT, CROSSING].map(|name| run.last(name));
    let (front, crossing) = (front?, crossing?);
    let Some(known) = known else {
        let reason =
            "weights exact for uniform strains leave 1 % at four across: fields that vary along are softened";
        return Ok(vec![
            Metric::compared(FRONT, front, "m/s", exact).within(0.02 * exact, reason),
            Metric::compared(CROSSING, crossing, "m/s", exact).within(0.02 * exact, reason),
        ]);
    };
    let found = exact * (1.0 + 0.01 * known);
    Ok(vec![
        Metric::compared("speed against the one known", front, "m/s", found)
            .within(0.005 * exact, "a figure to notice a change by: what a correction is for"),
        Metric::compared(CROSSING, crossing, "m/s", exact)
            .shown("surfaces without a correction are too soft or too stiff"),
    ])
}
