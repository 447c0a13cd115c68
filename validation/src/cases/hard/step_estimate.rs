//! step-estimate: the stable step that a run takes, against all eigenvalues of the deformed shell.

use std::time::Instant;

use explicit_dynamics::{Damping, Dynamics, March, QuasiStatic};
use nalgebra::SymmetricEigen;
use sph_shell::Shell;

use crate::Outcome;
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::scenes;
use crate::support::studies::{ENERGY, SHOWN, dense_tangent, figure, outcome, study};
use crate::{JudgeError, Metric};

const RATIO: &str = "estimate over true step";
const ABOVE: &str = "above the true step";
const FRESH: &str = "that of the start over true step";

pub fn case() -> Case {
    Case {
        name: "step-estimate",
        title: "The stable step on deformed shells: estimate against all eigenvalues",
        about: "The strip at half the moment of the ring and the panel pushed in by 20 mm, brought there in time. The estimate \
                of 30 Lanczos steps, Ritz value plus residual, over 2/ω of the largest eigenvalue of the whole matrix: above one it \
                would not be safe, far below it waste.",
        citation: "reference: dense symmetric eigenvalues of the same tangent",
        variants: variants(),
        each,
        headline: Some(Headline::new(RATIO, 1e-4)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for method in ENERGY {
        let ring = Variant::new(method, scenes::RING, "plate", [25, 3]).on("at half the moment");
        let panel = Variant::new(method, scenes::PANEL, "cylinder", [9, 9]).on("at 20 mm");
        variants.push(study(ring, |shell| run(shell, 0.5, 17.9)));
        variants.push(study(panel, |shell| run(shell, 2.0 / 3.0, 0.031)));
    }
    variants
}

/// Ramps to a level over four periods and looks there: the state need not be at rest.
fn run(mut shell: Shell, level: f64, period: f64) -> Result<Outcome, String> {
    let started = Instant::now();
    let step = |shell: &mut Shell| shell.stable_step(1.0).map(|step| step.dt).map_err(|e| e.to_string());
    let first = step(&mut shell)?;
    let path = QuasiStatic {
        levels: vec![level],
        period: Some(period),
        ramp: 4.0,
        hold: 1.0,
        damping: Damping::Ratio(1.0),
        tolerance: 1e-6,
        accuracy: 5e-3,
        safety: 0.8,
    };
    let march = March::start(path, &mut shell).map_err(|e| e.to_string())?;
    let clock = march.finish(&mut shell).map_err(|e| e.to_string())?;
    let estimate = step(&mut shell)?;
    let matrix = dense_tangent(&mut shell);
    let symmetric = (&matrix + matrix.transpose()) * 0.5;
    let asymmetry = (&matrix - &symmetric).norm() / matrix.norm();
    let values = SymmetricEigen::new(symmetric).eigenvalues;
    let exact = 2.0 / values.max().sqrt();
    let figures =
        [(RATIO, "-", estimate / exact), (FRESH, "-", first / exact), ("asymmetry", "-", asymmetry)];
    Ok(outcome(&shell, clock.steps, started, &figures, None))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let ratio = run.column(RATIO)?.last().copied();
    Ok(vec![
        Metric::compared(RATIO, ratio, "-", 1.0)
            .within(0.1, "between .9 of the true step and the whole of it"),
        Metric::error(ABOVE, ratio.map(|ratio| (ratio - 1.0).max(0.0)), "-").within(
            1e-3,
            "Ritz values lie below; the residual added to them leaves 1e-3, far less than any safety takes",
        ),
        Metric::compared(FRESH, run.column(FRESH)?.last().copied(), "-", 1.0).shown(SHOWN),
        figure(run, "asymmetry", "-")?.shown(SHOWN),
    ])
}
