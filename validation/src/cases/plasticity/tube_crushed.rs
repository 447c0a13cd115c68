//! tube-crushed: a tube crushed flat between two smooth plates.
//!
//! ```text
//!  ━━━━━━━━━
//!   ╭──┴──╮     P = (4 M_p/R) / √(1 − (δ/2R)²),   M_p = σ₀ t²/(2√3)
//!   ╰──┬──╯
//!  ━━━━━━━━━
//! ```

use crate::judge::measure::cubic_at;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/tube-crushed.toml");
/// Load when the plates have come together by so much of the diameter.
const TENTH: &str = "load at a tenth of the diameter";
const FIFTH: &str = "load at a fifth of the diameter";
/// Radius, thickness and length \[mm\], yield stress \[N/mm²\].
const RADIUS: f64 = 50.0;
const THICKNESS: f64 = 2.0;
const LENGTH: f64 = 5.0;
const YIELD: f64 = 250.0;
const SOFT: &str = "60 cells, E/1000";
const USUAL: &str = "60 cells, E/400";
const FINE: &str = "120 cells, E/400";

/// Errors \[%\].
const OF_TENTH: Measured = Measured(&[(STATIC, &[(SOFT, 0.93), (USUAL, 1.7), (FINE, 1.6)])]);
const OF_FIFTH: Measured = Measured(&[(STATIC, &[(SOFT, 2.9), (USUAL, 4.4), (FINE, 4.4)])]);

/// The scene, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "tube-crushed",
        title: "A tube crushed between plates",
        about: "A quarter of a tube in plane strain that yields where it bends, under a plate along which its hinges part: the load against four hinges of a tube that is rigid \
                but for them. What hardens by E/1000 and E/400 comes above it as the hinges turn.",
        citation: "DeRuntz and Hodge 1963: rigid, perfectly plastic",
        variants: vec![tube(61, 200.0, SOFT), tube(61, 500.0, USUAL), tube(121, 500.0, FINE)],
        each,
        headline: Some(Headline::new(TENTH, 0.5)),
        ..Case::default()
    }
}

fn tube(round: usize, slope: f64, grid: &str) -> Variant {
    Variant::scene(STATIC, SCENE, grid)
        .set("geometry.cylinder.particles", format!("[{round}, 3]"))
        .set("material.plastic.hardening.linear.slope", slope)
        .set("analysis.static.levels", "40")
        .set("tools.0.moved", "[0.0, 0.0, -20.0]")
}

/// Load of four hinges when each plate has come so far \[N\].
fn hinges(way: f64) -> f64 {
    let moment = YIELD * THICKNESS * THICKNESS / (2.0 * 3.0_f64.sqrt());
    4.0 * moment * LENGTH / RADIUS / (1.0 - (way / RADIUS).powi(2)).sqrt()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (way, load) = (run.column("crown")?, run.column("P")?);
    let off = |way_there: f64| {
        let found = cubic_at(&way, &load, way_there).filter(|_| run.done());
        found.map(|load| 100.0 * (load / hinges(way_there) - 1.0))
    };
    let reason = "the tube is elastic at first and hardens after that, which four rigid arms leave out";
    Ok(vec![
        Metric::error(TENTH, off(0.1 * RADIUS), "%").near(OF_TENTH.of(run)?, reason),
        Metric::error(FIFTH, off(0.2 * RADIUS), "%").near(OF_FIFTH.of(run)?, reason),
    ])
}
