//! turek-hron: a bar bent by its weight, soft and stiff at rest, and swinging without end.

use benchmarks_ref::fluid_structure::{Swing, bar, bar_swinging};

use crate::figures::{Axis, BLACK, BLUE, Chart, Figure, Line, Series};
use crate::judge::{Case, Headline, Published, Run, Runs, Variant};
use crate::methods::{CELL, STATIC};
use crate::support::studies::in_time;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("turek-hron.toml");
const NAME: &str = "down";
const ALONG: &str = "along";
const FREQUENCY: &str = "frequency";
/// A swing of the end lasts .91 s.
const DURATION: f64 = 10.0;
const RECORDED: f64 = 0.005;

const AT_REST: &str = "one percent; .3 % down and .65 % along at any spacing. The benchmark's clamp is round: its bar is \
                       .3510 long at its faces, with the mean that bending sees .3506, of which the strip is .35";
const SWINGING: &str = "three percent: levels of the benchmark differ by .2 %, finer meshes in smaller steps by 2 %, towards \
                        which the strip goes, 1.4 %";

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "turek-hron",
        title: "Bar under its weight, at rest and swinging (CSM1 to 3)",
        about: "Plane strain by a strip of three particles between two mirrors. Displacement of the end at rest, soft and \
                stiff; mean, amplitude and frequency of ten seconds of free swings without damping.",
        citation: "Turek and Hron 2006, structural tests CSM1, CSM2, CSM3",
        variants: variants(),
        // Codes that are converged spread by .3 to .5 %.
        headline: Some(Headline { metric: NAME, floor: 0.3, published }),
        figures,
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for (test, young) in [("CSM1", 1.4e6), ("CSM2", 5.6e6)] {
        for n in [10, 18, 36] {
            let still = Variant::new(STATIC, SCENE, "plate", [n, 3]).on(test).quick().usual_if(n == 18);
            let still = still.set("material.elastic.young", format!("{young:e}"));
            variants.push(still.judged(move |run, _| at_rest(run, bar(test)?)));
        }
    }
    for n in [10, 18, 36] {
        let moving = Variant::new(CELL, SCENE, "plate", [n, 3]).on("CSM3").quick_if(n == 10);
        variants.push(in_time(moving, DURATION, RECORDED).judged(|run, _| swinging(run, bar("CSM3")?)));
    }
    variants
}

fn at_rest(run: &Run, expected: [Swing; 2]) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = Vec::new();
    for (name, swing) in [ALONG, NAME].into_iter().zip(expected) {
        let found = Metric::compared(name, run.last(name)?, "m", swing.mean);
        metrics.push(found.within(0.01 * swing.mean.abs(), AT_REST));
    }
    Ok(metrics)
}

fn swinging(run: &Run, expected: [Swing; 2]) -> Result<Vec<Metric>, JudgeError> {
    let cycles = Cycles::of(&run.column("time")?, &run.column(NAME)?);
    let mut metrics = Vec::new();
    for (name, swing) in [ALONG, NAME].into_iter().zip(expected) {
        let [least, greatest] = cycles.extremes(&run.column(name)?);
        let mean = Metric::compared(name, Some(0.5 * (least + greatest)), "m", swing.mean);
        metrics.push(mean.within(0.03 * swing.mean.abs(), SWINGING));
        let amplitude = Some(0.5 * (greatest - least));
        let amplitude = Metric::compared(format!("{name}, amplitude"), amplitude, "m", swing.amplitude);
        metrics.push(amplitude.within(0.03 * swing.amplitude, SWINGING));
    }
    let frequency = Metric::compared(FREQUENCY, cycles.frequency(), "1/s", expected[1].frequency);
    let reason = "one percent: independent codes lie .4 % lower";
    metrics.push(frequency.within(0.01 * expected[1].frequency, reason));
    Ok(metrics)
}

/// Whole swings: where a record passes the middle of its range downwards.
struct Cycles {
    /// Times of the passes, between rows.
    times: Vec<f64>,
    /// Rows after the passes.
    rows: Vec<usize>,
}

impl Cycles {
    fn of(times: &[f64], values: &[f64]) -> Self {
        let [least, greatest] = range(values);
        let middle = 0.5 * (least + greatest);
        let mut cycles = Self { times: Vec::new(), rows: Vec::new() };
        for row in 1..values.len().min(times.len()) {
            let (before, after) = (values[row - 1] - middle, values[row] - middle);
            if before > 0.0 && after <= 0.0 {
                let part = before / (before - after);
                cycles.times.push(times[row - 1] + part * (times[row] - times[row - 1]));
                cycles.rows.push(row);
            }
        }
        cycles
    }

    /// Whole swings by time; none for less than one.
    fn frequency(&self) -> Option<f64> {
        match self.times.as_slice() {
            [first, .., last] => Some((self.times.len() - 1) as f64 / (last - first)),
            _ => None,
        }
    }

    /// Least and greatest value of a record, the means over all whole swings.
    fn extremes(&self, values: &[f64]) -> [f64; 2] {
        let ranges: Vec<[f64; 2]> =
            self.rows.windows(2).map(|rows| range(&values[rows[0]..rows[1]])).collect();
        let mean = |end: usize| ranges.iter().map(|range| range[end]).sum::<f64>() / ranges.len() as f64;
        [mean(0), mean(1)]
    }
}

fn range(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], &x| [least.min(x), most.max(x)])
}

/// Independent codes on CSM2, down.
fn published() -> Result<Vec<Published>, JudgeError> {
    Ok(vec![Published { source: "solids4foam, cubic finite volumes, CSM2", error: Some(0.31) }])
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let known =
        bar_swinging()?.map(|curve| curve.x().iter().copied().zip(curve.y().iter().copied()).collect());
    let [_, down]: [Vec<(f64, f64)>; 2] = known;
    let mut series = vec![Series::line("Turek and Hron, level 4", down, BLACK, Line::Dashed)];
    if let Some(run) = runs.get(CELL, "18×3 CSM3")? {
        let points = run.column("time")?.into_iter().zip(run.column(NAME)?).collect();
        series.push(Series::line("stress-point cell, 18×3", points, BLUE, Line::Solid));
    }
    Ok(vec![Figure::Chart(Chart {
        title: "The end of the soft bar, let go".into(),
        caption: "Ten seconds without damping: the two part by the frequencies, .4 %.".into(),
        x: Axis::linear("time [s]").between(0.0, DURATION),
        y: Axis::linear("displacement down [m]"),
        series,
    })])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_of_a_cosine_are_its_periods() {
        let times: Vec<f64> = (0..=2000).map(|i| 0.005 * f64::from(i)).collect();
        let values: Vec<f64> = times.iter().map(|t| 3.0 * libm::cos(7.0 * t) - 1.0).collect();
        let cycles = Cycles::of(&times, &values);
        let frequency = cycles.frequency().unwrap();
        assert!((frequency / (7.0 / std::f64::consts::TAU) - 1.0).abs() < 1e-4, "{frequency}");
        let [least, greatest] = cycles.extremes(&values);
        // Between two rows a cosine rises by (7 · 0.0025)²/2 at most.
        assert!((least + 4.0).abs() < 5e-4 && (greatest - 2.0).abs() < 5e-4);
        assert_eq!(Cycles::of(&times[..5], &values[..5]).frequency(), None);
    }
}
