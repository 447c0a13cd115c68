//! The source's own scheme on the cantilever: one linear answer a step, what is left out of balance goes into the next.

use std::time::Instant;

use implicit_statics::Equilibrium;
use sph_core::Vec3;
use sr_galerkin::{Galerkin, OneSolve};

use crate::JudgeError;
use crate::judge::{Metric, Outcome, Run, Variant};
use crate::support::marched::in_time;
use crate::support::studies::galerkin;

/// Name of the scheme in tables.
pub const ONE_SOLVE: &str = "galerkin, one solve a step";
/// Level that the runs end at.
const LAST: usize = 10;
/// Where steps stand that the prototype has figures of: steps, w/L at K = 1 and K = 10.
const PROTOTYPE: [(usize, f64, f64); 2] = [(20, 0.0779, 0.7421), (100, 0.1233, 0.7488)];

/// A scene led by the scheme, in so many equal steps.
pub fn led(scene: Variant, steps: usize) -> Variant {
    let built = scene.clone();
    let grid = format!("{}, {steps} steps", scene.grid);
    let run = move || lead(&mut galerkin(&built)?, steps);
    Variant::study(ONE_SOLVE, &grid, run)
}

/// Figures of the prototype for so many steps.
///
/// # Errors
/// Of the curve.
pub fn judged(run: &Run, steps: usize) -> Result<Vec<Metric>, JudgeError> {
    let Some((_, first, last)) = PROTOTYPE.into_iter().find(|row| row.0 == steps) else {
        return Ok(Vec::new());
    };
    let at = |k: f64| run.at("w", k);
    let digits = "four digits are known";
    let end = Metric::compared("w/L at K = 10", at(10.0)?, "-", last);
    Ok(vec![
        Metric::compared("w/L at K = 1", at(1.0)?, "-", first).within(1e-4, digits),
        if steps == 100 {
            end.within(1e-4, digits)
        } else {
            end.shown("not reproduced: steps of .5 let the last digits depend on when the loads are taken")
        },
        Metric::error("left out of balance, greatest", greatest(run)?, "of the load")
            .shown("nothing iterates for balance"),
    ])
}

fn greatest(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(run.column("left")?.into_iter().reduce(f64::max))
}

fn lead(body: &mut Galerkin, steps: usize) -> Result<Outcome, String> {
    let shown = |error: &dyn std::error::Error| error.to_string();
    let start = Instant::now();
    let mut scheme = OneSolve::new(body).map_err(|error| shown(&error))?;
    let tip = tip(body);
    let long = body.rest()[tip].x;
    let level = |step: usize| (LAST * step) as f64 / steps as f64;
    let mut rows = vec![vec![0.0; 3]];
    for step in 1..=steps {
        let left = scheme.step(body, (level(step - 1), level(step))).map_err(|error| shown(&error))?;
        rows.push(vec![level(step), -body.displacement(tip).z / long, left]);
    }
    Ok(Outcome {
        curve: in_time(&[("level", "-"), ("w", "L"), ("left", "-")], rows),
        particles: body.nodes(),
        dof: body.unknowns(),
        steps: steps as u64,
        threads: 1,
        wall_seconds: start.elapsed().as_secs_f64(),
        ..Outcome::default()
    })
}

/// The node at the end of the axis.
fn tip(body: &Galerkin) -> usize {
    let rest = body.rest();
    let high = rest.iter().fold(Vec3::zeros(), |most, x| most.sup(x));
    let axis = Vec3::new(high.x, 0.5 * high.y, 0.5 * high.z);
    let off = |a: &usize| (rest[*a] - axis).norm();
    (0..rest.len()).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
}
