//! column-solid: the cantilever's first frequency, and its buckling as a column by two laws.

use std::f64::consts::PI;

use super::{INCREMENTS, ST_VENANT};
use crate::judge::{Case, Headline, Recorded, Run, Runs, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cantilever-solid.toml");
const YOUNG: f64 = 82.74;
const POISSON: f64 = 0.2;
const DENSITY: f64 = 1e-9;
const LENGTH: f64 = 254.0;
const HEIGHT: f64 = 25.4;

const FREQUENCY: &str = "first frequency";
const LEVEL: &str = "buckling pressure";
const LAW: (&str, &str) = ("bodies.beam.solid.formulation.galerkin.law", "st-venant");
const PUSHED: (&str, &str) = ("loads", "[{ on = \"x1\", traction = { value = [-1.0, 0.0, 0.0] } }]");

/// The cantilever as an oscillator and as a column, and how far it may be from beams.
pub fn case() -> Case {
    Case {
        name: "column-solid",
        title: "Frequency and buckling of the cantilever as a solid of 21×3×3 nodes",
        about: "Its first frequency is a slender beam's less shear and rotatory inertia. Pushed along its axis it buckles at Euler's load \
                less shear (Engesser). The two laws differ there by their second order: under a strain −ε the modulus of logarithmic \
                strain is E(1 + 3ε), that of St Venant's law E(1 − 3ε).",
        citation: "Euler and Bernoulli; Engesser 1889; moduli derived beside the case",
        variants: vec![
            turned_to("analysis.modal", "{ modes = 2 }", INCREMENTS, &[("loads", "[]")]).judged(frequency),
            turned_to("analysis.buckling", "{ modes = 2 }", INCREMENTS, &[PUSHED]).judged(buckling),
            turned_to("analysis.buckling", "{ modes = 2 }", ST_VENANT, &[PUSHED, LAW]).judged(buckling),
        ],
        together,
        headline: Some(Headline::new(LEVEL, 0.01)),
        ..Case::default()
    }
}

/// The scene with another analysis and nothing to measure.
fn turned_to(analysis: &str, options: &str, method: &str, set: &[(&str, &str)]) -> Variant {
    let grid = analysis.trim_start_matches("analysis.").to_owned();
    let scene =
        Variant::scene(method, SCENE, &grid).set(analysis, options).set("curve", "[]").set("output", "{}");
    set.iter().fold(scene, |scene, (path, value)| scene.set(path, value)).quick()
}

fn frequency(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    // β₁² √(EI/ρA)/(2π L²) with β₁ = 1.8751, √(I/A) = h/√12
    let slender = 1.8751_f64.powi(2) * (YOUNG / DENSITY).sqrt() * HEIGHT
        / 12.0_f64.sqrt()
        / (2.0 * PI * LENGTH * LENGTH);
    let found = Metric::compared(FREQUENCY, run.column("frequency")?.first().copied(), "1/s", slender);
    Ok(vec![found.within(
        0.01 * slender,
        "measured −.3 %: shear and rotatory inertia take .6, the mesh gives .4 back",
    )])
}

/// Euler's stress of a cantilever, and with shear: P/(1 + P/(k G A)), k = 5/6.
fn column() -> [f64; 2] {
    let euler = PI * PI * YOUNG * HEIGHT * HEIGHT / (48.0 * LENGTH * LENGTH);
    let shear = 5.0 / 6.0 * YOUNG / (2.0 * (1.0 + POISSON));
    [euler, euler / (1.0 + euler / shear)]
}

fn buckling(run: &Run, _: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let [_, engesser] = column();
    let found = Metric::compared(LEVEL, run.column("level")?.first().copied(), "N/mm²", engesser);
    let reason = "measured +1.5 and +.3 %: the law's modulus under compression is ±.6, the mesh and the clamp stiffen by .9";
    Ok(vec![found.within(0.025 * engesser, reason)])
}

/// The ratio of the laws' loads: 1 + 6ε, ε the strain of the column when it buckles.
fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let (Some(at), Some(other)) = (runs.number(INCREMENTS, "buckling")?, runs.get(ST_VENANT, "buckling")?)
    else {
        return Ok(Vec::new());
    };
    let ours = runs.chosen[at].column("level")?.first().copied();
    let ratio = ours.zip(other.column("level")?.first().copied()).map(|(ours, other)| ours / other);
    let [euler, _] = column();
    let metric = Metric::compared("load over that of St Venant's law", ratio, "-", 1.0 + 6.0 * euler / YOUNG);
    Ok(vec![(
        at,
        metric.within(
            5e-4,
            "measured 1e-4: what is left is of the second order of the strain, 4e-6, and shear",
        ),
    )])
}
