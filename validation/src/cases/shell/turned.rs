//! turned: the strip cases turned in space, which must not change their curves.

use crate::judge::measure::largest;
use crate::judge::{Case, Recorded, Run, Runs, Variant};
use crate::methods::CELL;
use crate::support::scenes;
use crate::{JudgeError, Metric};

/// A strip, its levels, and the kinetic over internal energy at which it rests: a little above the round-off of each.
struct Strip {
    name: &'static str,
    scene: &'static str,
    levels: &'static str,
    rest: f64,
}

const STRIPS: [Strip; 4] = [
    Strip { name: "ring", scene: scenes::RING, levels: "[0.25, 0.5, 0.75, 1.0]", rest: 1e-24 },
    Strip {
        name: "ring-green-lagrange",
        scene: scenes::RING_GREEN_LAGRANGE,
        levels: "[0.25, 0.5, 0.75, 1.0]",
        rest: 1e-24,
    },
    Strip { name: "thin-ring", scene: scenes::THIN_RING, levels: "[0.25, 0.5]", rest: 1e-22 },
    Strip {
        name: "cantilever-end-shear",
        scene: scenes::CANTILEVER_END_SHEAR,
        levels: "[0.5, 1.0]",
        rest: 1e-22,
    },
];
/// Axis and angle in degrees, with their name; the first is the reference.
const TURNS: [(&str, &str); 5] = [
    ("0°", "{ axis = [0.0, 1.0, 0.0], degrees = 0.0 }"),
    ("45°", "{ axis = [0.0, 1.0, 0.0], degrees = 45.0 }"),
    ("80°", "{ axis = [0.0, 1.0, 0.0], degrees = 80.0 }"),
    ("90°", "{ axis = [0.0, 1.0, 0.0], degrees = 90.0 }"),
    ("57° skew", "{ axis = [1.0, 2.0, 3.0], degrees = 57.0 }"),
];
const GRID: &str = "25×3";

/// The scenes, their reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "turned",
        title: "The strips turned in space",
        about: "Geometry, supports, loads and probes turned together, about y and about the axis (1, 2, 3): the curves must \
                not change. Round-off makes the stable step, and with it the number of steps, differ a little, so the \
                motion is followed down to round-off (1e-24 to 1e-22 of the strain energy); what is compared are the states of \
                rest and not two moments of a decay.",
        citation: "reference: the same scene at 0°",
        variants: variants(),
        together,
        ..Case::default()
    }
}

fn method(strip: &str, turn: &str) -> String {
    format!("{CELL}, {strip}, {turn}")
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for Strip { name, scene, levels, rest } in STRIPS {
        for (turn, orientation) in TURNS {
            let variant = Variant::new(&method(name, turn), scene, "plate", [25, 3])
                .set("orientation", orientation)
                .set("analysis.explicit.quasi-static.levels", levels)
                .set("analysis.explicit.quasi-static.tolerance", rest)
                .set("analysis.explicit.quasi-static.hold", 40.0);
            variants.push(variant.quick_if(name == "ring"));
        }
    }
    variants
}

fn together(runs: &Runs) -> Result<Vec<Recorded>, JudgeError> {
    let mut metrics = Vec::new();
    for Strip { name, .. } in STRIPS {
        let Some(straight) = runs.get(&method(name, TURNS[0].0), GRID)? else { continue };
        for (turn, _) in &TURNS[1..] {
            let Some(at) = runs.number(&method(name, turn), GRID)? else { continue };
            metrics.push((
                at,
                Metric::error("difference from 0°", difference(straight, &runs.chosen[at])?, "-").within(
                    1e-9,
                    "left is round-off, 1e-15, and 1e-11 where two runs stop at different steps of the same decay",
                ),
            ));
        }
    }
    Ok(metrics)
}

/// Largest difference of a tip displacement over the largest tip displacement; none if the runs ended differently.
fn difference(straight: &Run, turned: &Run) -> Result<Option<f64>, JudgeError> {
    let (mut worst, mut size) = (Vec::new(), 0.0_f64);
    for column in ["minus_U_tip", "W_tip"] {
        let (a, b) = (straight.column(column)?, turned.column(column)?);
        if a.len() != b.len() {
            return Ok(None);
        }
        size = a.iter().fold(size, |size, value| size.max(value.abs()));
        worst.extend(a.iter().zip(&b).map(|(a, b)| Some((a - b).abs())));
    }
    Ok(largest(worst).map(|worst| worst / size))
}
