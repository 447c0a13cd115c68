//! warm-strip: bonds that are warm by their middles, against the stress of a long strip with a parabola of temperature.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{PAIRWISE, STATE};
use crate::{JudgeError, Metric};

const STRIP: &str = include_str!("../../../../scenes/strip-cooled-bonds.toml");
const STATE_BASED: &str = "{ state-based = { horizon = 3.015, plane = 'stress', correction = 'balanced' } }";
const CORE: &str = "stress in the core";

/// The strip, its closed form, and how far the two may differ.
pub fn case() -> Case {
    let strip = |method: &'static str, spacing: f64| {
        Variant::scene(method, STRIP, format!("{} across", 20.0 / spacing))
            .set("bodies.strip.solid.geometry.block.spacing", spacing)
            .quick_if(spacing == 1.0)
            .judged(move |run, _| judged(run, spacing))
    };
    let state = |spacing: f64| strip(STATE, spacing).set("bodies.strip.solid.formulation", STATE_BASED);
    Case {
        name: "warm-strip",
        title: "Strip of bonds that is warm in its core and cooled at its faces",
        about: "A strip in plane stress gives heat by its whole volume and is cooled at both faces, which conducts along its bonds: the temperature is a parabola. \
                A long free strip is pressed in its core by a third of EαT₀ and pulled at its faces by two thirds. What a face node shows is the stress of the bonds that are there.",
        citation: "closed form [boley1960]",
        variants: vec![strip(PAIRWISE, 1.0), strip(PAIRWISE, 0.5), state(1.0), state(0.5)],
        headline: Some(Headline::new(CORE, 1.0)),
        ..Case::default()
    }
}

/// Stresses in the middle of the length, `Eα (⅔ T₀ − T)`.
fn judged(run: &Run, spacing: f64) -> Result<Vec<Metric>, JudgeError> {
    let warmest = 200e3 * 11e-6 * 10.0 * 10.0 * 10.0 / (2.0 * 2.0);
    let core = run.last("core")?.map(|found| 100.0 * (found / (-warmest / 3.0) - 1.0));
    let face = run.last("face")?.map(|found| 100.0 * (found / (2.0 * warmest / 3.0) - 1.0));
    let reason = "three times what 20 cells across leave, .49 %, of second order in the horizon";
    Ok(vec![
        Metric::error(CORE, core, "%").within(1.5 * spacing * spacing, reason),
        Metric::error("stress of a node on a face", face, "%")
            .shown("a family that a face cuts has the stress of the bonds that are there"),
    ])
}
