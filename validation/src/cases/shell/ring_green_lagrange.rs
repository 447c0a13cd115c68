//! ring-green-lagrange: the ring with the curvature measure of the paper, judged by the law of that measure.

use benchmarks_ref::elastica::end_moment;
use benchmarks_ref::rolled_strip::under_moment;

use crate::figures::{BLUE, Figure, Line, Mark, Series, VERMILION};
use crate::judge::Variant;
use crate::judge::{Case, Run, Runs};
use crate::methods::CELL;
use crate::support::scenes;
use crate::support::strip;
use crate::{JudgeError, Metric};

/// Length of the strip \[cm\].
const LENGTH: f64 = 10.0;
/// Thickness over length.
const SLENDERNESS: f64 = 0.1;
const QUARTERS: [(f64, &str); 4] = [(0.25, "¼"), (0.5, "½"), (0.75, "¾"), (1.0, "1")];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "ring-green-lagrange",
        title: "The same ring with Green–Lagrange curvature, the measure of the paper",
        about: "x,α·d,β mixes the stretch of the mid-surface into the curvature. A strip with that measure has a law of \
                its own, λ² = M/(EIk) = 1 − (kt)²/6: the particles meet it, so the 7.3 % by which the ring misses \
                the circle belong to the strain measure and not to the particles.",
        citation: "Lin et al. 2013, eqs. 5–7; law: closed form in benchmarks-ref, rolled_strip",
        variants: vec![Variant::new(CELL, scenes::RING_GREEN_LAGRANGE, "plate", [50, 5]).quick()],
        each,
        figures,
        ..Case::default()
    }
}

/// Shortening and deflection in parts of L, by the law of the measure.
fn law(level: f64) -> Result<(f64, f64), JudgeError> {
    let strip = under_moment(std::f64::consts::TAU * level, SLENDERNESS)?;
    Ok((1.0 - strip.tip.0, strip.tip.1))
}

fn circle(level: f64) -> (f64, f64) {
    let tip = end_moment(std::f64::consts::TAU * level);
    (tip.u, tip.w)
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let mut metrics = Vec::new();
    for (level, name) in QUARTERS {
        let error = strip::tip_error(run, level, LENGTH, law(level)?)?;
        metrics.push(
            Metric::error(format!("own law at {name}"), error, strip::UNIT)
                .near(0.012, "the particles' own error; the law leaves out the ζ² strain as the shell does"),
        );
    }
    let error = strip::tip_error(run, 1.0, LENGTH, circle(1.0))?;
    // The law against the circle, by closed forms.
    let (law, circle) = (law(1.0)?, circle(1.0));
    let expected = 100.0 * libm::hypot(law.0 - circle.0, law.1 - circle.1);
    let cost = Metric::compared("circle at 1", error, strip::UNIT, expected);
    metrics.push(cost.near(0.1, "what the measure costs is the distance of its law from the circle"));
    Ok(metrics)
}

fn figures(runs: &Runs) -> Result<Vec<Figure>, JudgeError> {
    let Some(run) = runs.get(CELL, "50×5")? else { return Ok(Vec::new()) };
    let mut chart = strip::tip_chart(
        "Tip of the strip against the moment, Green–Lagrange curvature",
        "Black: the law of the Green–Lagrange strip, which the particles follow. Red: the circle, which they cannot reach.",
        &[(run, BLUE, Mark::Disc)],
        LENGTH,
        |level| law(level).ok(),
    )?;
    chart.series[0].label = "Green–Lagrange law: −u/L (solid), w/L (dashed)".into();
    let levels = (0..=200).map(|i| f64::from(i) / 200.0);
    let line = |pick: fn((f64, f64)) -> f64| levels.clone().map(|x| (x, pick(circle(x)))).collect();
    chart.series.push(Series::line("circle", line(|tip| tip.0), VERMILION, Line::Solid));
    chart.series.push(Series::line("", line(|tip| tip.1), VERMILION, Line::Dashed));
    Ok(vec![Figure::Chart(chart)])
}
