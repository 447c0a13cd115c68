//! The error of every number: bars hold the true error, the run is not touched, what has none is said.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::process::Command;
use std::sync::Arc;

use crate::common::{Replaced, overridden, ran, scene, scenes, text};
use coque::mesh::Arrays;
use coque::{Checked, Curve, Ended, Errors, Progress, ProgressReport, Silent, Verdict};

fn errors(scene: &Checked) -> (Curve, Errors) {
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    let errors = scene.errors(&outcome, 1, &mut Silent);
    (outcome.curve, errors)
}

/// The same scene on four times the cells along each direction: its error is a sixteenth at the second order.
fn truth(scene: &Checked) -> Curve {
    ran(Ok(scene.refined(4.0).unwrap().scene)).curve
}

#[test]
fn bars_hold_the_true_error_and_are_not_much_larger() {
    let problems: [(&str, Replaced, &str); 5] = [
        ("scordelis-lo.toml", &[("geometry.cylinder.particles", "[13, 13]")], "w_edge"),
        ("plate-clamped.toml", &[("geometry.plate.particles", "[13, 13]")], "w_centre"),
        (
            "hemisphere.toml",
            &[("analysis.static.levels", "2"), ("geometry.sphere.particles", "[13, 13]")],
            "outward",
        ),
        (
            "plate.toml",
            &[("analysis.modal.modes", "5"), ("geometry.plate.particles", "[13, 13]")],
            "frequency",
        ),
        ("column-buckling.toml", &[("geometry.plate.particles", "[21, 5]")], "level"),
    ];
    for (name, set, column) in problems {
        let scene = scene(name, set).unwrap();
        let (curve, errors) = errors(&scene);
        let truth = truth(&scene).column(column).unwrap();
        let own = curve.column(column).unwrap();
        let bars = &errors.of(column).unwrap().bars;
        assert_eq!(bars.len(), own.len());
        // No bar is narrower than what solvers leave, not even that of a row before any load.
        let left = 1e-9 * own.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for (row, found) in bars.iter().enumerate() {
            assert_eq!(found.value.to_bits(), own[row].to_bits());
            // The fine lattice is off by a fifteenth of the difference at the second order.
            let error = 16.0 / 15.0 * (own[row] - truth[row]).abs();
            let bar = found.bar.unwrap();
            // Where an error passes through zero from one lattice to the next, the bar is that of the lattices beside it.
            let wide = 6.0 * error + 1e-3 * own[row].abs() + 1.001 * left;
            assert!(error <= bar && bar <= wide, "{name} {row}: {found:?}, error {error}");
        }
    }
}

#[test]
fn middles_and_named_points_stay_on_particles() {
    // A point at a quarter of the length, in the middle of the width.
    let sets = "sets.point.nearest";
    let curve = "[{ name = \"w\", of = \"displacement\", on = \"point\", direction = [0.0, 0.0, 1.0] }]";
    let plate = |cells: &str, x: &str| {
        let set: [(&str, &str); 4] = [
            ("geometry.plate.lengths", "[1.0, 1.0]"),
            ("geometry.plate.particles", cells),
            (sets, x),
            ("curve", curve),
        ];
        scene("plate-clamped.toml", &set).unwrap()
    };
    for companion in plate("[21, 21]", "[0.25, 0.5, 0.0]").companions(1).unwrap().lattices {
        let particles = companion.scene.as_shell().unwrap().geometry.particles().unwrap();
        assert_eq!(((particles[0] - 1) % 4, (particles[1] - 1) % 2), (0, 0), "{}", companion.lattice);
        assert!(companion.spacing > 1.0);
    }
    // Seven of twenty cells: no coarser lattice has it, a finer one of twice the cells does.
    let found = plate("[21, 21]", "[0.35, 0.5, 0.0]").companions(1).unwrap();
    assert_eq!((found.lattices.len(), found.moved.len()), (1, 0));
    assert!((found.lattices[0].spacing - 0.5).abs() < 1e-12);
}

#[test]
fn the_lattices_of_a_fluid_hold_whole_numbers_of_particles() {
    let found = scene("dam-break.toml", &[]).unwrap().companions(1).unwrap();
    let spacings: Vec<f64> = found.lattices.iter().map(|companion| companion.spacing).collect();
    assert_eq!(spacings.len(), 2);
    assert!((1.2..1.7).contains(&spacings[0]) && (1.7..2.4).contains(&spacings[1]), "{spacings:?}");
}

#[test]
fn a_mesh_is_refined_face_by_face() {
    // A square plate of 6×6 quadrangles, clamped all round.
    let n = 6_u32;
    let points = (0..=n).flat_map(|i| (0..=n).map(move |j| [f64::from(i) / 6.0, f64::from(j) / 6.0, 0.0]));
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let faces =
        (0..n).flat_map(|i| (0..n).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    let arrays = Arrays {
        points: points.collect(),
        faces: faces.collect(),
        sets: BTreeMap::from([("middle".into(), vec![at(3, 3)])]),
        face_sets: BTreeMap::new(),
    };
    let wanted = r#"
        title = "Plate of a mesh"
        units = { length = "m", force = "N", time = "s" }
        geometry.mesh = { file = "plate" }
        material.elastic = { young = 1e7, poisson = 0.3, density = 1.0 }
        section.homogeneous = { thickness = 0.001 }
        supports = [{ on = "boundary0", clamped = {} }]
        loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, 1.0] } }]
        analysis.linear = {}
        curve = [{ name = "w", of = "displacement", on = "middle", direction = [0.0, 0.0, 1.0] }]
    "#;
    let mut plate = overridden(wanted, "plate.toml", &[]).unwrap().into_scene();
    plate.surfaces.insert("plate".into(), Arc::new(arrays));
    let plate = plate.check().unwrap();
    let (_, errors) = errors(&plate);
    let w = errors.of("w").unwrap().bars[0];
    assert_eq!(errors.lattices.len(), 3, "{:?}", errors.without);
    // Without shear: .0012653 q a⁴/D, q of 10⁻³; shear adds some 19 (h/a)² of it.
    let exact = 0.001_265_32 * 1e-3 / (1e7 * 1e-9 / (12.0 * 0.91));
    assert!((w.value - exact).abs() <= w.bar.unwrap(), "{w:?}, {exact}");
}

/// Ends one of the companions.
struct Impatient {
    companions: usize,
    ended: usize,
}

impl Progress for Impatient {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        if self.companions == self.ended { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn companion(&mut self, _: usize, _: usize, _: &str) {
        self.companions += 1;
    }
}

#[test]
fn an_interrupted_companion_is_said_and_what_the_run_found_stays() {
    let scene = scene("scordelis-lo.toml", &[]).unwrap();
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    let mut impatient = Impatient { companions: 0, ended: 1 };
    let errors = scene.errors(&outcome, 1, &mut impatient);
    assert_eq!((impatient.companions, errors.columns.len()), (1, 0));
    assert!(errors.without[0].contains("interrupted"), "{:?}", errors.without);
    assert_eq!(errors.beside(&outcome.curve), outcome.curve);
}

#[test]
fn an_interrupted_sharpening_leaves_the_bars_as_they_are_without() {
    let found = |set: Replaced, progress: &mut dyn Progress| {
        let scene = scene("scordelis-lo.toml", set).unwrap();
        let outcome = scene.build(1).unwrap().run(&mut Silent);
        scene.errors(&outcome, 1, progress)
    };
    let without = found(&[("error", "{}")], &mut Silent);
    let mut impatient = Impatient { companions: 0, ended: 3 };
    let errors = found(&[("error", "{ sharpen = true }")], &mut impatient);
    assert_eq!(impatient.companions, 3);
    assert!(errors.without.iter().any(|words| words.contains("interrupted")), "{:?}", errors.without);
    assert_eq!(errors.of("w_edge").unwrap().bars, without.of("w_edge").unwrap().bars);
}

#[test]
fn what_has_no_other_lattice_is_said_with_what_to_do() {
    let roof = scene("scordelis-lo.toml", &[]).unwrap();
    let mut outcome = roof.build(1).unwrap().run(&mut Silent);
    outcome.ended = Ended::Interrupted { time: 0.0, level: 0.5 };
    let interrupted = roof.errors(&outcome, 1, &mut Silent);
    assert!(interrupted.without[0].contains("did not reach its end"), "{:?}", interrupted.without);
    // Seven cells of water in one direction, eleven in the other: only whole multiples divide both, and the coarse one is none.
    let water = [
        ("bodies.water.fluid.geometry.block.lengths", "[0.07, 0.11]"),
        ("bodies.water.fluid.geometry.block.spacing", "0.01"),
    ];
    let found = scene("dam-break.toml", &water).unwrap().companions(1).unwrap();
    assert_eq!((found.lattices.len(), found.lattices[0].spacing), (1, 0.5));
}

#[test]
fn the_command_writes_bars_beside_the_numbers_and_changes_none() {
    let folder = std::env::temp_dir().join(format!("coque-errors-{}", std::process::id()));
    let run = |name: &str, more: &[&str]| {
        let out = folder.join(name);
        let mut command = Command::new(env!("CARGO_BIN_EXE_coque"));
        command.arg("run").arg(scenes().join("scordelis-lo.toml")).arg("--out").arg(&out).args(more);
        let said = command.output().unwrap();
        assert!(said.status.success(), "{said:?}");
        let curve: Curve = std::fs::read_to_string(out.join("curve.csv")).unwrap().parse().unwrap();
        let summary: serde_json::Value =
            serde_json::from_str(&std::fs::read_to_string(out.join("summary.json")).unwrap()).unwrap();
        (curve, summary, String::from_utf8(said.stderr).unwrap())
    };
    let (bare, plain, _) = run("bare", &[]);
    let (barred, summary, said) = run("barred", &["--error"]);
    assert!(plain.get("errors").is_none() && bare.columns.iter().all(|column| !column.name.contains('±')));
    for column in &bare.columns {
        assert_eq!(bare.column(&column.name), barred.column(&column.name));
    }
    let bar = barred.column("w_edge ±").unwrap()[0];
    assert_eq!(summary["errors"]["w_edge"]["bar"].as_f64(), Some(bar));
    assert_eq!(summary["errors"]["w_edge"]["verdict"], "converging");
    assert!(said.contains("w_edge  0.3040 ± 0.0036  (order 2.0, three lattices, converging)"), "{said}");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn limit_points_are_paired_by_kind_and_order() {
    let panel = text("panel.toml").replace("particles = [21, 21]", "particles = [13, 13]");
    let levels = [("analysis.arc-length.stop", "{ column = \"w_crown\", above = 20 }")];
    let scene = overridden(&panel, "panel.toml", &levels).unwrap();
    let (_, errors) = errors(&scene);
    let limits: Vec<_> = errors.critical.iter().filter(|point| point.kind == "limit point").collect();
    assert!(!limits.is_empty());
    assert!(limits.iter().all(|point| point.bar.verdict != Verdict::Unpaired && point.bar.bar.is_some()));
}

#[test]
fn an_accuracy_that_is_asked_for_is_reached_and_the_lattice_is_in_the_copy_of_the_scene() {
    let folder = std::env::temp_dir().join(format!("coque-accuracy-{}", std::process::id()));
    let mut command = Command::new(env!("CARGO_BIN_EXE_coque"));
    command
        .arg("run")
        .arg(scenes().join("scordelis-lo.toml"))
        .arg("--out")
        .arg(&folder)
        .args(["--accuracy", "1%"]);
    let said = command.output().unwrap();
    let words = String::from_utf8(said.stderr).unwrap();
    assert!(said.status.success() && words.contains("1.0 % takes"), "{words}");
    let summary: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap();
    let found = &summary["errors"]["w_edge"];
    assert!(found["bar"].as_f64().unwrap() <= 0.01 * found["value"].as_f64().unwrap(), "{words}");
    assert!(
        std::fs::read_to_string(folder.join("scene.toml")).unwrap().contains("geometry.cylinder.particles=[")
    );
    std::fs::remove_dir_all(folder).unwrap();
}
