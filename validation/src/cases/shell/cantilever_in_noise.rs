//! cantilever-in-noise: a cantilever whose clamp is shaken by white noise over its first three modes of bending.
//!
//! ```text
//!  ▐━━━━━━━━━━━━   σ² = ∫ |H(f)|² G df      K (1 + iη)
//!  ↕ G          ↕ w
//! ```

use std::f64::consts::TAU;
use std::sync::Arc;

use coque::{Column, Silent};

use super::cantilever_shaken::BEAM;
use crate::judge::{Case, Headline, Measured, Outcome, Problem, Run, Variant};
use crate::methods::STATIC;
use crate::support::studies::model;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cantilever-shaken.toml");
const WORST: &str = "worst root mean square";
const RATE: &str = "crossings of zero by time";
/// The noise, of a density of one.
const BAND: [f64; 2] = [5.0, 500.0];
/// Points of the trapezoidal rule, equal in the logarithm: 870 within half of the width of a peak.
const POINTS: usize = 200_000;

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const ROOTS: Measured = Measured(&[
    (STATIC, &[("81×5", 0.0277), ("201×5", 0.00234)]),
]);
#[rustfmt::skip]
const RATES: Measured = Measured(&[
    (STATIC, &[("81×5", 0.00134), ("201×5", 0.000164)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let noise = "{ random-vibration = { modes = 12, damping.structural = 0.04, frequencies = [16.75], \
                 base = [{ acceleration = [0.0, 0.0, 1.0], density = [[5.0, 1.0], [500.0, 1.0]] }] } }";
    let accelerated = "{ name = \"a\", of = \"acceleration\", on = \"u1\", direction = [0.0, 0.0, 1.0] }";
    let on = |grid: &str, particles: &str| {
        summed(
            Variant::scene(STATIC, SCENE, grid)
                .set("geometry.plate.particles", particles)
                .set("analysis", noise)
                .set("curve[+]", accelerated),
        )
    };
    Case {
        name: "cantilever-in-noise",
        title: "A cantilever in noise",
        about: "Root mean squares of the way of the end of a strip with respect to its clamp, and of its acceleration, under white noise of the clamp from 5 to 500 Hz, over \
                three modes of bending; how often the way crosses zero.",
        citation: "[timoshenko1921], with complex moduli: the transfer functions of a clamped beam in closed form, integrated over frequency",
        variants: vec![on("81×5", "[81, 5]"), on("201×5", "[201, 5]")],
        each,
        headline: Some(Headline::new(WORST, 0.5)),
        ..Case::default()
    }
}

/// The run, whose curve has further columns: root mean squares, and crossings of zero.
fn summed(scene: Variant) -> Variant {
    let built = scene.clone();
    let run = move || {
        let mut outcome = model(&built, 1)?.run(&mut Silent);
        let noise = outcome.summary.vibration.as_ref().map(|all| all.noise.clone()).unwrap_or_default();
        for own in noise {
            let [root, rate] = ["rms", "rate"].map(|word| format!("{}_{word}", own.column.name));
            outcome.curve.columns.push(Column { name: root, ..own.column });
            outcome.curve.columns.push(Column { name: rate, unit: "1/s".into() });
            for row in &mut outcome.curve.rows {
                row.extend([own.root_mean_square, own.crossings.unwrap_or_default()]);
            }
        }
        Ok(Outcome::from(outcome))
    };
    Variant { source: Problem::Study(Arc::new(run)), settles: false, ..scene }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    // Mean squares of way, its rate, and acceleration in space.
    let mut exact = [0.0; 3];
    let width = libm::log(BAND[1] / BAND[0]) / POINTS as f64;
    for i in 0..=POINTS {
        let frequency = BAND[0] * libm::exp(width * i as f64);
        let omega = TAU * frequency;
        let way = BEAM.relative(omega);
        let mut space = way * (-omega * omega);
        space.re += 1.0;
        let weight = width * frequency * if i == 0 || i == POINTS { 0.5 } else { 1.0 };
        let powers = [way.square(), omega * omega * way.square(), space.square()];
        exact.iter_mut().zip(powers).for_each(|(sum, power)| *sum += weight * power);
    }
    let last = |name: &str| Ok::<f64, JudgeError>(run.column(name)?.last().copied().unwrap_or_default());
    let off = |found: f64, exact: f64| (found / exact - 1.0).abs();
    let worst = off(last("tip_rms")?, exact[0].sqrt()).max(off(last("a_rms")?, exact[2].sqrt()));
    let rate = off(last("tip_rate")?, (exact[1] / exact[0]).sqrt() / TAU);
    let percent = |value: f64| run.done().then_some(100.0 * value);
    let reason = "three times the errors of the lattice: the mean square of a mode under white noise goes with the third power of its time, which converges with the square of the spacing";
    Ok(vec![
        Metric::error(WORST, percent(worst), "%").near(ROOTS.of(run)?, reason),
        Metric::error(RATE, percent(rate), "%").near(RATES.of(run)?, reason),
    ])
}
