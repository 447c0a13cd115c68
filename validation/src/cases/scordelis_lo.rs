//! scordelis-lo: a cylindrical roof under its weight; membrane and bending share the load.
//!
//! ```text
//!      .-'''-.       quarter: symmetry at the crown and at mid-length,
//!    .'       '.     diaphragm at the end, straight edge free
//! ```

use benchmarks_ref::fe_shell::cases::scordelis_lo as elements;

use super::dial::ELEMENTS;
use super::linear;
use crate::case::{Case, Headline, Published, Run};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../scenes/scordelis-lo.toml");
/// Published deflection of the middle of the free edge.
const DEFLECTION: f64 = 0.3024;
const NAME: &str = "edge deflection";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "scordelis-lo",
        title: "Scordelis–Lo roof",
        about: "Deflection of the middle of the free edge, linear. Inextensional bending and membrane action both carry \
                the weight: an element or particle whose membrane locks in bending stays behind.",
        citation: "MacNeal and Harder 1985; bricks of this project's reference file: 0.3014",
        variants: linear::lattices(SCENE, "cylinder", &[11, 17, 21, 41], elements),
        each,
        together: |_| Ok(Vec::new()),
        // The published value and that of bricks are 0.33 % apart.
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
    Ok(vec![linear::figure(run, NAME, "w_edge", DEFLECTION, judged)?])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let error = 100.0 * (linear::bricks(0)? / DEFLECTION - 1.0).abs();
    Ok(vec![
        Published { source: "MacNeal and Harder 1985", error: None },
        Published { source: "CalculiX, bricks", error: Some(error) },
    ])
}
