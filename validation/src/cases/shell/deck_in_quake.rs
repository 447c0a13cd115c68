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

pub(super) const SCENE: &str = include_str!("../../../../scenes/deck-in-quake.toml");
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

/// The record of the scene \[m/s²\], whose last number is zero, with a straight line taken off all others by which the ground is at rest where it began at that
/// zero.
///
/// Of a number at the time t, the hat about it moves the ground at the end T to a velocity of h and a way of h (T − t); the half hat at time zero to h/2 and
/// h T/2 − h²/6.
fn record() -> Vec<f64> {
    let numbers =
        SCENE.split_once("SEC\n").and_then(|(_, rest)| rest.split_once("\"\"\"")).map_or("", |(own, _)| own);
    let mut a: Vec<f64> =
        numbers.split_whitespace().filter_map(|word| word.parse::<f64>().ok()).map(|x| GRAVITY * x).collect();
    a.pop();
    let end = STEP * a.len() as f64;
    let sums = |of: &dyn Fn(usize) -> f64| {
        let hats = (1..a.len()).map(|i| [of(i), of(i) * (end - STEP * i as f64)]);
        let first = [0.5 * of(0), of(0) * (0.5 * end - STEP / 6.0)];
        hats.fold(first, |[v, u], [dv, du]| [v + dv, u + du]).map(|sum| STEP * sum)
    };
    let [[v, u], [v0, u0], [v1, u1]] = [sums(&|i| a[i]), sums(&|_| 1.0), sums(&|i| STEP * i as f64)];
    let determinant = v0 * u1 - v1 * u0;
    let line = [(v * u1 - u * v1) / determinant, (v0 * u - u0 * v) / determinant];
    let straight = a.iter().enumerate().map(|(i, x)| x - line[0] - line[1] * STEP * i as f64);
    straight.chain([0.0]).collect()
}

/// The greatest way, of ways at every twentieth of a step of the record: that falls short of an extreme by 1e-5 at most, half of the square of the phase between.
pub(super) fn greatest_way() -> f64 {
    ways(20 * 600, 20).into_iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Ways at so many points of time from rest, so many of them in a step of the record.
fn ways(count: usize, parts: usize) -> Vec<f64> {
    let ground = record();
    let step = STEP / parts as f64;
    let point = |i: usize| ground.get(i).copied().unwrap_or_default();
    let at = |k: usize| {
        let (i, share) = (k / parts, (k % parts) as f64 / parts as f64);
        (1.0 - share) * point(i) + share * point(i + 1)
    };
    let stiffness = 1.0 / (LENGTH.powi(3) / (3.0 * BENDING) + LENGTH / SHEAR);
    let mass = DECK + 33.0 / 140.0 * WALL;
    let share = (DECK + 3.0 / 8.0 * WALL) / mass;
    let omega = (stiffness / mass).sqrt();
    let decay = 0.5 * DAMPING;
    let damped = (omega * omega - decay * decay).sqrt();
    let (sin, cos) = libm::sincos(damped * step);
    let kept = libm::exp(-decay * step);
    let [mut x, mut v] = [0.0; 2];
    let mut found = vec![0.0];
    for i in 0..count.saturating_sub(1) {
        let (load, rate) = (-share * at(i), -share * (at(i + 1) - at(i)) / step);
        let by_time = rate / (omega * omega);
        let by_one = (load - DAMPING * by_time) / (omega * omega);
        let p = x - by_one;
        let q = (v - by_time + decay * p) / damped;
        x = by_one + by_time * step + kept * (p * cos + q * sin);
        v = by_time + kept * (damped * (q * cos - p * sin) - decay * (p * cos + q * sin));
        found.push(x);
    }
    found
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    // In millimetres.
    let found = run.column("w_deck")?;
    let exact = ways(found.len(), 1);
    let size = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = found.iter().zip(&exact).map(|(w, x)| (1e-3 * w - x).abs()).fold(0.0, f64::max);
    let off = run.done().then(|| 100.0 * off / size);
    let reason = "three times the error of the lattice, whose stiffness, and so the time of a swing, converges with the square of the spacing";
    Ok(vec![Metric::error(OFF, off, "%").near(WAY.of(run)?, reason)])
}
