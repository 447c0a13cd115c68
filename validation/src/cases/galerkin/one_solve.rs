//! The source's own scheme on the cantilever: one linear answer a step, what is left out of balance goes into the next.

use crate::JudgeError;
use crate::judge::{Metric, Run, Variant};

/// Name of the scheme in tables.
pub const ONE_SOLVE: &str = "galerkin, one solve a step";
/// Level that the runs end at.
const LAST: usize = 10;
/// Where steps stand that the prototype has figures of: steps, w/L at K = 1 and K = 10.
const PROTOTYPE: [(usize, f64, f64); 2] = [(20, 0.0779, 0.7421), (100, 0.1233, 0.7488)];

/// A scene led by the scheme, in so many equal steps.
pub fn led(scene: Variant, steps: usize) -> Variant {
    let levels: Vec<f64> = (1..=steps).map(|step| (LAST * step) as f64 / steps as f64).collect();
    let grid = format!("{}, {steps} steps", scene.grid);
    let led = scene.named(grid).static_levels(&levels).set("analysis.static.one_solve", true).unsettled();
    Variant { method: ONE_SOLVE.into(), ..led }
}

/// Figures of the prototype for so many steps, and the error that the scheme tells of itself.
///
/// # Errors
/// Of the curve.
pub fn judged(run: &Run, steps: usize, balanced: f64) -> Result<Vec<Metric>, JudgeError> {
    let Some((_, first, last)) = PROTOTYPE.into_iter().find(|row| row.0 == steps) else {
        return Ok(Vec::new());
    };
    let at = |k: f64| run.at("w", k);
    let digits = "four digits are known";
    let end = Metric::compared("w/L at K = 10", at(10.0)?, "-", last);
    let (reported, found) = (run.at("remaining_displacement", 1.0)?, at(1.0)?);
    let share = reported.zip(found).map(|(reported, w)| reported * w / (balanced - w).abs());
    Ok(vec![
        Metric::compared("w/L at K = 1", found, "-", first).within(1e-4, digits),
        if steps == 100 {
            end.within(1e-4, digits)
        } else {
            end.shown("not reproduced: steps of .5 let the last digits depend on when the loads are taken")
        },
        Metric::compared("error estimated at K = 1, over the true one", share, "-", 1.0).shown(
            "of the order of itself where a step is long: one more solve would not reach balance either",
        ),
        Metric::error("left out of balance, greatest", greatest(run)?, "of the load")
            .shown("nothing iterates for balance"),
    ])
}

fn greatest(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(run.column("unbalanced")?.into_iter().reduce(f64::max))
}
