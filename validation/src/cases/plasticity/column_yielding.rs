//! column-yielding: a column that yields before it buckles.
//!
//! ```text
//!  ▐━━━━━━━━◀▐  P_t = π² D_t b/L²      D_t = (4/3) E_t t³/12      E_t = E H/(E + H)
//! ```

use std::f64::consts::PI;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::support::studies::off;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/column-yielding.toml");
const OFF: &str = "error of the load at the bifurcation";
/// E, H \[F/L²\].
const MODULI: [f64; 2] = [70_000.0, 70_000.0 / 9.0];
/// Length, width \[L\].
const SIZE: [f64; 2] = [60.0, 3.0];

/// Errors \[%\].
const MEASURED: Measured = Measured(&[(
    STATIC,
    &[("40 cells, t/L 1/30", 0.34), ("80 cells, t/L 1/30", 0.26), ("80 cells, t/L 1/60", 0.084)],
)]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "column-yielding",
        title: "A column that yields before it buckles",
        about: "Pushed together in plane strain without an imperfection: the load at which the path bifurcates is that of the tangent modulus, a tenth of \
                the elastic one, since all of the section flows on there; transverse shear counted by Engesser's sum of flexibilities. Half as thick, with a \
                quarter of the strain, the terms left out are a quarter.",
        citation: "Engesser 1889, Shanley 1947",
        variants: vec![column(40, 2.0).quick_if(true), column(80, 2.0), column(80, 1.0).quick_if(true)],
        each,
        headline: Some(Headline::new(OFF, 0.01)),
        ..Case::default()
    }
}

fn column(cells: usize, thickness: f64) -> Variant {
    let thin = thickness < 2.0;
    let share = if thin { 0.25 } else { 1.0 };
    Variant::scene(STATIC, SCENE, format!("{cells} cells, t/L 1/{}", SIZE[0] / thickness))
        .set("geometry.plate.particles", format!("[{}, 3]", cells + 1))
        .set("section.homogeneous.thickness", format!("{thickness:?}"))
        .set("supports[4].moved.by", format!("{:?}", 0.03 * share))
        .set("material.plastic.hardening.linear.yield-stress", format!("{:?}", 4.0 * share))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let ([young, hard], [length, width]) = (MODULI, SIZE);
    let thickness = if run.variant.grid.ends_with("1/60") { 1.0 } else { 2.0 };
    let tangent = young * hard / (young + hard);
    let bending = PI * PI / (length * length) * 4.0 / 3.0 * tangent * width * f64::powi(thickness, 3) / 12.0;
    let shear = 5.0 / 6.0 * young / 3.0 * width * thickness;
    let exact = 1.0 / (1.0 / bending + 1.0 / shear);
    let at = run.outcome.critical.iter().find(|point| point.kind == "bifurcation").map(|point| point.level);
    let levels: Vec<(f64, f64)> = run.column("level")?.into_iter().zip(run.column("F")?).collect();
    let load = at.and_then(|at| {
        let pair = levels.windows(2).find(|pair| (pair[0].0..=pair[1].0).contains(&at))?;
        let [(a, below), (b, above)] = [pair[0], pair[1]];
        Some(below + (above - below) * (at - a) / (b - a))
    });
    let error = off(load.map(|load| load / exact)).map(f64::abs);
    let reason =
        "terms of the order of the strain, .05 % of a thick one, five of them, and cells of second order";
    Ok(vec![Metric::error(OFF, error, "%").near(MEASURED.of(run)?, reason)])
}
