//! The hinged panel as a mesh: the same particles give the same limit load, and triangles come close.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use coque::{Outcome, Scene, Silent};
use sph_core::{Cloud, Cylinder, EndWeights, Side, lattice};

const COUNTS: [usize; 2] = [11, 11];

/// The panel of scenes/panel.toml: 0.1 rad of a cylinder.
fn panel() -> Cloud {
    let patch = Cylinder { radius: 2540.0, angles: [0.0, 5.729577951308232_f64.to_radians()], length: 254.0 };
    lattice(&patch, COUNTS, EndWeights::Trapezoid).unwrap()
}

/// Gmsh 2.2 with the edges as physical lines; quadrangles or triangles, with or without normals.
fn msh(cloud: &Cloud, triangles: bool, normals: bool) -> String {
    let mut text = String::from(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"crown\"\n1 2 \"hinge\"\n1 3 \"middle\"\n$EndPhysicalNames\n",
    );
    writeln!(text, "$Nodes\n{}", cloud.len()).unwrap();
    for (a, x) in cloud.positions.iter().enumerate() {
        writeln!(text, "{} {:?} {:?} {:?}", a + 1, x.x, x.y, x.z).unwrap();
    }
    let mut elements = String::new();
    let mut count = 0;
    let mut add = |kind: &str, group: usize, nodes: &[u32]| {
        count += 1;
        let nodes: Vec<String> = nodes.iter().map(|a| (a + 1).to_string()).collect();
        writeln!(elements, "{count} {kind} 2 {group} {group} {}", nodes.join(" ")).unwrap();
    };
    let sides = cloud.sides.as_ref().unwrap();
    for (group, side) in [(1, Side::U0), (2, Side::U1), (3, Side::V0)] {
        sides.edge(side).windows(2).for_each(|ends| add("1", group, ends));
    }
    for (c, cell) in cloud.cells.iter().enumerate() {
        let [p, q, r, s] = cell.corners;
        match (triangles, c % 3) {
            (false, _) => add("3", 4, &[p, q, r, s]),
            (true, 0) => [[p, q, r], [r, s, p]].iter().for_each(|t| add("2", 4, t)),
            (true, _) => [[q, r, s], [s, p, q]].iter().for_each(|t| add("2", 4, t)),
        }
    }
    writeln!(text, "$EndNodes\n$Elements\n{count}\n{elements}$EndElements").unwrap();
    if normals {
        writeln!(text, "$NodeData\n1\n\"Normals\"\n1\n0\n3\n0\n3\n{}", cloud.len()).unwrap();
        for (a, frame) in cloud.frames.iter().enumerate() {
            writeln!(text, "{} {:?} {:?} {:?}", a + 1, frame.n.x, frame.n.y, frame.n.z).unwrap();
        }
        text.push_str("$EndNodeData\n");
    }
    text
}

/// The crown displacements of scenes/panel.toml on the way to the limit point, without time.
const LEVELS: &str = "[0.0667, 0.1333, 0.2, 0.2667, 0.3, 0.3333, 0.3667, 0.4, 0.4333]";

/// Runs the panel after `change` was made to its scene.
fn run(origin: &str, change: impl Fn(&str) -> String) -> Outcome {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let text = change(&fs::read_to_string(scenes.join("panel.toml")).unwrap());
    let levels = ("analysis.static.levels".to_string(), LEVELS.to_string());
    let scene = Scene::with_overrides(&text, origin, &[levels]).unwrap_or_else(|e| panic!("{e}"));
    scene.build(1).unwrap_or_else(|e| panic!("{e}")).run(&mut Silent)
}

fn meshed(name: &str, mesh: &str) -> Outcome {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    fs::write(folder.join(name), mesh).unwrap();
    run(&folder.join("scene.toml").to_string_lossy(), |text| {
        let (head, tail) = text.split_once("[geometry.cylinder]").unwrap();
        let (_, tail) = tail.split_once("[material").unwrap();
        let tail = tail
            .replace("\"u1\"", "\"hinge\"")
            .replace("\"u0\"", "\"crown\"")
            .replace("\"v0\"", "\"middle\"")
            .replace("\"u0v0\"", "\"load\"")
            .replace("\"u0v1\"", "\"edge\"");
        let sets =
            "[sets]\nload = { nearest = [0.0, 0.0, 2540.0] }\nedge = { nearest = [0.0, 254.0, 2540.0] }\n";
        format!("{head}[geometry.mesh]\nfile = \"{name}\"\n\n{sets}\n[material{tail}")
    })
}

fn loads(outcome: &Outcome) -> Vec<f64> {
    let loads = outcome.curve.column("P").unwrap();
    assert_eq!(loads.len(), 10, "{:?}", outcome.ended);
    loads
}

#[test]
fn the_same_particles_give_the_same_limit_load() {
    let native = loads(&run("panel.toml", |text| text.replace("[21, 21]", "[11, 11]")));
    let cloud = panel();
    let exact = loads(&meshed("panel-quads.msh", &msh(&cloud, false, true)));
    for (found, expected) in exact.iter().zip(&native).skip(1) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} for {expected}");
    }
    // The limit lies between: the load still rises at first and falls at last.
    let limit = native.iter().copied().fold(0.0, f64::max);
    assert!(native[1] < limit && *native.last().unwrap() < limit);

    // Triangles are joined to the same quadrangles, in another order.
    let joined = loads(&meshed("panel-triangles.msh", &msh(&cloud, true, true)));
    // Normals from the faces lean by half a cell at the hinge alone; the symmetry planes put theirs right.
    let means = loads(&meshed("panel-means.msh", &msh(&cloud, true, false)));
    for (i, expected) in native.iter().enumerate().skip(1) {
        assert!((joined[i] / expected - 1.0).abs() < 1e-6, "{} for {expected}", joined[i]);
        // Measured: 4e-6 at most.
        assert!((means[i] / expected - 1.0).abs() < 1e-4, "{} for {expected}", means[i]);
    }
}
