//! heat: a plate between walls that buckles as it is heated, and two metals that bend, against closed forms.

use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const PLATE: &str = include_str!("../../../../scenes/heated-plate.toml");
const STRIP: &str = include_str!("../../../../scenes/bimetal-strip.toml");
const NAME: &str = "critical temperature";
/// Length of the strip \[m\].
const LENGTH: f64 = 0.2;

/// The scenes, their references, and how far they may differ.
pub fn case() -> Case {
    let plate = |counts| Variant::new(STATIC, PLATE, "plate", counts).quick().on("plate between walls");
    let strip = |counts| Variant::new(STATIC, STRIP, "plate", counts).quick().on("strip of two metals");
    Case {
        name: "heat",
        title: "Plate and strip that are heated",
        about: "Changes of temperature: a square plate whose hinged edges hold it in its plane buckles, and a strip of steel on brass bends.",
        citation: "closed forms of the theory of plates; S. Timoshenko, J. Opt. Soc. Am. 11 (1925)",
        variants: vec![
            plate([21, 21]).judged(|run, _| buckled(run, 20.0)),
            plate([41, 41]).judged(|run, _| buckled(run, 40.0)),
            strip([31, 4]).judged(|run, _| bent(run)),
            strip([61, 4]).judged(|run, _| bent(run)),
        ],
        headline: Some(Headline::new(NAME, 0.5)),
        ..Case::default()
    }
}

fn buckled(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let exact = reference("heated_shells")?.number(0, "value")?;
    let percent = run.last("level")?.map(|found| 100.0 * (found / exact - 1.0));
    // .077 % with 40 cells.
    let reason =
        "three times what one curvature and one gradient a cell leave of a half wave, of second order";
    Ok(vec![Metric::error(NAME, percent, "%").within(3.0 * 0.077 * (40.0 / cells).powi(2), reason)])
}

fn bent(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let turn = LENGTH * reference("heated_shells")?.number(1, "value")?;
    let percent = run.last("turn")?.map(|found| 100.0 * (found.abs() / turn - 1.0));
    // .0076 % with 30 cells and with 60.
    let reason =
        "three times what the bend across takes from that along, which Timoshenko's strip does not have";
    Ok(vec![Metric::error("turn of the end", percent, "%").within(3.0 * 0.0076, reason)])
}
