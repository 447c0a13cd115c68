//! incline: a plate let go on a slope, sliding and at rest.

use benchmarks_ref::touching::incline;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::CELL;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/incline.toml");
const PACE: &str = "acceleration";
const CREEP: &str = "way of the plate at rest";
/// Gravity \[m/s²\], cell \[m\], friction.
const GRAVITY: f64 = 10.0;
const CELL_SIZE: f64 = 1.0 / 15.0;
const FRICTION: f64 = 0.3;

/// Errors of the acceleration \[%\].
const MEASURED: Measured = Measured(&[(CELL, &[("30°", 0.14), ("20°", 0.51)])]);
/// Ways at rest \[% of a cell\].
const AT_REST: Measured = Measured(&[(CELL, &[("15°", 0.15)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "incline",
        title: "A plate let go on an incline, μ = .3",
        about: "It slides with g (sin φ − μ cos φ) where the slope is beyond μ, else it stays. Nothing damps how it swings on its contact, so that the \
                force across the slope comes and goes by half of it; the mean counts.",
        citation: "Coulomb's friction",
        variants: vec![slides(30.0), slides(20.0), rests(15.0)],
        headline: Some(Headline::new(PACE, 0.01)),
        ..Case::default()
    }
}

fn on_slope(degrees: f64) -> Variant {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    let gravity = format!("[{}, 0.0, {}]", GRAVITY * sin, -GRAVITY * cos);
    Variant::scene(CELL, SCENE, format!("{degrees}°")).set("loads.0.gravity.acceleration", gravity)
}

fn slides(degrees: f64) -> Variant {
    on_slope(degrees).judged(move |run, _| {
        let (time, pace) = (run.column("time")?, run.column("v")?);
        // From a tenth after the ramp of the weight on.
        let start = time.iter().position(|time| *time >= 0.2);
        let found = start.zip(pace.len().checked_sub(1)).filter(|_| run.done());
        let found = found.map(|(a, b)| (pace[b] - pace[a]) / (time[b] - time[a]));
        let exact = GRAVITY * incline(FRICTION, degrees.to_radians());
        let off = found.map(|found| 100.0 * (found / exact - 1.0));
        let reason = "the swing across the slope, of which the interval cuts off a part";
        Ok(vec![Metric::greatest(PACE, [(0.0, off)], "%").near(MEASURED.of(run)?, reason)])
    })
}

fn rests(degrees: f64) -> Variant {
    on_slope(degrees).judged(|run: &Run, _| -> Result<Vec<Metric>, JudgeError> {
        let most = run.column("u")?.into_iter().map(f64::abs).reduce(f64::max).filter(|_| run.done());
        let reason = "where the force across the slope is least, less than weight, friction lets go for a moment of each swing";
        Ok(vec![
            Metric::error(CREEP, most.map(|way| 100.0 * way / CELL_SIZE), "% of a cell")
                .near(AT_REST.of(run)?, reason),
        ])
    })
}
