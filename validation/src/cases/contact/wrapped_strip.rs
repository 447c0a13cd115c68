//! wrapped-strip: a cantilever bent over a smooth drum by a dead force at its tip.

use benchmarks_ref::touching::{Wrapped, wrapped_strips};

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/strip-over-drum.toml");
const OFF: &str = "distance of the tip";
const BORNE: &str = "force on the drum against that on the tip";
/// Radius of the middle of the strip on the drum, and half of its thickness \[mm\].
const RADIUS: f64 = 100.0;
const HALF: f64 = 0.5;
/// Length of the strip \[mm\], and B times its width over the square of that \[N\].
const LENGTH: f64 = 100.0;
const FORCE: f64 = 2.1e5 / 12.0 * 10.0 / (LENGTH * LENGTH);

/// Distances \[% of L\].
const MEASURED: Measured = Measured(&[(
    STATIC,
    &[("50 cells, .3 wrapped", 0.0021), ("50 cells, .6 wrapped", 0.0032), ("100 cells, .6 wrapped", 0.0024)],
)]);

/// Errors of the force \[%\].
const OF_FORCE: Measured = Measured(&[(
    STATIC,
    &[("50 cells, .3 wrapped", 0.47), ("50 cells, .6 wrapped", 0.94), ("100 cells, .6 wrapped", 0.79)],
)]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "wrapped-strip",
        title: "A strip bent over a drum, t/R = 1/100",
        about: "Where the tip comes to, against the elastica: three and six tenths of the strip lie on the drum, at whose last point \
                the moment of the force is that of the radius. The drum bears all of the force: along it the strip has one curvature, no shear, \
                and the clamp none. The drum stands lower by the sag of a cell.",
        citation: "inextensible elastica by shooting; the wrapped part has the radius of the drum and half of the thickness",
        variants: vec![strip(50, 0.3), strip(50, 0.6), strip(100, 0.6)],
        headline: Some(Headline::new(OFF, 0.001)),
        ..Case::default()
    }
}

fn strip(cells: usize, wrapped: f64) -> Variant {
    let known = wrapped_strips().ok().and_then(|all| all.into_iter().find(|strip| strip.wrapped == wrapped));
    let force = known.map_or(f64::NAN, |known| FORCE * known.force);
    let cell = LENGTH / cells as f64;
    Variant::scene(STATIC, SCENE, format!("{cells} cells, .{} wrapped", (10.0 * wrapped).round()))
        .set("geometry.plate.particles", format!("[{}, 5]", cells + 1))
        .set("tools.0.cylinder.radius", RADIUS - HALF - cell * cell / (8.0 * RADIUS))
        .set("loads.0.force.total", format!("[0.0, 0.0, {}]", -force))
        .judged(move |run, _| judged(run, known))
}

fn judged(run: &Run, known: Option<Wrapped>) -> Result<Vec<Metric>, JudgeError> {
    let off = |known: Wrapped, x: f64, w: f64| {
        100.0 * libm::hypot(x / LENGTH - known.tip[0], w / LENGTH - known.tip[1])
    };
    let found = run.last("x")?.zip(run.last("w")?);
    let off = known.zip(found).map(|(known, (x, w))| off(known, x, w));
    let reason = "cells of a polygon about the drum, shear and stretch of the order of (t/L)², which the elastica leaves out";
    let borne = run.last("borne")?.zip(known).map(|(borne, known)| borne / (FORCE * known.force));
    let borne = borne.map(|part| 100.0 * (part - 1.0).abs());
    Ok(vec![
        Metric::error(OFF, off, "% of L").near(MEASURED.of(run)?, reason),
        Metric::error(BORNE, borne, "%")
            .near(OF_FORCE.of(run)?, "what the sag of the first cell leaves on the clamp, and the end of what is wrapped, which stands between vertices"),
    ])
}
