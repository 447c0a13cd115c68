//! irregular-waves: waves of a spectrum that a piston makes, against the sum of their components by linear theory at the same places and times.

use std::f64::consts::TAU;

use fluid_sph::{Component, Spectrum, Waves};

use super::measure::line;
use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/wave-flume.toml");
const MADE: &str = "significant height at the wall over linear theory";
const PEAK: &str = "frequency of the peak over linear theory";
const LOST: &str = "lost a metre";
const LONGER: &str = "mean period .4 m from the wall over linear theory, less one";
/// Significant height \[m\], period of the peak \[s\], depth \[m\], gravity \[m/s²\], and the rest of the spectrum.
const HEIGHT: f64 = 0.04;
const TIME: f64 = 1.0;
const DEPTH: f64 = 0.3;
const GRAVITY: f64 = 9.81;
const PEAKEDNESS: f64 = 3.3;
const COMPONENTS: usize = 64;
const SEED: u32 = 1;
/// Places of the gauges, decimetres from the wall.
const GAUGES: [u32; 7] = [4, 6, 8, 10, 12, 16, 20];
/// From when on waves are measured, and until when \[s\]: the wall grows for two periods.
const FROM: f64 = 6.0;
const DURATION: &str = "34.0";
/// Frequencies at which spectra are looked at \[1/s\].
const STEP: f64 = 0.01;
const BAND: std::ops::Range<u32> = 50..300;

/// The flume, linear theory, and how far the two may differ.
pub fn case() -> Case {
    let waves = format!(
        "{{ height = {HEIGHT}, period = {TIME:.1}, depth = {DEPTH}, spectrum = {{ shape = {{ jonswap = {PEAKEDNESS} }}, seed = {SEED}, components = {COMPONENTS} }} }}"
    );
    let of = |place: u32| {
        let x = 0.1 * f64::from(place);
        format!("{{ name = \"h{place}\", of = \"level\", on = \"water.all\", at = [{x:.1}, 0.0, 0.0] }}")
    };
    let gauges = format!("[{}]", GAUGES.map(of).join(", "));
    Case {
        name: "irregular-waves",
        title: "Waves of a spectrum in a flume",
        about: "A piston makes a sea of JONSWAP's spectrum by the transfer function of the first order of each of its components. The standard deviation of the surface at gauges is held against that of the \
                sum of the components, by linear theory over the same time; a straight line of the logarithm of their ratio over the way gives it at the wall, and what is lost.",
        citation: "Dean and Dalrymple, Water Wave Mechanics for Engineers and Scientists; Hasselmann et al. (1973)",
        variants: vec![
            Variant::scene(KICKS, SCENE, "piston, 2 spacings high")
                .set("analysis.explicit.transient.duration", DURATION)
                .set("analysis.explicit.transient.record_every", "0.05")
                .set("bodies.piston.walls.motion.waves", waves)
                .set("curve", gauges)
                .set("output", "{}")
                .unsettled()
                .full_if(true)
                .judged(|run, _| judged(run)),
        ],
        headline: Some(Headline::new(MADE, 0.1)),
        ..Case::default()
    }
}

/// The surface at a distance from the wall at times, by the sum of the components.
fn theory(components: &[Component], x: f64, time: &[f64]) -> Vec<f64> {
    let number = |own: &Component| {
        TAU / Waves { period: 1.0 / own.frequency, depth: DEPTH, gravity: GRAVITY }.length()
    };
    let waves: Vec<[f64; 3]> = components
        .iter()
        .map(|own| [own.amplitude, TAU * own.frequency, own.phase - number(own) * x])
        .collect();
    let at = |t: &f64| waves.iter().map(|[size, omega, phase]| size * libm::cos(omega * t + phase)).sum();
    time.iter().map(at).collect()
}

/// What a course is about its mean.
fn about_mean(course: &[f64]) -> Vec<f64> {
    let mean = course.iter().sum::<f64>() / course.len() as f64;
    course.iter().map(|x| x - mean).collect()
}

/// Standard deviation, frequency of the peak, mean period √(m₀/m₂).
fn figures(time: &[f64], course: &[f64]) -> [f64; 3] {
    let off = about_mean(course);
    let deviation = (off.iter().map(|x| x * x).sum::<f64>() / off.len() as f64).sqrt();
    let power = |frequency: f64| {
        let part = |of: &dyn Fn(f64) -> f64| {
            time.iter().zip(&off).map(|(t, x)| x * of(TAU * frequency * t)).sum::<f64>()
        };
        let (a, b) = (part(&libm::cos), part(&libm::sin));
        a * a + b * b
    };
    let (mut peak, mut moments) = ([0.0; 2], [0.0; 2]);
    for frequency in BAND.map(|i| STEP * f64::from(i)) {
        let own = power(frequency);
        if own > peak[1] {
            peak = [frequency, own];
        }
        moments = [moments[0] + own, moments[1] + own * frequency * frequency];
    }
    [deviation, peak[0], (moments[0] / moments[1]).sqrt()]
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let components =
        Spectrum::Jonswap { peakedness: PEAKEDNESS }.components(HEIGHT, 1.0 / TIME, COMPONENTS, SEED);
    let all = run.column("time")?;
    let first = all.iter().position(|t| *t >= FROM).unwrap_or(all.len());
    let time = &all[first..];
    let mut ratios = Vec::new();
    for place in GAUGES {
        let x = 0.1 * f64::from(place);
        let measured = run.column(&format!("h{place}"))?;
        if time.len() > 1 {
            let own = figures(time, &measured[first..]);
            let exact = figures(time, &theory(&components, x, time));
            ratios.push((x, [0, 1, 2].map(|k| own[k] / exact[k])));
        }
    }
    let found = run.done() && !ratios.is_empty();
    let logs: Vec<[f64; 2]> = ratios.iter().map(|(x, ratio)| [*x, libm::log(ratio[0])]).collect();
    let course = found.then(|| line(&logs));
    let near = ratios.first().filter(|_| found).map(|(_, ratio)| *ratio);
    Ok(vec![
        Metric::compared(MADE, course.map(|[at_wall, _]| libm::exp(at_wall)), "-", 1.0)
            .within(0.05, "asked 5 %: the transfer function of the first order, component by component"),
        Metric::compared(PEAK, near.map(|ratio| ratio[1]), "-", 1.0)
            .within(0.03, "a peak that is looked for in steps of 1 %, of a record of 28 s"),
        Metric::error(LOST, course.map(|[_, slope]| -100.0 * slope), "%")
            .near(9.9, "short waves are lost first, as regular ones are (docs/fluids.md)"),
        Metric::error(LONGER, near.map(|ratio| 100.0 * (ratio[2] - 1.0)), "%")
            .near(7.7, "the same: what is left has lost of its short waves"),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_of_two_waves_has_its_figures() {
        let time: Vec<f64> = (0..1000).map(|i| 0.05 * f64::from(i)).collect();
        let wave = |amplitude: f64, frequency: f64| Component { amplitude, frequency, phase: 0.3 };
        let course = theory(&[wave(0.02, 1.0), wave(0.01, 2.0)], 0.5, &time);
        let [deviation, peak, period] = figures(&time, &course);
        assert!((deviation - (2.5e-4_f64).sqrt()).abs() < 1e-6 && (peak - 1.0).abs() < 1e-9);
        // m₂/m₀ = (4 + 4)/5.
        assert!((period - (5.0_f64 / 8.0).sqrt()).abs() < 0.02, "{period}");
        let found = line(&[[1.0, 3.0], [2.0, 5.0], [4.0, 9.0]]);
        assert!((found[0] - 1.0).abs() < 1e-12 && (found[1] - 2.0).abs() < 1e-12);
    }
}
