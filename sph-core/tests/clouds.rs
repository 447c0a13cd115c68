//! Clouds: building from cells, disorder, motion, and the errors a wrong input gets.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

mod common;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use common::flat_clouds;
use sph_core::*;

fn square(n: usize) -> Cloud {
    lattice(&Plate { lengths: [2.0, 1.0] }, [n, n], EndWeights::Trapezoid).unwrap()
}

#[test]
fn the_cells_of_a_plate_give_the_lattice_back() {
    let plate = square(6);
    let cloud = Cloud::from_cells(plate.positions.clone(), None, plate.cells.clone()).unwrap();
    for a in 0..plate.len() {
        assert_relative_eq!(cloud.areas[a], plate.areas[a], epsilon = 1e-14);
        assert_relative_eq!(cloud.edge_lengths[a], plate.edge_lengths[a], epsilon = 1e-14);
        assert_abs_diff_eq!(cloud.edge_normals[a], plate.edge_normals[a], epsilon = 1e-14);
        assert_relative_eq!(cloud.frames[a].t1, plate.frames[a].t1, epsilon = 1e-14);
        assert_relative_eq!(cloud.frames[a].n, plate.frames[a].n, epsilon = 1e-14);
    }
    assert_relative_eq!(cloud.spacing(), (2.0f64 / 36.0).sqrt(), epsilon = 1e-14);
}

#[test]
fn flat_clouds_obey_the_divergence_theorem() {
    for (name, cloud) in flat_clouds() {
        let area: f64 = cloud.areas.iter().sum();
        let flux: f64 = cloud.edge_normals.iter().zip(&cloud.positions).map(|(r, x)| r.dot(x)).sum();
        assert_relative_eq!(area, 3.0, epsilon = 1e-12);
        assert_relative_eq!(flux, 2.0 * area, epsilon = 1e-12);
        assert_abs_diff_eq!(cloud.edge_normals.iter().sum::<Vec3>(), Vec3::zeros(), epsilon = 1e-13);
        assert_relative_eq!(cloud.edge_lengths.iter().sum::<f64>(), 7.0, epsilon = 1e-12);
        assert_eq!(cloud.check(), Ok(()), "{name}");
    }
}

#[test]
fn disorder_stays_on_the_surface_and_on_the_edges_and_repeats() {
    let roof = Cylinder { radius: 2.0, angles: [-0.5, 0.5], length: 1.0 };
    let regular = lattice(&roof, [9, 7], EndWeights::Trapezoid).unwrap();
    let cloud = jittered_lattice(&roof, [9, 7], 0.25, 42).unwrap();
    assert_eq!(cloud, jittered_lattice(&roof, [9, 7], 0.25, 42).unwrap());
    assert_ne!(cloud, jittered_lattice(&roof, [9, 7], 0.25, 43).unwrap());
    let sides = cloud.sides.as_ref().unwrap();
    for (a, x) in cloud.positions.iter().enumerate() {
        assert_relative_eq!(libm::hypot(x.x, x.z), 2.0, epsilon = 1e-14);
        assert_relative_eq!(cloud.frames[a].n, Vec3::new(x.x, 0.0, x.z) / 2.0, epsilon = 1e-14);
        assert!((x - regular.positions[a]).norm() < 0.25 * (0.25f64.powi(2) + (1.0f64 / 6.0).powi(2)).sqrt());
    }
    for side in [Side::U0, Side::U1, Side::V0, Side::V1] {
        for a in sides.edge(side).iter().map(|&a| a as usize) {
            let (x, y) = (cloud.positions[a], regular.positions[a]);
            match side {
                Side::U0 | Side::U1 => assert_eq!((x.x, x.z), (y.x, y.z)),
                Side::V0 | Side::V1 => assert_eq!(x.y, y.y),
            }
        }
    }
    assert_eq!(jittered_lattice(&roof, [9, 7], 0.0, 1).unwrap().positions, regular.positions);
    assert!(matches!(jittered_lattice(&roof, [9, 7], 0.5, 1), Err(SpaceError::OutOfRange { .. })));
}

#[test]
fn estimated_normals_and_flat_areas_converge_to_those_of_the_sphere() {
    let dome = Sphere { radius: 1.0, polar: [0.5, 1.2], azimuth: [0.0, 0.8] };
    let error = |n: usize| {
        let exact = lattice(&dome, [n, n], EndWeights::Trapezoid).unwrap();
        let cloud = Cloud::from_cells(exact.positions.clone(), None, exact.cells.clone()).unwrap();
        let inside = |a: &usize| cloud.edge_lengths[*a] == 0.0;
        let tilt = (0..n * n)
            .filter(inside)
            .map(|a| (cloud.frames[a].n - exact.frames[a].n).norm())
            .fold(0.0, f64::max);
        let area = 0.8 * (libm::cos(0.5f64) - libm::cos(1.2f64));
        (tilt, (cloud.areas.iter().sum::<f64>() / area - 1.0).abs())
    };
    let (coarse, fine) = (error(9), error(17));
    assert!(fine.0 < coarse.0 / 3.0 && fine.1 < coarse.1 / 3.5, "{coarse:?} {fine:?}"); // second order
}

#[test]
fn wrong_clouds_are_refused_with_the_place() {
    let plate = square(4);
    let rebuilt = |change: &dyn Fn(&mut Vec<Vec3>, &mut Vec<Cell>)| {
        let (mut positions, mut cells) = (plate.positions.clone(), plate.cells.clone());
        change(&mut positions, &mut cells);
        Cloud::from_cells(positions, None, cells).unwrap_err()
    };
    let messages = [
        rebuilt(&|x, _| x[5].y = f64::NAN),
        rebuilt(&|x, _| x[5] = x[6] + Vec3::new(1e-9, 0.0, 0.0)),
        rebuilt(&|x, _| x.push(Vec3::new(9.0, 9.0, 0.0))),
        rebuilt(&|x, c| {
            x.push(Vec3::new(0.3, 0.3, 1.0));
            c.push(Cell::triangle([5, 6, 16]));
        }),
        rebuilt(&|_, c| c[4] = Cell::quadrangle([5, 6, 10, 9])),
        rebuilt(&|_, c| c[0] = Cell::quadrangle([0, 4, 5, 16])),
        rebuilt(&|_, c| c[0] = Cell::quadrangle([0, 4, 0, 1])),
    ]
    .map(|error| error.to_string());
    let expected = [
        "particle 5: position is NaN, a finite number is needed; check the input that places it",
        "particles 5 and 6 coincide",
        "particle 16 is isolated: 0 cells or neighbours, at least 1 is needed; connect or remove it",
        "edge 5–6 belongs to 3 cells, at most 2 are allowed",
        "cells 1 and 4 run the same way along edge 5–6; reverse the corner order of one of them",
        "cell 0: corner 16 is repeated or not below 16; correct the list of cells",
        "cell 0: corner 0 is repeated",
    ];
    for (message, expected) in messages.iter().zip(expected) {
        assert!(message.starts_with(expected), "{message}");
    }
}

#[test]
fn cells_without_area_are_refused() {
    let line = (0..3).map(|i| Vec3::new(f64::from(i), 0.0, 0.0)).collect();
    let error = Cloud::from_cells(line, None, vec![Cell::triangle([0, 1, 2])]).unwrap_err();
    assert!(matches!(error, SpaceError::DegenerateCell { cell: 0, .. }), "{error}");
}

#[test]
fn the_lips_of_a_slit_may_touch_but_kernels_refuse_to_mix_them() {
    // A full ring cut open at φ = 0: first and last row coincide.
    let ring = Parametric {
        position: |u: f64, v: f64| Vec3::new(u * libm::cos(v), u * libm::sin(v), 0.0),
        range: [[1.0, 2.0], [0.0, std::f64::consts::TAU]],
    };
    let mut cloud = lattice(&ring, [4, 25], EndWeights::Trapezoid).unwrap();
    assert!(cell_operator(&cloud).is_ok());
    assert!(matches!(
        kernel_operator(&cloud, &CubicSpline, 1.4),
        Err(SpaceError::Coincident { first: 0, second: 24, .. })
    ));
    assert!(nodal_operator(&cloud, &CubicSpline, 1, 1.2).is_err());
    // The same places inside the sheet are an error.
    cloud.edge_lengths[0] = 0.0;
    assert!(matches!(cloud.check(), Err(SpaceError::Coincident { first: 0, second: 24, .. })));
}

/// Particles one apart along a line, without cells.
fn line(n: usize) -> Cloud {
    Cloud {
        positions: (0..n).map(|i| Vec3::new(i as f64, 0.0, 0.0)).collect(),
        frames: vec![Frame::from_normal(Vec3::z()); n],
        areas: vec![1.0; n],
        edge_normals: vec![Vec3::zeros(); n],
        edge_lengths: vec![0.0; n],
        cells: Vec::new(),
        joined: Vec::new(),
        sides: None,
        lattice: None,
    }
}

#[test]
fn clouds_without_cells_are_checked_by_distance_and_direction() {
    let mut cloud = line(20);
    assert_eq!(cloud.check(), Ok(()));
    let gradients = nodal_operator(&cloud, &CubicSpline, 2, 1.3);
    assert!(matches!(gradients, Err(SpaceError::Undetermined { point: 0, order: 1, .. })), "{gradients:?}");
    cloud.positions[19].x += 10.0;
    assert!(matches!(cloud.check(), Err(SpaceError::Isolated { particle: 19, .. })));
    cloud.areas[3] = 0.0;
    assert!(matches!(cloud.check(), Err(SpaceError::BadNumber { particle: 3, what: "area", .. })));
    cloud.areas.pop();
    assert!(matches!(cloud.check(), Err(SpaceError::Length { found: 19, expected: 20, .. })));
}

/// A ribbon of `n` quadrangles closed to a ring, after `half_turns` of half a turn.
fn ribbon(n: usize, half_turns: usize) -> (Vec<Vec3>, Vec<Cell>) {
    let place = |i: usize, side: f64| {
        let along = std::f64::consts::TAU * i as f64 / n as f64;
        let twist = 0.5 * half_turns as f64 * along;
        let radius = 3.0 + side * libm::cos(twist);
        Vec3::new(radius * libm::cos(along), radius * libm::sin(along), side * libm::sin(twist))
    };
    let positions = (0..n).flat_map(|i| [place(i, -0.5), place(i, 0.5)]).collect();
    let cells = (0..n as u32).map(|i| {
        let (a, b) = (2 * i, 2 * i + 1);
        match (i as usize == n - 1, half_turns % 2 == 1) {
            (false, _) => Cell::quadrangle([a, b, b + 2, a + 2]),
            (true, false) => Cell::quadrangle([a, b, 1, 0]),
            (true, true) => Cell::quadrangle([a, b, 0, 1]), // the sides have changed places
        }
    });
    (positions, cells.collect())
}

#[test]
fn a_sheet_with_one_side_is_refused_and_a_twisted_one_with_two_is_not() {
    let build = |half_turns| {
        let (positions, cells) = ribbon(40, half_turns);
        Cloud::from_cells(positions, None, cells)
    };
    assert!(build(0).is_ok());
    assert!(build(2).is_ok());
    let error = build(1).unwrap_err();
    assert!(matches!(error, SpaceError::NonOrientable { .. }), "{error}");
    assert!(error.to_string().contains("cut it open there"), "{error}");
    // Reversing one cell of a sheet with two sides is an error that reversing mends.
    let (positions, mut cells) = ribbon(40, 2);
    cells[7].corners.reverse();
    let error = Cloud::from_cells(positions, None, cells).unwrap_err();
    assert!(matches!(error, SpaceError::Orientation { cell: 6, other: 7, .. }), "{error}");
}

#[test]
fn normals_to_the_other_side_are_refused_with_particle_and_cell() {
    let plate = square(4);
    let mut normals = vec![Vec3::z(); plate.len()];
    normals[6] = Vec3::new(0.1, 0.0, -1.0);
    let error = Cloud::from_cells(plate.positions, Some(normals), plate.cells).unwrap_err();
    assert_eq!(
        error.to_string(),
        "particle 6: its normal is 174° from that of cell 1, less than 90° is needed; turn the normal round or reverse \
         the corner order of the cell"
    );
}

#[test]
fn slivers_are_refused_with_their_angle() {
    let mut plate = square(4);
    // Cell 0 = (0, 4, 5, 1): particle 5 moved towards the diagonal of its other corners and past 4 makes a sharp corner.
    plate.positions[5] = plate.positions[4] + Vec3::new(0.66, 0.03, 0.0);
    let error = Cloud::from_cells(plate.positions, None, plate.cells).unwrap_err();
    let SpaceError::Sliver { particle, degrees, bound, .. } = error else { panic!("{error}") };
    assert!(particle == 4 && degrees < 5.0 && bound == 5.0, "{particle} {degrees}");
}

#[test]
fn sheets_apart_are_pieces_of_one_cloud() {
    let plate = square(3);
    assert_eq!(plate.pieces(), [(0..9).collect::<Vec<u32>>()]);
    let mut positions = plate.positions.clone();
    positions.extend(plate.positions.iter().map(|x| x + Vec3::new(5.0, 0.0, 0.0)));
    let mut cells = plate.cells.clone();
    cells.extend(plate.cells.iter().map(|cell| Cell::quadrangle(cell.corners.map(|b| b + 9))));
    let cloud = Cloud::from_cells(positions, None, cells).unwrap();
    assert_eq!(cloud.pieces(), [(0..9).collect::<Vec<u32>>(), (9..18).collect()]);
    assert_relative_eq!(cloud.areas.iter().sum::<f64>(), 4.0, epsilon = 1e-14);
}
