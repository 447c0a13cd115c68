//! Meshes whose sheets share nodes: cut where they meet, normals of each sheet alone.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::cloud;
use mesh_io::surface::{Format, Junctions, Surface, parse};
use sph_core::{Cloud, Vec3};

/// A surface of squares from lists of corners in steps of one, nodes merged.
fn surface(faces: &[Vec<[f64; 3]>]) -> Surface {
    let (mut nodes, mut text, mut lines): (Vec<[f64; 3]>, _, _) = (Vec::new(), String::new(), String::new());
    for face in faces {
        lines.push('f');
        for corner in face {
            let near = |x: &[f64; 3]| x.iter().zip(corner).all(|(a, b)| (a - b).abs() < 1e-9);
            let number = nodes.iter().position(near).unwrap_or_else(|| {
                nodes.push(*corner);
                nodes.len() - 1
            });
            lines.push_str(&format!(" {}", number + 1));
        }
        lines.push('\n');
    }
    nodes.iter().for_each(|[x, y, z]| text.push_str(&format!("v {x} {y} {z}\n")));
    parse("test.obj", Format::Obj, (text + &lines).as_bytes()).unwrap()
}

/// Squares of a sheet from `origin` along u and v.
fn sheet(origin: [f64; 3], u: [f64; 3], v: [f64; 3], [m, n]: [usize; 2]) -> Vec<Vec<[f64; 3]>> {
    let at = |i: usize, j: usize| -> [f64; 3] {
        std::array::from_fn(|k| origin[k] + i as f64 * u[k] + j as f64 * v[k])
    };
    let cells = (0..m).flat_map(|i| (0..n).map(move |j| (i, j)));
    cells.map(|(i, j)| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]).collect()
}

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn tee() -> Surface {
    surface(&[sheet([-2.0, 0.0, 0.0], X, Y, [4, 3]), sheet([0.0; 3], Z, Y, [2, 3])].concat())
}

/// A strip along x that turns by an angle \[degrees\] after every so many cells.
fn polygon(degrees: f64, cells: usize, facets: usize, triangles: bool) -> Surface {
    let mut faces = Vec::new();
    let mut start = [0.0; 3];
    for facet in 0..facets {
        let (sin, cos) = libm::sincos((facet as f64 * degrees).to_radians());
        let along = [cos, 0.0, sin];
        faces.extend(sheet(start, along, Y, [cells, 2]));
        start = std::array::from_fn(|k| start[k] + cells as f64 * along[k]);
    }
    if triangles {
        faces = faces.iter().flat_map(|f| [vec![f[0], f[1], f[2]], vec![f[0], f[2], f[3]]]).collect();
    }
    surface(&faces)
}

/// Every particle stands across its cells: its normal is theirs.
fn normals_are_those_of_cells(cloud: &Cloud) {
    for cell in &cloud.cells {
        let normal: Vec3 = cell.geometry(&cloud.positions).normal;
        for &a in cell.particles() {
            assert!(cloud.frames[a as usize].n.dot(&normal) > 1.0 - 1e-12);
        }
    }
}

#[test]
fn a_stem_on_a_bar_has_particles_of_its_own() {
    let surface = tee();
    assert_eq!(surface.junctions, Junctions { branches: 3, folds: 0 });
    assert_eq!(surface.joined.len(), 4);
    assert!(surface.joined.iter().all(|place| place.len() == 2));
    assert_eq!(surface.pieces, 1);
    assert_eq!(surface.positions.len(), 5 * 4 + 3 * 4);
    let cloud = cloud(&surface);
    normals_are_those_of_cells(&cloud);
    // Areas are those of both sheets, twice where they meet.
    assert!((cloud.areas.iter().sum::<f64>() - 18.0).abs() < 1e-12);
    assert_eq!(cloud.pieces().len(), 1);
    // The bar's edge is closed; the stem's ends at the bar.
    let lines: Vec<(usize, f64)> = surface.loops.iter().map(|l| (l.nodes.len(), l.length)).collect();
    assert_eq!(lines, [(14, 14.0), (8, 7.0)]);
    assert_eq!(surface.tied(), "3 edges of three faces and more: 8 particles tied at 4 places");
}

#[test]
fn a_box_is_six_sheets_and_turns_one_way() {
    let side = |o: [f64; 3], u, v| sheet(o, u, v, [2, 2]);
    let faces = [
        side([0.0; 3], Y, X),
        side([0.0, 0.0, 2.0], X, Y),
        side([0.0; 3], X, Z),
        side([0.0, 2.0, 0.0], X, Z), // looks inwards in the file
        side([0.0; 3], Z, Y),
        side([2.0, 0.0, 0.0], Y, Z),
    ];
    let surface = surface(&faces.concat());
    assert_eq!(surface.junctions, Junctions { branches: 0, folds: 24 });
    // Twelve edges of three places, eight corners of three sheets.
    assert_eq!(surface.joined.iter().filter(|place| place.len() == 3).count(), 8);
    assert_eq!(surface.joined.len(), 8 + 12);
    assert_eq!((surface.turned, surface.pieces, surface.loops.len()), (4, 1, 0));
    let cloud = cloud(&surface);
    normals_are_those_of_cells(&cloud);
    let centre = Vec3::new(1.0, 1.0, 1.0);
    let out = cloud.positions.iter().zip(&cloud.frames).map(|(x, frame)| (x - centre).dot(&frame.n));
    assert!(
        out.into_iter().all(|side| side > 0.9) || cloud.frames[0].n.dot(&(cloud.positions[0] - centre)) < 0.0
    );
}

#[test]
fn crossing_sheets_go_on_straight() {
    let cross = [sheet([-2.0, 0.0, 0.0], X, Y, [4, 2]), sheet([0.0, 0.0, -2.0], Z, Y, [4, 2])].concat();
    let surface = surface(&cross);
    assert_eq!(surface.junctions.branches, 2);
    assert!(surface.joined.iter().all(|place| place.len() == 2));
    let cloud = cloud(&surface);
    normals_are_those_of_cells(&cloud);
    // Both sheets have their closed edge.
    assert_eq!(surface.loops.len(), 2);
}

#[test]
fn folds_beyond_the_bound_are_cut_and_facets_are_not() {
    for (degrees, cells, facets, triangles, folds) in [
        // One fold: beyond 30° cut, at 30° not.
        (29.9, 3, 2, false, 0),
        (30.0, 3, 2, false, 0),
        (30.1, 3, 2, false, 2),
        (30.1, 3, 2, true, 2),
        (120.0, 1, 2, false, 2),
        // Facets of one cell are a coarse curve up to 60°, those of three are facets.
        (45.0, 1, 5, false, 0),
        (45.0, 1, 5, true, 0),
        (45.0, 3, 5, false, 8),
        (45.0, 3, 5, true, 8),
        (72.0, 1, 4, false, 6),
    ] {
        let surface = polygon(degrees, cells, facets, triangles);
        let name = format!("{degrees}° {cells} cells, triangles: {triangles}");
        assert_eq!(surface.junctions.folds, folds, "{name}");
        assert_eq!(surface.pieces, 1, "{name}");
        cloud(&surface);
    }
}

#[test]
fn a_loop_goes_on_over_a_fold() {
    let surface = polygon(90.0, 3, 2, false);
    assert_eq!(surface.joined.len(), 3);
    assert_eq!(surface.loops.len(), 1);
    assert!((surface.loops[0].length - 16.0).abs() < 1e-12);
    // Both particles of the two ends of the fold.
    assert_eq!(surface.loops[0].nodes.len(), 16 + 2);
}

#[test]
fn groups_of_the_file_hold_every_sheet() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\ng flat\nf 1 2 3 4\ng web\nf 2 5 6 3\n";
    let surface = parse("fold.obj", Format::Obj, text.as_bytes()).unwrap();
    assert_eq!(surface.positions.len(), 8);
    assert_eq!(surface.sets["flat"].len(), 6);
    assert_eq!(surface.sets["web"].len(), 6);
}

#[test]
fn one_normal_a_node_from_the_file_makes_no_fold() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\nvn 0 0 1\nvn -1 0 0\nvn -1 0 1\n\
                f 1//1 2//3 3//3 4//1\nf 2//3 5//2 6//2 3//3\n";
    let surface = parse("fold.obj", Format::Obj, text.as_bytes()).unwrap();
    assert_eq!((surface.joined.len(), surface.normals.is_some()), (0, true));
    // A third face is a junction all the same, and its nodes have normals of their own.
    let text = format!("{text}v 1 0 -1\nv 1 1 -1\nf 2//3 7//2 8//2 3//3\n");
    let surface = parse("web.obj", Format::Obj, text.as_bytes()).unwrap();
    assert_eq!(surface.joined.len(), 2);
    normals_are_those_of_cells(&cloud(&surface));
}
