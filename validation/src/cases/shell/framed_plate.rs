//! framed-plate: a plate whose sizes follow from two numbers and whose frame is a difference of sets, against a plate without a frame and against itself at another size.

use crate::judge::{Case, Headline, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/framed-plate.toml");
const MIDDLE: &str = "deflection of the middle";
const SCALED: &str = "deflection at twice the size, over half of that at the first";
const FRAMED: &str = "framed, side 400";

/// `w D/(q a⁴)` of a clamped square plate of a hundredth of its side, from `plate_static_square`.
const CLAMPED: f64 = 0.00126785;

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    let plate = |grid: &str| Variant::scene(STATIC, SCENE, grid);
    let even = plate("even, side 400")
        .set("parts[0].section.homogeneous.thickness", "\"${thickness}\"")
        .set("loads[0]", "{ on = \"all\", pressure = { value = -0.01 } }");
    Case {
        name: "framed-plate",
        title: "Plate with a thick frame, its sizes by parameters",
        about: "Particles, sections and sets of the scene follow from a side and a slenderness by expressions. With a frame as thick as the plate under a pressure it is a clamped plate; \
                twice as large at the same slenderness it gives way half as much under the same force.",
        citation: "thick plates by a Ritz series (this project's reference file); dimensions",
        variants: vec![
            even.judged(|run, _| judged_even(run)),
            plate(FRAMED),
            plate("framed, side 800").set("parameters.side", 800.0).judged(judged_scaled),
        ],
        headline: Some(Headline::new(MIDDLE, 1.0)),
        ..Case::default()
    }
}

fn judged_even(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (side, thickness) = (400.0_f64, 4.0_f64);
    let stiffness = 70e3 * thickness.powi(3) / (12.0 * (1.0 - 0.3 * 0.3));
    let exact = CLAMPED * 0.01 * side.powi(4) / stiffness;
    let percent = run.last("w_middle")?.map(|found| 100.0 * (found.abs() / exact - 1.0));
    Ok(vec![Metric::error(MIDDLE, percent, "%").within(OFF, "three times the rounding of the reference")])
}

/// Half of the last digit of the reference, three times over \[%\]; the plate is off by 7e-6 %.
const OFF: f64 = 0.0012;

fn judged_scaled(run: &Run, runs: &Runs) -> Result<Vec<Metric>, JudgeError> {
    let Some(small) = runs.get(STATIC, FRAMED)? else { return Ok(Vec::new()) };
    let (Some(large), Some(small)) = (run.last("w_middle")?, small.last("w_middle")?) else {
        return Ok(Vec::new());
    };
    let off = Some(100.0 * (2.0 * large / small - 1.0));
    Ok(vec![Metric::error(SCALED, off, "%").within(1e-6, "rounding of the solves")])
}
