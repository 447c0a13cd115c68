//! twisted-beam: a strip twisted by a quarter turn, thick and thin; every cell is warped.

use benchmarks_ref::fe_shell::cases::{TwistedBeam, twisted_beam as elements};
use nalgebra::Vector3;

use crate::judge::Measured;
use crate::judge::{Case, Headline, Published, Run, Variant};
use crate::methods::{ELEMENTS, STATIC};
use crate::support::linear;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/twisted-beam.toml");
const NAME: &str = "tip displacement";

/// One of the four problems.
struct Beam {
    name: &'static str,
    thickness: f64,
    /// Direction of the tip force: z lies in the plane of the tip, y across it.
    along_z: bool,
    force: f64,
    /// Displacement of the middle of the tip along the force.
    displacement: f64,
    /// Row of the linear obstacle course.
    row: usize,
}

#[rustfmt::skip]
const BEAMS: [Beam; 4] = [
    Beam { name: "thick, in plane", thickness: 0.32, along_z: true, force: 1.0, displacement: 0.005424, row: 3 },
    Beam { name: "thick, across", thickness: 0.32, along_z: false, force: 1.0, displacement: 0.001754, row: 4 },
    Beam { name: "thin, in plane", thickness: 0.0032, along_z: true, force: 1e-6, displacement: 0.005256, row: 5 },
    Beam { name: "thin, across", thickness: 0.0032, along_z: false, force: 1e-6, displacement: 0.001294, row: 6 },
];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "twisted-beam",
        title: "Twisted beam, thick and thin",
        about: "Displacement of the tip along a force in the plane of the tip section and across it, linear, t = 0.32 and \
                0.0032. All cells are warped: strains that are sampled on a flat facet would couple bending and stretching.",
        citation: "MacNeal and Harder 1985; Zupan and Saje 2004",
        variants: variants(),
        headline: Some(Headline { metric: NAME, floor: 0.05, published }),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for beam in &BEAMS {
        let (y, z) = if beam.along_z { (0.0, beam.force) } else { (beam.force, 0.0) };
        for [u, v] in [[25, 5], [49, 9]] {
            let particles = Variant::new(STATIC, SCENE, "twisted", [u, v])
                .set("section.homogeneous.thickness", beam.thickness)
                .set("loads[0].force.total", format!("[0.0, {y:?}, {z:?}]"));
            let direction = if beam.along_z { Vector3::z() } else { Vector3::y() };
            let given = TwistedBeam { thickness: beam.thickness, direction, force: beam.force };
            let nodes = Variant::elements(ELEMENTS, [u, v], move || elements(u - 1, v - 1, &given));
            let pair = [particles.usual_if(u == 49), nodes.usual_if(u == 25)];
            variants
                .extend(pair.map(|variant| variant.on(beam.name).quick().judged(|run, _| tip(run, beam))));
        }
    }
    variants
}

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[
        ("25×5 thick, in plane", 0.19), ("49×9 thick, in plane", 0.18), ("25×5 thick, across", 0.95),
        ("49×9 thick, across", 0.057), ("25×5 thin, in plane", 0.025), ("49×9 thin, in plane", 0.081),
        ("25×5 thin, across", 0.4), ("49×9 thin, across", 0.17),
    ]),
    (ELEMENTS, &[
        ("25×5 thick, in plane", 0.31), ("49×9 thick, in plane", 0.2), ("25×5 thick, across", 0.42),
        ("49×9 thick, across", 0.18), ("25×5 thin, in plane", 0.28), ("49×9 thin, in plane", 0.19),
        ("25×5 thin, across", 0.49), ("49×9 thin, across", 0.2),
    ]),
]);

/// The tip of one of the beams along its force.
fn tip(run: &Run, beam: &Beam) -> Result<Vec<Metric>, JudgeError> {
    let reason = "of second order in the spacing; on flat facets bending and stretching would couple";
    let column = if beam.along_z { "W_tip" } else { "V_tip" };
    Ok(vec![linear::figure(run, NAME, column, beam.displacement, (&MEASURED, reason))?])
}

fn published() -> Result<Vec<Published>, JudgeError> {
    let mut worst: f64 = 0.0;
    for beam in &BEAMS {
        worst = worst.max(linear::bricks_off(beam.row, beam.displacement)?);
    }
    Ok(vec![
        Published { source: "MacNeal and Harder; Zupan and Saje", error: None },
        Published { source: "CalculiX, bricks, largest of four", error: Some(worst) },
    ])
}
