//! Rows of wall particles: where they stand, how near to each other, that nothing is left open.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

use approx::assert_relative_eq;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use sph_core::*;

const SPACING: f64 = 0.1;

/// Points in an order that does not depend on how they were made.
fn sorted(mut points: Vec<Vec3>) -> Vec<Vec3> {
    let key = |x: &Vec3| [x.x, x.y, x.z].map(|value| (value / SPACING * 1e3).round() as i64);
    points.sort_by_key(key);
    points
}

fn assert_same(a: Vec<Vec3>, b: Vec<Vec3>) {
    assert_eq!(a.len(), b.len());
    for (a, b) in sorted(a).iter().zip(&sorted(b)) {
        assert!((a - b).norm() < 1e-6 * SPACING, "{a:?} {b:?}");
    }
}

/// Least distance between two points.
fn nearest_pair(points: &[Vec3]) -> f64 {
    let list = CellList::new(points, SPACING);
    points.iter().map(|x| list.nearest(x, 2)).fold(f64::INFINITY, f64::min)
}

/// The fluid that fills a box.
fn fluid(dimensions: usize, lengths: [f64; 3], origin: Vec3) -> Vec<Vec3> {
    let (spacing, nodes) = ([SPACING; 3], NodePlaces::Centres);
    let (grading, disorder, seed) = ([1.0; 3], 0.0, 0);
    let lattice = BlockLattice { dimensions, lengths, spacing, origin, nodes, grading, disorder, seed };
    lattice.block().unwrap().positions
}

#[test]
fn fluid_in_a_closed_basin_has_the_neighbours_of_an_endless_lattice() {
    // Lattice points within 2.6 spacings: 21 in the plane, 81 in space.
    for (dimensions, neighbours) in [(2, 21), (3, 81)] {
        let (min, lengths) = (Vec3::new(-0.3, 2.0, 1.0), [0.7, 1.1, 0.5]);
        let max = min + Vec3::from(lengths);
        let water = fluid(dimensions, lengths, min);
        let walls = basin_rows(&min, &max, [false; 6], dimensions, SPACING, 3).unwrap();
        let [a, b, c] = [7, 11, if dimensions == 2 { 1 } else { 5 }];
        let whole = (a + 6) * (b + 6) * if dimensions == 2 { 1 } else { c + 6 };
        assert_eq!(walls.len(), whole - a * b * c);
        let list = CellList::new(&[water.clone(), walls].concat(), SPACING);
        let mut found = Vec::new();
        for x in &water {
            list.within(x, 2.6 * SPACING, &mut found);
            assert_eq!(found.len(), neighbours, "{x:?}");
        }
    }
}

#[test]
fn walls_end_at_open_sides() {
    let (min, max) = (Vec3::zeros(), Vec3::new(1.0, 0.5, 0.0));
    let open = [false, false, false, true, false, false];
    let tank = basin_rows(&min, &max, open, 2, SPACING, 3).unwrap();
    assert_eq!(tank.len(), 16 * 8 - 50);
    assert!(tank.iter().all(|x| x.y < 0.5 && x.z == 0.0));
    // What is inside z does not count in a plane.
    let floor = [true, true, false, true, false, false];
    let row = basin_rows(&min, &max, floor, 2, SPACING, 1).unwrap();
    assert_eq!(row.len(), 10);
    for (i, x) in row.iter().enumerate() {
        assert_relative_eq!(x.x, 0.1 * (i as f64 + 0.5), max_relative = 1e-12);
        assert_eq!(x.y, -0.05);
    }
    let trough =
        basin_rows(&min, &Vec3::new(1.0, 0.5, 0.3), [true, true, false, true, false, false], 3, SPACING, 2);
    assert_eq!(trough.unwrap().len(), 10 * (7 * 7 - 5 * 3));
}

#[test]
fn spacings_along_a_wall_divide_its_length_and_across_it_are_as_asked() {
    let walls = basin_rows(&Vec3::zeros(), &Vec3::new(1.04, 0.28, 0.0), [false; 6], 2, SPACING, 2).unwrap();
    let left: Vec<f64> = walls.iter().map(|x| x.x).filter(|&x| x < 0.0).collect();
    assert!(left.iter().all(|x| [-0.15, -0.05].iter().any(|row| (x - row).abs() < 1e-12)));
    let floor: Vec<&Vec3> =
        walls.iter().filter(|x| (x.y + 0.05).abs() < 1e-12 && x.x > 0.0 && x.x < 1.04).collect();
    assert_eq!(floor.len(), 10);
    assert_relative_eq!(floor[1].x - floor[0].x, 0.104, max_relative = 1e-12);
}

#[test]
fn an_obstacle_is_a_lattice_hollow_behind_its_rows() {
    let origin = Vec3::new(1.0, -1.0, 0.5);
    let block = block_rows([0.8, 1.2, 0.9], &origin, 3, SPACING, 2).unwrap();
    assert_eq!(block.len(), 8 * 12 * 9 - 4 * 8 * 5);
    assert_relative_eq!(nearest_pair(&block), SPACING, max_relative = 1e-9);
    let full = block_rows([0.8, 1.2, 0.9], &origin, 3, SPACING, 5).unwrap();
    assert_same(full, fluid(3, [0.8, 1.2, 0.9], origin));
    // The outermost rows are half a spacing inside, whatever the lengths.
    let odd = block_rows([0.83, 0.12, 0.1], &origin, 2, SPACING, 3).unwrap();
    assert_eq!(odd.len(), 8);
    assert_relative_eq!(odd[0].x, 1.05, max_relative = 1e-12);
    assert_relative_eq!(odd[7].x, 1.78, max_relative = 1e-12);
    assert_relative_eq!(odd[0].y, -0.94, max_relative = 1e-12);
}

const BOX: [[f64; 2]; 5] = [[0.2, 0.1], [1.2, 0.1], [1.2, 0.7], [0.2, 0.7], [0.2, 0.1]];

#[test]
fn a_closed_rectangle_is_a_basin_outside_and_an_obstacle_inside() {
    let (min, max) = (Vec3::new(0.2, 0.1, 0.0), Vec3::new(1.2, 0.7, 0.0));
    let basin = basin_rows(&min, &max, [false; 6], 2, SPACING, 3).unwrap();
    let block = block_rows([1.0, 0.6, 0.0], &min, 2, SPACING, 3).unwrap();
    let backwards: Vec<[f64; 2]> = BOX.iter().rev().copied().collect();
    assert_same(polyline_rows(&BOX, LineSide::Right, SPACING, 3).unwrap(), basin.clone());
    assert_same(polyline_rows(&backwards, LineSide::Left, SPACING, 3).unwrap(), basin);
    assert_same(polyline_rows(&BOX, LineSide::Left, SPACING, 3).unwrap(), block);
}

#[test]
fn an_open_line_is_flush_at_its_ends() {
    let rows = polyline_rows(&[[0.0, 0.0], [0.46, 0.0], [1.0, 0.0]], LineSide::Left, SPACING, 2).unwrap();
    let lattice = (0..2).flat_map(|j| (0..10).map(move |i| Vec3::new(i as f64 + 0.5, j as f64 + 0.5, 0.0)));
    assert_same(rows, lattice.map(|x| x * SPACING).collect());
    let short = polyline_rows(&[[0.0, 0.0], [0.0, 0.03]], LineSide::Right, SPACING, 1).unwrap();
    assert_same(short, vec![Vec3::new(0.05, 0.015, 0.0)]);
}

/// Distance of a point from a polyline, and whether it is on the left of the nearest segment.
fn distance(points: &[[f64; 2]], x: &Vec3) -> f64 {
    let to = |pair: &[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]].map(|[x, y]| Vec3::new(x, y, 0.0));
        let part = ((b - a).dot(&(x - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (a.lerp(&b, part) - x).norm()
    };
    points.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

/// What every wall along a polyline obeys, and its leaks.
fn checked(points: &[[f64; 2]], side: LineSide) -> (Vec<Vec3>, usize) {
    let walls = polyline_rows(points, side, SPACING, 3).unwrap();
    assert!(nearest_pair(&walls) >= 0.5 * SPACING, "{points:?}: {}", nearest_pair(&walls));
    for x in &walls {
        assert!(distance(points, x) >= SPACING * (0.5 - 1e-6), "{points:?}: {x:?}");
    }
    let marks = polyline_first_row(points, side, SPACING).unwrap();
    let count = leaks(&marks, &walls, 2, SPACING);
    (walls, count)
}

#[test]
fn corners_of_any_angle_are_closed_outside() {
    for degrees in [5.0_f64, 20.0, 30.0, 31.0, 45.0, 60.0, 89.0, 90.0, 120.0, 150.0, 175.0, 179.9] {
        // The fluid is within the angle, which opens to the right; the wall lies to the left of who comes from above.
        let half = 0.5 * degrees.to_radians();
        let wedge = [[libm::cos(half), libm::sin(half)], [0.0, 0.0], [libm::cos(half), -libm::sin(half)]];
        let (outside, open) = checked(&wedge, LineSide::Right);
        assert_eq!(open, 0, "{degrees}°");
        // A ray from within, through the corner and half a spacing to either side, meets the wall: the tip is closed.
        let tip = outside.iter().filter(|x| x.x < 0.0 && x.y.abs() < 0.6 * SPACING).count();
        assert!(tip > 0, "{degrees}°");
        let (_, open) = checked(&wedge, LineSide::Left);
        assert_eq!(open > 0, degrees < 50.0, "{degrees}°: a blade without particles at its edge is named");
    }
}

#[test]
fn a_circle_of_few_or_many_points_has_rows_of_its_length() {
    for count in [24, 100, 1000] {
        let at = |i: usize| {
            let angle = (i % count) as f64 / count as f64 * std::f64::consts::TAU;
            [libm::cos(angle), libm::sin(angle)]
        };
        let circle: Vec<[f64; 2]> = (0..=count).map(at).collect();
        for (side, sign) in [(LineSide::Right, 1.0), (LineSide::Left, -1.0)] {
            let (walls, open) = checked(&circle, side);
            assert_eq!(open, 0);
            let rows = [0.05, 0.15, 0.25].map(|d| 1.0 + sign * d);
            let wanted: f64 = rows.iter().map(|radius| std::f64::consts::TAU * radius / SPACING).sum();
            // Each of three rows is rounded to whole particles; 24 chords are 0.3 % shorter than the arc.
            assert!((walls.len() as f64 - wanted).abs() < 2.5, "{count}: {} {wanted}", walls.len());
            // The sagitta of 24 chords is 0.0086.
            let off = |x: &Vec3| rows.iter().map(|r| (x.norm() - r).abs()).fold(f64::INFINITY, f64::min);
            assert!(walls.iter().all(|x| off(x) < 0.012), "{count}");
        }
    }
}

#[test]
fn a_plate_thinner_than_a_spacing_is_named() {
    let plate = |thickness: f64| [[0.0, 0.0], [1.0, 0.0], [1.0, thickness], [0.0, thickness], [0.0, 0.0]];
    assert_eq!(checked(&plate(0.11), LineSide::Left).1, 0);
    assert_eq!(checked(&plate(0.08), LineSide::Left).1, 1);
}

#[test]
fn tight_bends_into_the_wall_are_trimmed_without_a_gap() {
    // Fluid outside a bump of radius 0.06 made of 40 short segments, then a straight wall on both sides.
    let mut points = vec![[-1.0, 0.0], [-0.06, 0.0]];
    points.extend((1..40).map(|i| {
        let angle = std::f64::consts::PI * (1.0 - f64::from(i) / 40.0);
        [0.06 * libm::cos(angle), 0.06 * libm::sin(angle)]
    }));
    points.extend([[0.06, 0.0], [1.0, 0.0]]);
    // The wall below: the bump stands into the fluid. Above: the fluid fills a groove.
    for side in [LineSide::Right, LineSide::Left] {
        let (walls, open) = checked(&points, side);
        // Along 2 with a bump there are 20 particles a row, and one to seven more round the groove.
        assert!((57..=80).contains(&walls.len()), "{}", walls.len());
        assert_eq!(open, 0, "{side:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(1), failure_persistence: None, cases: 200, ..ProptestConfig::default() })]

    /// Basins round the fluid in the shape of a star: no corner of the wall is sharp, any corner of the fluid may be.
    #[test]
    fn round_any_star_of_fluid_the_wall_is_closed(radii in prop::collection::vec(0.5..1.6f64, 5..12)) {
        let count = radii.len();
        let at = |i: usize| {
            let angle = (i % count) as f64 / count as f64 * std::f64::consts::TAU;
            [radii[i % count] * libm::cos(angle), radii[i % count] * libm::sin(angle)]
        };
        let star: Vec<[f64; 2]> = (0..=count).map(at).collect();
        let sharpest = (0..count).map(|i| {
            let (a, b, c) = (at((i + count - 1) % count), at(i), at(i + 1));
            let (u, v) = ([a[0] - b[0], a[1] - b[1]], [c[0] - b[0], c[1] - b[1]]);
            let angle = libm::atan2(v[0] * u[1] - v[1] * u[0], v[0] * u[0] + v[1] * u[1]);
            if angle < 0.0 { -angle } else { std::f64::consts::TAU - angle }
        }).fold(f64::INFINITY, f64::min);
        let (walls, open) = checked(&star, LineSide::Right);
        if sharpest > 1.0 {
            prop_assert_eq!(open, 0);
        }
        prop_assert!(walls.len() > 100);
    }
}

fn refused<T: std::fmt::Debug>(result: Result<T, SpaceError>, wanted: &str) {
    let message = result.unwrap_err().to_string();
    assert!(message.contains(wanted), "{message}");
}

#[test]
fn wrong_walls_are_refused() {
    let (zero, one) = (Vec3::zeros(), Vec3::repeat(1.0));
    let closed = [false; 6];
    refused(basin_rows(&zero, &one, closed, 2, 0.0, 3), "spacing = 0");
    refused(basin_rows(&zero, &one, closed, 2, f64::NAN, 3), "spacing");
    refused(basin_rows(&zero, &one, closed, 4, 0.1, 3), "dimensions = 4");
    refused(basin_rows(&zero, &one, closed, 2, 0.1, 0), "rows of walls = 0");
    refused(basin_rows(&zero, &one, closed, 2, 0.1, 21), "[1, 20]");
    refused(basin_rows(&one, &zero, closed, 2, 0.1, 3), "length of a wall = -1");
    refused(basin_rows(&zero, &one, closed, 3, 1e-5, 3), "number of wall particles");
    refused(basin_rows(&zero, &one, closed, 3, 1e-300, 3), "number of wall particles");
    refused(basin_rows(&zero, &one, [true; 6], 3, 0.1, 3), "closed sides of a basin = 0");
    let floor = [true, true, true, true, false, false];
    refused(basin_rows(&zero, &one, floor, 2, 0.1, 3), "closed sides of a basin = 0");
    refused(block_rows([1.0, 0.05, 1.0], &zero, 2, 0.1, 3), "over the spacing = 0.5");
    refused(block_rows([1.0, f64::INFINITY, 1.0], &zero, 2, 0.1, 3), "length of a wall = inf");
    let line = |points: &[[f64; 2]]| polyline_rows(points, LineSide::Left, 0.1, 3);
    refused(line(&[[0.0, 0.0]]), "points of a polyline: 1 found");
    refused(line(&[[0.0, 0.0], [1.0, f64::NAN]]), "particle 1: a coordinate of a polyline is NaN");
    refused(line(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]), "particles 1 and 2 coincide");
    refused(line(&[[0.0, 0.0], [0.0, 0.0]]), "particles 0 and 1 coincide");
    refused(line(&[[0.0, 0.0], [1e9, 0.0]]), "number of wall particles");
}
