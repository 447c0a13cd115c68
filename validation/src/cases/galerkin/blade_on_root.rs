//! blade-on-root: a cantilever, half a solid and half a shell, joined by the directors of the shell.
//!
//! ```text
//!  ▐▓▓▓▓▓▓▓▓▓━━━━━━━━━  ↓ P
//! ```

use super::INCREMENTS;
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/shell-on-root.toml");
const TIP: &str = "deflection of the tip";
const PASSED: &str = "force that the joint passes";
/// Length of the root, and what of it the whole is \[mm\].
const ROOT: f64 = 72.0;
const WHOLE: f64 = 192.0;
/// Width, thickness \[mm\], modulus \[N/mm²\], load \[N\].
const WIDTH: f64 = 40.0;
const THICKNESS: f64 = 8.0;
const YOUNG: f64 = 70e3;
const LOAD: f64 = 500.0;

/// The scene with a root as thick as its blade and without Poisson's ratio, beside Timoshenko's beam.
pub fn case() -> Case {
    let joined = |root: &'static str, blade: &'static str| {
        let block = |spacing| {
            format!(
                "{{ lengths = [{ROOT:.1}, {WIDTH:.1}, {THICKNESS:.1}], spacing = {spacing}, origin = [{:.1}, 0.0, -4.0] }}",
                24.0 - ROOT
            )
        };
        Variant::scene(INCREMENTS, SCENE, format!("{root} and {blade}"))
            .set("bodies.root.solid.geometry.block", block(root))
            .set("bodies.blade.shell.geometry.plate.particles", blade)
            .set("bodies.root.solid.material.elastic.poisson", "0.0")
            .set("bodies.blade.shell.material.elastic.poisson", "0.0")
    };
    Case {
        name: "blade-on-root",
        title: "A blade on a root: a shell joined to a solid",
        about: "A cantilever, three eighths of it a Galerkin solid and the rest a shell of the same thickness, whose end the face of the solid follows by its directors, \
                bent by a force at its tip.",
        citation: "Timoshenko's beam, shear factor 5/6, without Poisson's ratio",
        variants: vec![joined("[12.0, 10.0, 2.0]", "[13, 5]"), joined("[6.0, 8.0, 2.0]", "[25, 7]")],
        each,
        headline: Some(Headline::new(TIP, 0.5)),
        ..Case::default()
    }
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let bending = YOUNG * WIDTH * THICKNESS.powi(3) / 12.0;
    let shear = 5.0 / 6.0 * 0.5 * YOUNG * WIDTH * THICKNESS;
    let exact = -LOAD * (WHOLE.powi(3) / (3.0 * bending) + WHOLE / shear);
    let off = |column: &str, exact: f64| -> Result<Option<f64>, JudgeError> {
        Ok(run.last(column)?.map(|found| 100.0 * (found / exact - 1.0)))
    };
    let bends = "what cells of solid and shell leave of a beam that bends: measured .024 and .075, three times the more";
    let passes = "forces of the joint have no sum but the load: rounding of the solve";
    Ok(vec![
        Metric::error(TIP, off("tip", exact)?, "%").within(0.23, bends),
        Metric::error(PASSED, off("shear", LOAD)?, "%").within(1e-5, passes),
    ])
}
