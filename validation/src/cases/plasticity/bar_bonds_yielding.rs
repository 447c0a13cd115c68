//! bar-bonds-yielding: a bar of peridynamic bonds drawn beyond its yield stress and let go a little.
//!
//! ```text
//!  ▐▒▒▒▒▒▒▒▒▒▒▒▒▒▒▶ u     σ = σ_y + E H/(E + H) (ε − σ_y/E),   the section thinner by 2ν σ/E and by the plastic strain
//! ```

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATE;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/bar-bonds-yielding.toml");
const SLOPE: &str = "elastic force";
const FLOWING: &str = "force that flows";
const BACK: &str = "force let go";
const COARSE: &str = "4 cells across";
const FINE: &str = "8 cells across";
const YOUNG: f64 = 200e3;
const POISSON: f64 = 0.3;
const YIELD: f64 = 250.0;
const SLOPE_PLASTIC: f64 = 2000.0;
/// Length that is drawn and section of the bar \[mm, mm²\].
const BAR: [f64; 2] = [14.0, 16.0];
/// Ends of the three rests \[s\].
const RESTS: [f64; 3] = [8.9e-5, 3.29e-4, 4.39e-4];

/// Errors \[%\].
const ELASTIC: Measured = Measured(&[(STATE, &[(COARSE, 0.58), (FINE, 0.16)])]);
const PLASTIC: Measured = Measured(&[(STATE, &[(COARSE, 1.09), (FINE, 1.24)])]);
const UNLOADED: Measured = Measured(&[(STATE, &[(COARSE, 1.19), (FINE, 0.65)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "bar-bonds-yielding",
        title: "A bar of bonds drawn beyond its yield stress",
        about: "State-based bonds that yield by von Mises' criterion with linear hardening, in time under strong damping: the force at rest below yield, at four times the \
                strain of yielding, and after a part of the way back, which is elastic. Families that the faces cut flow a little early. What is drawn is as deep as the horizon.",
        citation: "uniaxial stress in closed form",
        variants: vec![
            Variant::scene(STATE, SCENE, COARSE).quick_if(true),
            Variant::scene(STATE, SCENE, FINE).set("bodies.bar.solid.geometry.block.spacing", 0.5),
        ],
        each,
        headline: Some(Headline::new(FLOWING, 1.0)),
        ..Case::default()
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let [time, force, way] = ["time", "F", "u"].map(|name| run.column(name));
    let (time, force, way) = (time?, force?, way?);
    let at = |rest: f64| time.iter().rposition(|time| *time <= rest).filter(|_| run.done());
    let rests = RESTS.map(|rest| at(rest).map(|row| [force[row], way[row] / BAR[0]]));
    let elastic = |[force, strain]: [f64; 2]| {
        let exact = BAR[1] * YOUNG * strain * (1.0 - 2.0 * POISSON * strain);
        100.0 * (force / exact - 1.0).abs()
    };
    let flowing = |[force, strain]: [f64; 2]| {
        let beyond = strain - YIELD / YOUNG;
        let stress = YIELD + YOUNG * SLOPE_PLASTIC / (YOUNG + SLOPE_PLASTIC) * beyond;
        let thinner = 2.0 * POISSON * stress / YOUNG + (stress - YIELD) / SLOPE_PLASTIC;
        100.0 * (force / (BAR[1] * stress * (1.0 - thinner)) - 1.0).abs()
    };
    let back = rests[1].zip(rests[2]).map(|([from, drawn], [to, left])| {
        let slope = (from - to) / (BAR[1] * YOUNG * (drawn - left));
        100.0 * (slope - 1.0).abs()
    });
    let faces = "faces, where families are cut";
    Ok(vec![
        Metric::error(SLOPE, rests[0].map(elastic), "%").near(ELASTIC.of(run)?, faces),
        Metric::error(FLOWING, rests[1].map(flowing), "%").near(PLASTIC.of(run)?, faces),
        Metric::error(BACK, back, "%").near(UNLOADED.of(run)?, faces),
    ])
}
