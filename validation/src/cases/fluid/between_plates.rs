//! flow-between-plates: laminar flow between plates from rest, through periodic sides, against its series.

use std::f64::consts::PI;

use crate::judge::{Case, Headline, Run, Variant};
use crate::support::fluids::KICKS;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/flow-between-plates.toml");
const COURSE: &str = "rms error of the flow over time";
const LAST: &str = "flow at last";
const DRAG: &str = "drag on the plates at last";
/// Kinematic viscosity \[m²/s\], gravity along the plates \[m/s²\], mass between them \[kg/m\]; the plates are 1 m apart.
const VISCOSITY: f64 = 0.5;
const GRAVITY: f64 = 4.0;
const MASS: f64 = 500.0;

/// The channel, and how far the flow may be off.
pub fn case() -> Case {
    Case {
        name: "flow-between-plates",
        title: "Flow between plates from rest",
        about: "A viscous liquid between two plates, periodic along them, is set going by gravity: q = g d³/12ν − Σ 8g d³/(νπ⁴n⁴) exp(−n²π²νt/d²) over odd n. No artificial \
                viscosity: friction is that of ν alone, and at last the plates bear the weight.",
        citation: "closed form",
        variants: vec![
            Variant::scene(KICKS, SCENE, "d/Δx 20").unsettled().judged(|run, _| judged(run, [0.52, 0.60])),
            Variant::scene(KICKS, SCENE, "d/Δx 40")
                .set("bodies.oil.fluid.geometry.block.spacing", "0.025")
                .unsettled()
                .full_if(true)
                .judged(|run, _| judged(run, [0.07, 0.03])),
        ],
        headline: Some(Headline::new(COURSE, 0.1)),
        ..Case::default()
    }
}

/// What flows through a section at a time \[m²/s\].
fn exact(time: f64) -> f64 {
    let mode = |n: f64| {
        8.0 * GRAVITY / (VISCOSITY * (PI * n).powi(4)) * libm::exp(-n * n * PI * PI * VISCOSITY * time)
    };
    steady() - (0..40).map(|i| mode(2.0 * f64::from(i) + 1.0)).sum::<f64>()
}

/// The same at last \[m²/s\].
fn steady() -> f64 {
    GRAVITY / (12.0 * VISCOSITY)
}

fn judged(run: &Run, [course, last]: [f64; 2]) -> Result<Vec<Metric>, JudgeError> {
    let (time, flow) = (run.column("time")?, run.column("flow")?);
    let square = |(t, q): (&f64, &f64)| (q - exact(*t)).powi(2);
    let mean = time.iter().zip(&flow).map(square).sum::<f64>() / time.len() as f64;
    let rms = (run.done() && !time.is_empty()).then(|| 100.0 * mean.sqrt() / steady());
    Ok(vec![
        Metric::error(COURSE, rms, "%")
            .near(course, "in parts of the flow at last; walls hold to the first order of the spacing"),
        Metric::compared(LAST, run.last("flow")?, "m²/s", steady()).near(last, "as above"),
        Metric::compared(DRAG, run.last("drag_mean")?, "N", MASS * GRAVITY).within(
            0.006 * MASS * GRAVITY,
            "momentum is kept: what is left swings with the rows, measured .1 and .2 %",
        ),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of 1/n⁴ over odd n is π⁴/96: forty terms leave 1/(6·81³) of it.
    #[test]
    fn the_series_starts_from_rest() {
        assert!(exact(0.0).abs() < 1e-5 && (exact(9.0) - steady()).abs() < 1e-12);
    }
}
