//! Points held by places and directors of a shell: where they stand, derivatives, momentum with couples, rigid motions, the bound of frequencies.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{forces, moved};
use contact::{Glue, Glued, Hold, Nearest};
use nalgebra::Rotation3;
use sph_core::Vec3;

/// A warped cell and a triangle beside it: their corners.
const CORNERS: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [1.0, 0.1, 0.1], [1.1, 1.0, 0.0], [0.0, 0.9, 0.2], [2.0, 0.3, 0.3]];
/// Directors at them before they are made unit vectors: square to neither face.
const DIRECTORS: [[f64; 3]; 5] =
    [[0.1, -0.1, 1.0], [-0.2, 0.0, 1.0], [0.0, 0.3, 1.0], [0.1, 0.1, 1.0], [-0.3, 0.2, 1.0]];
/// Above and below, on the surface, beyond a rim and beyond a corner, each with its cell.
const POINTS: [([f64; 3], &[usize]); 6] = [
    ([0.4, 0.5, 0.3], &[0, 1, 2, 3]),
    ([0.5, 0.4, -0.4], &[0, 1, 2, 3]),
    ([-0.1, 0.5, 0.2], &[0, 1, 2, 3]),
    ([0.5, -0.2, 0.1], &[0, 1, 2, 3]),
    ([1.4, 0.4, 0.5], &[1, 4, 2]),
    ([2.1, 0.2, -0.2], &[1, 4, 2]),
];

/// Corners, directors as places of unit length behind them, then the points.
fn sample() -> (Glue, Vec<[f64; 3]>) {
    let director = |d: [f64; 3]| Vec3::from(d).normalize();
    let mut places: Vec<[f64; 3]> = CORNERS.to_vec();
    places.extend(DIRECTORS.map(|d| <[f64; 3]>::from(director(d))));
    let mut glued = Vec::new();
    for (number, (point, face)) in POINTS.into_iter().enumerate() {
        let point = Vec3::from(point);
        let corners: Vec<Vec3> = face.iter().map(|&a| CORNERS[a].into()).collect();
        let directors: Vec<Vec3> = face.iter().map(|&a| director(DIRECTORS[a])).collect();
        let nearest = Nearest::on(&point, &corners).unwrap();
        let (weights, height) = nearest.by_directors(&point, &corners, &directors).unwrap();
        let stands: Vec3 = (0..face.len()).map(|i| (corners[i] + directors[i] * height) * weights[i]).sum();
        assert!((stands - point).norm() < 1e-14 && (weights.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let nodes = face.iter().copied().chain(face.iter().map(|a| CORNERS.len() + a)).collect();
        let numbers = weights.iter().copied().chain(weights.iter().map(|w| w * height)).collect();
        let stiffness = 1.0 + number as f64;
        glued.push(Glued { point: places.len(), nodes, hold: Hold::Places(numbers), stiffness });
        places.push(point.into());
    }
    (Glue::new(glued, &places), places)
}

fn is_director(place: usize) -> bool {
    (CORNERS.len()..2 * CORNERS.len()).contains(&place)
}

/// A rigid motion turns and moves places, and turns directors: 1e-14 of the places, rounding.
#[test]
fn rigid_motions_cost_nothing() {
    let (glue, places) = sample();
    assert!(forces(&glue, &places).1.iter().flatten().all(|f| *f == 0.0));
    let (turn, way) = (Rotation3::from_euler_angles(0.7, -1.9, 2.4), Vec3::new(3.0, -2.0, 1.0));
    let of = |(a, &x): (usize, &[f64; 3])| -> [f64; 3] {
        let way = if is_director(a) { Vec3::zeros() } else { way };
        (turn * Vec3::from(x) + way).into()
    };
    let turned: Vec<[f64; 3]> = places.iter().enumerate().map(of).collect();
    let (energy, forces) = forces(&glue, &turned);
    assert!(energy < 1e-28 && forces.iter().flatten().all(|f| f.abs() < 1e-13), "{energy:e}");
}

#[test]
fn forces_and_couples_have_neither_a_sum_nor_a_moment() {
    let (glue, rest) = sample();
    let places = moved(&rest, 0.3);
    let (_, forces) = forces(&glue, &places);
    let (mut sum, mut moment, mut size) = (Vec3::zeros(), Vec3::zeros(), 0.0);
    for (a, (x, f)) in places.iter().zip(&forces).enumerate() {
        let (x, f) = (Vec3::from(*x), Vec3::from(*f));
        // A force on a director is none on the shell, its moment with the director a couple.
        if !is_director(a) {
            sum += f;
        }
        (moment, size) = (moment + x.cross(&f), size + f.norm());
    }
    assert!(size > 1.0 && sum.norm() < 1e-14 * size && moment.norm() < 1e-14 * size, "{sum} {moment}");
}

/// The energy is of second degree: central differences are exact but for rounding over a step of a hundredth, 1e-13.
#[test]
fn forces_and_blocks_are_derivatives() {
    let (glue, rest) = sample();
    let (places, h) = (moved(&rest, 0.3), 1e-2);
    let (_, home) = forces(&glue, &places);
    let mut blocks = vec![[[0.0; 3]; 3]; glue.pairs().len()];
    glue.stressed(&places, &rest, &mut blocks);
    let mut others = blocks.clone();
    glue.stiffness(&places, &mut others);
    assert_eq!(blocks, others);
    for (b, j) in (0..3 * places.len()).map(|at| (at / 3, at % 3)) {
        let shifted = |by: f64| {
            let mut there = places.clone();
            there[b][j] += by;
            forces(&glue, &there)
        };
        let ((low, before), (high, after)) = (shifted(-h), shifted(h));
        assert!(((high - low) / (2.0 * h) + home[b][j]).abs() < 1e-11);
        let mut motion = vec![[0.0; 3]; places.len()];
        motion[b][j] = 1.0;
        let mut resisting = motion.clone();
        glue.resist(&places, &motion, &mut resisting);
        for (a, i) in (0..3 * places.len()).map(|at| (at / 3, at % 3)) {
            let change = -(after[a][i] - before[a][i]) / (2.0 * h);
            let block = glue.pairs().binary_search(&[a.min(b), a.max(b)]);
            let block = block.map_or(0.0, |at| if a > b { blocks[at][j][i] } else { blocks[at][i][j] });
            assert!((change - block).abs() < 1e-11 && (change - resisting[a][i]).abs() < 1e-11);
        }
    }
}

/// Each point alone: what swings on it is `1/Σ c²/m`, and the bound of frequencies is no less than `k` over it.
#[test]
fn the_bound_holds_for_directors_with_rotary_inertias() {
    let (glue, places) = sample();
    let masses: Vec<f64> = (0..places.len()).map(|a| if is_director(a) { 0.02 } else { 1.5 }).collect();
    for (own, mass) in glue.glued().iter().zip(glue.swinging(&places, &masses)) {
        let Hold::Places(numbers) = &own.hold else { panic!("held by places") };
        let parts = own.nodes.iter().zip(numbers).map(|(&a, c)| c * c / masses[a]);
        let exact = 1.0 / (1.0 / masses[own.point] + parts.sum::<f64>());
        let alone = Glue::new(vec![own.clone()], &places);
        let bound = alone.fastest(&places, &masses);
        assert!((mass / exact - 1.0).abs() < 1e-14);
        assert!(bound >= own.stiffness / exact && bound < 20.0 * own.stiffness / exact, "{bound}");
    }
}
