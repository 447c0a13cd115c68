//! hemisphere: a thin hemisphere with a hole under two pairs of forces; almost pure bending of a double curvature.

use benchmarks_ref::fe_shell::cases::hemisphere_with_hole as elements;

use super::linear;
use crate::case::{Case, Headline, Run};
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
        headline: Some(Headline {
            metric: NAME,
            floor: 0.1,
            published: || linear::published(2, DISPLACEMENT),
        }),
        figures: |_| Ok(Vec::new()),
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let judged = linear::one_percent(run);
    Ok(vec![
        linear::figure(run, NAME, "outward", DISPLACEMENT, judged)?,
        linear::figure(run, "inward", "inward", DISPLACEMENT, judged)?,
    ])
}
