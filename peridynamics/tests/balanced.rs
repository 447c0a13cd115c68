//! Balanced weights: uniform strains are in balance with the tractions on faces, and what follows from that.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use explicit_dynamics::LinearisedDynamics;
use lattices::{ALL, Random, displace, formulation, parts, poisson};
use nalgebra::{DMatrix, Matrix3, SymmetricEigen};
use peridynamics::{Correction, Elastic, Formulation, Law, Solid, SolidError, Space};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

const YOUNG: f64 = 2.5;

/// A box of cells with nodes at their corners.
fn edges(dimensions: usize, cells: [usize; 3], spacing: [f64; 3], grading: f64) -> Block {
    let lattice = BlockLattice {
        dimensions,
        lengths: [0, 1, 2].map(|a| if a < dimensions { cells[a] as f64 * spacing[a] } else { spacing[a] }),
        spacing,
        origin: Vec3::new(0.3, -0.2, 0.1),
        nodes: NodePlaces::Edges,
        grading: [grading, 1.0, 1.0],
        disorder: 0.0,
        seed: 1,
    };
    lattice.block().unwrap()
}

fn balanced(space: Space, law: Law, horizon: f64) -> Formulation {
    Formulation { correction: Correction::Balanced, horizon, ..formulation(space, law) }
}

fn body(block: &Block, shape: Formulation) -> Solid {
    let material = Elastic { young: YOUNG, poisson: poisson(shape.space, shape.law), density: 1.0 };
    Solid::new(parts(block.clone(), material, shape)).unwrap()
}

/// Stress of a strain.
fn stress(space: Space, nu: f64, strain: &Matrix3<f64>) -> Matrix3<f64> {
    let mu = YOUNG / (2.0 * (1.0 + nu));
    let lambda = match space {
        Space::PlaneStress => YOUNG * nu / (1.0 - nu * nu),
        _ => YOUNG * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)),
    };
    let plane = if space == Space::Solid {
        Matrix3::identity()
    } else {
        Matrix3::from_diagonal(&Vec3::new(1.0, 1.0, 0.0))
    };
    plane * (lambda * strain.trace()) + strain * (2.0 * mu)
}

/// The areas of faces that nodes stand for, outward.
fn areas(block: &Block) -> Vec<Vec3> {
    let mut out = vec![Vec3::zeros(); block.len()];
    for (number, face) in block.faces[..2 * block.dimensions].iter().enumerate() {
        let sign = if number % 2 == 0 { -1.0 } else { 1.0 };
        face.iter().for_each(|&(node, area)| out[node as usize][number / 2] += sign * area);
    }
    out
}

fn bodies() -> Vec<(String, Block, Formulation)> {
    let mut out = Vec::new();
    for (space, law) in ALL {
        let d = space.dimensions();
        for (cells, spacing, grading) in [
            ([7, 5, 4], [0.1, 0.1, 0.1], 1.0),
            ([9, 3, 3], [0.1, 0.08, 0.09], 1.0),
            ([8, 4, 4], [0.1, 0.1, 0.1], 1.4),
        ] {
            for horizon in [1.5, 2.015, 3.015] {
                if grading > 1.0 && horizon < 2.0 {
                    continue;
                }
                let name = format!("{space:?} {law:?} {cells:?} {grading} {horizon}");
                out.push((name, edges(d, cells, spacing, grading), balanced(space, law, horizon)));
            }
        }
    }
    out
}

#[test]
fn uniform_strains_are_in_balance_at_every_node() {
    let mut random = Random(5);
    for (name, block, shape) in bodies() {
        let started = std::time::Instant::now();
        let mut solid = match Solid::new(parts(
            block.clone(),
            Elastic { young: YOUNG, poisson: poisson(shape.space, shape.law), density: 1.0 },
            shape,
        )) {
            Ok(s) => s,
            Err(e) => {
                println!("{name}: {e}");
                continue;
            }
        };
        let took = started.elapsed();
        let d = block.dimensions;
        let strain = Matrix3::from_fn(|_, _| random.next());
        let plane = Matrix3::from_fn(|a, b| if a < d && b < d { 1.0 } else { 0.0 });
        let strain = (strain + strain.transpose()).component_mul(&plane) * 1e-5;
        let nu = poisson(shape.space, shape.law);
        let sigma = stress(shape.space, nu, &strain);
        let mut forces = vec![Vec3::zeros(); block.len()];
        let mut energy = 0.0;
        for sign in [1.0, -1.0] {
            displace(&mut solid, |x| strain * x * sign);
            solid.evaluate_internal(true);
            energy += 0.5 * solid.internal_energy();
            for node in 0..block.len() {
                forces[node] += 0.5 * sign * solid.internal_force(node);
            }
        }
        let size = areas(&block).iter().map(|a| (sigma * a).norm()).fold(0.0, f64::max);
        let apart =
            areas(&block).iter().zip(&forces).map(|(a, f)| (sigma * a - f).norm()).fold(0.0, f64::max) / size;
        let volume: f64 = block.volumes.iter().sum();
        let whole = 0.5 * volume * sigma.dot(&strain);
        println!("{name}: {apart:.1e} {:.1e} {took:?}", energy / whole - 1.0);
    }
}
