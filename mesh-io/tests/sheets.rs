//! What makes a surface of faces: directions that agree, boundary loops, numbers along the surface, quality.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{canonical, cloud, obj, square_with_a_hole};
use mesh_io::surface::{Format, parse, quality};
use sph_core::{Cloud, EndWeights, Plate, Vec3, lattice};

/// A strip of `n` squares, its ends joined straight or with a half turn.
fn band(n: usize, half_turns: f64) -> String {
    let mut text = String::new();
    for i in 0..n {
        let turn = std::f64::consts::TAU * i as f64 / n as f64;
        for side in [-1.0, 1.0] {
            let (reach, height) = (
                3.0 + side * 0.5 * libm::cos(0.5 * half_turns * turn),
                side * 0.5 * libm::sin(0.5 * half_turns * turn) + if half_turns == 0.0 { side } else { 0.0 },
            );
            text.push_str(&format!("v {} {} {height}\n", reach * libm::cos(turn), reach * libm::sin(turn)));
        }
    }
    for i in 0..n {
        let [a, b] = [2 * i + 1, 2 * i + 2];
        let [c, d] = match ((i + 1) == n, half_turns as usize % 2 == 1) {
            (true, true) => [2, 1],
            (true, false) => [1, 2],
            _ => [2 * i + 3, 2 * i + 4],
        };
        text.push_str(&format!("f {a} {c} {d} {b}\n"));
    }
    text
}

#[test]
fn faces_are_turned_to_agree() {
    // The second and third faces of a row of four run the other way round.
    let mut text = String::new();
    for i in 0..5 {
        text.push_str(&format!("v {i} 0 0\nv {i} 1 0\n"));
    }
    for (i, forward) in [true, false, false, true].into_iter().enumerate() {
        let [a, b, c, d] = [2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2];
        text.push_str(&if forward { format!("f {a} {b} {c} {d}\n") } else { format!("f {d} {c} {b} {a}\n") });
    }
    let surface = obj(&text);
    assert_eq!((surface.turned, surface.pieces), (2, 1));
    assert!(cloud(&surface).frames.iter().all(|frame| frame.n == cloud(&surface).frames[0].n));
    // Three against one: the smaller part follows the larger.
    let turned = obj(&text.replace("f 1 3 4 2", "f 2 4 3 1"));
    assert_eq!(turned.turned, 1);
    assert_eq!(cloud(&turned).frames[0].n, -Vec3::z());
    assert_eq!(cloud(&turned.flipped()).frames[0].n, Vec3::z());
    // Normals of the file decide over the larger part.
    let with_normals = text.replace("f 1 3 4 2", "vn 0 0 1\nf 1//1 3//1 4//1 2//1");
    let with_normals = with_normals.replace("f 7 9 10 8", "f 7//1 9//1 10//1 8//1");
    let with_normals = with_normals.replace("f 4 6 5 3", "f 4//1 6//1 5//1 3//1");
    assert_eq!(cloud(&obj(&with_normals)).frames[0].n, Vec3::z());
}

#[test]
fn bands_have_two_edges_or_one() {
    // A band has two edges; with a full twist (two half turns) it still has two sides.
    for half_turns in [0.0, 2.0] {
        let surface = obj(&band(24, half_turns));
        assert_eq!((surface.loops.len(), surface.pieces), (2, 1));
        assert_eq!(surface.loops[0].nodes.len(), 24);
    }
    let error = parse("moebius.obj", Format::Obj, band(24, 1.0).as_bytes()).unwrap_err();
    assert!(error.what.contains("one side only"), "{error}");
}

#[test]
fn the_longest_boundary_comes_first() {
    let surface = obj(&square_with_a_hole());
    let lengths: Vec<f64> = surface.loops.iter().map(|found| found.length).collect();
    assert_eq!(lengths, [16.0, 4.0]);
    assert_eq!(surface.set("boundary0").unwrap().len(), 16);
    assert_eq!(surface.set("boundary1").unwrap(), [7, 8, 13, 12]); // the surface lies to the left
    assert_eq!(surface.set("boundary2"), None);
    assert_eq!(surface.clone().flipped().set("boundary1").unwrap(), [7, 12, 13, 8]);
    assert_eq!(surface.scaled(0.5).loops[1].length, 2.0);
}

#[test]
fn unused_nodes_and_seams_are_reported() {
    let surface = obj(
        "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 4 5\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 6 7 8 9\n",
    );
    assert_eq!((surface.positions.len(), surface.pieces), (8, 2));
    assert_eq!(surface.labels[0], 2);
    let notes = surface.notes.join("\n");
    assert!(notes.contains("nodes that no face uses, left out: 1"), "{notes}");
    assert!(notes.contains("coincident nodes on the boundary: 4"), "{notes}");
}

#[test]
fn nodes_are_numbered_along_the_surface() {
    let n = 33; // 32 gaps: places are exact
    // 331 has no divisor in common with 33²: every number once, neighbours far apart.
    let scattered = |a: usize| (331 * a) % (n * n);
    let mut nodes = vec![String::new(); n * n];
    for a in 0..n * n {
        nodes[scattered(a)] = format!("v {} {} 0\n", a / n, a % n);
    }
    let mut text = nodes.concat();
    for (i, j) in (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))) {
        let corners = [i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1];
        let [a, b, c, d] = corners.map(|a| scattered(a) + 1);
        text.push_str(&format!("g row{i}\nf {a} {b} {c} {d}\n"));
    }
    let surface = obj(&text);
    let lengths = [(n - 1) as f64; 2];
    let native = lattice(&Plate { lengths }, [n, n], EndWeights::Trapezoid).unwrap();
    assert!(canonical(&cloud(&surface)) == canonical(&native));
    // A row of the lattice spans n + 1 numbers, a front of a flood from a corner at most two diagonals.
    let reach = |cloud: &Cloud| {
        let spans = cloud
            .cells
            .iter()
            .map(|cell| cell.corners.iter().max().unwrap() - cell.corners.iter().min().unwrap());
        spans.max().unwrap() as usize
    };
    assert!(reach(&cloud(&surface)) <= 3 * n, "{}", reach(&cloud(&surface)));
    // Sets and numbers go with the nodes.
    let row = surface.set("row3").unwrap();
    assert_eq!(row.len(), 2 * n);
    for &a in row {
        let x = surface.positions[a as usize];
        assert!(x.x == 3.0 || x.x == 4.0);
        assert_eq!(surface.labels[a as usize], scattered(x.x as usize * n + x.y as usize) as u64 + 1);
    }
    // A lattice in good order keeps its numbers.
    let plain: String = (0..n * n).map(|a| format!("v {} {} 0\n", a / n, a % n)).collect();
    let faces = |(i, j): (usize, usize)| {
        format!("f {} {} {}\n", i * n + j + 1, (i + 1) * n + j + 1, (i + 1) * n + j + 2)
            + &format!("f {} {} {}\n", i * n + j + 1, (i + 1) * n + j + 2, i * n + j + 2)
    };
    let faces: String = (0..n - 1).flat_map(|i| (0..n - 1).map(move |j| (i, j))).map(faces).collect();
    let kept = cloud(&obj(&(plain + &faces)));
    assert!((kept.positions, kept.cells) == (native.positions, native.cells));
}

#[test]
fn quality_has_its_schoolbook_figures() {
    // A right triangle 3-4-5 and a square of side 3: angles 36.87°, 53.13°, 90°.
    let surface = obj("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 7 0 0\nf 1 2 3 4\nf 2 5 3\n");
    let found = quality(&surface);
    assert_eq!((found.area, found.slivers, found.hollow, found.warp), (15.0, 0, 0, 0.0));
    assert_eq!((found.spacing[0], found.spacing[2]), (3.0, 5.0));
    assert!((found.spacing[1] - 21.0 / 6.0).abs() < 1e-14);
    assert!((found.angles[0] - libm::atan(0.75_f64)).abs() < 1e-14);
    assert!((found.aspect - 5.0 / 3.0).abs() < 1e-14);
    // An arrow has a corner beyond 180°; a needle is a sliver.
    let bad = obj("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1.2 0.8 0\nf 1 2 3 4\nv 0 -0.1 0\nf 1 5 2\n");
    let found = quality(&bad);
    assert_eq!((found.slivers, found.hollow), (1, 1));
}
