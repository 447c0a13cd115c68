//! solid-energy-drift: a free bar that vibrates along itself for 10⁴ steps without damping; its energy has to stay.

use std::error::Error;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Instant;

use explicit_dynamics::Dynamics;
use peridynamics::{Correction, Elastic, Law, Solid, Space};
use sph_core::Vec3;

use crate::Metric;
use crate::judge::{Case, Headline, Outcome, Variant};
use crate::support::marched::{LAWS, march, marched};
use crate::support::solids::{formulation, lattice, parts};
use crate::support::studies::{SHOWN, figure};

const LENGTH: f64 = 24.0;
const WIDTH: f64 = 4.0;
const STEPS: f64 = 1e4;
const RECORDS: f64 = 1000.0;
/// Greatest speed over that of waves along the bar.
const SPEED: f64 = 1e-3;

const DRIFT: &str = "drift";
const SWING: &str = "largest error";

/// The bar, and how far its energy may drift.
pub fn case() -> Case {
    Case {
        name: "solid-energy-drift",
        title: "A free bar that vibrates for 10⁴ steps",
        about: "Every node gets the velocity of the first mode along the bar. The drift is the mean energy of the last tenth of \
                the march less that of the first, in parts of the energy given, at .9 of the stable step.",
        citation: "reference: the energy given at the start",
        variants: variants(),
        each: |run| {
            let drift = Metric::error(DRIFT, run.last(DRIFT)?, "%");
            Ok(vec![
                drift.within(0.1, "asked: a tenth of a percent over 10⁴ steps"),
                figure(run, SWING, "%")?.shown(SHOWN),
            ])
        },
        headline: Some(Headline::new(DRIFT, 1e-3)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (method, law) in LAWS {
        for (grid, space) in [("24 × 4, plane", Space::PlaneStress), ("24 × 4 × 4", Space::Solid)] {
            let run = move || swing(law, space).map_err(|e| e.to_string());
            variants.push(Variant::study(method, grid, run).quick_if(space == Space::PlaneStress));
        }
    }
    variants
}

fn swing(law: Law, space: Space) -> Result<Outcome, Box<dyn Error>> {
    let started = Instant::now();
    let poisson = if law == Law::BondBased { space.pairwise_poisson() } else { 0.3 };
    let material = Elastic { young: 1.0, poisson, density: 1.0 };
    let block = lattice(space.dimensions(), Vec3::zeros(), [LENGTH, WIDTH, WIDTH], 1.0).block()?;
    let mut body = Solid::new(parts(block, material, formulation(space, law, Correction::Even)))?;
    for node in 0..body.len() {
        let x = body.block().positions[node].x;
        body.set_velocity(node, Vec3::x() * (SPEED * libm::cos(PI * x / LENGTH)));
    }
    let duration = STEPS * body.stable_step(0.9)?.dt;
    let mut totals = Vec::new();
    let steps = march(&mut body, duration, duration / RECORDS, |_, record| {
        totals.push(record.energy.kinetic + record.energy.internal);
        ControlFlow::Continue(())
    })?;
    let tenth = totals.len() / 10;
    let mean = |part: &[f64]| part.iter().sum::<f64>() / part.len() as f64;
    let drift = (mean(&totals[totals.len() - tenth..]) - mean(&totals[..tenth])) / totals[0];
    let worst = totals.iter().fold(0.0_f64, |worst, total| worst.max((total / totals[0] - 1.0).abs()));
    Ok(marched(&body, steps, started, &[(DRIFT, "%", 100.0 * drift), (SWING, "%", 100.0 * worst)]))
}
