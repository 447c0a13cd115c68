//! Cells of a mesh that are hollow, warped or cross themselves: cut in two, warned of, refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use crate::common::{column, ran};
use coque::{Outcome, Rendering, Scene, SceneError, WarningKind, render};
use sph_core::Vec3;

/// Cells along the side of a third of an octant.
const SIDE: usize = 12;

/// An octant of a sphere of radius 100 in three patches of quadrangles, one cell of which has been turned about its middle, and one of its nodes
/// pushed outwards.
fn octant(degrees: f64, out: f64) -> String {
    let (mut nodes, mut index, mut faces) = (Vec::<Vec3>::new(), HashMap::new(), Vec::new());
    let tan = |i: usize| libm::tan(std::f64::consts::FRAC_PI_4 * i as f64 / SIDE as f64);
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
    nodes[corners[0]] *= 1.0 + out;
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

/// The run of an octant, or why there is none, and whether its mesh is warned of.
fn buckled(name: &str, degrees: f64, out: f64) -> Result<(bool, Outcome), SceneError> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("warped-{name}"));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("sphere.msh"), octant(degrees, out)).unwrap();
    let scene = || Scene::parse(SPHERE, &folder.join("scene.toml").display().to_string());
    let reported = scene()?.build(1)?.warnings().iter().any(|warning| warning.kind == WarningKind::PoorMesh);
    Ok((reported, ran(scene())))
}

/// One cell of an octant turned in the surface by 60°, two neighbours hollow: cut in two they leave the level where it is, to 5e-5.
#[test]
fn hollow_cells_are_cut_in_two() {
    let (reported, sound) = buckled("sound", 0.0, 0.0).unwrap();
    let level = |outcome: &Outcome| column(outcome, "level")[0];
    assert!(!reported && (level(&sound) - 1.0).abs() < 0.005, "{}", level(&sound));
    let (reported, turned) = buckled("turned", 60.0, 0.0).unwrap();
    println!("{} of {}", level(&turned), level(&sound));
    assert!(!reported && (level(&turned) / level(&sound) - 1.0).abs() < 2e-4, "{}", level(&turned));
    let line = "432 quadrangles, 2 of them with a corner beyond 180° and cut into two triangles each";
    let modelled = &turned.summary.body.modelled;
    assert!(modelled.iter().any(|said| said.contains(line)), "{modelled:?}");
}

/// A node out of the surface warps the cells at it, which is reported; turned by 89° two cells cross themselves, of which no cut makes cells.
#[test]
fn warped_cells_are_reported_and_crossed_ones_refused() {
    assert!(buckled("warped", 0.0, 0.02).unwrap().0);
    let refused = buckled("crossed", 89.0, 0.0).err().unwrap();
    let text = render(&refused, Rendering { width: 200, colour: false });
    assert!(text.contains("cross each other"), "{text}");
}
