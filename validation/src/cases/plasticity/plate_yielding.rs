//! plate-yielding: a square plate on four edges that carries a pressure far past its yield.

use crate::cases::plasticity::bricks::Bricks;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/plate-yielding.toml");
const OFF: &str = "greatest error of the load";
/// The table, and what of it is compared.
const TABLE: Bricks = Bricks {
    table: "plasticity_square_plate",
    known: ["w_centre", "p"],
    found: ["w", "level"],
    unit: 0.07,
    between: [2.0, 20.0],
};

/// Errors \[% of the load\].
const MEASURED: Measured = Measured(&[(STATIC, &[("16 cells", 1.2), ("24 cells", 0.87)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-yielding",
        title: "A square plate past its yield",
        about: "No hardening: the pressure at equal deflections of the centre from .5 to 20 mm, eight thicknesses; beyond, folds are narrower than a cell.",
        citation: "elements of CalculiX; data of Simo and Kennedy 1992",
        variants: [16, 24].map(plate).into(),
        each,
        headline: Some(Headline::new(OFF, 0.1)),
        figures: |runs| {
            let words = ["Pressure against the deflection of the centre", "Solid elements and shells."];
            TABLE.figure(
                runs,
                words,
                [Axis::linear("deflection of the centre [mm]"), Axis::linear("pressure [N/mm²]")],
            )
        },
        ..Case::default()
    }
}

fn plate(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.plate.particles", format!("[{}, {}]", cells + 1, cells + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let worst = TABLE.worst(run)?.filter(|_| run.done());
    let reason =
        "cells of second order, hinges along the diagonals of the order of a cell; lines between levels";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
