//! cylinder-yielding: a cylinder between diaphragms that yields under two forces.

use crate::cases::plasticity::bricks::Bricks;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cylinder-yielding.toml");
const OFF: &str = "greatest error of the load";
/// The table, and what of it is compared.
const TABLE: Bricks = Bricks {
    table: "plasticity_pinched_cylinder",
    known: ["w", "F"],
    found: ["w", "F"],
    unit: 1.0,
    between: [12.0, 100.0],
};

/// Errors \[% of the load\].
const MEASURED: Measured = Measured(&[(STATIC, &[("16 by 16 cells", 9.1), ("30 by 24 cells", 2.9)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cylinder-yielding",
        title: "A pinched cylinder past its yield",
        about: "Linear hardening, driven to a third of the radius: the force at equal ways from 12 to 100.",
        citation: "elements of CalculiX; data of Simo and Kennedy 1992",
        variants: [[16, 16], [30, 24]].map(cylinder).into(),
        each,
        headline: Some(Headline::new(OFF, 0.3)),
        figures: |runs| {
            let words = ["Force against its way", "Solid elements and shells."];
            TABLE.figure(runs, words, [Axis::linear("way under the force"), Axis::linear("force")])
        },
        ..Case::default()
    }
}

fn cylinder([around, along]: [usize; 2]) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{around} by {along} cells"))
        .set("geometry.cylinder.particles", format!("[{}, {}]", around + 1, along + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let worst = TABLE.worst(run)?.filter(|_| run.done());
    let reason =
        "the dimple under the force is of a few cells; the elements' own 3 %, 5 to 10 in the first 10";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
