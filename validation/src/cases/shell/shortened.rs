//! shortened: a plate whose edge is moved, through buckling, against closed forms.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const PLATE: &str = include_str!("../../../../scenes/plate-shortened.toml");

/// Stiffness against being shortened before buckling, E t b/a \[N/mm\].
const BEFORE: f64 = 70_000.0;
/// 4π²D/b, D = E t³/12(1 − ν²) \[N\].
const CRITICAL: f64 = 1265.33;
/// Shortening at level one \[mm\].
const FULL: f64 = 0.0544;
/// Levels between which the stiffness beyond buckling is taken: 1.1 and 1.2 times the critical one.
const BEYOND: [f64; 2] = [11.0 / 30.0, 12.0 / 30.0];
/// Shares of the stiffness that are kept beyond buckling while the sides may wave in the plane.
const KEPT: f64 = 0.408;
const NAME: &str = "critical force";

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    let plate = || Variant::new(STATIC, PLATE, "plate", [21, 21]).quick();
    Case {
        name: "shortened",
        title: "Plate shortened by an edge, through buckling",
        about: "An edge is moved as a whole, by level, beside a pressure that shows the way; the force is read. Buckling of \
                the same scene gives the critical force, the path the stiffness before and beyond.",
        citation: "Timoshenko and Gere 1961, sections 9.2 and 9.13; Hemp 1945 for the stiffness beyond",
        variants: vec![
            plate().on("buckling").set("analysis.buckling.modes", 1).judged(|run, _| critical(run)),
            plate().on("path").judged(|run, _| path(run)),
        ],
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

fn critical(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let level = run.column("level")?.first().copied();
    let percent = level.map(|level| 100.0 * (level * FULL * BEFORE / CRITICAL - 1.0));
    let reason = "three times the .04 % of 21×21; a critical level of the force in place of the motion would be the same";
    Ok(vec![Metric::error(NAME, percent, "%").within(0.12, reason)])
}

fn path(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (levels, forces) = (run.column("level")?, run.column("P")?);
    let at = |level: f64| {
        let row = levels.iter().position(|found| (found - level).abs() < 1e-9)?;
        forces.get(row).copied()
    };
    let before = at(0.1).map(|force| 100.0 * (force / (0.1 * FULL * BEFORE) - 1.0));
    let [start, end] = BEYOND.map(at);
    let beyond = start.zip(end).map(|(start, end)| {
        let slope = (end - start) / ((BEYOND[1] - BEYOND[0]) * FULL);
        100.0 * (slope / (KEPT * BEFORE) - 1.0)
    });
    Ok(vec![
        Metric::error("stiffness before", before, "%").within(0.02, "uniform strain: what the pressure adds is .003 %"),
        Metric::error("stiffness beyond", beyond, "%").within(
            5.0,
            "three times the 1.6 % measured: the share holds at the critical force and falls from there on, by .01 \
             to 1.2 times it",
        ),
    ])
}
