//! cantilever-on-flat: a cantilever that comes to lie on a smooth flat.
//!
//! ```text
//!  ▐━━━━━━╮ ↓ ↓ ↓ ↓ ↓
//!          ╰━━━━━━━━━   c
//!   ▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓▓
//! ```

use benchmarks_ref::on_flats::cantilever_on_flat;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cantilever-on-flat.toml");
const OFF: &str = "greatest error of the force on the flat";
/// B c/L³ times the width \[N\].
const UNIT: f64 = 0.01 * 0.1;
/// Load at level one \[B c/L⁴\].
const LOAD: f64 = 1152.0;

/// Errors \[% of the force\].
const MEASURED: Measured = Measured(&[(STATIC, &[("40 cells", 0.055), ("80 cells", 0.18)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cantilever-on-flat",
        title: "A cantilever that comes to lie on a flat",
        about: "A load spread over a strip that is clamped above a flat: the end touches at 8 B c/L⁴, from 72 on the strip lies on the flat and the line \
                where it lifts off moves in. The force on the flat tells that line: a/L is 1.5 (1 − F/q).",
        citation: "Euler and Bernoulli's beam of small deflection",
        variants: vec![strip(40), strip(80)],
        each,
        headline: Some(Headline::new(OFF, 0.02)),
        ..Case::default()
    }
}

fn strip(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.plate.particles", format!("[{}, 3]", cells + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("level")?.into_iter().zip(run.column("F")?);
    let error = |(level, force): (f64, f64)| {
        let exact = cantilever_on_flat(LOAD * level);
        // Below the first touch, of a force of the order of one.
        100.0 * (force / UNIT - exact).abs() / exact.max(1.0)
    };
    let worst = found.map(error).reduce(f64::max).filter(|_| run.done());
    let reason =
        "lift-off stands between vertices, most where it begins, at 72 B c/L⁴; (c/L)² and depth are less";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
