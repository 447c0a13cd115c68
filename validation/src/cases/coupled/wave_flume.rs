//! wave-flume: regular waves that a wall makes, their height, period and length, and what comes back from a beach.

use std::f64::consts::TAU;

use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/wave-flume.toml");
const HEIGHT: &str = "height of the waves";
const PERIOD: &str = "period";
const LENGTH: &str = "length";
/// Height asked of the wall \[m\], period \[s\], depth \[m\], gravity \[m/s²\], distance of the gauges \[m\].
const ASKED: f64 = 0.04;
const TIME: f64 = 1.0;
const DEPTH: f64 = 0.3;
const GRAVITY: f64 = 9.81;
const APART: f64 = 0.4;
/// From when on waves are regular at both gauges, and how many periods are measured.
const FROM: f64 = 3.98;
const PERIODS: f64 = 3.0;

/// The flume, linear theory, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "wave-flume",
        title: "Regular waves in a flume",
        about: "A piston or a flap makes waves by the stroke of the transfer function of the first order; they run past two gauges and out on a beach. Held against linear \
                theory: the height asked for, the period, and the length by the phase between the gauges.",
        citation: "Dean and Dalrymple, Water Wave Mechanics for Engineers and Scientists: dispersion and wave makers of the first order",
        variants: vec![
            Variant::scene(KICKS, SCENE, "piston, 2 spacings high").unsettled().judged(|run, _| judged(run)),
            Variant::scene(KICKS, SCENE, "flap, 2 spacings high")
                .set(
                    "bodies.piston.walls.motion.waves",
                    "{ height = 0.04, period = 1.0, depth = 0.3, hinge = [0.0, 0.0, 0.0] }",
                )
                .unsettled()
                .judged(|run, _| judged(run)),
        ],
        headline: Some(Headline::new(HEIGHT, 0.1)),
        ..Case::default()
    }
}

/// Length of waves by linear theory, `ω² = g k tanh kd`, by halving \[m\].
fn length() -> f64 {
    let wanted = (TAU / TIME) * (TAU / TIME) * DEPTH / GRAVITY;
    let (mut low, mut high) = (1e-3, 50.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if middle * libm::tanh(middle) > wanted {
            high = middle;
        } else {
            low = middle;
        }
    }
    TAU * DEPTH / low
}

/// The first harmonic of a gauge over whole periods: height from trough to crest, and phase.
fn harmonic(time: &[f64], level: &[f64]) -> Option<[f64; 2]> {
    let inside = |t: f64| t > FROM - 1e-9 && t < FROM + PERIODS * TIME - 1e-9;
    let kept: Vec<[f64; 2]> =
        time.iter().zip(level).filter(|(t, _)| inside(**t)).map(|(t, h)| [*t, *h]).collect();
    if kept.is_empty() {
        return None;
    }
    let part = |of: &dyn Fn(f64) -> f64| {
        2.0 / kept.len() as f64 * kept.iter().map(|[t, h]| h * of(TAU * t / TIME)).sum::<f64>()
    };
    let [cosine, sine] = [part(&libm::cos), part(&libm::sin)];
    Some([2.0 * libm::hypot(cosine, sine), libm::atan2(sine, cosine)])
}

/// Mean time between crossings of the mean upwards.
fn period(time: &[f64], level: &[f64]) -> Option<f64> {
    let kept: Vec<[f64; 2]> =
        time.iter().zip(level).filter(|(t, _)| **t > FROM - 1.0).map(|(t, h)| [*t, *h]).collect();
    let mean = kept.iter().map(|[_, h]| h).sum::<f64>() / kept.len() as f64;
    let up = |pair: &[[f64; 2]]| {
        let [[t, x], [u, y]] = [pair[0], pair[1]];
        (x < mean && y >= mean).then(|| t + (u - t) * (mean - x) / (y - x))
    };
    let all: Vec<f64> = kept.windows(2).filter_map(up).collect();
    let (first, last) = (all.first()?, all.last()?);
    (all.len() > 1).then(|| (last - first) / (all.len() - 1) as f64)
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (time, far, near) = (run.column("time")?, run.column("h")?, run.column("h_before")?);
    let [far_wave, near_wave] = [&far, &near].map(|level| harmonic(&time, level).filter(|_| run.done()));
    let behind = far_wave.zip(near_wave).map(|([_, late], [_, early])| (late - early).rem_euclid(TAU));
    let found = behind.map(|behind| TAU * APART / behind);
    let lost =
        "friction and the diffusion of density take a hundredth a second; waves of two spacings; asked 3 %";
    Ok(vec![
        Metric::compared(HEIGHT, far_wave.map(|[height, _]| height), "m", ASKED).within(0.03 * ASKED, lost),
        Metric::compared(PERIOD, period(&time, &far).filter(|_| run.done()), "s", TIME)
            .within(0.01, "that of the wall; crossings between particles; asked 1 %"),
        Metric::compared(LENGTH, found, "m", length())
            .within(0.03 * length(), "by the phase over .4 m, to which what is left of second waves adds"),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wave_has_its_height_period_and_length() {
        let time: Vec<f64> = (0..=350).map(|i| 0.02 * f64::from(i)).collect();
        let number = TAU / length();
        let wave = |x: f64| -> Vec<f64> {
            time.iter().map(|t| 0.3 + 0.02 * libm::cos(TAU * t / TIME - number * x)).collect()
        };
        let [near, far] = [1.0, 1.4].map(|x| harmonic(&time, &wave(x)).unwrap());
        assert!((far[0] - 0.04).abs() < 1e-9);
        assert!((TAU * APART / (far[1] - near[1]).rem_euclid(TAU) / length() - 1.0).abs() < 1e-9);
        assert!((period(&time, &wave(1.4)).unwrap() - TIME).abs() < 1e-6);
        // The root of ω² = g k tanh kh by Newton's method.
        assert!((length() - 1.372949).abs() < 1e-6, "{}", length());
    }
}
