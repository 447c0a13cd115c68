//! step-limit: steps of 0.5, 0.8, 0.95 and 1.05 of the true limit; the last has to be named, not printed as a result.

use std::time::Instant;

use explicit_dynamics::{Clock, MarchError};
use sph_shell::Shell;

use crate::Outcome;
use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::CELL;
use crate::support::scenes;
use crate::support::studies::{ENERGY, SHOWN, figure, march, outcome, sharp_eigenvalue, stir, study};
use crate::{JudgeError, Metric};

const PARTS: [f64; 4] = [0.5, 0.8, 0.95, 1.05];
const BLOCKS: [u64; 2] = [100, 50];
/// Velocities, in parts of the speed of sound: small enough that the tangent of the start holds on.
const SPEED: f64 = 1e-6;
const OUTCOME: &str = "as it should end";
const WORST: &str = "largest energy";

pub fn case() -> Case {
    Case {
        name: "step-limit",
        title: "Steps of 0.5, 0.8, 0.95 and 1.05 of the limit of stability",
        about: "Small random velocities are marched for 5000 steps, the step a part of 2/ω, ω the largest frequency of the \
                particles by 400 Lanczos steps. Below the limit the energy stays bounded; above it the run has to end with an \
                error that names time and particle. The metric is 1 where a run does not end so.",
        citation: "central differences: stable for ωΔt < 2",
        variants: variants(),
        each,
        headline: Some(Headline::new(OUTCOME, 0.0)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for part in PARTS {
        for (scene, geometry, counts) in
            [(scenes::RING, "plate", [25, 3]), (scenes::PANEL, "cylinder", [7, 7])]
        {
            for method in ENERGY {
                let scene = Variant::new(method, scene, geometry, counts)
                    .set("loads", "[]")
                    .on(&format!("at {part} of the limit"));
                let scene = if method == CELL { scene.quick() } else { scene };
                variants.push(study(scene, move |shell| run(shell, part)));
            }
        }
    }
    variants
}

fn run(mut shell: Shell, part: f64) -> Result<Outcome, String> {
    let started = Instant::now();
    let speed = SPEED * shell.reference().sound_speed;
    stir(&mut shell, speed, 2);
    let mut clock = Clock::start(&mut shell, 1.0, 1.0, 0.0).map_err(|e| e.to_string())?;
    clock.dt = part * 2.0 / sharp_eigenvalue(&mut shell).sqrt();
    let (mut first, mut worst) = (0.0, 0.0_f64);
    let ended = march(&mut clock, &mut shell, BLOCKS, |_, record| {
        let energy = record.energy.kinetic + record.energy.internal;
        first = if record.step == 0 { energy } else { first };
        worst = worst.max(energy / first);
    });
    let named = match &ended {
        Err(MarchError::Diverged { time, particle, speed, .. }) => {
            *time > 0.0 && *particle < shell.len() && speed.is_finite()
        }
        Err(MarchError::OutOfBounds { time, .. }) => *time > 0.0,
        _ => false,
    };
    let sound = ended.is_ok() && worst < 10.0;
    let wrong = if part < 1.0 { !sound } else { !named };
    let figures = [
        (OUTCOME, "-", f64::from(u8::from(wrong))),
        (WORST, "of the first", worst.min(f64::MAX)),
        ("steps", "-", clock.steps as f64),
    ];
    let failure = ended.err().filter(|_| part < 1.0).map(|e| e.to_string());
    Ok(outcome(&shell, clock.steps, started, &figures, failure))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "bounded below the limit, named above it";
    let mut metrics = vec![figure(run, OUTCOME, "-")?.within(0.0, reason)];
    metrics.push(figure(run, WORST, "of the first")?.shown(SHOWN));
    metrics.push(figure(run, "steps", "-")?.shown(SHOWN));
    Ok(metrics)
}
