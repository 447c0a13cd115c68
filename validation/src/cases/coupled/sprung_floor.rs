//! sprung-floor: water on a floor on springs that is pushed down, against the modes of a column that sounds.

use std::f64::consts::PI;

use super::measure::SHELL;
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::coupled::WATER;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("sprung-floor.toml");
/// Depth of the water \[m\], its speed of sound \[m/s\], mass \[kg/m²\] and springs \[N/m³\] of the floor.
const DEPTH: f64 = 0.6;
const SOUND: f64 = 45.0;
const FLOOR: f64 = 100.0;
const SPRINGS: f64 = 145_800.0 / 0.27;
/// What pushes it down \[N/m²\], within so long \[s\]: a fifth of all weight, so that no water pulls.
const PUSH: f64 = 378.0 / 0.27;
const RISE: f64 = 0.1;
/// Times of the first way down and back, with how far off the floor was when this was reviewed \[%\].
const TIMES: [(f64, &str, f64); 4] = [
    (0.12, "way at .12 s", 29.0),
    (0.16, "way at .16 s", 16.0),
    (0.2, "way at .2 s", 9.0),
    (0.24, "way at .24 s", 5.6),
];
/// Modes that are summed, and intervals of their integrals.
const MODES: u32 = 20;
const INTERVALS: u32 = 2000;

/// The floor, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "sprung-floor",
        title: "Water on a floor on springs that is pushed down",
        about: "A slice between smooth sides: everything moves up and down alone. A force bears floor and water, and a fifth of it \
                pushes them down within .1 s. What they swing with are the modes of a column that sounds on a mass with a spring, \
                k − m ω² = ω ρ c tan(ω H/c).",
        citation: "closed form: normal modes under a force in time, derived in the case",
        variants: [(12_usize, true), (24, false)]
            .into_iter()
            .map(|(cells, quick)| {
                let particles = format!("[{}, {}]", cells + 1, 3 * cells / 4 + 1);
                Variant::scene(SHELL, SCENE, format!("H/Δx {cells}"))
                    .set("bodies.water.fluid.geometry.block.spacing", DEPTH / cells as f64)
                    .set("bodies.floor.shell.geometry.plate.particles", particles)
                    .unsettled()
                    .quick_if(quick)
                    .judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(TIMES[1].1, 0.1)),
        ..Case::default()
    }
}

/// Way of the floor \[m\].
///
/// In the mode cos(ω (H − y)/c) of mass `M = m cos² x + ρ H/2 + ρ c/(4ω) sin 2x`, x = ωH/c, the floor moves by cos x and the force has the share
/// cos x: `w = Σ cos² x/(M ω) ∫ F(s) sin ω(t − s) ds`.
fn exact(time: f64) -> f64 {
    let force = |at: f64| {
        let s = (at / RISE).clamp(0.0, 1.0);
        PUSH * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
    };
    let mode = |omega: f64| {
        let x = omega * DEPTH / SOUND;
        let (sine, cosine) = (libm::sin(x), libm::cos(x));
        let mass = FLOOR * cosine * cosine + WATER * (0.5 * DEPTH + SOUND / (2.0 * omega) * sine * cosine);
        // By Simpson's rule.
        let step = time / f64::from(INTERVALS);
        let term = |i: u32| {
            let weight = if i == 0 || i == INTERVALS { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
            let at = f64::from(i) * step;
            weight * force(at) * libm::sin(omega * (time - at))
        };
        cosine * cosine / (mass * omega) * (0..=INTERVALS).map(term).sum::<f64>() * step / 3.0
    };
    (0..MODES).filter_map(root).map(mode).sum()
}

/// Angular frequency of a mode \[1/s\]: the one on its branch of the tangent, by halving.
fn root(branch: u32) -> Option<f64> {
    let left = |omega: f64| {
        SPRINGS - FLOOR * omega * omega - omega * WATER * SOUND * libm::tan(omega * DEPTH / SOUND)
    };
    let end = |half: f64| (f64::from(branch) + half).max(0.0) * PI * SOUND / DEPTH;
    let (mut low, mut high) = (end(-0.5) + 1e-9, end(0.5) - 1e-9);
    if left(low) <= 0.0 || left(high) >= 0.0 {
        return None;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if left(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, ways) = (run.column("time")?, run.column("w")?);
    let metric = |(time, name, measured): (f64, &str, f64)| {
        let row = times.iter().position(|known| (known - time).abs() < 1e-9);
        let way = row.map(|row| 1e3 * ways[row]);
        Metric::compared(name, way, "mm", 1e3 * exact(time)).near(
            measured,
            "half a spacing of water is missing before the floor, whose load the force bears: it starts too high, by the first order of the spacing",
        )
    };
    Ok(TIMES.map(metric).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_it_swings_about_what_the_push_does_at_rest() {
        let (rest, all) = (PUSH / SPRINGS, FLOOR + WATER * DEPTH);
        let one = (SPRINGS / all).sqrt();
        assert!((root(0).unwrap() / one - 1.0).abs() < 0.03);
        let mean = (100..1100).map(|i| exact(0.005 * f64::from(i))).sum::<f64>() / 1000.0;
        assert!((mean / rest - 1.0).abs() < 0.02, "{mean} {rest}");
    }
}
