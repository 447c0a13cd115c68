//! roof-collapsing: a roof on two end walls that collapses under its weight.

use crate::cases::plasticity::bricks::Bricks;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/roof-collapsing.toml");
const OFF: &str = "greatest error of the load";
const FAR: &str = "greatest error of the load from 1 to 1.5 m";
/// The table, and what of it is compared.
const TABLE: Bricks = Bricks {
    table: "plasticity_scordelis_roof",
    known: ["edge_midpoint_down", "p"],
    found: ["w_edge", "level"],
    unit: 0.004,
    between: [40.0, 1000.0],
};

/// The same past a metre, where one hinge gives way to others.
const BEYOND: Bricks = Bricks { between: [1000.0, 1500.0], ..TABLE };

const LIMIT: &str = "error of the limit load";
/// Limit load of the elements \[N/mm²\].
const KNOWN: f64 = 0.005_806_79;

/// Errors of the limit load \[%\].
const OF_LIMIT: Measured = Measured(&[(STATIC, &[("16 cells", 1.6), ("24 cells", 0.22)])]);
/// Errors \[% of the load\].
const MEASURED: Measured = Measured(&[(STATIC, &[("16 cells", 2.8), ("24 cells", 1.1)])]);
/// Errors past a metre \[% of the load\].
const MEASURED_FAR: Measured = Measured(&[(STATIC, &[("16 cells", 9.3), ("24 cells", 6.1)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "roof-collapsing",
        title: "A roof past its limit load",
        about: "No hardening, along the path by arc length: the load at equal ways of the middle of the free edge from 40 to 1000 mm and to 1500 mm, and the limit load.",
        citation: "elements of CalculiX; data of Roehl and Ramm",
        variants: [16, 24].map(roof).into(),
        each,
        headline: Some(Headline::new(OFF, 0.3)),
        figures: |runs| {
            let words = ["Load against the way of the free edge", "Solid elements and shells."];
            TABLE.figure(
                runs,
                words,
                [Axis::linear("way of the middle of the free edge [mm]"), Axis::linear("load [N/mm²]")],
            )
        },
        ..Case::default()
    }
}

fn roof(cells: usize) -> Variant {
    Variant::scene(STATIC, SCENE, format!("{cells} cells"))
        .set("geometry.cylinder.particles", format!("[{}, {}]", cells + 1, cells + 1))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let worst = TABLE.worst(run)?.filter(|_| run.done());
    let far = BEYOND.worst(run)?.filter(|_| run.done());
    let reason = "hinges of the order of a cell; the elements' own 3 %, likely 2 % high at the limit";
    // The first limit point, before the edge has come down by a metre.
    let paired = run.column("w_edge")?.into_iter().zip(run.column("level")?);
    let greatest = paired.filter(|(way, _)| *way < 1000.0).map(|(_, level)| level).fold(0.0, f64::max);
    let limit = run.done().then_some(100.0 * (greatest * TABLE.unit / KNOWN - 1.0).abs());
    Ok(vec![
        Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason),
        Metric::error(FAR, far, "%").near(MEASURED_FAR.of(run)?, reason),
        Metric::error(LIMIT, limit, "%").near(OF_LIMIT.of(run)?, reason),
    ])
}
