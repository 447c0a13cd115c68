//! cook-yielding: Cook's membrane far past its yield.

use sph_core::Vec3;

use crate::cases::plasticity::bricks::Bricks;
use crate::figures::Axis;
use crate::judge::{Case, Headline, Lattices, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::support::mesh_scenes::on_mesh;
use crate::support::meshes::Mesh;
use crate::{JudgeError, Metric, Outcome};

const SCENE: &str = include_str!("../../../../scenes/meshes/cook-yielding.toml");
const OFF: &str = "greatest error of the load";
/// The table, and what of it is compared.
const TABLE: Bricks = Bricks {
    table: "plasticity_cook_membrane",
    known: ["v_upper_right_corner", "F"],
    found: ["v", "level"],
    unit: 1.0,
    between: [0.4, 11.0],
};

/// Errors \[% of the load\].
const MEASURED: Measured = Measured(&[(STATIC, &[("8 cells", 2.1), ("16 cells", 0.35)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "cook-yielding",
        title: "Cook's membrane past its yield",
        about: "Linear hardening, plastic strains beyond .25: the force at equal ways of the upper corner from .5 to 11 mm. Asked: .5 % with 16 cells a side, \
                8 cells in 350 iterations at most.",
        citation: "elements of CalculiX; geometry of Cook 1974",
        variants: vec![membrane(8).quick(), membrane(16)],
        each,
        headline: Some(Headline::new(OFF, 0.1)),
        figures: |runs| {
            let words = ["Force against the way of the corner", "Solid elements and shells."];
            TABLE.figure(runs, words, [Axis::linear("way of the corner [mm]"), Axis::linear("force [kN]")])
        },
        ..Case::default()
    }
}

fn membrane(cells: usize) -> Variant {
    Variant::study_on(STATIC, &format!("{cells} cells"), Lattices::of(cells, run))
}

fn run(cells: usize) -> Result<Outcome, String> {
    let mesh = Mesh::blocks(
        [cells, cells],
        &[&|u, v| Vec3::new(48.0 * u, 44.0 * u * (1.0 - v) + (44.0 + 16.0 * u) * v, 0.0)],
    );
    let at = |x: f64| move |place: &Vec3| (place.x - x).abs() < 1e-9;
    let corner = |place: &Vec3| (place - Vec3::new(48.0, 60.0, 0.0)).norm() < 1e-9;
    on_mesh(SCENE, &mesh, &[("LEFT", &at(0.0)), ("RIGHT", &at(48.0)), ("CORNER", &corner)], &[])
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let worst = TABLE.worst(run)?.filter(|_| run.done());
    let reason = "cells of second order, the knee between two levels";
    let iterations = run.column("iterations")?.iter().sum();
    Ok(vec![
        Metric::error(OFF, worst, "%").near(MEASURED.of(run)?, reason),
        Metric::error("Newton's iterations", Some(iterations), "-")
            .within(350.0, "what the study of the law asks of 8 cells"),
    ])
}
