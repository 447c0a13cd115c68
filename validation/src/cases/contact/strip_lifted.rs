//! strip-lifted: a long heavy strip, an end of which is lifted off a smooth flat.
//!
//! ```text
//!   ╭━━ ↑ δ
//!  ━╯
//!  ▓▓▓▓▓▓▓▓▓▓
//! ```

use benchmarks_ref::on_flats::lifted;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-lifted.toml");
const OFF: &str = "greatest error of the force on the end";
/// Lift at level one \[q l₀⁴/B\], and q l₀ times the width \[N\].
const LIFT: f64 = 0.1;
const UNIT: f64 = 0.01 * 0.1;

/// Errors \[% of the force\].
const MEASURED: Measured =
    Measured(&[(STATIC, &[("75 cells", 0.049), ("150 cells", 0.001), ("600 cells, one level", 0.002)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-lifted",
        title: "A heavy strip lifted off a flat",
        about: "An end of a strip that lies on a flat is lifted by .001, .01 and .1 q l₀⁴/B, or by the last at once, where five sixths of 600 \
                cells let go in one level: what touches is found with contact softened first. The end bears half of the weight that hangs.",
        citation: "Euler and Bernoulli's beam of small slope",
        variants: vec![
            strip(75, "75 cells"),
            strip(150, "150 cells"),
            strip(600, "600 cells, one level").set("analysis.static.levels", "1"),
        ],
        each,
        headline: Some(Headline::new(OFF, 0.02)),
        ..Case::default()
    }
}

fn strip(cells: usize, grid: &str) -> Variant {
    Variant::scene(STATIC, SCENE, grid).set("geometry.plate.particles", format!("[{}, 3]", cells + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("level")?.into_iter().zip(run.column("F")?).filter(|(level, _)| *level > 0.0);
    let errors = found.map(|(level, force)| 100.0 * (force / (UNIT * lifted(LIFT * level)[1]) - 1.0).abs());
    let worst = errors.reduce(f64::max).filter(|_| run.done());
    let reason = "the line of lift-off stands between vertices; slope and stretch of the strip of a thousandth are left out";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
