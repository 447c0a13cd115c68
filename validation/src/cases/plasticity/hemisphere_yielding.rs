//! hemisphere-yielding: a hemisphere with a hole that yields under two pairs of forces.

use crate::cases::plasticity::bricks::Bricks;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/hemisphere-yielding.toml");
const OFF: &str = "greatest error of the load";
/// The table, and what of it is compared.
const TABLE: Bricks = Bricks {
    table: "plasticity_hemisphere",
    known: ["inward", "P"],
    found: ["inward", "level"],
    unit: 0.06,
    between: [0.75, 8.0],
};

/// Errors \[% of the load\].
const MEASURED: Measured = Measured(&[(STATIC, &[("16 cells", 0.34), ("32 cells", 0.64)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere-yielding",
        title: "A hemisphere pulled and pinched past its yield",
        about: "Linear hardening, forces to .06: the force at equal inward ways of .75 to 8, eight tenths of the radius.",
        citation: "elements of CalculiX; data of Simo and Kennedy 1992",
        variants: [16, 32].map(sphere).into(),
        each,
        headline: Some(Headline::new(OFF, 0.1)),
        figures: |runs| {
            let words = ["Force against the inward way", "Solid elements and shells."];
            TABLE.figure(runs, words, [Axis::linear("inward way"), Axis::linear("force")])
        },
        ..Case::default()
    }
}

fn sphere(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.sphere.particles", format!("[{}, {}]", cells + 1, cells + 1))
        .quick_if(cells == 16)
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let worst = TABLE.worst(run)?.filter(|_| run.done());
    let reason = "cells of second order; lines between levels; the elements' own .13 % in the mean";
    Ok(vec![Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason)])
}
