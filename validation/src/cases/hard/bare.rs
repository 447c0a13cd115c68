//! Bare shells for studies: any scene at any place of the dial, states to start from, and what a study leaves behind.

use std::ops::ControlFlow;
use std::time::Instant;

use coque::{Column, Curve, Model, Rendering, Scene, doubts, render};
use explicit_dynamics::{Clock, LinearisedDynamics, MarchError, Observer, Record, largest_eigenvalue};
use nalgebra::DMatrix;
use sph_core::Vec3;
use sph_shell::Shell;

use crate::case::{Problem, Run, Variant};
use crate::cases::dial::{CELL, NODAL_1, NODAL_2, NODAL_3, WIDE_14, WIDE_25, WIDE_30};
use crate::outcome::{Outcome, Solver};
use crate::record::Found;
use crate::{JudgeError, Metric};

/// Every formulation that derives from an energy.
pub const ENERGY: [&str; 7] = [CELL, WIDE_14, WIDE_25, WIDE_30, NODAL_1, NODAL_2, NODAL_3];

/// Reason of metrics that are only shown.
pub const SHOWN: &str = "shown beside the metric that is judged";

/// The model of a variant that is a scene, for `threads` threads.
pub fn model(variant: &Variant, threads: usize) -> Result<Model, String> {
    let Problem::Scene { text, set } = &variant.source else { return Err("no scene".into()) };
    let how = Rendering { width: 110, colour: false };
    Scene::with_overrides(text, "scene of a study", set)
        .and_then(|scene| scene.build(threads))
        .map_err(|error| render(&error, how))
}

/// Turns a scene into a study of its shell, on the same row and column of the table.
pub fn study(
    scene: Variant,
    run: impl Fn(Shell) -> Result<Outcome, String> + Send + Sync + 'static,
) -> Variant {
    let (method, grid, quick) = (scene.method.clone(), scene.grid.clone(), scene.quick);
    let study = Variant::study(&method, &grid, move || run(model(&scene, 1)?.shell));
    if quick { study.quick() } else { study }
}

/// What a study leaves behind: one row of figures, with their units.
pub fn outcome(
    shell: &Shell,
    steps: u64,
    started: Instant,
    figures: &[(&str, &str, f64)],
    failure: Option<String>,
) -> Outcome {
    let wall_seconds = started.elapsed().as_secs_f64();
    Outcome {
        solver: Solver::Explicit,
        curve: row(figures),
        particles: shell.len(),
        spacing: shell.reference().cloud.spacing(),
        dof: shell.freedoms(),
        steps,
        threads: 1,
        wall_seconds,
        particle_steps_per_second: shell.len() as f64 * steps as f64 / wall_seconds,
        stable_step: 0.0,
        restless: 0,
        critical: Vec::new(),
        failure,
        warnings: doubts(shell),
        shapes: Vec::new(),
        faces: Vec::new(),
    }
}

/// A curve of one row: names, units and figures.
pub fn row(figures: &[(&str, &str, f64)]) -> Curve {
    let column = |&(name, unit, _): &(&str, &str, f64)| Column { name: name.into(), unit: unit.into() };
    Curve {
        columns: figures.iter().map(column).collect(),
        rows: vec![figures.iter().map(|figure| figure.2).collect()],
    }
}

/// A figure of the last row, as an error that is itself the value.
pub fn figure(run: &Run, name: &str, unit: &str) -> Result<Found, JudgeError> {
    Ok(Metric::error(name, run.column(name)?.last().copied(), unit))
}

/// Keeps the last record.
#[derive(Default)]
pub struct Last(pub Option<Record>);

impl Observer<Shell> for Last {
    fn record(&mut self, _: &mut Shell, record: &Record) -> ControlFlow<()> {
        self.0 = Some(*record);
        ControlFlow::Continue(())
    }
}

/// Steps of `blocks` blocks of `each` steps; after every block `look` sees the shell and a record taken there.
pub fn march(
    clock: &mut Clock,
    shell: &mut Shell,
    [blocks, each]: [u64; 2],
    mut look: impl FnMut(&Shell, &Record),
) -> Result<(), MarchError> {
    let mut last = Last::default();
    for block in 0..=blocks {
        clock.recorded_step(shell, &mut last, false, f64::INFINITY, |_| 1.0)?.is_break();
        if let Some(record) = &last.0 {
            look(shell, record);
        }
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
