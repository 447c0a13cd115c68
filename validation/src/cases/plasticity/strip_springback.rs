//! strip-springback: a strip bent past its yield and let go.
//!
//! ```text
//!  ▐━━━━━━╮  M          M/M_y = (1 − E_t/E)(1.5 − .5/r²) + (E_t/E) r,   r = κ/κ_y ≥ 1
//!          ╰━━          left: κ − M/EI
//! ```

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-springback.toml");
const BENT: &str = "error of the turn under the couple";
const LEFT: &str = "error of the turn that is left";
/// E_t/E with H = E/50.
const TANGENT: f64 = 1.0 / 51.0;
/// Length times the curvature of first yield, and the couple over that of first yield.
const TURN: f64 = 5.0 * 0.02;
const COUPLE: f64 = 0.075918 / 0.05;

/// Errors \[%\].
const OF_BENT: Measured =
    Measured(&[(STATIC, &[("6 slices", 1.15), ("10 slices", 2.64), ("40 slices", 0.105)])]);
const OF_LEFT: Measured =
    Measured(&[(STATIC, &[("6 slices", 1.85), ("10 slices", 4.26), ("40 slices", 0.169)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-springback",
        title: "A strip bent past its yield, and its springback",
        about: "A rectangular section of linear hardening under a couple of 1.52 times that of first yield, four times its curvature, and let go: what it turns by \
                under the couple and what is left. Of a given couple an error of the moment counts ten times in the turn.",
        citation: "uniaxial bending in closed form",
        variants: [6, 10, 40].map(slices).into(),
        each,
        headline: Some(Headline::new(LEFT, 0.01)),
        ..Case::default()
    }
}

fn slices(count: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{count} slices"))
        .set("section.homogeneous.slices", count.to_string())
        .quick_if(count == 10)
}

/// r at a couple, by halving.
fn curvature() -> f64 {
    let moment = |r: f64| (1.0 - TANGENT) * (1.5 - 0.5 / (r * r)) + TANGENT * r;
    let (mut low, mut high) = (1.0, 100.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if moment(middle) < COUPLE {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (levels, turns) = (run.column("level")?, run.column("turn")?);
    let r = curvature();
    let bent = levels.iter().zip(&turns).find(|(level, _)| **level == 1.0).map(|(_, turn)| *turn);
    let left = turns.last().copied().filter(|_| run.done());
    let off = |turn: Option<f64>, exact: f64| turn.map(|turn| 100.0 * (turn / (exact * TURN) - 1.0).abs());
    let reason = "slices in place of a line through the thickness, of the order of 1/n²";
    Ok(vec![
        Metric::error(BENT, off(bent, r), "%").near(OF_BENT.of(run)?, reason),
        Metric::error(LEFT, off(left, r - COUPLE), "%").near(OF_LEFT.of(run)?, reason),
    ])
}
