//! What a cloud refuses of a sound surface: file, line, face and node are those of the file.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use mesh_io::surface::{Format, MeshError, parse};

fn refused(file: &str, format: Format, text: &str) -> MeshError {
    let surface = parse(file, format, text.as_bytes()).unwrap();
    surface.cloud(surface.node_normals()).unwrap_err()
}

#[test]
fn a_sharp_corner_is_named_by_face_and_line() {
    // arctan 0.05 = 2.86°, below the 5° that a cell must have.
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nv 2 0.05 0\nf 2 5 3\nv 3 0 0\nf 2 6 5\n";
    assert_eq!(
        refused("sharp.obj", Format::Obj, text).to_string(),
        "sharp.obj, line 9: face 3: the corner at node 2 at [1, 0, 0] has 2.86°; at least 5° is needed; move the node, \
         merge it with its neighbour, or mesh the surface anew"
    );
}

#[test]
fn sharp_triangles_that_join_well_are_sound() {
    // Two triangles of 2.86° make a rectangle of 1 × 0.05.
    let surface =
        parse("thin.obj", Format::Obj, b"v 0 0 0\nv 1 0 0\nv 1 0.05 0\nv 0 0.05 0\nf 1 2 3\nf 1 3 4\n");
    let surface = surface.unwrap();
    let (cloud, cells) = surface.cloud(surface.node_normals()).unwrap();
    assert_eq!((cloud.cells.len(), cells.joined), (1, 1));
}

#[test]
fn a_normal_against_its_face_is_named_by_face_and_line() {
    // Two squares along the y axis, the second folded back by 150°: the normal given at an end of the fold leans far
    // enough to the first to look away from the second, not from the mean of both.
    let (c, s) = (-(3.0_f64.sqrt()) / 2.0 * 0.5, 0.25);
    let text = format!(
        "*Node\n1, -1., 0., 0., 0., 0., 1.\n2, 0., 0., 0., 0., 0., 1.\n3, 0., 1., 0., 0., 0., 1.\n4, -1., 1., 0., 0., 0., 1.\n\
         5, {c}, 0., {s}, -0.5, 0., -0.87\n6, {c}, 1., {s}, -0.5, 0., -0.87\n*Element, type=S4R\n11, 1, 2, 3, 4\n12, 2, 5, 6, 3\n"
    );
    assert_eq!(
        refused("fold.inp", Format::Abaqus, &text).to_string(),
        "fold.inp, line 10: face 12: the normal at node 2 at [0, 0, 0] is 150° from that of the face; less than 90° is \
         needed; turn it round, or leave the normals out of the file"
    );
}
