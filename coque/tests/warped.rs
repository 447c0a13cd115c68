//! Cells of a mesh that are warped or hollow: told by `check` and `run` as by `mesh`.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use common::{column, ran};
use coque::{Doubt, Scene};
use sph_core::Vec3;

/// Cells along the side of a third of an octant.
const SIDE: usize = 12;

/// An octant of a sphere of radius 100 in three patches of quadrangles, one cell of which has been turned about its middle.
fn octant(degrees: f64) -> String {
    let (mut nodes, mut index, mut faces) = (Vec::<Vec3>::new(), HashMap::new(), Vec::new());
    let tan = |i: usize| (std::f64::consts::FRAC_PI_4 * i as f64 / SIDE as f64).tan();
    for axis in 0..3 {
        let mut node = |i: usize, j: usize| {
            let mut x = Vec3::zeros();
            (x[axis], x[(axis + 1) % 3], x[(axis + 2) % 3]) = (1.0, tan(i), tan(j));
            let x = 100.0 * x.normalize();
            *index.entry([0, 1, 2].map(|k| (x[k] * 1e6).round() as i64)).or_insert_with(|| {
                nodes.push(x);
                nodes.len() - 1
            })
        };
        for (i, j) in (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (i, j))) {
            faces.push([node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
        }
    }
    let corners = faces[SIDE / 2 * SIDE + SIDE / 2];
    let axis = corners.iter().map(|&node| nodes[node]).sum::<Vec3>();
    let turn = nalgebra::Rotation3::new(axis.normalize() * degrees.to_radians());
    corners.iter().for_each(|&node| nodes[node] = turn * nodes[node]);
    let mut text = format!("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", nodes.len());
    for (i, x) in nodes.iter().enumerate() {
        writeln!(text, "{} {} {} {}", i + 1, x.x, x.y, x.z).unwrap();
    }
    writeln!(text, "$EndNodes\n$Elements\n{}", faces.len()).unwrap();
    for (i, [a, b, c, d]) in faces.iter().enumerate() {
        writeln!(text, "{} 3 2 1 1 {} {} {} {}", i + 1, a + 1, b + 1, c + 1, d + 1).unwrap();
    }
    text + "$EndElements\n"
}

/// The sphere under the pressure at which it buckles, 2E/√(3(1 − ν²)) (t/R)².
const SPHERE: &str = r#"
title = "Sphere"
units = { length = "mm", force = "N", time = "s" }
geometry.mesh = { file = "sphere.msh" }
material.elastic = { young = 200000.0, poisson = 0.3, density = 7.8e-9 }
section.homogeneous.thickness = 1.0
sets.x = { plane = { point = [0, 0, 0], normal = [1, 0, 0], within = 1e-6 } }
sets.y = { plane = { point = [0, 0, 0], normal = [0, 1, 0], within = 1e-6 } }
sets.z = { plane = { point = [0, 0, 0], normal = [0, 0, 1], within = 1e-6 } }
supports = [{ on = "x", symmetry = { normal = [1, 0, 0] } }, { on = "y", symmetry = { normal = [0, 1, 0] } },
            { on = "z", symmetry = { normal = [0, 0, 1] } }]
loads = [{ on = "all", pressure = { value = -24.21, follower = true } }]
analysis.buckling.modes = 1
"#;

/// Whether the mesh is doubted, and the lowest level.
fn buckled(degrees: f64) -> (bool, f64) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("warped-{degrees}"));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("sphere.msh"), octant(degrees)).unwrap();
    let scene = || Scene::parse(SPHERE, &folder.join("scene.toml").display().to_string());
    let model = scene().unwrap().build(1).unwrap();
    let told = model.warnings().iter().any(|warning| warning.doubt == Doubt::PoorMesh);
    (told, column(&ran(scene()), "level")[0])
}

/// One cell of an octant turned in the surface, its neighbours hollow: with 89° the level is .964 of that of the sound mesh, with 60° .9995.
#[test]
fn a_turned_cell_is_told() {
    let (told, sound) = buckled(0.0);
    assert!(!told && (sound - 1.0).abs() < 0.005, "{sound}");
    for degrees in [60.0, 89.0] {
        let (told, level) = buckled(degrees);
        println!("{degrees}: {level} of {sound}");
        assert!(told, "{degrees}");
    }
}
