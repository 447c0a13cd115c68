//! hollow-ball-solid: a thick hollow ball under inner pressure, shape functions in a surface from a file.

use super::INCREMENTS;
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/meshes/hollow-ball-galerkin.toml");
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/meshes/hollow-ball.obj");
/// Pressure, Young's modulus \[MPa\], Poisson's ratio.
const PRESSED: [f64; 3] = [100.0, 210e3, 0.3];
/// Radii \[mm\].
const RADII: [f64; 2] = [50.0, 100.0];
const NAMES: [&str; 2] = ["u_inner", "u_outer"];

/// The scene, its closed form, and how far the two may differ.
pub fn case() -> Case {
    let variant = Variant::scene(INCREMENTS, SCENE, "5 spacings")
        .set("bodies.ball.solid.geometry.filled.file", format!("{FILE:?}"))
        .judged(|run, _| judged(run));
    Case {
        name: "hollow-ball-solid",
        title: "A thick hollow ball under inner pressure, by shape functions",
        about: "An eighth of a ball between planes of symmetry: nodes on a cubic lattice and on a surface of triangles, which cuts the cells. Displacements along the radius \
                of a node of the cavity and of one of the outer face. Asked: 2 %.",
        citation: "Lamé's solution [timoshenko1970]",
        variants: vec![variant],
        headline: Some(Headline::new(NAMES[0], 0.01)),
        ..Case::default()
    }
}

/// Displacement along the radius at a radius \[mm\].
fn exact(radius: f64) -> f64 {
    let ([pressure, young, nu], [a, b]) = (PRESSED, RADII.map(|r| r * r * r));
    pressure * a / (young * (b - a)) * ((1.0 - 2.0 * nu) * radius + (1.0 + nu) * b / (2.0 * radius * radius))
}

fn judged(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let metric = |(name, radius): (&'static str, f64)| {
        let found = Metric::compared(name, run.last(name)?, "mm", exact(radius));
        Ok(found.near(0.83, "five spacings through the wall, parts of cells at their centroids"))
    };
    NAMES.into_iter().zip(RADII).map(metric).collect()
}
