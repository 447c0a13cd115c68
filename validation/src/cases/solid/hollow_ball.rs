//! hollow-ball: a thick hollow ball under inner pressure, its nodes in a surface from a file.
//!
//! ```text
//!   ╭─────╮
//!   │ (p) │   u(r) = p a³/(E (b³ − a³)) [(1 − 2ν) r + (1 + ν) b³/(2r²)]
//!   ╰─────╯
//! ```

use coque::{Column, Event, Scene, Simulation};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATE;
use crate::{JudgeError, Metric, Outcome};

const SCENE: &str = include_str!("../../../../scenes/meshes/hollow-ball.toml");
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/meshes/hollow-ball.obj");
const OUTER: &str = "outer face";
const WALL: &str = "middle of the wall";
/// Pressure, Young's modulus \[MPa\], Poisson's ratio.
const PRESSED: [f64; 3] = [100.0, 210e3, 0.3];
/// Radii \[mm\].
const RADII: [f64; 2] = [50.0, 100.0];
/// Spacings of the radius of the cavity, with the spacing \[mm\].
const GRIDS: [(&str, f64); 2] = [("8 spacings", 6.25), ("10 spacings", 5.0)];

/// Errors \[%\].
const AT_OUTER: Measured = Measured(&[(STATE, &[("8 spacings", 0.80), ("10 spacings", 0.97)])]);
const IN_WALL: Measured = Measured(&[(STATE, &[("8 spacings", 1.67), ("10 spacings", 1.42)])]);

/// The scene, its closed form, and how far the two may differ.
pub fn case() -> Case {
    let variant = |(grid, spacing): (&str, f64)| {
        Variant::study(STATE, grid, move || run(spacing)).quick_if(spacing == GRIDS[0].1)
    };
    Case {
        name: "hollow-ball",
        title: "A thick hollow ball under inner pressure",
        about: "An eighth of a ball between planes of symmetry: nodes of a cubic lattice fill a surface of triangles, which cuts their volumes and bears the pressure. \
                Displacements along the radius over those of the closed form at the same places, means of the nodes within a spacing of the outer face and of those in \
                the middle of the wall. Asked: 2 %.",
        citation: "Lamé's solution [timoshenko1970]",
        variants: GRIDS.into_iter().map(variant).collect(),
        each,
        headline: Some(Headline::new(OUTER, 1.0)),
        ..Case::default()
    }
}

/// Displacement along the radius at a radius \[mm\].
fn exact(radius: f64) -> f64 {
    let ([pressure, young, nu], [a, b]) = (PRESSED, RADII.map(|r| r * r * r));
    pressure * a / (young * (b - a)) * ((1.0 - 2.0 * nu) * radius + (1.0 + nu) * b / (2.0 * radius * radius))
}

/// The ball on a lattice, by Newton's method, which leaves the nodes where they are in balance.
fn run(spacing: f64) -> Result<Outcome, String> {
    let key = "bodies.ball.solid.geometry.filled";
    let replaced = [
        (format!("{key}.file"), format!("{FILE:?}")),
        (format!("{key}.spacing"), spacing.to_string()),
        ("analysis".into(), "{ static = { levels = 1 } }".into()),
    ];
    let built = Scene::with_overrides(SCENE, "hollow-ball", &replaced).and_then(|scene| scene.build(1));
    let mut simulation = Simulation::new(built.map_err(|error| error.to_string())?);
    // How a run ends that fails stands in its outcome.
    while let Ok(event) = simulation.advance() {
        if matches!(event, Event::End) {
            break;
        }
    }
    let body = simulation.body().configuration();
    let over = |low: f64, high: f64| {
        let pairs = body.rest.iter().zip(&*body.present).filter(|(x, _)| (low..high).contains(&x.norm()));
        let ratios: Vec<f64> =
            pairs.map(|(x, now)| (now - x).dot(&x.normalize()) / exact(x.norm())).collect();
        ratios.iter().sum::<f64>() / ratios.len() as f64
    };
    let ([a, b], deep) = (RADII, GRIDS[0].1);
    let seen = [(OUTER, over(b - deep, 2.0 * b)), (WALL, over(0.5 * (a + b) - deep, 0.5 * (a + b) + deep))];
    let mut outcome = simulation.finish();
    for (name, ratio) in seen {
        outcome.curve.columns.push(Column { name: name.into(), unit: "-".into() });
        outcome.curve.rows.iter_mut().for_each(|row| row.push(ratio));
    }
    Ok(outcome.into())
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let off = |name| -> Result<Option<f64>, JudgeError> {
        Ok(run.last(name)?.filter(|_| run.done()).map(|ratio| 100.0 * (ratio - 1.0)))
    };
    let reason = "strains averaged over the horizon, families that the curved faces cut";
    Ok(vec![
        Metric::error(OUTER, off(OUTER)?, "%").near(AT_OUTER.of(run)?, reason),
        Metric::error(WALL, off(WALL)?, "%").near(IN_WALL.of(run)?, reason),
    ])
}
