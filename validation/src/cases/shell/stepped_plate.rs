//! stepped-plate: a strip of two thicknesses and heights against closed forms of two beams.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/stepped-plate.toml");
const NAME: &str = "deflection";

/// As in the scene: modulus, width, length, where the thickness steps, the two thicknesses \[N, m\].
const YOUNG: f64 = 210e9;
const WIDTH: f64 = 0.1;
const LENGTH: f64 = 0.6;
const STEP: f64 = 0.3;
const THICK: f64 = 0.008;
const THIN: f64 = 0.005;
/// Force at the end \[N\].
const FORCE: f64 = 100.0;
/// Height of the thick part over the thin one with their lower faces flush \[m\].
const FLUSH: f64 = 0.0015;

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    let strip = |counts| Variant::new(STATIC, SCENE, "plate", counts).quick();
    let pulled = |counts| {
        strip(counts)
            .set("parts.0.offset", FLUSH)
            .set("loads.0.force.total", format!("[{FORCE}, 0.0, 0.0]"))
            .on("lower faces flush, pulled")
    };
    Case {
        name: "stepped-plate",
        title: "Strip of two thicknesses, concentric and eccentric",
        about: "Sections of their own in cells: the deflection under an end force, the stress beside the clamp and the energy of \
                each part as those of two beams. With the thick part higher, a pull along the thin one bends the strip by \
                the offset alone.",
        citation: "closed forms of the theory of beams, with transverse shear",
        variants: vec![
            strip([25, 5]).judged(|run, _| bent(run, 24.0)),
            strip([49, 9]).judged(|run, _| bent(run, 48.0)),
            pulled([25, 5]).judged(|run, _| drawn(run)),
            pulled([49, 9]).judged(|run, _| drawn(run)),
        ],
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

/// Bending stiffness of a thickness \[N m²\].
fn stiffness(thickness: f64) -> f64 {
    YOUNG * WIDTH * thickness.powi(3) / 12.0
}

/// Energy of a part between two distances from the end: `∫ (P s)²/2EI ds + P² length/2GA` \[N m\].
fn energy(near: f64, far: f64, thickness: f64) -> f64 {
    let shear = 5.0 / 6.0 * 0.5 * YOUNG * WIDTH * thickness;
    0.5 * FORCE.powi(2) * ((far.powi(3) - near.powi(3)) / (3.0 * stiffness(thickness)) + (far - near) / shear)
}

/// Under the end force, with so many cells along the strip.
fn bent(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let [thin, thick] = [energy(0.0, LENGTH - STEP, THIN), energy(LENGTH - STEP, LENGTH, THICK)];
    let percent = |column: &str, exact: f64| -> Result<_, JudgeError> {
        Ok(run.last(column)?.map(|found| 100.0 * (found / exact - 1.0)))
    };
    // Errors of 48 cells are .02, .006 and .044 %.
    let times = 3.0 * (48.0 / cells).powi(2);
    let curvature = "three times what one curvature a cell leaves of a moment that varies, of second order";
    // The stress of a cell is that of its middle.
    let arm = LENGTH - 0.5 * LENGTH / cells;
    let beside_clamp = 6.0 * FORCE * arm / (WIDTH * THICK * THICK);
    let exact =
        "the moment of a cell is in balance with the end force: the differences of a linear answer are left";
    Ok(vec![
        Metric::error(NAME, percent("w_end", 2.0 * (thin + thick) / FORCE)?, "%")
            .within(0.02 * times, curvature),
        Metric::error("energy of the thick part", percent("energy_root", thick)?, "%")
            .within(0.006 * times, curvature),
        Metric::error("energy of the thin part", percent("energy_tip", thin)?, "%")
            .within(0.044 * times, curvature),
        Metric::error("stress beside the clamp", percent("stress", beside_clamp)?, "%").within(0.001, exact),
        Metric::error("moment of the supports", percent("M_clamp", FORCE * LENGTH)?, "%")
            .within(0.001, exact),
    ])
}

fn drawn(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    // The pull acts by the height below the middle of the thick part: κ = P e/EI there, a straight line beyond.
    let curvature = FORCE * FLUSH / stiffness(THICK);
    let exact = curvature * STEP * (LENGTH - 0.5 * STEP);
    let percent = run.last("w_end")?.map(|found| 100.0 * (found / exact - 1.0));
    let reason = "the moment is the same everywhere: the cells take it as it is";
    Ok(vec![Metric::error(NAME, percent, "%").within(0.01, reason)])
}
