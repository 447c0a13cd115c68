//! hemisphere: a thin hemisphere with a hole under two pairs of forces; almost pure bending of a double curvature.

use benchmarks_ref::fe_shell::cases::hemisphere_with_hole as elements;

use super::dial::ELEMENTS;
use super::linear;
use crate::case::{Case, Headline, Published, Run};
use crate::{JudgeError, Metric};

pub const SCENE: &str = include_str!("../../../scenes/hemisphere.toml");
/// Published displacement under a force.
const DISPLACEMENT: f64 = 0.0940;
/// The same by bricks (CalculiX), which stand for the limit of fine meshes.
pub const BRICKS: f64 = 0.0937;
const NAME: &str = "displacement under a force";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hemisphere",
        title: "Pinched hemisphere with a hole",
        about: "Displacement under a force, linear, R/t = 250. The shell bends without stretching; whatever stretches by \
                mistake (membrane locking) shows at once.",
        citation: "MacNeal and Harder 1985; bricks of this project's reference file: 0.0937",
        variants: linear::lattices(SCENE, "sphere", &[11, 17, 21, 41], elements),
        each,
        together: |_| Ok(Vec::new()),
        // The published value is given to this, and bricks lie 0.3 % below it.
        headline: Some(Headline { metric: NAME, floor: 0.1, published }),
        figures: |_| Ok(Vec::new()),
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let judged = match (run.variant.method.as_str(), run.variant.grid.as_str()) {
        (ELEMENTS, "17×17") => (Some(1.0), "issue 3: finite elements within 1 % at 16 elements a side"),
        (ELEMENTS, _) => (None, "judged at 16 elements a side"),
        (_, "21×21") => (Some(1.0), "issue 3: particles within 1 % at 21² a quarter"),
        _ => (None, "judged at 21²"),
    };
    Ok(vec![
        linear::figure(run, NAME, "outward", DISPLACEMENT, judged)?,
        linear::figure(run, "inward", "inward", DISPLACEMENT, judged)?,
    ])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let error = 100.0 * (linear::bricks(2)? / DISPLACEMENT - 1.0).abs();
    Ok(vec![
        Published { source: "MacNeal and Harder 1985", error: None },
        Published { source: "CalculiX, bricks", error: Some(error) },
    ])
}
