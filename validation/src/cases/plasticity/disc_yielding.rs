//! disc-yielding: round plates at their limit loads.
//!
//! ```text
//!   ▲━━━━━━━━━━▲  p      free rim: 6.516 M₀/R²     clamped: 12.55 M₀/R²     M₀ = σ_y t²/4
//! ```

use libm::{cos, sin};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Lattices, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::support::mesh_scenes::{Set, on_mesh};
use crate::support::meshes::Mesh;
use crate::support::studies::off;
use crate::{JudgeError, Metric, Outcome};

const SCENE: &str = include_str!("../../../../scenes/meshes/disc-yielding.toml");
const OFF: &str = "error of the load at a deflection of .06 t";
/// Radius \[L\].
const RADIUS: f64 = 10.0;
/// Limit loads over M₀/R²: `r dM_r/dr = M_θ − M_r − p r²/2` on von Mises' curve, integrated to six figures; Hopkins and Wang 1954 have these numbers to three.
const LOADS: [(&str, f64); 2] = [("free", 6.516_41), ("clamped", 12.552_06)];

/// Errors \[%\].
const MEASURED: Measured = Measured(&[(
    STATIC,
    &[
        ("12 cells, free", 0.66),
        ("24 cells, free", 0.72),
        ("12 cells, clamped", 6.8),
        ("24 cells, clamped", 3.4),
    ],
)]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let all = [12, 24].into_iter().flat_map(|cells| LOADS.map(|(rim, _)| disc(cells, rim)));
    Case {
        name: "disc-yielding",
        title: "Round plates at their limit loads",
        about: "No hardening, cells along a radius: the pressure by arc length until the middle has sunk by .06 of the thickness, six to fifteen times what it \
                sinks at first yield, beside the limit load. Clamped, the hinge runs in the outermost cells, half a cell inside. Asked: 1 % free, 4 % clamped with 24 cells.",
        citation: "Hopkins and Wang 1954; integrated for this project",
        variants: all.collect(),
        each,
        headline: Some(Headline::new(OFF, 0.1)),
        ..Case::default()
    }
}

fn disc(cells: usize, rim: &'static str) -> Variant {
    let of = move |cells| run(cells, rim);
    let lattices = Lattices { step: 2, ..Lattices::of(cells, of) };
    Variant::study_on(STATIC, &format!("{cells} cells, {rim}"), lattices).quick_if(cells == 12)
}

/// A quarter in three blocks: a square round the middle, and two beside it as far as the rim.
fn run(cells: usize, rim: &str) -> Result<Outcome, String> {
    let side = 0.5 * RADIUS;
    let corner = Vec3::new(0.46 * RADIUS, 0.46 * RADIUS, 0.0);
    let (x, y) = (Vec3::x() * side, Vec3::y() * side);
    let on = |part: f64| {
        let angle = part * std::f64::consts::FRAC_PI_4;
        Vec3::new(cos(angle), sin(angle), 0.0) * RADIUS
    };
    let inner = |u: f64, v: f64| x * (u * (1.0 - v)) + corner * (u * v) + y * ((1.0 - u) * v);
    let right = |u: f64, v: f64| (x + (corner - x) * v) * (1.0 - u) + on(v) * u;
    let top = |u: f64, v: f64| (y + (corner - y) * u) * (1.0 - v) + on(2.0 - u) * v;
    let mesh = Mesh::blocks([cells / 2, cells / 2], &[&inner, &right, &top]);
    let near = |value: f64| value.abs() < 1e-9;
    let sets: [Set<'_>; 4] = [
        ("X", &|place| near(place.x)),
        ("Y", &|place| near(place.y)),
        ("RIM", &|place| near(place.norm() - RADIUS)),
        ("MIDDLE", &|place| near(place.norm())),
    ];
    let clamped = [("supports[2]", "{ on = \"RIM\", clamped = {} }")];
    on_mesh(SCENE, &mesh, &sets, if rim == "clamped" { &clamped } else { &[] })
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (rim, exact) = LOADS[usize::from(run.variant.grid.ends_with("clamped"))];
    let error = off(run.last("level")?.filter(|_| run.done()).map(|load| load / exact)).map(f64::abs);
    let reason = match rim {
        "clamped" => "a hinge half a cell inside the rim: the span is shorter by it",
        _ => "the middle of the plate does not flow in full yet",
    };
    Ok(vec![Metric::error(OFF, error, "%").near(MEASURED.of(run)?, reason)])
}
