//! paddle-on-hinge: a box under water swings about a hinge over it.
//!
//! ```text
//!           o            hinge
//!  |~~~~~~~~¦~~~~~~~|
//!  |      ┌───┐     |
//!  |      │ ↔ │/\/\/|    spring
//!  |      └───┘     |
//!  └────────────────┘
//! ```

use benchmarks_ref::floating_box::crossings;
use benchmarks_ref::hinged_box::HingedBox;

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::RIGID;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/paddle-on-hinge.toml");
const HALF: &str = "half a swing, mean of five";
const PADDLE: HingedBox = HingedBox { tank: [1.2, 0.6], section: [0.2, 0.2], heights: [0.2, 0.8] };
/// Stiffness over the density of water and by width \[m³/s²\]; size of the cells \[m\].
const STIFFNESS: f64 = 38.4;
const CELL: f64 = 0.025;

/// Two spacings, their reference, and how far they may differ.
pub fn case() -> Case {
    let swinging = |spacing: f64, grid: &str| {
        Variant::scene(RIGID, SCENE, grid)
            .set("bodies.water.fluid.geometry.block.spacing", spacing)
            .unsettled()
            .full_if(spacing < 0.02)
            .judged(|run, _| swings(run))
    };
    Case {
        name: "paddle-on-hinge",
        title: "A paddle on a hinge",
        about: "A box as dense as water, all under it, hangs on a hinge above the water and swings against a spring, so fast that no wave goes out. Potential flow in the same tank, \
                by finite volumes, says how much water swings with it; it has no viscosity and no vortices at the corners.",
        citation: "potential flow, benchmarks-ref/src/hinged_box.rs",
        variants: vec![swinging(0.02, "10 spacings an edge"), swinging(0.01, "20 spacings an edge")],
        headline: Some(Headline::new(HALF, 0.1)),
        ..Case::default()
    }
}

fn swings(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let rows: Vec<[f64; 2]> =
        run.column("time")?.into_iter().zip(run.column("x")?).map(|(time, x)| [time, x]).collect();
    let exact = PADDLE.half_swing(1.0, STIFFNESS, CELL);
    // The first crossing that is found is the end of the first half.
    let found = crossings(&rows).get(4).map(|fifth| fifth / 5.0);
    let reason = "sound and the start at once make half swings differ by 2 % from one to the next, which five of them level out; friction goes with the sides, vortices leave the corners: none of \
                  it in potential flow; measured .04 % with both spacings; asked 1 %";
    Ok(vec![Metric::compared(HALF, found, "s", exact).within(0.01 * exact, reason)])
}
