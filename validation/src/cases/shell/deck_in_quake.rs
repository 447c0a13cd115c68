//! deck-in-quake: a heavy deck on a wall of timber under a record of its ground's acceleration.
//!
//! ```text
//!   ██ m   w     ü + 2ζω u̇ + ω² u = −Γ a(t)      straight lines between the points of a: exact from one to the next
//!   ┃
//!   ┃
//!  ▔▔▔ ↔ a
//! ```

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::CELL;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/deck-in-quake.toml");
const OFF: &str = "way of the deck, worst over its greatest";

/// Errors \[%\].
const WAY: Measured = Measured(&[(CELL, &[("9×3", 1.30), ("17×3", 0.307), ("33×3", 0.0634)])]);

const GRAVITY: f64 = 9.80665;
const LENGTH: f64 = 4.0;
const BENDING: f64 = 12e9 * 0.5 * 0.15 * 0.15 * 0.15 / 12.0;
const SHEAR: f64 = 5.0 / 6.0 * 6e9 * 0.5 * 0.15;
const DECK: f64 = 2000.0;
const WALL: f64 = 450.0 * 0.5 * 0.15 * LENGTH;
const DAMPING: f64 = 0.624;
const STEP: f64 = 0.02;

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let on = |grid: &str, along: u32| {
        Variant::scene(CELL, SCENE, grid).set("geometry.plate.particles", format!("[{along}, 3]"))
    };
    Case {
        name: "deck-in-quake",
        title: "A deck on a wall in an earthquake",
        about: "The deck's way with respect to the ground at 601 records over 12 s of a record of 8 s in g, whose baseline is straightened: against one degree of \
                freedom with the mass of the deck and 33/140 of the wall's, and the stiffness of the wall in bending and shear.",
        citation: "[nigam1969]: the exact recurrence for straight lines between the points of a record",
        variants: vec![on("9×3", 9).quick_if(true), on("17×3", 17), on("33×3", 33)],
        each,
        headline: Some(Headline::new(OFF, 0.5)),
        ..Case::default()
    }
}

/// The record of the scene \[m/s²\], with a straight line taken off by which the ground ends at rest where it began.
fn record() -> Vec<f64> {
    let numbers =
        SCENE.split_once("SEC\n").and_then(|(_, rest)| rest.split_once("\"\"\"")).map_or("", |(own, _)| own);
    let a: Vec<f64> =
        numbers.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).map(|x| GRAVITY * x).collect();
    let [mut v, mut u] = [0.0; 2];
    for pair in a.windows(2) {
        u += STEP * (v + STEP * (2.0 * pair[0] + pair[1]) / 6.0);
        v += 0.5 * STEP * (pair[0] + pair[1]);
    }
    let whole = STEP * (a.len() - 1) as f64;
    let (v, u) = (v / whole, u / (whole * whole));
    let line = |i: usize| 6.0 * u - 2.0 * v + (6.0 * v - 12.0 * u) / whole * STEP * i as f64;
    a.iter().enumerate().map(|(i, x)| x - line(i)).collect()
}

/// Ways at so many points of time, from rest.
fn ways(count: usize) -> Vec<f64> {
    let ground = record();
    let at = |i: usize| ground.get(i).copied().unwrap_or_default();
    let stiffness = 1.0 / (LENGTH.powi(3) / (3.0 * BENDING) + LENGTH / SHEAR);
    let mass = DECK + 33.0 / 140.0 * WALL;
    let share = (DECK + 3.0 / 8.0 * WALL) / mass;
    let omega = (stiffness / mass).sqrt();
    let decay = 0.5 * DAMPING;
    let damped = (omega * omega - decay * decay).sqrt();
    let (sin, cos) = libm::sincos(damped * STEP);
    let kept = libm::exp(-decay * STEP);
    let [mut x, mut v] = [0.0; 2];
    let mut found = vec![0.0];
    for i in 0..count.saturating_sub(1) {
        let (load, rate) = (-share * at(i), -share * (at(i + 1) - at(i)) / STEP);
        let by_time = rate / (omega * omega);
        let by_one = (load - DAMPING * by_time) / (omega * omega);
        let p = x - by_one;
        let q = (v - by_time + decay * p) / damped;
        x = by_one + by_time * STEP + kept * (p * cos + q * sin);
        v = by_time + kept * (damped * (q * cos - p * sin) - decay * (p * cos + q * sin));
        found.push(x);
    }
    found
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    // In millimetres.
    let found = run.column("w_deck")?;
    let exact = ways(found.len());
    let size = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = found.iter().zip(&exact).map(|(w, x)| (1e-3 * w - x).abs()).fold(0.0, f64::max);
    let off = run.done().then(|| 100.0 * off / size);
    let reason = "three times the error of the lattice, whose stiffness, and so the time of a swing, converges with the square of the spacing";
    Ok(vec![Metric::error(OFF, off, "%").near(WAY.of(run)?, reason)])
}
