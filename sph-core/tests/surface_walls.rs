//! Rows of wall particles behind triangulated surfaces: distances, density, no holes.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

use sph_core::*;

const SPACING: f64 = 0.1;

/// Least distance between two points.
fn nearest_pair(points: &[Vec3]) -> f64 {
    let list = CellList::new(points, SPACING);
    points.iter().map(|x| list.nearest(x, 2)).fold(f64::INFINITY, f64::min)
}

/// A box of triangles.
fn crate_of(lengths: [f64; 3]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let corner =
        |i: usize| Vec3::from([0, 1, 2].map(|axis| if i >> axis & 1 == 1 { lengths[axis] } else { 0.0 }));
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [c, d, a]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

/// A ball of triangles, each face of a cube divided so many times along its edges.
fn ball(divisions: u32, radius: f64) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let first = vertices.len() as u32;
            for i in 0..=divisions {
                for j in 0..=divisions {
                    let part = |k: u32| 2.0 * f64::from(k) / f64::from(divisions) - 1.0;
                    let mut x = Vec3::zeros();
                    (x[axis], x[(axis + 1) % 3], x[(axis + 2) % 3]) = (sign, part(i), part(j));
                    vertices.push(x.normalize() * radius);
                }
            }
            for (i, j) in (0..divisions).flat_map(|i| (0..divisions).map(move |j| (i, j))) {
                let at = |i: u32, j: u32| first + i * (divisions + 1) + j;
                triangles.extend([
                    [at(i, j), at(i + 1, j), at(i + 1, j + 1)],
                    [at(i, j), at(i, j + 1), at(i + 1, j + 1)],
                ]);
            }
        }
    }
    (vertices, triangles)
}

/// What every wall behind a surface obeys; its particles over area by spacing squared of each row, which `areas`
/// tell.
fn checked_surface(
    (vertices, triangles): &(Vec<Vec3>, Vec<[u32; 3]>),
    inside: Vec3,
    height: impl Fn(&Vec3) -> f64,
    areas: [f64; 3],
) -> Vec<Vec3> {
    let walls = surface_rows(vertices, triangles, &inside, SPACING, 3).unwrap();
    assert!(nearest_pair(&walls) >= 0.7 * SPACING - 1e-9, "{}", nearest_pair(&walls) / SPACING);
    let mut counts = [0.0; 3];
    for x in &walls {
        let row = (height(x) / SPACING - 0.5).round();
        assert!((height(x) / SPACING - 0.5 - row).abs() < 0.06, "{x:?}: {}", height(x) / SPACING);
        counts[row as usize] += 1.0;
    }
    for (count, area) in counts.iter().zip(areas) {
        let density = count * SPACING * SPACING / area;
        // One particle for each square of the spacing: measured 1.00 to 1.06 round boxes and outside balls. Within
        // balls of three to six spacings, rows of some hundred particles, 0.94 to 1.16.
        assert!((0.85..1.25).contains(&density), "{density}");
    }
    let marks = surface_first_row(vertices, triangles, &inside, SPACING).unwrap();
    assert_eq!(leaks(&marks, &walls, 3, SPACING), 0);
    walls
}

/// Surface at a distance outside a box: faces, quarter cylinders, a ball.
fn round_box([a, b, c]: [f64; 3], d: f64) -> f64 {
    use std::f64::consts::PI;
    2.0 * (a * b + b * c + c * a) + 2.0 * PI * d * (a + b + c) + 4.0 * PI * d * d
}

#[test]
fn a_box_of_triangles_is_closed_outside_and_inside() {
    let lengths = [1.0, 0.8, 1.2];
    let surface = crate_of(lengths);
    let rows = [0.05, 0.15, 0.25];
    // Outside: the distance from the box.
    let outside = |x: &Vec3| {
        let over = [0, 1, 2].map(|axis| (x[axis] - lengths[axis]).max(-x[axis]).max(0.0));
        Vec3::from(over).norm()
    };
    checked_surface(&surface, Vec3::new(0.3, 0.4, 0.5), outside, rows.map(|d| round_box(lengths, d)));
    let inside =
        |x: &Vec3| (0..3).map(|axis| x[axis].min(lengths[axis] - x[axis])).fold(f64::INFINITY, f64::min);
    let shrunk = |d: f64| {
        let [a, b, c] = lengths.map(|length| length - 2.0 * d);
        2.0 * (a * b + b * c + c * a)
    };
    checked_surface(&surface, Vec3::new(0.3, 0.4, 5.0), inside, rows.map(shrunk));
}

#[test]
fn the_row_behind_a_face_has_no_hole() {
    let lengths = [1.0, 0.8, 1.2];
    let (vertices, triangles) = crate_of(lengths);
    let walls = surface_rows(&vertices, &triangles, &Vec3::repeat(0.5), SPACING, 1).unwrap();
    let list = CellList::new(&walls, SPACING);
    let mut widest = 0.0_f64;
    for (i, j) in (0..=200).flat_map(|i| (0..=200).map(move |j| (f64::from(i), f64::from(j)))) {
        let x = Vec3::new(i / 200.0 * 1.2 - 0.1, j / 200.0 - 0.1, -0.05);
        // Beyond the edge the row is round.
        let foot = Vec3::new(x.x.clamp(0.0, 1.0), x.y.clamp(0.0, 0.8), 0.0);
        widest = widest.max(list.nearest(&(foot + (x - foot).normalize() * 0.05), 1));
    }
    // Measured 0.75; a square lattice leaves 0.71.
    assert!(widest < 0.85 * SPACING, "{}", widest / SPACING);
}

#[test]
fn a_ball_coarse_or_fine_is_closed() {
    use std::f64::consts::PI;
    const RADIUS: f64 = 0.6;
    for divisions in [3, 12] {
        let surface = ball(divisions, RADIUS);
        let (vertices, triangles) = &surface;
        let corners = |cell: &[u32; 3]| cell.map(|corner| vertices[corner as usize]);
        let area = |[a, b, c]: [Vec3; 3]| 0.5 * (b - a).cross(&(c - a)).norm();
        let whole: f64 = triangles.iter().map(|cell| area(corners(cell))).sum();
        let radius = (whole / (4.0 * PI)).sqrt();
        let areas = |sign: f64| [0.05, 0.15, 0.25].map(|d| 4.0 * PI * (radius + sign * d).powi(2));
        // Triangles of a cube divided by three lie far within the ball, by twelve 0.005.
        let around =
            |x: &Vec3| if divisions == 3 { flat_height(&surface, x) } else { (x.norm() - RADIUS).abs() };
        checked_surface(&surface, Vec3::new(0.1, 0.2, 0.1), around, areas(1.0));
        checked_surface(&surface, Vec3::new(2.0, 0.2, 0.1), around, areas(-1.0));
    }
}

/// Distance from the nearest triangle, by sampling.
fn flat_height((vertices, triangles): &(Vec<Vec3>, Vec<[u32; 3]>), x: &Vec3) -> f64 {
    let plane = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|corner| vertices[corner as usize]);
        let mut nearest = f64::INFINITY;
        for [i, j] in (0..=20).flat_map(|i| (0..=20 - i).map(move |j| [i, j].map(|k| f64::from(k) / 20.0))) {
            nearest = nearest.min((a + (b - a) * i + (c - a) * j - x).norm());
        }
        nearest
    };
    triangles.iter().map(plane).fold(f64::INFINITY, f64::min)
}

#[test]
fn an_open_dish_has_its_wall_on_one_side_and_ends_at_its_border() {
    let (vertices, triangles) = ball(20, 1.0);
    let lower = |corners: &&[u32; 3]| corners.iter().all(|&corner| vertices[corner as usize].z <= 1e-12);
    let dish: Vec<[u32; 3]> = triangles.iter().filter(lower).copied().collect();
    for (inside, sign) in [(Vec3::new(0.0, 0.0, 0.5), 1.0), (Vec3::new(0.0, 0.0, -1.5), -1.0)] {
        let walls = surface_rows(&vertices, &dish, &inside, SPACING, 2).unwrap();
        assert!(walls.iter().all(|x| sign * (x.norm() - 1.0) > 0.045 && x.z < 0.01));
        let marks = surface_first_row(&vertices, &dish, &inside, SPACING).unwrap();
        assert_eq!(leaks(&marks, &walls, 3, SPACING), 0);
    }
    // The order of corners says nothing: turn every other triangle round.
    let turned: Vec<[u32; 3]> = dish
        .iter()
        .enumerate()
        .map(|(i, &[a, b, c])| if i.is_multiple_of(2) { [a, b, c] } else { [b, a, c] })
        .collect();
    let walls = surface_rows(&vertices, &turned, &Vec3::new(0.0, 0.0, 0.5), SPACING, 2).unwrap();
    assert!(walls.iter().all(|x| x.norm() > 1.045));
}

#[test]
fn a_sharp_wedge_of_fluid_is_closed_at_its_edge() {
    // A prism over a triangle of 15° between two long sides.
    let (far, half) = (1.5, 1.5 * libm::tan(7.5_f64.to_radians()));
    let ends = [0.0, 1.0].map(|z| [[0.0, 0.0, z], [far, half, z], [far, -half, z]].map(Vec3::from));
    let vertices = ends.concat();
    let triangles =
        [[0, 1, 2], [3, 4, 5], [0, 1, 4], [4, 3, 0], [1, 2, 5], [5, 4, 1], [2, 0, 3], [3, 5, 2]].to_vec();
    let inside = Vec3::new(1.2, 0.0, 0.5);
    let walls = surface_rows(&vertices, &triangles, &inside, SPACING, 3).unwrap();
    let marks = surface_first_row(&vertices, &triangles, &inside, SPACING).unwrap();
    assert_eq!(leaks(&marks, &walls, 3, SPACING), 0);
    // Nothing stands in the fluid, and three rows stand before the edge.
    let in_fluid =
        |x: &&Vec3| x.x > 0.0 && x.x < far && x.y.abs() < half / far * x.x && (0.0..1.0).contains(&x.z);
    assert_eq!(walls.iter().filter(in_fluid).count(), 0);
    let before = |row: f64| {
        walls
            .iter()
            .filter(|x| x.y.abs() < 0.05 && (0.2..0.8).contains(&x.z) && (x.x + row).abs() < 0.03)
            .count()
    };
    for row in [0.05, 0.15, 0.25] {
        assert!(before(row) >= 4, "{row}: {}", before(row));
    }
}

#[test]
fn a_face_without_a_wall_behind_it_is_named() {
    let (vertices, triangles) = crate_of([1.0, 1.0, 1.0]);
    let marks = surface_first_row(&vertices, &triangles, &Vec3::repeat(0.5), SPACING).unwrap();
    let without = surface_rows(&vertices, &triangles[2..], &Vec3::repeat(0.5), SPACING, 3).unwrap();
    assert_eq!(leaks(&marks, &without, 3, SPACING), 1);
    assert!(surface_rows(&vertices, &triangles[..2], &Vec3::repeat(0.5), SPACING, 3).unwrap().len() > 250);
}

fn refused<T: std::fmt::Debug>(result: Result<T, SpaceError>, wanted: &str) {
    let message = result.unwrap_err().to_string();
    assert!(message.contains(wanted), "{message}");
}

#[test]
fn wrong_surfaces_are_refused() {
    let (zero, one) = (Vec3::zeros(), Vec3::repeat(1.0));
    let surface = |triangles: &[[u32; 3]], inside: Vec3| {
        let vertices = [zero, Vec3::x(), Vec3::y(), Vec3::x() * 2.0, Vec3::z(), -Vec3::y()];
        surface_rows(&vertices, triangles, &inside, 0.1, 3)
    };
    refused(surface(&[], one), "triangles of a wall: 0 found");
    refused(surface(&[[0, 1, 9]], one), "corner 9");
    refused(surface(&[[0, 1, 3]], one), "cell 0: area 0e0");
    refused(surface(&[[0, 1, 2], [0, 1, 4], [0, 1, 5]], one), "edge 0–1 belongs to 3 cells");
    refused(surface(&[[0, 1, 2]], Vec3::new(0.2, 0.2, 0.0)), "height of the inside point");
    refused(surface(&[[0, 1, 2]], Vec3::new(5.0, 5.0, 0.0)), "height of the inside point");
    refused(surface(&[[0, 1, 2]], Vec3::new(f64::NAN, 5.0, 0.0)), "coordinate of the inside point");
    // A strip of three quadrangles joined with a half turn.
    let strip = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 5], [4, 5, 1], [5, 1, 0]];
    let turn = |i: usize| {
        let (angle, side) = ((i / 2) as f64 * 2.0944, if i.is_multiple_of(2) { 1.0 } else { -1.0 });
        let (about, arm) = (0.5 * angle, 0.3 * side);
        let radius = 1.0 + arm * libm::cos(about);
        Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), arm * libm::sin(about))
    };
    let vertices: Vec<Vec3> = (0..6).map(turn).collect();
    refused(surface_rows(&vertices, &strip, &Vec3::z(), 0.1, 3), "one side only");
}
