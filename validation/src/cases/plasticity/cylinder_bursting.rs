//! cylinder-bursting: a thick cylinder in plane strain, a Galerkin solid, that yields from within under a pressure.
//!
//! ```text
//!  p ▶▒▒▒▒▒▒▒░░░░░░░   p(c) = 2/√3 Y (ln c/a + ½ (1 − c²/b²)),   u_b = (1 − ν²) 2k c²/(E b),   k = Y/√3
//!    a      c      b
//! ```

use libm::log;

use crate::cases::galerkin::INCREMENTS;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cylinder-bursting.toml");
const LIMIT: &str = "error of the limit pressure";
const COURSE: &str = "greatest error of the pressure by the radius to which it yields";
/// Inner and outer radius \[L\].
const RADII: [f64; 2] = [100.0, 200.0];
const YOUNG: f64 = 2e5;
const YIELD: f64 = 250.0;
/// Pressure at level one \[F/L²\].
const PRESSURE: f64 = 100.0;

const COARSE: &str = "4 cells, ν .499";
const USUAL: &str = "4 cells, ν .3";
/// Errors \[%\].
const OF_LIMIT: Measured = Measured(&[(INCREMENTS, &[(COARSE, 1.1), (USUAL, 0.97)])]);
const OF_COURSE: Measured = Measured(&[(INCREMENTS, &[(COARSE, 4.6)])]);

/// The scene, its closed form, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cylinder-bursting",
        title: "A thick cylinder bursting",
        about: "No hardening, plane strain, along the path by arc length: the pressure by the radius to which it has yielded, which the widening of the outer \
                face tells where nothing changes its volume (ν = .499), and the limit pressure, which is the same for any ν.",
        citation: "Hill 1950",
        variants: vec![cylinder(COARSE, 4, 0.499), cylinder(USUAL, 4, 0.3)],
        each,
        headline: Some(Headline::new(LIMIT, 0.2)),
        ..Case::default()
    }
}

fn cylinder(name: &str, across: usize, poisson: f64) -> Variant {
    Variant::scene(INCREMENTS, SCENE, name)
        .set("bodies.tube.solid.geometry.arc.cells", format!("[{}, 2, {across}]", across * 3 / 2))
        .set("bodies.tube.solid.material.plastic.poisson", format!("{poisson}"))
}

/// Pressure when it has yielded to a radius.
fn hill(c: f64) -> f64 {
    let [a, b] = RADII;
    2.0 / 3.0_f64.sqrt() * YIELD * (log(c / a) + 0.5 * (1.0 - c * c / (b * b)))
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (levels, widened) = (run.column("level")?, run.column("u_outer")?);
    let last = levels.last().copied().unwrap_or_default() * PRESSURE;
    let limit = run.done().then_some(100.0 * (last / hill(RADII[1]) - 1.0));
    let reason = "the mesh: 1.1 % of the elastic displacement, and a cell of 25 mm yields in a piece or not; .2 % by which the radii grow";
    let mut metrics = vec![Metric::greatest(LIMIT, [(0.0, limit)], "%").near(OF_LIMIT.of(run)?, reason)];
    if run.variant.grid != USUAL {
        let slope = YOUNG * RADII[1] * 3.0_f64.sqrt() / (2.0 * YIELD * (1.0 - 0.499 * 0.499));
        let mut worst = 0.0_f64;
        for (level, u) in levels.into_iter().zip(widened) {
            let c = (u.max(0.0) * slope).sqrt();
            if c > 1.02 * RADII[0] && c < RADII[1] {
                worst = worst.max(100.0 * (level * PRESSURE / hill(c) - 1.0).abs());
            }
        }
        metrics
            .push(Metric::error(COURSE, run.done().then_some(worst), "%").near(OF_COURSE.of(run)?, reason));
    }
    Ok(metrics)
}
