//! tilted-basin: gravity leans at once by a fiftieth, and the water of a basin begins to slosh about its new level.

use std::f64::consts::PI;

use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("tilted-basin.toml");
/// Length of the basin and depth of the water \[m\], gravity \[m/s²\], its lean.
const LENGTH: f64 = 1.0;
const DEPTH: f64 = 0.5;
const GRAVITY: f64 = 10.0;
const LEAN: f64 = 0.02;
/// Times of the first half of a swing \[s\], with how far off the way was when this was reviewed \[%\].
const TIMES: [(f64, &str, f64); 4] = [
    (0.15, "way at .15 s", 4.1),
    (0.3, "way at .3 s", 3.6),
    (0.45, "way at .45 s", 2.9),
    (0.6, "way at .6 s", 1.2),
];

/// The basin, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "tilted-basin",
        title: "A basin whose gravity leans at once",
        about: "The way of the water's centre in the first half of the swing about the new level. Each odd mode of the basin is let go from what \
                the lean is in it: x = 8 ε L²/(π⁴ H) Σ (1 − cos ω t)/n⁴ with ω² = g k tanh kH, k = nπ/L.",
        citation: "closed form: linear waves of an ideal fluid; speed of sound 18 √(gH)",
        variants: [(0.05, true), (0.025, false)]
            .into_iter()
            .map(|(spacing, quick)| {
                Variant::scene(KICKS, SCENE, format!("H/Δx {}", DEPTH / spacing))
                    .set("bodies.water.fluid.geometry.block.spacing", spacing)
                    .unsettled()
                    .quick_if(quick)
                    .judged(|run, _| judged(run))
            })
            .collect(),
        headline: Some(Headline::new(TIMES[3].1, 0.1)),
        ..Case::default()
    }
}

/// Way of the centre along the basin \[m\].
fn exact(time: f64) -> f64 {
    let mode = |n: u32| {
        let n = f64::from(n);
        let k = n * PI / LENGTH;
        let omega = (GRAVITY * k * libm::tanh(k * DEPTH)).sqrt();
        (1.0 - libm::cos(omega * time)) / n.powi(4)
    };
    8.0 * LEAN * LENGTH * LENGTH / (PI.powi(4) * DEPTH) * (1..200).step_by(2).map(mode).sum::<f64>()
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (times, places) = (run.column("time")?, run.column("x")?);
    let metric = |(time, name, measured): (f64, &str, f64)| {
        let row = times.iter().position(|known| (known - time).abs() < 1e-9);
        let way = row.map(|row| 1e3 * (places[row] - places[0]));
        Metric::compared(name, way, "mm", 1e3 * exact(time))
            .near(measured, "ten particles a depth: artificial viscosity, and the sound of a start at once")
    };
    Ok(TIMES.map(metric).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_water_swings_about_its_level_at_rest() {
        // One mode alone turns at twice the way at rest, ε L²/12H; the others are a hundredth.
        let rest = LEAN * LENGTH * LENGTH / (12.0 * DEPTH);
        let most = (0..120).map(|i| exact(0.01 * f64::from(i))).fold(0.0, f64::max);
        assert!((most / (2.0 * rest) - 1.0).abs() < 0.02, "{most} {rest}");
        // At first it falls down its slope: twice the way over the square of the time is what the lean gives of gravity to the centre.
        let first = 2.0 * exact(1e-3) / 1e-6;
        assert!(first > 0.0 && first < LEAN * GRAVITY, "{first}");
    }
}
