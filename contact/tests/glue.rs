//! Points glued to surfaces: forces and tangent are derivatives, momentum is kept, rigid motions cost nothing, the bound of frequencies is one.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{forces, moved, number};
use contact::{Foot, Glue, Glued, Hold, Nearest};
use nalgebra::{DMatrix, Rotation3};
use sph_core::Vec3;

/// Two quadrilaterals and a triangle with five points: over them, on one, beyond a rim, over a corner; each on its face alone and on all nodes.
fn sample() -> (Glue, Vec<[f64; 3]>) {
    let mut places = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.1, 0.1],
        [1.1, 1.0, 0.0],
        [0.0, 0.9, 0.2],
        [2.0, 0.0, 0.3],
        [2.1, 1.1, 0.1],
        [3.0, 0.5, 0.4],
    ];
    let faces: [&[usize]; 3] = [&[0, 1, 2, 3], &[1, 4, 5, 2], &[4, 6, 5]];
    let points = [
        ([0.4, 0.5, 0.3], 0, 2.0),
        ([1.5, 0.5, 0.15], 1, 1.0),
        ([0.5, -0.2, -0.2], 0, 3.0),
        ([1.05, 1.05, 0.4], 1, 0.7),
        ([2.4, 0.5, 0.6], 2, 1.5),
    ];
    let mut glued = Vec::new();
    for (point, face, stiffness) in points {
        let point = Vec3::from(point);
        let corners: Vec<Vec3> = faces[face].iter().map(|&a| Vec3::from(places[a])).collect();
        let nearest = Nearest::on(&point, &corners).unwrap();
        let nodes: Vec<Vec3> = places[..7].iter().map(|&x| x.into()).collect();
        let feet = [
            (faces[face].to_vec(), nearest.on_corners(&point, &corners)),
            ((0..7).collect(), Foot::fitted(&point, &nodes, &nearest.place, &nearest.normal)),
        ];
        for (nodes, foot) in feet {
            let hold = Hold::Surface(foot.unwrap());
            glued.push(Glued { point: places.len(), nodes, hold, stiffness });
        }
        places.push(point.into());
    }
    (Glue::new(glued, &places), places)
}

#[test]
fn at_rest_and_after_rigid_motions_nothing_acts() {
    let (glue, places) = sample();
    let turn = Rotation3::from_euler_angles(0.7, -1.9, 2.4);
    let turned = places.iter().map(|&x| <[f64; 3]>::from(turn * Vec3::from(x) + Vec3::new(3.0, -2.0, 1.0)));
    assert!(forces(&glue, &places).1.iter().flatten().all(|f| *f == 0.0));
    for places in [places.clone(), turned.collect()] {
        let (energy, forces) = forces(&glue, &places);
        assert!(energy < 1e-28 && forces.iter().flatten().all(|f| f.abs() < 1e-13), "{energy:e}");
    }
}

/// Central differences over 1e-5: 2e-10 found for forces and for blocks, of numbers of the order of one.
#[test]
fn forces_and_blocks_are_derivatives() {
    let (glue, rest) = sample();
    for by in [0.0, 0.02, 0.3] {
        let places = moved(&rest, by);
        let (_, home) = forces(&glue, &places);
        let mut blocks = vec![[[0.0; 3]; 3]; glue.pairs().len()];
        glue.stiffness(&places, &mut blocks);
        let block = |a: usize, b: usize, i: usize, j: usize| {
            let turned = a > b;
            let at = glue.pairs().binary_search(&[a.min(b), a.max(b)]);
            at.map_or(0.0, |at| if turned { blocks[at][j][i] } else { blocks[at][i][j] })
        };
        let h = 1e-5;
        let (mut worst, mut worst_block) = (0.0_f64, 0.0_f64);
        let force = home.iter().flatten().fold(1.0, |most: f64, f| most.max(f.abs()));
        let most = blocks.iter().flatten().flatten().fold(0.0, |most: f64, k| most.max(k.abs()));
        for b in 0..places.len() {
            for j in 0..3 {
                let shifted = |by: f64| {
                    let mut there = places.clone();
                    there[b][j] += by;
                    forces(&glue, &there)
                };
                let ((low, before), (high, after)) = (shifted(-h), shifted(h));
                worst = worst.max(((high - low) / (2.0 * h) + home[b][j]).abs());
                for a in 0..places.len() {
                    for i in 0..3 {
                        let change = -(after[a][i] - before[a][i]) / (2.0 * h);
                        worst_block = worst_block.max((change - block(a, b, i, j)).abs());
                    }
                }
            }
        }
        let (worst, worst_block) = (worst / force, worst_block / most);
        println!("{by}: forces {worst:.1e}, blocks {worst_block:.1e}");
        assert!(worst < 3e-9 && worst_block < 3e-9, "{by}: {worst:e} {worst_block:e}");
        // What resists a motion is the same.
        let (motion, mut resisting) =
            (moved(&vec![[0.0; 3]; places.len()], 1.0), vec![[0.0; 3]; places.len()]);
        glue.resist(&places, &motion, &mut resisting);
        for a in 0..places.len() {
            for i in 0..3 {
                let sum: f64 = (0..places.len())
                    .map(|b| (0..3).map(|j| block(a, b, i, j) * motion[b][j]).sum::<f64>())
                    .sum();
                assert!((sum - resisting[a][i]).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn forces_have_neither_a_sum_nor_a_moment() {
    let (glue, rest) = sample();
    let places = moved(&rest, 0.3);
    let (_, forces) = forces(&glue, &places);
    let (mut sum, mut moment, mut size) = (Vec3::zeros(), Vec3::zeros(), 0.0);
    for (x, f) in places.iter().zip(&forces) {
        let (x, f) = (Vec3::from(*x), Vec3::from(*f));
        (sum, moment, size) = (sum + f, moment + x.cross(&f), size + f.norm());
    }
    assert!(size > 1.0 && sum.norm() < 1e-14 * size && moment.norm() < 1e-14 * size, "{sum} {moment}");
}

/// The greatest eigenvalue of the blocks at places of some masses.
fn highest(glue: &Glue, places: &[[f64; 3]], masses: &[f64]) -> f64 {
    let mut blocks = vec![[[0.0; 3]; 3]; glue.pairs().len()];
    glue.stiffness(places, &mut blocks);
    let mut whole = DMatrix::<f64>::zeros(3 * places.len(), 3 * places.len());
    for (&[a, b], block) in glue.pairs().iter().zip(&blocks) {
        let over = 1.0 / (masses[a] * masses[b]).sqrt();
        for i in 0..3 {
            for j in 0..3 {
                whole[(3 * a + i, 3 * b + j)] = block[i][j] * over;
                whole[(3 * b + j, 3 * a + i)] = block[i][j] * over;
            }
        }
    }
    whole.symmetric_eigenvalues().max()
}

/// At rest, on unlike masses: the bound of all, and the mass that swings on each.
#[test]
fn the_bound_lies_above_the_highest_frequency() {
    let (glue, places) = sample();
    for round in 0..4 {
        let masses: Vec<f64> = (0..places.len()).map(|a| libm::pow(10.0, number(100 * round + a))).collect();
        let (bound, exact) = (glue.fastest(&places, &masses), highest(&glue, &places, &masses));
        println!("{bound} {exact}");
        assert!(bound >= exact && bound < 10.0 * exact, "{bound} {exact}");
        for (own, mass) in glue.glued().iter().zip(glue.swinging(&places, &masses)) {
            let alone = Glue::new(vec![Glued { stiffness: mass, ..own.clone() }], &places);
            let exact = highest(&alone, &places, &masses);
            assert!(exact < 1.0 + 1e-12 && exact > 0.1, "{exact}");
        }
    }
}
