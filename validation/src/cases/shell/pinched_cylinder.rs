//! pinched-cylinder: a cylinder between diaphragms under two point forces; a dimple that the lattice has to resolve.

use benchmarks_ref::fe_shell::cases::pinched_cylinder as elements;

use crate::judge::Measured;
use crate::judge::{Case, Headline, Published, Run, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::linear;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/pinched-cylinder.toml");
/// Deflection under the force by a series of Kirchhoff's theory.
const DEFLECTION: f64 = 1.8248e-5;
const NAME: &str = "deflection under the force";

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let mut variants = linear::lattices(SCENE, "cylinder", &[11, 21, 25, 41], (21, 0), |n| elements(n, 1.0));
    // Cells that are nearly square resolve the dimple alike in both directions.
    variants.push(Variant::new(STATIC, SCENE, "cylinder", [26, 17]).quick());
    // Nodes crowded towards the force with this power of the uniform place.
    let graded = Variant::elements(ELEMENTS, [25, 25], || elements(24, 1.3)).on("graded 1.3");
    variants.push(graded.quick().usual_if(true));
    Case {
        name: "pinched-cylinder",
        title: "Pinched cylinder between diaphragms",
        about: "Deflection under the force, linear. The reference is the series of a shell without transverse shear; with it \
                a point force has no finite deflection, and answers grow slowly with refinement beyond the reference \
                (bricks: 1.850 to 1.865e-5 on graded meshes).",
        citation: "Belytschko et al. 1985; graded bricks of this project's reference file",
        variants,
        each,
        headline: Some(Headline { metric: NAME, floor: 0.5, published }),
        peers: || linear::calculix("pinched-cylinder", DEFLECTION),
        ..Case::default()
    }
}

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[("11×11", 13.0), ("21×21", 2.2), ("25×25", 0.94), ("41×41", 0.78), ("26×17", 0.88)]),
    (ELEMENTS, &[("11×11", 17.0), ("21×21", 4.2), ("25×25", 2.7), ("41×41", 0.27), ("25×25 graded 1.3", 0.7)]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "coarse lattices stay behind the dimple; fine ones grow past the series, which has no shear, as bricks do \
                  (1.4 to 2.2 %): a point force has no finite deflection";
    Ok(vec![linear::figure(run, NAME, "w_load", DEFLECTION, (&MEASURED, reason))?])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    // The file holds a text: 16×16 uniform 1.8272e-5; graded 40×40 1.8647e-5.
    Ok(vec![
        Published { source: "series, Kirchhoff", error: None },
        Published {
            source: "CalculiX, bricks 40×40 graded",
            error: Some(100.0 * (1.8647e-5 / DEFLECTION - 1.0)),
        },
    ])
}
