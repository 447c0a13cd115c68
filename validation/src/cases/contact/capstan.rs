//! capstan: a belt over a drum that turns and drags it.
//!
//! ```text
//!      ╭──▓▓──╮
//!      │ ▓▓▓▓ │
//!   T₂ │      │ T₁
//! ```

use benchmarks_ref::touching::capstan;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/capstan.toml");
const RATIO: &str = "ratio of the tensions";
const LOSS: &str = "energy lost against torque times angle";
/// Weight at the end of the belt \[N\], middle of the belt \[mm\], turn of the drum \[rad\].
const WEIGHT: f64 = 210.0;
const RADIUS: f64 = 100.0;
const TURN: f64 = 0.02;

/// Errors of the ratio \[%\].
const MEASURED: Measured = Measured(&[(STATIC, &[("120 cells, μ .3", 0.35), ("120 cells, μ .1", 0.12)])]);
/// Errors of the loss \[%\].
const OF_LOSS: Measured = Measured(&[(STATIC, &[("120 cells, μ .3", 0.0088), ("120 cells, μ .1", 0.021)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "capstan",
        title: "A belt over a drum that turns, half of the way round",
        about: "A weight stretches a thin belt, then the drum turns by .02 and slips under all of it: the tension at the end that is held \
                against Euler's T₁ e^{μπ}, and what friction loses between two levels against the torque times the angle.",
        citation: "L. Euler 1762, J. A. Eytelwein",
        variants: vec![belt(0.3), belt(0.1)],
        headline: Some(Headline::new(RATIO, 0.01)),
        ..Case::default()
    }
}

fn belt(friction: f64) -> Variant {
    Variant::scene(STATIC, SCENE, format!("120 cells, μ .{}", (10.0 * friction).round()))
        .set("tools.0.friction", friction)
        .set("analysis.static.levels", "[0.2, 0.4]")
        .judged(move |run, _| judged(run, friction))
}

fn judged(run: &Run, friction: f64) -> Result<Vec<Metric>, JudgeError> {
    let tension = run.last("T2")?;
    let exact = WEIGHT * capstan(friction, std::f64::consts::PI);
    let off = tension.map(|tension| 100.0 * (tension / exact - 1.0));
    let lost = run.column("lost")?;
    let step = lost.len().checked_sub(2).map(|before| lost[before + 1] - lost[before]);
    let loss = step
        .zip(tension)
        .map(|(step, tension)| 100.0 * (step / ((tension - WEIGHT) * RADIUS * 0.2 * TURN) - 1.0).abs());
    Ok(vec![
        Metric::greatest(RATIO, [(0.0, off)], "%").near(
            MEASURED.of(run)?,
            "the clamp bears the first cell; the polygon of the belt; bending of the order of B/(T R²) where the belt is held",
        ),
        Metric::error(LOSS, loss, "%").near(OF_LOSS.of(run)?, "friction acts where the vertices are, within the sag of a cell of the radius"),
    ])
}
