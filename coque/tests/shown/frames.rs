//! Fields of every kind of scene: written, read back as a mesh, and without what the resultants do not tell.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use coque::{
    Ended, FieldFiles, Outcome, Picture, RunOptions, Scene, Sheet, Silent, listed, mesh, picture_svg,
};

/// An empty folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("frames").join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    folder
}

/// Runs a scene with all fields; its frames.
fn run(name: &str, origin: &Path, replaced: &[(&str, &str)]) -> (Outcome, Vec<PathBuf>) {
    let everything = [("output.fields", "{ stresses = true, extruded = true }")];
    let pairs = replaced.iter().chain(&everything);
    let pairs: Vec<_> = pairs.map(|(path, value)| (path.to_string(), value.to_string())).collect();
    let text = fs::read_to_string(origin).unwrap();
    let scene = Scene::with_overrides(&text, &origin.to_string_lossy(), &pairs).unwrap();
    let folder = folder(name);
    let mut files = FieldFiles::create(&folder, FieldFiles::LONE, &scene.output.fields.unwrap()).unwrap();
    let options =
        RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(&mut files), from: None };
    let outcome = scene.build(1).unwrap().run_with(options).unwrap();
    assert_eq!(outcome.ended, Ended::Done);
    let frames = listed(&folder.join("shell.pvd")).unwrap();
    (outcome, frames.into_iter().map(|(_, path)| path).collect())
}

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name)
}

fn left_out(outcome: &Outcome, what: &str) -> bool {
    outcome.summary.body.left_out.iter().any(|line| line.contains(what))
}

#[test]
fn a_frame_is_a_mesh_for_another_scene() {
    let replaced = [("geometry.cylinder.particles", "[5, 4]"), ("analysis.static.levels", "1")];
    let (outcome, frames) = run("mesh", &shipped("panel.toml"), &replaced);
    let surface = mesh::read(&frames[1]).unwrap();
    // The same bits: base64 on both sides, and twenty nodes keep their order.
    assert_eq!(surface.positions, outcome.shapes[1].positions);
    assert_eq!((surface.faces.len(), surface.pieces, surface.turned, surface.loops.len()), (12, 1, 0, 1));
    let (cloud, _) = surface.cloud(surface.node_normals()).unwrap();
    assert_eq!(cloud.cells, outcome.cells);
    // Fields are no sets, and directors no normals: a mesh begins free of stress.
    assert!(surface.sets.is_empty() && surface.normals.is_none());
}

#[test]
fn plies_leave_out_the_stresses_at_the_faces() {
    let replaced = [("geometry.cylinder.particles", "[5, 5]"), ("analysis.static.levels", "2")];
    let (outcome, frames) = run("plies", &shipped("panel-laminated.toml"), &replaced);
    assert!(left_out(&outcome, "stresses of the plies"));
    let sheet = Sheet::read(&frames[2]).unwrap();
    for name in ["membrane_force", "moment", "shear_force", "membrane_strain", "curvature", "shear_strain"] {
        assert!(sheet.cell_data[name].numbers.iter().any(|&value| value != 0.0), "{name}");
    }
    assert!(!sheet.cell_data.keys().any(|name| name.contains("stress") || name.contains("mises")));
    let solid = Sheet::read(&frames[2].with_file_name("solid-0002.vtu")).unwrap();
    assert!(solid.cell_data.is_empty());
    // The first direction is the axis of the plies: along y, the axis of the cylinder, where symmetry holds it.
    assert!(sheet.cell_data["t1"].numbers.chunks(3).all(|t1| t1[1] > 0.99));
}

#[test]
fn the_linear_answer_is_one_frame() {
    let (outcome, frames) = run("linear", &shipped("scordelis-lo.toml"), &[]);
    assert_eq!((outcome.summary.record.frames, frames.len()), (1, 1));
    let sheet = Sheet::read(&frames[0]).unwrap();
    let names: Vec<&str> = sheet.point_data.keys().map(String::as_str).collect();
    assert_eq!(names, ["director", "displacement", "reaction", "thickness"]);
    // The middle of the free edge sinks most of all; the curve has it to 1e-9 by differences.
    let sunk = sheet.point_data["displacement"].numbers.chunks(3).map(|u| -u[2]).fold(0.0, f64::max);
    let expected = outcome.curve.column("w_edge").unwrap()[0];
    assert!((sunk / expected - 1.0).abs() < 1e-7, "{sunk} for {expected}");
    // A quarter of the roof weighs 90 an area, on 25 × 40° × 25; the diaphragm bears it.
    let borne: f64 = sheet.point_data["reaction"].numbers.chunks(3).map(|force| force[2]).sum();
    let weight = 90.0 * 25.0 * 40.0_f64.to_radians() * 25.0;
    // The chords of 20 cells over the arc are short by (2°)²/24.
    assert!((borne / weight - 1.0).abs() < 6e-5, "{borne} for {weight}");
}

/// Fields that do not grow with the load.
const STATES: [&str; 3] = ["director", "t1", "thickness"];

/// Half the difference of a small load and its opposite, per unit of load: Newton's method, and squares cancel.
#[test]
fn linear_stresses_are_those_of_a_small_load() {
    for (name, formulation) in [("cells", "{ stress-point = {} }"), ("nodal", "{ nodal = { order = 2 } }")] {
        let coarse =
            [("geometry.cylinder.particles", "[9, 9]"), ("formulation", formulation), ("curve", "[]")];
        let run = |load: &str, more: &[(&str, &str)]| {
            let place = format!("{name}-{load}");
            run(&place, &shipped("scordelis-lo.toml"), &[&coarse[..], more].concat()).1.pop().unwrap()
        };
        let linear = run("linear", &[]);
        let small = |pull: &str| {
            let pull = format!("[0.0, 0.0, {pull}]");
            let pull = ("loads[0].gravity.acceleration", pull.as_str());
            run(pull.1, &[("analysis", "{ static = { levels = [1e-4] } }"), pull])
        };
        let (down, up) = (small("-1.0"), small("1.0"));
        let fields = |path: &Path, name: &str| {
            let Sheet { cell_data, point_data, .. } = Sheet::read(&path.with_file_name(name)).unwrap();
            cell_data.into_iter().chain(point_data).collect::<BTreeMap<_, _>>()
        };
        for kind in ["shell", "solid"] {
            let found = fields(&linear, &format!("{kind}-0000.vtu"));
            let [down, up] = [&down, &up].map(|path| fields(path, &format!("{kind}-0001.vtu")));
            assert!(found.keys().eq(down.keys()));
            // Directors stay unit vectors, and the faces move with them.
            let grows = |field: &str| !STATES.contains(&field) && (kind, field) != ("solid", "displacement");
            for (field, found) in found.iter().filter(|(field, _)| grows(field)) {
                // Equivalent stresses have no sign.
                let sign = if field.starts_with("von_mises") { 1.0 } else { -1.0 };
                let both = down[field].numbers.iter().zip(&up[field].numbers);
                let expected: Vec<f64> = both.map(|(a, b)| 0.5e4 * (a + sign * b)).collect();
                let largest = expected.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                for (x, y) in found.numbers.iter().zip(&expected) {
                    assert!((x - y).abs() <= 2e-5 * largest, "{name} {field}: {x} for {y} of {largest}");
                }
            }
        }
    }
}

/// Uniform tension 1e-3 on a sheet 1 × 0.1: σ = 1e-2, to the digits of single precision, as nothing is left out.
#[test]
fn the_linear_patch_test_is_exact() {
    let hinge = ("supports[2]", "{ on = \"u0v0\", hinged = {} }");
    let (_, frames) = run("patch", &shipped("patch-test.toml"), &[hinge, ("analysis", "{ linear = {} }")]);
    let sheet = Sheet::read(&frames[0]).unwrap();
    for name in ["von_mises_top", "von_mises_bottom"] {
        let stresses = &sheet.cell_data[name].numbers;
        assert!(stresses.iter().all(|s| (s / 1e-2 - 1.0).abs() < 2e-7), "{name}: {stresses:?}");
    }
    let reaction: f64 = sheet.point_data["reaction"].numbers.chunks(3).map(|force| force[0]).sum();
    assert!((reaction / -1e-3 - 1.0).abs() < 1e-8, "{reaction}");
}

#[test]
fn points_without_faces_are_shown_as_points() {
    let text = "title = \"Points\"\nunits = { length = \"m\", force = \"N\", time = \"s\" }\n\
        geometry.mesh.file = \"points.csv\"\nmaterial.elastic = { young = 12e6, poisson = 0.3, density = 10.0 }\n\
        section.homogeneous.thickness = 0.1\nformulation.nodal = { order = 1, consistent = false }\n\
        sets.fixed.box = { min = [0.0, 0.0, 0.0], max = [0.0, 2.0, 0.0] }\n\
        sets.tip.box = { min = [2.0, 0.0, 0.0], max = [2.0, 2.0, 0.0] }\n\
        supports = [{ on = \"fixed\", clamped = {} }]\n\
        loads = [{ on = \"tip\", force = { total = [0.0, 0.0, 300.0] } }]\nanalysis.static.levels = 1\n";
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("frames-of-points");
    fs::create_dir_all(&place).unwrap();
    // A lattice of 6 × 6 points, areas of half a cell at the edges.
    let (n, side) = (6, 0.4);
    let mut points = String::from("x,y,z,nx,ny,nz,area\n");
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let share = |k: usize| if k == 0 || k + 1 == n { 0.5 * side } else { side };
        points.push_str(&format!(
            "{},{},0,0,0,1,{}\n",
            i as f64 * side,
            j as f64 * side,
            share(i) * share(j)
        ));
    }
    fs::write(place.join("points.csv"), points).unwrap();
    let origin = place.join("points.toml");
    fs::write(&origin, text).unwrap();
    let (_, frames) = run("points", &origin, &[]);
    let sheet = Sheet::read(&frames[1]).unwrap();
    assert_eq!(sheet.cells, (0..n * n).map(|a| vec![a]).collect::<Vec<_>>());
    assert_eq!(sheet.point_data["moment"].numbers.len(), 3 * n * n);
    let solid = Sheet::read(&frames[1].with_file_name("solid-0001.vtu")).unwrap();
    assert_eq!(solid.cells, (0..n * n).map(|a| vec![a, a + n * n]).collect::<Vec<_>>());
    let svg = picture_svg(&sheet, &Picture::new("points")).unwrap();
    assert_eq!(svg.matches("<circle cx=").count(), n * n);
    // No faces, no surface: the same refusal as for any file of points.
    let refused = mesh::read(&frames[1]).unwrap_err().to_string();
    assert!(refused.contains("no triangles or quadrangles among 36 nodes"), "{refused}");
}
