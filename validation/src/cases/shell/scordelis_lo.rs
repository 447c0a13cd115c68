//! scordelis-lo: a cylindrical roof under its weight; membrane and bending share the load.
//!
//! ```text
//!      .-'''-.       quarter: symmetry at the crown and at mid-length,
//!    .'       '.     diaphragm at the end, straight edge free
//! ```

use benchmarks_ref::fe_shell::cases::scordelis_lo as elements;

use crate::judge::Measured;
use crate::judge::{Case, Headline, Run};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::linear;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/scordelis-lo.toml");
/// Published deflection of the middle of the free edge.
const DEFLECTION: f64 = 0.3024;
const NAME: &str = "edge deflection";
/// The same held against bricks, which stand for the limit of fine meshes.
const BY_BRICKS: &str = "over that of bricks";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "scordelis-lo",
        title: "Scordelis–Lo roof",
        about: "Deflection of the middle of the free edge, linear. Inextensional bending and membrane action both carry \
                the weight: an element or particle whose membrane locks in bending stays behind.",
        citation: "MacNeal and Harder 1985; bricks of this project's reference file: 0.3014",
        variants: linear::lattices(SCENE, "cylinder", &[11, 17, 21, 41], (21, 17), elements),
        each,
        // The published value and that of bricks are 0.33 % apart.
        headline: Some(Headline { metric: NAME, floor: 0.1, published: || linear::published(0, DEFLECTION) }),
        peers: || linear::calculix("scordelis-lo", DEFLECTION),
        ..Case::default()
    }
}

/// Errors over the published deflection \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("11×11", 2.8), ("17×17", 0.95), ("21×21", 0.54), ("41×41", 0.034)]),
    (ELEMENTS, &[("11×11", 0.15), ("17×17", 0.24), ("21×21", 0.31), ("41×41", 0.33)]),
]);

/// Errors over that of bricks \[%\].
#[rustfmt::skip] // a paragraph a method
const OF_BRICKS: Measured = Measured(&[
    (STATIC, &[("11×11", 3.2), ("17×17", 1.3), ("21×21", 0.87), ("41×41", 0.32)]),
    (ELEMENTS, &[("11×11", 0.48), ("17×17", 0.096), ("21×21", 0.034), ("41×41", 0.034)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "of second order in the spacing; the published value is that of elements, .3 % above bricks";
    let by_bricks = "of second order in the spacing";
    Ok(vec![
        linear::figure(run, NAME, "w_edge", DEFLECTION, (&MEASURED, reason))?,
        linear::figure(run, BY_BRICKS, "w_edge", linear::bricks(0)?, (&OF_BRICKS, by_bricks))?,
    ])
}
