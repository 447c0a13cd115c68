//! A mesh and the places of its scene moved together: the same curve, iterations included. Plates and shells that coque lays out itself begin at
//! zero; meshes may stand anywhere.

use std::fs;

use super::{Outcome, common::text, difference, judge, ran};

/// Scenes of meshes with the length of each, about.
const MESHES: [(&str, &str, f64); 3] =
    [("t-frame", "t-frame", 1.0), ("bracket-gmsh", "bracket", 100.0), ("roof", "roof", 300.0)];

/// A Gmsh 2.2 mesh with its nodes moved.
fn moved_mesh(mesh: &str, by: [f64; 3]) -> String {
    let (mut within, mut out) = (false, String::new());
    for line in mesh.lines() {
        within = (within || line == "$Nodes") && line != "$EndNodes";
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            [node, x, y, z] if within => {
                let [x, y, z] = [x, y, z].map(|word| word.parse::<f64>().unwrap());
                out += &format!("{node} {:?} {:?} {:?}\n", x + by[0], y + by[1], z + by[2]);
            }
            _ => out += &format!("{line}\n"),
        }
    }
    out
}

/// The scene of a mesh in a folder, both moved.
fn of_mesh((scene, mesh, _): (&str, &str, f64), by: [f64; 3]) -> Outcome {
    let folder = std::env::temp_dir().join(format!("coque-shifted-{scene}-{}-{}", by[0], std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join(format!("{mesh}.msh"));
    fs::write(&file, moved_mesh(&text(&format!("meshes/{mesh}.msh")), by)).unwrap();
    let mut table: toml::Table = text(&format!("meshes/{scene}.toml")).parse().unwrap();
    if let Some(toml::Value::Table(sets)) = table.get_mut("sets") {
        for nearest in sets.iter_mut().filter_map(|(_, set)| set.get_mut("nearest")?.as_array_mut()) {
            for (place, by) in nearest.iter_mut().zip(by) {
                *place = toml::Value::Float(place.as_float().unwrap() + by);
            }
        }
    }
    let path = format!("\"{}\"", file.display());
    let outcome = ran(
        &toml::to_string(&table).unwrap(),
        &[("geometry.mesh.file", &path), ("analysis", "{ static = { levels = 4 } }")],
        1,
    );
    fs::remove_dir_all(&folder).unwrap();
    outcome
}

#[test]
fn a_mesh_far_away_gives_the_same_curve() {
    let mut failures = Vec::new();
    for scene in MESHES {
        let far = [0.9, -0.4, 0.3].map(|part| part * 1e4 * scene.2);
        let (here, there) = (of_mesh(scene, [0.0; 3]), of_mesh(scene, far));
        let ones = vec![1.0; here.curve.columns.len()];
        judge(&mut failures, "shifted", scene.0, difference(&here, &there, &ones), 1e-9);
        let iterations = |outcome: &Outcome| outcome.summary.record.newton_iterations;
        assert_eq!(iterations(&here), iterations(&there), "{}", scene.0);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
