//! Fluids: how boxes are filled and walled, marches that are watched, and what a study of one leaves behind.

use std::error::Error;
use std::time::Instant;

use benchmarks_ref::reference;
use explicit_dynamics::{Dynamics, March, MarchError, Record, Transient};
use fluid_sph::{Fluid, Formulation, Liquid, Parts, Scheme, Start, Wall, WallRule};
use sph_core::{Vec3, basin_rows};

use crate::JudgeError;
use crate::judge::{Outcome, Solver};
use crate::support::marched::Balanced;

/// The default formulation, marched by kicks and drifts.
pub const KICKS: &str = "kick and drift";
/// The default formulation, marched by the published predictor and corrector.
pub const CORRECTED: &str = "predictor-corrector";
/// The whole published set: predictor and corrector, dynamic walls, α = 0.1, XSPH, no diffusion of density.
pub const PUBLISHED: &str = "published set";

/// Acceleration of gravity \[m/s²\].
pub const GRAVITY: f64 = 9.81;
/// Density of water \[kg/m³\].
pub const DENSITY: f64 = 1000.0;
/// Sides of a basin without a lid, in a plane and in space.
pub const OPEN_TOP: [[bool; 6]; 2] =
    [[false, false, false, true, false, false], [false, false, false, false, false, true]];

/// The formulation that a name of a method stands for.
pub fn formulation(method: &str) -> Formulation {
    match method {
        PUBLISHED => Formulation::published(),
        CORRECTED => Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() },
        _ => Formulation::default(),
    }
}

/// What sets a formulation apart from the default one, in a few signs; nothing for the default.
pub fn apart(of: &Formulation) -> String {
    let usual = Formulation::default();
    let mut words = Vec::new();
    if of.viscosity != usual.viscosity {
        words.push(format!("α {}", of.viscosity));
    }
    if of.density_diffusion != usual.density_diffusion {
        words.push(format!("δ {}", of.density_diffusion));
    }
    if of.smoothing != usual.smoothing {
        words.push(format!("h/Δx {}", of.smoothing));
    }
    if of.walls == WallRule::Dynamic {
        words.push("dynamic walls".into());
    }
    words.into_iter().map(|word| format!(", {word}")).collect()
}

/// A formulation as a scene says it.
pub fn said(of: &Formulation) -> String {
    let method = if of.scheme == Scheme::PredictorCorrector { "source" } else { "kick-drift-kick" };
    let walls = if of.walls == WallRule::Dynamic { "dynamic" } else { "extrapolated" };
    let Formulation { smoothing, viscosity, density_diffusion, xsph, confined, .. } = of;
    format!(
        "{{ weakly-compressible = {{ method = \"{method}\", walls = \"{walls}\", smoothing = {smoothing}, viscosity = {viscosity}, \
         density_diffusion = {density_diffusion}, xsph = {xsph}, confined = {confined} }} }}"
    )
}

/// Rows of wall that the kernel reaches.
pub fn rows(formulation: &Formulation) -> usize {
    (2.0 * formulation.smoothing).round() as usize
}

/// Particles a spacing apart from half a spacing inside the least corner of a box on; a plane lies at z = 0.
pub fn filled(low: [f64; 3], high: [f64; 3], dimensions: usize, spacing: f64) -> Vec<Vec3> {
    let count = |k: usize| if k < dimensions { ((high[k] - low[k]) / spacing).round() as usize } else { 1 };
    let place = |k: usize, i: usize| if k < dimensions { low[k] + (i as f64 + 0.5) * spacing } else { 0.0 };
    let mut particles = Vec::with_capacity((0..3).map(count).product());
    for i in 0..count(0) {
        for j in 0..count(1) {
            particles.extend((0..count(2)).map(|k| Vec3::new(place(0, i), place(1, j), place(2, k))));
        }
    }
    particles
}

/// Water at rest under gravity along the last axis, without a wall.
pub fn water(
    dimensions: usize,
    spacing: f64,
    positions: Vec<Vec3>,
    sound_speed: f64,
    formulation: Formulation,
) -> Parts {
    let mut gravity = Vec3::zeros();
    gravity[dimensions - 1] = -GRAVITY;
    Parts {
        dimensions,
        spacing,
        positions,
        velocities: Vec::new(),
        liquid: Liquid { density: DENSITY, sound_speed },
        formulation,
        gravity,
        start: Start::Hydrostatic,
        walls: Vec::new(),
        structures: Vec::new(),
        domain: None,
        threads: 1,
    }
}

/// A basin from the origin on, without a lid.
pub fn basin(
    size: [f64; 3],
    dimensions: usize,
    spacing: f64,
    formulation: &Formulation,
) -> Result<Wall, Box<dyn Error>> {
    let high = Vec3::from(size);
    let open = OPEN_TOP[dimensions - 2];
    let points = basin_rows(&Vec3::zeros(), &high, open, dimensions, spacing, rows(formulation))?;
    Ok(Wall { points, motion: None })
}

/// The box round a basin that no drop may leave: through its walls by less than a spacing, far over its edge.
pub fn domain(size: [f64; 3], dimensions: usize, spacing: f64) -> [Vec3; 2] {
    let mut high = Vec3::from(size) + Vec3::from([spacing; 3]);
    high[dimensions - 1] = 5.0 * size[dimensions - 1];
    [Vec3::from([-spacing; 3]), high]
}

/// What a march of a fluid was.
#[derive(Clone, Debug)]
pub struct Marched {
    started: Instant,
    /// Steps done, up to the last record of one that failed.
    pub steps: u64,
    /// Time of the last record \[T\].
    pub until: f64,
    /// Errors of its energy balance over its greatest energy.
    pub balanced: Balanced,
    /// The greatest of them \[F L; F in a plane\].
    pub missing: f64,
    /// Why it did not reach its end.
    pub failure: Option<String>,
}

/// Marches a fluid without damping at its own stable step and shows it at equal intervals.
pub fn march(
    fluid: &mut Fluid,
    duration: f64,
    record_every: f64,
    mut show: impl FnMut(&mut Fluid, &Record),
) -> Marched {
    let started = Instant::now();
    let (mut balanced, mut missing, mut last) = (Balanced::default(), 0.0_f64, None);
    let run = Transient { duration, record_every, damping: 0.0, safety: 1.0 };
    let mut led = || {
        let mut march = March::start(run, fluid)?;
        while let Some(record) = march.next_record(fluid)? {
            balanced.see(&record);
            missing = missing.max(record.balance_error.abs());
            last = Some(record);
            show(fluid, &record);
        }
        Ok::<_, MarchError>(march.clock().clone())
    };
    let ended = led();
    let (steps, until) = match &ended {
        Ok(clock) => (clock.steps, clock.now.time),
        Err(_) => last.map_or((0, 0.0), |record: Record| (record.step, record.at.time)),
    };
    Marched { started, steps, until, balanced, missing, failure: ended.err().map(|error| error.to_string()) }
}

impl Marched {
    /// What the march leaves behind, to be given a curve or a row of figures.
    pub fn outcome(&self, fluid: &mut Fluid) -> Outcome {
        let wall_seconds = self.started.elapsed().as_secs_f64();
        let count = fluid.len();
        Outcome {
            solver: Solver::Explicit,
            particles: count,
            spacing: fluid.spacing(),
            dof: fluid.dimensions() * count,
            steps: self.steps,
            threads: 1,
            wall_seconds,
            particle_steps_per_second: count as f64 * self.steps as f64 / wall_seconds,
            stable_step: fluid.stable_step(1.0).map_or(0.0, |step| step.dt),
            failure: self.failure.clone(),
            ..Outcome::default()
        }
    }
}

/// Two columns of a reference as points, by the numbers of the columns.
pub fn published(name: &str, [x, y]: [usize; 2]) -> Result<Vec<(f64, f64)>, JudgeError> {
    let table = reference(name)?;
    let column = |number: usize| match table.columns.get(number) {
        Some(column) => table.column(&column.name),
        None => table.column(&format!("number {number}")),
    };
    Ok(column(x)?.into_iter().zip(column(y)?).collect())
}

/// The ordinate of points with growing abscissae, linear between them, the first of equal ones; none beyond their ends.
pub fn between(points: &[(f64, f64)], at: f64) -> Option<f64> {
    let right = points.partition_point(|&(x, _)| x < at).max(1);
    let (&(x0, y0), &(x1, y1)) = (points.get(right - 1)?, points.get(right)?);
    (x0 <= at && at <= x1).then(|| if x1 > x0 { y0 + (y1 - y0) * (at - x0) / (x1 - x0) } else { y0 })
}

/// The mean of points over a range of abscissae by the trapezoidal rule between its ends.
pub fn mean(points: &[(f64, f64)], [from, to]: [f64; 2]) -> Option<f64> {
    let mut inside = vec![(from, between(points, from)?)];
    inside.extend(points.iter().filter(|(x, _)| *x > from && *x < to));
    inside.push((to, between(points, to)?));
    let area: f64 =
        inside.windows(2).map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1)).sum();
    Some(area / (to - from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_of_straight_lines_are_exact_between_points() {
        let line: Vec<(f64, f64)> = [0.0, 0.3, 1.0, 2.0].map(|x| (x, 1.0 + 2.0 * x)).to_vec();
        assert!((mean(&line, [0.1, 1.7]).unwrap() - 2.8).abs() < 1e-15);
        assert_eq!(between(&line, 0.15), Some(1.3));
        assert_eq!((between(&line, 2.1), between(&line, -0.1)), (None, None));
        assert_eq!(mean(&line, [0.0, 2.1]), None);
        assert_eq!(between(&[(0.0, 1.0), (0.0, 3.0), (1.0, 5.0)], 0.0), Some(1.0));
    }

    #[test]
    fn boxes_are_filled_from_half_a_spacing_on() {
        let plane = filled([0.0; 3], [1.0, 0.5, 9.0], 2, 0.25);
        assert_eq!((plane.len(), plane[0]), (8, Vec3::new(0.125, 0.125, 0.0)));
        assert_eq!(filled([0.0; 3], [1.0, 0.5, 0.75], 3, 0.25).len(), 24);
    }
}
