//! Patch test: linear displacements on a boundary layer; how far the nodes within are from them.

use implicit_statics::{Equilibrium, linear_response};
use peridynamics::{Correction, Elastic, Law, Solid, Space, StaticSolid};
use sph_core::{Block, Vec3};

use crate::blocks::{formulation, lattice, moved, parts};
use crate::bodies::{poisson, short};

/// Greatest distance of a node within from the linear field, over the greatest displacement.
fn patch(block: Block, law: Law) -> f64 {
    let space = if block.dimensions == 3 { Space::Solid } else { Space::PlaneStress };
    let material = Elastic { young: 1.0, poisson: poisson(space, law), density: 1.0 };
    let mut parts = parts(block.clone(), material, formulation(space, law, Correction::Even));
    let centre = block.positions.iter().sum::<Vec3>() / block.len() as f64;
    let half = block.positions.iter().fold(Vec3::zeros(), |most, x| most.sup(&(x - centre).abs()));
    // Two horizons: beyond one, forces on nodes within would feel weights that a surface has corrected.
    let depth = 7.1 * block.greatest_spacing();
    let field = |x: &Vec3| {
        let y = x - centre;
        1e-6 * Vec3::new(
            y.x + 0.3 * y.y,
            -0.4 * y.y + 0.1 * y.x,
            if space == Space::Solid { 0.5 * y.z } else { 0.0 },
        )
    };
    for (node, x) in block.positions.iter().enumerate() {
        let inside = (0..block.dimensions).all(|axis| half[axis] - (x - centre)[axis].abs() > depth);
        if !inside {
            for axis in &[Vec3::x(), Vec3::y(), Vec3::z()][..block.dimensions] {
                parts.supports.push(moved(vec![node as u32], *axis, field(x).dot(axis)));
            }
        }
    }
    let mut system = StaticSolid::new(Solid::new(parts).unwrap());
    let answer = linear_response(&mut system, 0.0).unwrap();
    system.update(&answer);
    system.evaluate(1.0);
    let (mut off, mut most) = (0.0_f64, 0.0_f64);
    for (node, x) in block.positions.iter().enumerate() {
        off = off.max((system.solid().displacement(node) - field(x)).norm());
        most = most.max(field(x).norm());
    }
    off / most
}

/// A lattice balances every linear field; nodes out of order balance it as well as their weights allow.
#[test]
fn linear_fields_on_lattices_graded_and_disordered_nodes() {
    for (law, dimensions) in [(Law::BondBased, 2), (Law::StateBased, 2), (Law::BondBased, 3)] {
        let lengths = if dimensions == 2 { [40.0, 30.0, 1.0] } else { [20.0; 3] };
        let even = lattice(dimensions, Vec3::zeros(), lengths, 1.0);
        let mut graded = even.clone();
        graded.grading = [1.5, 1.0, 1.0];
        let mut disordered = even.clone();
        disordered.disorder = 0.2;
        let errors = [even, graded, disordered].map(|lattice| patch(lattice.block().unwrap(), law));
        println!("{law:?}, {dimensions} dimensions: lattice, graded, disordered {}", short(&errors));
        assert!(errors[0] < 1e-9, "{law:?}, {dimensions}: {:.1e}", errors[0]);
        // Measured 1e-3 and 1e-2: weights are exact for energies of uniform strains, not for their forces.
        assert!(errors[1] < 0.003, "{law:?}, {dimensions}, graded: {:.1e}", errors[1]);
        assert!(errors[2] < 0.03, "{law:?}, {dimensions}, disordered: {:.1e}", errors[2]);
    }
}
