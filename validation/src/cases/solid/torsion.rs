//! torsion-of-a-rod: a clamped square rod, six widths long, let go at the speed that should turn its end by 70°.

use std::error::Error;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Instant;

use peridynamics::{Correction, Elastic, Formulation, Influence, Law, Parts, Solid, Space};
use sph_core::Vec3;

use crate::figures::{Axis, Chart, Figure, Line, SKY, Series, VERMILION};
use crate::judge::{Case, Headline, Outcome, Run, Runs, Variant};
use crate::methods::PAIRWISE;
use crate::support::marched::{Balanced, in_time, march, marched, method};
use crate::support::misses::{Miss, between};
use crate::support::solids::{formulation, held, lattice, nodes, parts};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const WIDTH: f64 = 0.02;
const LENGTH: f64 = 0.12;
/// Layers held beyond the clamped end.
const GHOSTS: f64 = 4.0;

const ANGLE: &str = "angle";
const FREQUENCY: &str = "frequency over the closed form";
const AMPLITUDE: &str = "amplitude";
const BALANCE: &str = "balance";

#[derive(Clone, Copy)]
struct Rod {
    law: Law,
    influence: Influence,
    across: usize,
    /// What the end is to turn by \[°\].
    degrees: f64,
}

/// The rod, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "torsion-of-a-rod",
        title: "Torsional vibration of a clamped square rod, to 70°",
        about: "Each node gets the velocity of the first mode. The end swings out and back; the time of its return is half a \
                period. Sections of four nodes warp too freely; eight are asked for more. Weights fall \
                to zero at the horizon; with w = 1/r the rod is softer. Small and large angles differ little.",
        citation: "f₁ = √(μ J_t/(ρ I_p))/(4l), J_t/I_p = 6 × .1406 [timoshenko1970]",
        variants: variants(),
        headline: Some(Headline::new(FREQUENCY, 1.0)),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    [
        (Law::StateBased, Influence::Linear, 4, 70.0, true),
        (Law::StateBased, Influence::Linear, 4, 1.0, false),
        (Law::BondBased, Influence::Linear, 4, 70.0, true),
        (Law::StateBased, Influence::Inverse, 4, 70.0, true),
        (Law::StateBased, Influence::Linear, 8, 70.0, false),
        (Law::StateBased, Influence::Inverse, 8, 70.0, false),
    ]
    .into_iter()
    .map(|(law, influence, across, degrees, quick)| {
        let rod = Rod { law, influence, across, degrees };
        let run = move || rod.run().map_err(|e| e.to_string());
        let weight = if influence == Influence::Linear { "" } else { ", w = 1/r" };
        Variant::study(method(law), &format!("{across} across, {degrees}°{weight}"), run)
            .quick_if(quick)
            .judged(move |run, _| judged(&rod, run))
    })
    .collect()
}

impl Rod {
    fn run(&self) -> Result<Outcome, Box<dyn Error>> {
        let started = Instant::now();
        let dx = WIDTH / self.across as f64;
        let poisson = if self.law == Law::BondBased { 0.25 } else { 0.3 };
        let material = Elastic { young: 210e9, poisson, density: 7850.0 };
        let origin = Vec3::new(-GHOSTS * dx, -0.5 * WIDTH, -0.5 * WIDTH);
        let block = lattice(3, origin, [LENGTH + GHOSTS * dx, WIDTH, WIDTH], dx).block()?;
        let clamped = nodes(&block, |x| x.x < 0.0);
        let end = nodes(&block, |x| x.x > LENGTH - dx);
        let bonds = Formulation {
            influence: self.influence,
            ..formulation(Space::Solid, self.law, Correction::Even)
        };
        let mut body = Solid::new(Parts {
            supports: vec![held(clamped, &[Vec3::x(), Vec3::y(), Vec3::z()])],
            ..parts(block, material, bonds)
        })?;
        let shear = material.moduli(Space::Solid)?.mu;
        // Torsion constant over polar moment of a square: 0.1406 · 6.
        let omega = 0.5 * PI / LENGTH * (0.8436 * shear / material.density).sqrt();
        let first = omega * self.degrees.to_radians();
        for node in 0..body.len() {
            let x = body.block().positions[node];
            if x.x > 0.0 {
                let rate = first * libm::sin(0.5 * PI * x.x / LENGTH);
                body.set_velocity(node, Vec3::new(0.0, -x.z, x.y) * rate);
            }
        }
        let period = 2.0 * PI / omega;
        let mut angles = Vec::new();
        let mut balanced = Balanced::default();
        let steps = march(&mut body, 0.7 * period, 0.01 * period, |body, record| {
            balanced.see(record);
            angles.push((record.at.time, turned(body, &end)));
            ControlFlow::Continue(())
        })?;
        let back =
            angles.windows(2).find(|w| w[0].1 > 0.0 && w[1].1 <= 0.0).ok_or("the rod does not swing back")?;
        let half = back[0].0 + (back[1].0 - back[0].0) * back[0].1 / (back[0].1 - back[1].1);
        let frequency = 0.5 * period / half;
        let most = angles.iter().map(|at| at.1).fold(0.0, f64::max);
        let row = |&(time, angle): &(f64, f64)| {
            vec![time / period, angle, frequency, most / self.degrees, balanced.percent()]
        };
        let columns = [("periods", "-"), (ANGLE, "°"), (FREQUENCY, "-"), (AMPLITUDE, "-"), (BALANCE, "%")];
        let curve = in_time(&columns, angles.iter().map(row).collect());
        Ok(Outcome { curve, ..marched(&body, steps, started, &[]) })
    }
}

/// The angle by which nodes have turned about the x-axis \[°\].
fn turned(body: &Solid, nodes: &[u32]) -> f64 {
    let (mut sine, mut cosine) = (0.0, 0.0);
    for &node in nodes {
        let (from, to) = (body.block().positions[node as usize], body.position(node as usize));
        sine += from.y * to.z - from.z * to.y;
        cosine += from.y * to.y + from.z * to.z;
    }
    libm::atan2(sine, cosine).to_degrees()
}

fn judged(rod: &Rod, run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let bound = if rod.across == 4 { 8.0 } else { 5.0 };
    let bounds = [1.0 - 0.01 * bound, 1.0 + 0.01 * bound];
    let cause = "8.6 %; .5 to 1 % less with the linear influence: why is not isolated";
    let miss = (rod.across == 4 && rod.influence == Influence::Inverse).then(|| Miss::of(1.0, 0.914, cause));
    let reason = "sections of few nodes are too soft in torsion: 8 % at four across, 5 % at eight are asked";
    let mut metrics = between(FREQUENCY, run.last(FREQUENCY)?, "-", bounds, reason, miss);
    metrics.extend([
        Metric::compared(AMPLITUDE, run.last(AMPLITUDE)?, "-", 1.0).within(
            0.18,
            "measured 6 %, three times that: a softer rod swings farther, and not in one mode alone",
        ),
        figure(run, BALANCE, "%")?
            .near(0.05, "central differences keep the energy to second order of the step"),
    ]);
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let mut series = Vec::new();
    for run in runs.iter().filter(|run| run.variant.grid.contains(", 70°")) {
        let colour = if run.is(PAIRWISE) { SKY } else { VERMILION };
        let line = if run.variant.grid.starts_with('8') { Line::Solid } else { Line::Dashed };
        let points = run.column("periods")?.into_iter().zip(run.column(ANGLE)?).collect();
        series.push(Series::line(
            &format!("{}, {}", run.variant.method, run.variant.grid),
            points,
            colour,
            line,
        ));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "Angle of the end".into(),
        caption: "Over the period of the closed form: at half of it the end should be back.".into(),
        x: Axis::linear("time over the period [-]"),
        y: Axis::linear("angle [°]"),
        series,
    })])
}
