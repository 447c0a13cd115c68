//! let-go: a block of bonds and a solid ball let go on a slope: sliding, at rest, rolling.
//!
//! ```text
//!      ●↘
//!   ╲   ▓▓↘
//!    ╲_______
//! ```

use benchmarks_ref::touching::{incline, rolling, spinning};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::{PAIRWISE, RIGID};
use crate::{JudgeError, Metric};

const BLOCK: &str = include_str!("../../../../scenes/block-on-incline.toml");
const BALL: &str = include_str!("../../../../scenes/ball-on-incline.toml");
const PACE: &str = "acceleration";
const SPIN: &str = "rate of the spin";
const CREEP: &str = "way of the block at rest";
/// Gravity \[m/s²\], spacing of the block and radius of the ball \[m\], friction of the block.
const GRAVITY: f64 = 10.0;
const SPACING: f64 = 0.05;
const RADIUS: f64 = 0.05;
const FRICTION: f64 = 0.3;
const ROLLS: &str = "ball, 30°, μ = .3";
const SLIPS: &str = "ball, 30°, μ = .1";

/// Errors of the acceleration \[%\].
const OF_PACE: Measured = Measured(&[
    (PAIRWISE, &[("block, 30°", 0.12), ("block, 20°", 0.59)]),
    (RIGID, &[(ROLLS, 0.081), (SLIPS, 0.038)]),
]);
/// Errors of the rate of the spin \[%\].
const OF_SPIN: Measured = Measured(&[(RIGID, &[(ROLLS, 0.57), (SLIPS, 0.59)])]);
/// Ways at rest \[% of a spacing\].
const AT_REST: Measured = Measured(&[(PAIRWISE, &[("block, 15°", 0.064)])]);

/// The scenes, their closed forms, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "let-go",
        title: "A block of bonds and a ball let go on an incline",
        about: "The block slides with g (sin φ − μ cos φ) where the slope is beyond μ, else it stays. A solid ball rolls with 5/7 g sin φ where \
                friction can turn it as fast, tan φ < 7/2 μ; else it slides as the block does and turns with 5/2 μ g cos φ/R.",
        citation: "Coulomb's friction",
        variants: vec![slides(30.0), slides(20.0), rests(15.0), ball(ROLLS, 0.3), ball(SLIPS, 0.1)],
        headline: Some(Headline::new(PACE, 0.01)),
        ..Case::default()
    }
}

fn on_slope(degrees: f64) -> Variant {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    let gravity = format!("[{}, 0.0, {}]", GRAVITY * sin, -GRAVITY * cos);
    let variant = Variant::scene(PAIRWISE, BLOCK, format!("block, {degrees}°"));
    variant.set("loads.0.gravity.acceleration", gravity).quick()
}

/// Rows after the weight is there, a fortieth of a second later.
fn weighed(run: &Run) -> Result<(usize, Vec<f64>), JudgeError> {
    let time = run.column("time")?;
    let start = time.iter().position(|time| *time >= 0.225).filter(|_| run.done());
    Ok((start.unwrap_or(time.len()), time))
}

/// Mean slope of a column since then.
fn mean_rate(run: &Run, column: &str) -> Result<Option<f64>, JudgeError> {
    let ((start, time), of) = (weighed(run)?, run.column(column)?);
    let ends = of.get(start).zip(of.last()).zip(time.get(start).zip(time.last()));
    Ok(ends.map(|((from, to), (since, until))| (to - from) / (until - since)))
}

/// How far off the acceleration is \[%\].
fn pace(run: &Run, exact: f64) -> Result<Metric, JudgeError> {
    let off = mean_rate(run, "v")?.map(|found| 100.0 * (found / (GRAVITY * exact) - 1.0).abs());
    let reason = "the swing across the slope, of which the interval cuts off a part";
    Ok(Metric::error(PACE, off, "%").near(OF_PACE.of(run)?, reason))
}

fn slides(degrees: f64) -> Variant {
    on_slope(degrees).judged(move |run, _| Ok(vec![pace(run, incline(FRICTION, degrees.to_radians()))?]))
}

fn rests(degrees: f64) -> Variant {
    on_slope(degrees).judged(|run: &Run, _| {
        let most = run.column("u")?.into_iter().map(f64::abs).reduce(f64::max).filter(|_| run.done());
        let reason = "anchors stretch, and a node that swings off the face has none until the next step";
        let off = most.map(|way| 100.0 * way / SPACING);
        Ok(vec![Metric::error(CREEP, off, "% of a spacing").near(AT_REST.of(run)?, reason)])
    })
}

/// The spin by the angle, whose second difference over equal times it is.
fn ball(words: &'static str, friction: f64) -> Variant {
    let variant = Variant::scene(RIGID, BALL, words).set("bodies.ball.rigid.tools.0.friction", friction);
    variant.quick().judged(move |run, _| {
        let slope = std::f64::consts::FRAC_PI_6;
        let ((start, time), turned) = (weighed(run)?, run.column("turned")?);
        let half = time.len().saturating_sub(start + 1) / 2;
        let rows =
            time.len().checked_sub(1).filter(|_| half > 0).map(|last| [last - 2 * half, last - half, last]);
        let rate =
            rows.map(|[a, b, c]| (turned[c] - 2.0 * turned[b] + turned[a]) / (time[c] - time[b]).powi(2));
        let exact = GRAVITY / RADIUS * spinning(friction, slope);
        let off = rate.map(|rate| 100.0 * (rate / exact - 1.0).abs());
        let reason = "its coat gives way by a hundredth of the radius";
        Ok(vec![
            pace(run, rolling(friction, slope))?,
            Metric::error(SPIN, off, "%").near(OF_SPIN.of(run)?, reason),
        ])
    })
}
