//! flap-on-sill: an elastic flap that water presses on a sill below its foot.
//!
//! ```text
//!  ~~~~~~~~~▐
//!   water   ┃
//!           ┃●
//!  ▁▁▁▁▁▁▁▁▁▁▁▁
//! ```

use crate::Metric;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::CELL;

const SCENE: &str = include_str!("../../../../scenes/gate-on-sill.toml");
const NAME: &str = "force on the sill over the thrust";
/// A sill that touches the foot alone, where a beam is propped.
const SILL: &str =
    "[{ name = 'sill', cylinder = { point = [0.112, 0, 0], axis = [0, 0, 1], radius = 0.005 } }]";

// The flap, its way to the sill, and the water above its top [m].
const LENGTH: f64 = 0.079;
const THICKNESS: f64 = 0.005;
const WIDTH: f64 = 0.02;
const GAP: f64 = 0.002;
const ABOVE: f64 = 0.061;
/// Modulus [Pa] and Poisson's ratio of the flap, weight of the water [N/m³].
const MODULUS: f64 = 12e6;
const POISSON: f64 = 0.4;
const WEIGHT: f64 = 9810.0;
/// The first water of the shut flap is left out [s].
const SETTLED: f64 = 0.1;

/// Error \[%\].
const MEASURED: Measured = Measured(&[(CELL, &[("41×2", 0.9)])]);

/// The scene, the beam, and how far the two may differ.
pub fn case() -> Case {
    let variant = Variant::scene(CELL, SCENE, "41×2")
        .set("contact", "[]")
        .set("bodies.flap.shell.tools", SILL)
        .set("output", "{}");
    Case {
        name: "flap-on-sill",
        title: "Flap that water presses on a sill",
        about: "Water presses a rubber flap that hangs from a lintel two millimetres on, where a round sill stops its foot. The water swings \
                with its own speed of sound; the mean force on the sill is held against that of a propped beam under the mean thrust.",
        citation: "Bernoulli's beam in plane strain",
        variants: vec![variant.judged(|run, _| judged(run))],
        headline: Some(Headline::new(NAME, 0.02)),
        ..Case::default()
    }
}

/// A cantilever under even and growing pressure, and what holds its foot back at the gap:
/// `(R + k g)/T` with `k = 3B/L³`, T the thrust.
fn exact() -> f64 {
    let bending = MODULUS / (1.0 - POISSON * POISSON) * THICKNESS.powi(3) / 12.0;
    let (even, growing) = (WEIGHT * ABOVE, WEIGHT * LENGTH);
    let free = (even / 8.0 + growing * 11.0 / 120.0) * LENGTH.powi(4) / bending;
    back() * free / ((even + 0.5 * growing) * LENGTH)
}

/// Force on the foot by its displacement \[N/m\].
fn back() -> f64 {
    let bending = MODULUS / (1.0 - POISSON * POISSON) * THICKNESS.powi(3) / 12.0;
    3.0 * bending / LENGTH.powi(3) * WIDTH
}

fn judged(run: &Run) -> Result<Vec<Metric>, crate::JudgeError> {
    let times = run.column("time")?;
    let mean = |name: &str| -> Result<f64, crate::JudgeError> {
        let found = run.column(name)?;
        let settled = found.iter().zip(&times).filter(|(_, time)| **time >= SETTLED);
        let all: Vec<f64> = settled.map(|(value, _)| *value).collect();
        Ok(all.iter().sum::<f64>() / all.len() as f64)
    };
    let found = (mean("sill")? + back() * GAP) / mean("water_mean")?;
    let error = 100.0 * (found / exact() - 1.0).abs();
    let reason = "the pressure of water that swings is not that of water at rest";
    Ok(vec![Metric::error(NAME, Some(error), "%").near(MEASURED.of(run)?, reason)])
}
