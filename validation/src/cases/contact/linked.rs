//! linked: a mass between stops, on a hardening spring, on a dashpot; a slider and its crank.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::judge::{Case, Run, Variant};
use crate::methods::RIGID;
use crate::{JudgeError, Metric};

const STOPS: &str = include_str!("../../../../scenes/mass-between-stops.toml");
const CRANK: &str = include_str!("../../../../scenes/slider-crank.toml");

/// Mass \[kg\], stiffness behind the gaps \[N/m\], gap \[m\], velocity \[m/s\].
const MASS: f64 = 2.0;
const STIFFNESS: f64 = 800.0;
const GAP: f64 = 0.05;
const SPEED: f64 = 1.0;
/// The hardening spring, `α x + β x³` \[N/m, N/m³\].
const ALPHA: f64 = 200.0;
const BETA: f64 = 20000.0;
/// The dashpot \[N s/m\].
const DAMPING: f64 = 16.0;
/// Pin of the crank and length of the rod \[m\].
const PIN: f64 = 0.1;
const ROD: f64 = 0.3;

/// The scenes, their closed forms, and how far the two may differ.
pub fn case() -> Case {
    let mass = |links: String, words: &str| {
        Variant::scene(RIGID, STOPS, words)
            .set("links", links)
            .set("analysis.explicit.transient.duration", 1.0)
    };
    let along = "on = 'mass.all', direction = [1, 0, 0]";
    let table = (-40..=40).map(|i| 0.005 * f64::from(i)).map(|e| [e, ALPHA * e + BETA * e * e * e]);
    let table = format!("[{{ {along}, table = {:?} }}]", table.collect::<Vec<_>>());
    let gap = format!("[{{ {along}, stiffness = {STIFFNESS}, gap = {GAP} }}]");
    let damped = format!("[{{ {along}, stiffness = {STIFFNESS} }}, {{ {along}, damping = {DAMPING} }}]");
    Case {
        name: "linked",
        title: "Links and joints of rigid bodies",
        about: "A mass between two stops behind gaps, on a hardening spring by its table, on a spring with a dashpot beside it: periods and decay. A flywheel that \
                leads a piston by three hinges and a slider.",
        citation: "closed forms; the period of Duffing's oscillator by the complete elliptic integral",
        variants: vec![
            mass(gap, "between stops").judged(|run, _| {
                let exact = 4.0 * GAP / SPEED + 2.0 * PI * (MASS / STIFFNESS).sqrt();
                period(run, exact, 1e-4, "three times what steps of a hundredth of a record leave, 2.1e-5 %")
            }),
            mass(table, "hardening").judged(|run, _| {
                period(
                    run,
                    hardening(),
                    0.075,
                    "three times what the chords of 81 points are too stiff, .025 %",
                )
            }),
            mass(damped, "with a dashpot").judged(|run, _| decay(run)),
            Variant::scene(RIGID, CRANK, "slider and crank").judged(|run, _| piston(run)),
        ],
        ..Case::default()
    }
}

/// The time between two crossings upwards, of which the first is at the start.
fn period(run: &Run, exact: f64, within: f64, reason: &str) -> Result<Vec<Metric>, JudgeError> {
    let (time, x) = (run.column("time")?, run.column("x")?);
    let up = |i: &usize| time[*i] > 0.6 * exact && x[*i] <= 0.0 && x[i + 1] > 0.0;
    let at = |i: usize| time[i] + (time[i + 1] - time[i]) * x[i] / (x[i] - x[i + 1]);
    let found = (0..time.len().saturating_sub(1)).find(up).map(|i| 100.0 * (at(i) / exact - 1.0));
    Ok(vec![Metric::error("period", found, "%").within(within, reason)])
}

/// `4 K(m)/√((α + βA²)/M)` with `m = βA²/2(α + βA²)` and `½ M v² = ½ α A² + ¼ β A⁴`.
fn hardening() -> f64 {
    let square = (-ALPHA + (ALPHA * ALPHA + 2.0 * BETA * MASS * SPEED * SPEED).sqrt()) / BETA;
    let stiff = ALPHA + BETA * square;
    let (mut a, mut b) = (1.0, (1.0 - 0.5 * BETA * square / stiff).sqrt());
    for _ in 0..10 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    4.0 * FRAC_PI_2 / a / (stiff / MASS).sqrt()
}

/// Against `v/ω_d e^{−ζωt} sin ω_d t`, over v/ω_d.
fn decay(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let w = (STIFFNESS / MASS).sqrt();
    let rate = 0.5 * DAMPING / MASS;
    let wd = (w * w - rate * rate).sqrt();
    let exact = |t: f64| libm::exp(-rate * t) * libm::sin(wd * t);
    let (time, x) = (run.column("time")?, run.column("x")?);
    let off = time.iter().zip(&x).map(|(t, x)| 100.0 * (x * wd / SPEED - exact(*t)).abs());
    let reason = "three times what steps of a hundredth of a record leave, 4.4e-5 %";
    let worst = off.reduce(f64::max).filter(|_| run.done());
    Ok(vec![Metric::error("greatest error of the way", worst, "%").within(1.3e-4, reason)])
}

/// Against `r cos φ + √(l² − r² sin² φ)`, over the pin.
fn piston(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (turn, x) = (run.column("turn")?, run.column("x")?);
    let exact = |turn: f64| {
        let (sin, cos) = libm::sincos(turn);
        PIN * cos + (ROD * ROD - (PIN * sin).powi(2)).sqrt() - PIN - ROD
    };
    let off = turn.iter().zip(&x).map(|(turn, x)| 100.0 * (x - exact(*turn)).abs() / PIN);
    let worst = off.reduce(f64::max).filter(|_| run.done());
    let reason = "rounding: constraints are solved in every step";
    Ok(vec![Metric::error("greatest error of the piston", worst, "%").within(1e-9, reason)])
}
