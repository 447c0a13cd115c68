//! Surfaces from text, and the plate that stands in `tests/meshes` in every format.

#![allow(dead_code)] // each test binary uses its own part
#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::path::{Path, PathBuf};

use mesh_io::surface::{Format, Surface, parse, read};
use sph_core::Cloud;

/// The plates; scenes of another crate run on them too.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../mesh-io/tests/meshes")
}

pub fn plate(name: &str) -> Surface {
    read(&folder().join(name)).unwrap()
}

pub fn cloud(surface: &Surface) -> Cloud {
    surface.cloud(surface.node_normals()).unwrap().0
}

/// Particles and cells in an order of their places: files number nodes as they like.
pub fn canonical(cloud: &Cloud) -> (Vec<[f64; 8]>, Vec<Vec<[f64; 3]>>) {
    let mut particles: Vec<[f64; 8]> = (0..cloud.len())
        .map(|a| {
            let (x, n) = (cloud.positions[a], cloud.frames[a].n);
            [x.x, x.y, x.z, n.x, n.y, n.z, cloud.areas[a], cloud.edge_lengths[a]]
        })
        .collect();
    particles.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let mut cells: Vec<Vec<[f64; 3]>> = cloud
        .cells
        .iter()
        .map(|cell| {
            let mut places: Vec<[f64; 3]> =
                cell.particles().iter().map(|&a| cloud.positions[a as usize].into()).collect();
            places.sort_by(|a, b| a.partial_cmp(b).unwrap());
            places
        })
        .collect();
    cells.sort_by(|a, b| a.partial_cmp(b).unwrap());
    (particles, cells)
}

pub const PLATES: [&str; 10] = [
    "plate-22.msh",
    "plate-41.msh",
    "plate.inp",
    "plate.stl",
    "plate-binary.stl",
    "plate.obj",
    "plate.ply",
    "plate-binary.ply",
    "plate-ascii.vtu",
    "plate-binary.vtu",
];

pub fn obj(text: &str) -> Surface {
    parse("test.obj", Format::Obj, text.as_bytes()).unwrap()
}

/// A square of 5 × 5 nodes with a hole of one cell.
pub fn square_with_a_hole() -> String {
    let mut text = String::new();
    for i in 0..25 {
        text.push_str(&format!("v {} {} 0\n", i / 5, i % 5));
    }
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).filter(|&cell| cell != (1, 2)) {
        let a = 5 * i + j + 1;
        text.push_str(&format!("f {a} {} {} {}\n", a + 5, a + 6, a + 1));
    }
    text
}
