//! hub-turned: a disc held at its rim and turned in its plane by couples along its normals.
//!
//! ```text
//!    ╭───────╮      inner circle r = a, rim r = b       turn of the hub  θ = M/4πGt (1/a² − 1/b²)
//!    │  (↺ M) │     the hub is free to widen            moment at the rim  M
//!    ╰───────╯
//! ```

use std::f64::consts::{FRAC_PI_2, PI};

use libm::{cos, exp, log, sin};
use sph_core::Vec3;

use crate::judge::{Case, Headline, Lattices, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::support::mesh_scenes::{Set, on_mesh};
use crate::support::meshes::Mesh;
use crate::{JudgeError, Metric, Outcome};

const SCENE: &str = include_str!("../../../../scenes/meshes/hub-turned.toml");
const TURN: &str = "turn of the hub";
const BORNE: &str = "moment at the rim, of couples on a line and on an area";

/// Radii and thickness \[L\], couples on the line and on the area \[F L\], shear modulus \[F/L²\].
const RADII: [f64; 2] = [0.05, 0.2];
const THICKNESS: f64 = 0.0012;
const COUPLES: [f64; 2] = [2000.0, 200.0];
const SHEAR: f64 = 70e9 / 2.6;

/// Errors \[%\].
const MEASURED: Measured =
    Measured(&[(STATIC, &[("6 rings", 0.645), ("12 rings", 0.160), ("24 rings", 0.0396)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "hub-turned",
        title: "A disc turned by a hub in its plane",
        about: "A couple along the normals of the inner circle, of which directors bear nothing: the line is turned by forces along it. Rings of cells, each wider \
                than the one inside it by one factor, as many round as make them square.",
        citation: "[timoshenko1951]: shear by torsion in the plane of a ring, θ = M/4πGt (1/a² − 1/b²)",
        variants: [6, 12, 24].into_iter().map(ring).collect(),
        each,
        headline: Some(Headline::new(TURN, 0.1)),
        ..Case::default()
    }
}

fn ring(rings: usize) -> Variant {
    let lattices = Lattices { step: 2, ..Lattices::of(rings, run) };
    Variant::study_on(STATIC, &format!("{rings} rings"), lattices)
}

/// Four quarters, six cells round each for six along the radius.
fn run(rings: usize) -> Result<Outcome, String> {
    let [inner, outer] = RADII;
    let at = |quarter: f64| {
        move |u: f64, v: f64| {
            let (radius, angle) = (inner * exp(u * log(outer / inner)), (quarter + v) * FRAC_PI_2);
            Vec3::new(cos(angle), sin(angle), 0.0) * radius
        }
    };
    let quarters = [at(0.0), at(1.0), at(2.0), at(3.0)];
    let blocks: Vec<&dyn Fn(f64, f64) -> Vec3> = quarters.iter().map(|quarter| quarter as _).collect();
    let mesh = Mesh::blocks([rings, rings + rings / 3], &blocks);
    let on = |radius: f64| move |place: &Vec3| (place.norm() - radius).abs() < 1e-9;
    let (hub, rim) = (on(inner), on(outer));
    let sets: [Set<'_>; 3] =
        [("HUB", &hub), ("RIM", &rim), ("ARM", &|place| (place - Vec3::x() * inner).norm() < 1e-9)];
    on_mesh(SCENE, &mesh, &sets, &[])
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let (way, borne) = (run.column("way")?, run.column("M_rim")?);
    let [inner, outer] = RADII;
    let exact = COUPLES[0] / (4.0 * PI * SHEAR * THICKNESS) * (1.0 / (inner * inner) - 1.0 / (outer * outer));
    // The column is in millimetres.
    let turn =
        way.first().filter(|_| run.done()).map(|way| 100.0 * (way / (1e3 * inner * exact) - 1.0).abs());
    let off = |(found, couple): (&f64, f64)| 100.0 * (found / couple + 1.0).abs();
    let borne =
        (borne.len() == COUPLES.len()).then(|| borne.iter().zip(COUPLES).map(off).fold(0.0, f64::max));
    let reason =
        "three times the error of the lattice: chords for arcs and one point a cell, of the second order";
    Ok(vec![
        Metric::error(TURN, turn, "%").near(MEASURED.of(run)?, reason),
        Metric::error(BORNE, borne, "%")
            .within(1e-6, "a moment that is statically the couple: round-off of the columns' differences"),
    ])
}
