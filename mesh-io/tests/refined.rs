//! A refined surface lies on the one that its nodes are of: circles, cylinders, spheres to a higher order than chords; what is flat stays so.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;

use libm::{cos, sin};
use mesh_io::surface::Arrays;
use sph_core::Vec3;

/// Cells n×m of a surface over the unit square.
fn grid(n: u32, m: u32, place: impl Fn(f64, f64) -> [f64; 3]) -> Arrays {
    let at = |i: u32, j: u32| i * (m + 1) + j;
    let points = (0..=n).flat_map(|i| (0..=m).map(move |j| (i, j)));
    let points = points.map(|(i, j)| place(f64::from(i) / f64::from(n), f64::from(j) / f64::from(m)));
    let faces = (0..n)
        .flat_map(|i| (0..m).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
        .collect();
    Arrays { points: points.collect(), faces, sets: BTreeMap::new(), face_sets: BTreeMap::new() }
}

/// Each quadrangle as two triangles.
fn in_triangles(mut arrays: Arrays) -> Arrays {
    let halves = arrays.faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c, c], [a, c, d, d]]);
    arrays.faces = halves.collect();
    arrays
}

/// Nodes of the refined surface.
fn refined(arrays: &Arrays) -> Vec<Vec3> {
    let surface = arrays.surface("surface", false).unwrap();
    surface.refined().points.into_iter().map(Vec3::from).collect()
}

/// Greatest distance of the new nodes from a surface.
fn off(arrays: &Arrays, distance: impl Fn(&Vec3) -> f64) -> f64 {
    let all = refined(arrays);
    all[arrays.points.len()..].iter().map(|x| distance(x).abs()).fold(0.0, f64::max)
}

#[test]
fn new_nodes_lie_on_the_cylinder_and_the_sphere() {
    let roof = |n| grid(n, n, |u, v| [cos(1.2 * u), v, sin(1.2 * u)]);
    let cap = |n| {
        grid(n, n, |u, v| {
            let [x, y] = [0.9 * u - 0.3, 0.8 * v - 0.4];
            [x, y, libm::sqrt(1.0 - x * x - y * y)]
        })
    };
    let of_roof = |x: &Vec3| libm::hypot(x.x, x.z) - 1.0;
    let of_cap = |x: &Vec3| x.norm() - 1.0;
    // Chords lie off the roof by h²/8: 1.8e-3 with ten cells, off the cap by the sums of two. A parabola through the ends of an arc is off by h⁴/32.
    for (made, distance, bounds) in [
        (&roof as &dyn Fn(u32) -> Arrays, &of_roof as &dyn Fn(&Vec3) -> f64, [2e-5, 2e-6]),
        (&cap, &of_cap, [3e-4, 3e-5]),
    ] {
        for (n, bound) in [10, 20].into_iter().zip(bounds) {
            for arrays in [made(n), in_triangles(made(n))] {
                let found = off(&arrays, distance);
                println!("{n}: {found:e}");
                assert!(found < bound, "{n}: {found:e}");
            }
        }
    }
}

#[test]
fn the_edge_of_a_hole_stays_a_circle_in_its_plane() {
    let plate = grid(8, 8, |u, v| {
        let angle = std::f64::consts::FRAC_PI_2 * u;
        let edge = 4.0 / f64::max(cos(angle), sin(angle));
        let r = 1.0 + (edge - 1.0) * v;
        [r * cos(angle), r * sin(angle), 0.0]
    });
    let fine = refined(&plate);
    assert!(fine.iter().all(|x| x.z == 0.0));
    let held = |x: &Vec3| x.x.abs() < 1e-15 || x.y == 0.0;
    // Nodes on the lines of symmetry stay on them, those of the outer edge on straight lines; the corner is one.
    let outer = fine.iter().filter(|x| (x.x.max(x.y) - 4.0).abs() < 1e-12);
    assert_eq!((fine.iter().filter(|x| held(x)).count(), outer.count()), (2 * 17, 17));
    // The edge of the hole: middles of its cells, beside the chord's h²/8 of 4.8e-3.
    let near = fine.iter().filter(|x| x.norm() < 1.1).map(|x| (x.norm() - 1.0).abs());
    let most = near.fold(0.0, f64::max);
    println!("hole {most:e}");
    assert!(most < 2e-4, "{most:e}");
}

#[test]
fn what_is_flat_stays_flat_to_the_bit() {
    let sheared = grid(5, 4, |u, v| [u + 0.3 * v, v * v + 0.1, 0.25]);
    let surface = sheared.surface("flat", false).unwrap();
    let fine = surface.refined().points;
    assert!(fine.iter().all(|x| x[2] == 0.25));
    // Flat beside a quarter of a cylinder: the flat half stays in its plane.
    let bent = grid(16, 3, |u, v| {
        let s = 2.0 * u - 1.0;
        if s <= 0.0 { [s, v, 0.0] } else { [sin(s), v, 1.0 - cos(s)] }
    });
    // Of triangles the nodes about a corner reach into the arc; they lift by a seventh of what its cells bulge, 2e-3.
    for (arrays, bound) in [(bent.clone(), 0.0), (in_triangles(bent), 5e-4)] {
        let fine = refined(&arrays);
        let lifted = fine.iter().filter(|x| x.x < 0.0).map(|x| x.z.abs()).fold(0.0, f64::max);
        println!("lifted {lifted:e}");
        assert!(lifted <= bound, "{lifted:e}");
        let off = |x: &&Vec3| x.x > 1e-9 && (libm::hypot(x.x, 1.0 - x.z) - 1.0).abs() > 1.2e-3;
        assert_eq!(fine.iter().filter(off).count(), 0);
    }
    // A fold of two plates is a line of both.
    let angle = grid(4, 2, |u, v| if u <= 0.5 { [u, v, 0.0] } else { [0.5, v, u - 0.5] });
    let fine = refined(&angle);
    assert!(fine.iter().all(|x| x.z == 0.0 || x.x == 0.5));
}

#[test]
fn turned_scaled_and_mirrored_it_is_the_same() {
    let saddle = grid(6, 5, |u, v| [u, 1.3 * v, 0.2 * u * u - 0.3 * u * v + 0.1 * v * v * v]);
    let turn = nalgebra::Rotation3::new(Vec3::new(0.4, -1.1, 0.7));
    let way = |x: &Vec3| turn * Vec3::new(x.x, x.y, -x.z) * 1e3 + Vec3::new(5.0, 6.0, 7.0);
    let mut moved = saddle.clone();
    moved.points.iter_mut().for_each(|x| *x = way(&Vec3::from(*x)).into());
    let apart =
        refined(&saddle).iter().zip(refined(&moved)).map(|(a, b)| (way(a) - b).norm()).fold(0.0, f64::max);
    println!("{apart:e}");
    assert!(apart < 1e-10, "{apart:e}");
}
