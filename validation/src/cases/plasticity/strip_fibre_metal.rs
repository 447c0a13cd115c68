//! strip-fibre-metal: sheets that yield with fibre between them, pulled and let back.
//!
//! ```text
//!  ▐▓▓▓▓▓▓▓▓▶ u        F(h) = b e⁻ʰ (t_m σ + t_f Q11 h)      h = ¾σ/E + √¾ α,   σ = 2(Y + Hα)/√3
//! ```

use libm::{exp, log};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-fibre-metal.toml");
const OFF: &str = "greatest error of the force";
const FLOW: &str = "error of the plastic strain";
/// E, Y and H of the sheets \[F/L²\].
const SHEETS: [f64; 3] = [72_400.0, 300.0, 1500.0];
/// E_L, E_T \[F/L²\] and ν of the fibre.
const FIBRE: [f64; 3] = [54_000.0, 9_400.0, 0.33];
/// Width, thickness of all sheets, of all fibre \[L\].
const SIZE: [f64; 3] = [10.0, 0.9, 0.5];

/// Errors \[%\].
const FORCE: Measured = Measured(&[(STATIC, &[("10 by 2 cells", 1.1e-5)])]);
const STRAIN: Measured = Measured(&[(STATIC, &[("10 by 2 cells", 3.3e-6)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "strip-fibre-metal",
        title: "A strip of fibre and metal pulled past its yield",
        about: "Three sheets of aluminium and two plies of glass fibre, held across: force at every level, pulled to 2 % and let back, and the plastic strain \
                of the sheets against the sum over the plies.",
        citation: "plane strain of plies in closed form",
        variants: vec![Variant::scene(STATIC, SCENE, "10 by 2 cells").quick_if(true)],
        each,
        headline: Some(Headline::new(OFF, 1e-6)),
        ..Case::default()
    }
}

/// Stress of a sheet and its plastic strain α at a logarithmic strain beyond α's of before: in plane strain and ν = ½ the stress across is half of that along.
fn sheet(strain: f64, before: f64) -> [f64; 2] {
    let [young, limit, slope] = SHEETS;
    let flow = 0.75_f64.sqrt();
    let trial = (strain - flow * before) * young / 0.75;
    if trial <= (limit + slope * before) / flow {
        return [trial, before];
    }
    // ¾/E (Y + Hα)/√¾ + √¾ α = h.
    let alpha = (strain - 0.75 / young * limit / flow) / (0.75 / young * slope / flow + flow);
    [(limit + slope * alpha) / flow, alpha]
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let [along, across, poisson] = FIBRE;
    let fibre = along / (1.0 - poisson * poisson * across / along);
    let [width, metal, glass] = SIZE;
    let (mut alpha, mut worst) = (0.0, 0.0_f64);
    for (stretch, force) in run.column("stretch")?.into_iter().zip(run.column("F")?).skip(1) {
        let strain = log(stretch);
        let [stress, next] = sheet(strain, alpha);
        alpha = next;
        let exact = (stress * metal + fibre * strain * glass) * width * exp(-strain);
        worst = worst.max(100.0 * (force / exact - 1.0).abs());
    }
    let flowed = run.column("plastic")?.last().map(|found| 100.0 * (found / alpha - 1.0).abs());
    let [off, flow] = [Some(worst), flowed].map(|error| error.filter(|_| run.done()));
    let reason = "Poisson's ratio is a ten-millionth below a half";
    Ok(vec![
        Metric::error(OFF, off, "%").near(FORCE.of(run)?, reason),
        Metric::error(FLOW, flow, "%").near(STRAIN.of(run)?, reason),
    ])
}
