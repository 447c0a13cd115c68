//! Studies: runs that are no scene. Shells of any scene and method, states to start from, and what a study leaves behind.

use std::sync::Arc;
use std::time::Instant;

use coque::{Checked, Model, Rendering, Scene, SceneError, Silent, render, warnings};
use explicit_dynamics::{Clock, LinearisedDynamics, MarchError, Record, largest_eigenvalue};
use nalgebra::DMatrix;
use sph_core::Vec3;
use sph_shell::Shell;

use crate::JudgeError;
use crate::judge::{Found, Metric, Outcome, Problem, Run, Solver, Variant};
use crate::methods::{CELL, NODAL_1, NODAL_2, NODAL_3, WIDE_14, WIDE_25, WIDE_30};

/// Every formulation that derives from an energy.
pub const ENERGY: [&str; 7] = [CELL, WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3];

/// Reason of metrics that are only shown.
pub const SHOWN: &str = "shown beside the metric that is judged";

/// The model of a variant that is a scene, for `threads` threads.
pub fn model(variant: &Variant, threads: usize) -> Result<Model, String> {
    scene(variant).and_then(|scene| scene.build(threads).map_err(|error| shown(&error)))
}

/// The shell of a variant that is a scene, for programs that move it themselves.
pub fn shell(variant: &Variant) -> Result<Shell, String> {
    scene(variant).and_then(|scene| scene.build_shell(1).map_err(|error| shown(&error)))
}

/// The scene of a variant.
fn scene(variant: &Variant) -> Result<Checked, String> {
    let Problem::Scene { text, set } = &variant.source else { return Err("no scene".into()) };
    Scene::with_overrides(text, "scene of a study", set).map_err(|error| shown(&error))
}

fn shown(error: &SceneError) -> String {
    render(error, Rendering { width: 110, colour: false })
}

/// Turns a scene into a study of its shell, on the same row and column of the table.
pub fn study(
    scene: Variant,
    run: impl Fn(Shell) -> Result<Outcome, String> + Send + Sync + 'static,
) -> Variant {
    let built = scene.clone();
    let source = Problem::Study(Arc::new(move || run(shell(&built)?)));
    Variant { source, settles: false, ..scene }
}

/// Makes a refusal of the scene an outcome of the run: a method that cannot be built on a cloud is a row of the table.
pub fn or_refused(variant: Variant) -> Variant {
    let Problem::Scene { text, set } = variant.source.clone() else { return variant };
    let run = move || {
        let model = Scene::with_overrides(text, "hard case", &set).and_then(|scene| scene.build(1));
        Ok(match model {
            Ok(model) => Outcome::from(model.run(&mut Silent)),
            Err(refusal) => failed(format!("refused: {refusal}")),
        })
    };
    Variant { source: Problem::Study(Arc::new(run)), ..variant }
}

/// What a study finds, or why it finds nothing, which is a row of the table as well.
pub fn or_failed(found: Result<Outcome, String>) -> Outcome {
    found.unwrap_or_else(failed)
}

/// Nothing but the reason why there is nothing.
fn failed(cause: String) -> Outcome {
    Outcome { failure: Some(cause), ..finding(0, 0.0, &[]) }
}

/// What a study without time finds: one row of figures without a unit.
pub fn finding(particles: usize, spacing: f64, figures: &[(&str, f64)]) -> Outcome {
    let figures: Vec<_> = figures.iter().map(|&(name, value)| (name, "-", value)).collect();
    Outcome { particles, spacing, dof: 5 * particles, steps: 1, ..Outcome::row(Solver::Static, &figures) }
}

/// How far a ratio is from one, more being positive \[%\].
pub fn off(ratio: Option<f64>) -> Option<f64> {
    ratio.map(|ratio| 100.0 * (ratio - 1.0))
}

/// What a study in time leaves behind: one row of figures, with their units.
pub fn outcome(
    shell: &Shell,
    steps: u64,
    started: Instant,
    figures: &[(&str, &str, f64)],
    failure: Option<String>,
) -> Outcome {
    let wall_seconds = started.elapsed().as_secs_f64();
    Outcome {
        particles: shell.len(),
        spacing: shell.reference().cloud.spacing(),
        dof: shell.dof(),
        steps,
        wall_seconds,
        particle_steps_per_second: shell.len() as f64 * steps as f64 / wall_seconds,
        failure,
        warnings: warnings(shell),
        ..Outcome::row(Solver::Explicit, figures)
    }
}

/// A figure of the last row, as an error that is itself the value.
pub fn figure(run: &Run, name: &str, unit: &str) -> Result<Found, JudgeError> {
    Ok(Metric::error(name, run.column(name)?.last().copied(), unit))
}

/// Steps of `blocks` blocks of `each` steps; after every block `look` sees the shell and a record taken there.
pub fn march(
    clock: &mut Clock,
    shell: &mut Shell,
    [blocks, each]: [u64; 2],
    mut look: impl FnMut(&Shell, &Record),
) -> Result<(), MarchError> {
    for block in 0..=blocks {
        let record = clock.recorded_step(shell)?;
        look(shell, &record);
        for _ in 1..if block < blocks { each } else { 1 } {
            clock.step(shell, f64::INFINITY, |_| 1.0)?;
        }
    }
    clock.watch(shell)
}

/// Numbers in (−1, 1), the same on every machine: the high bits of a linear congruential generator.
pub struct RandomNumbers(pub u64);

impl RandomNumbers {
    pub fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 / (1_u64 << 53) as f64) * 2.0 - 1.0
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.roll(), self.roll(), self.roll())
    }
}

/// Gives every particle a random velocity of up to `speed` \[L/T\] a component, and its director a rate to match.
pub fn stir(shell: &mut Shell, speed: f64, seed: u64) {
    let mut dice = RandomNumbers(seed);
    for a in 0..shell.len() {
        let radius = (shell.reference().inertias[a] / shell.reference().masses[a]).sqrt();
        let (v, w) = (dice.vector() * speed, dice.vector() * (speed / radius));
        shell.set_rate(a, v, w);
    }
}

/// Largest eigenvalue of the mass-scaled tangent \[1/T²\]: enough Lanczos steps that the residual is round-off.
pub fn sharp_eigenvalue(shell: &mut Shell) -> f64 {
    largest_eigenvalue(shell, 400).ritz
}

/// The mass-scaled tangent of the present state, column by column \[1/T²\].
pub fn dense_tangent(shell: &mut Shell) -> DMatrix<f64> {
    let n = shell.unknowns();
    let mut matrix = DMatrix::zeros(n, n);
    let (mut unit, mut column) = (vec![0.0; n], vec![0.0; n]);
    for j in 0..n {
        unit[j] = 1.0;
        shell.apply(&unit, &mut column);
        unit[j] = 0.0;
        matrix.column_mut(j).copy_from_slice(&column);
    }
    matrix
}

/// In real time in place of the scene's analysis \[T\]; studies that march a bare shell themselves give any duration.
pub fn in_time(variant: Variant, duration: f64, record_every: f64) -> Variant {
    let times = format!("{{ duration = {duration:e}, record_every = {record_every:e} }}");
    variant.set("analysis", format!("{{ explicit = {{ transient = {times} }} }}"))
}

/// A free body without loads.
pub fn free(variant: Variant) -> Variant {
    in_time(variant.set("supports", "[]").set("loads", "[]"), 1.0, 1.0)
}

/// Moves the particles of a scene at random by up to a quarter of the spacing.
pub fn jittered(variant: Variant, geometry: &str) -> Variant {
    let path = format!("geometry.{geometry}.disorder");
    variant.set(&path, "{ fraction = 0.25, seed = 1 }").on("jitter .25")
}
