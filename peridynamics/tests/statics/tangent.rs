//! The tangent is the derivative of the forces, whatever the law, the space and the bonds left.

use implicit_statics::{Equilibrium, row_sums, tangent_error};
use nalgebra::{DMatrix, Rotation3, SymmetricEigen};
use peridynamics::{Law, Solid, Space, StaticSolid};
use sph_core::Vec3;

use crate::bodies::{block_parts, deform, free_blocks, noise, norm};

#[test]
fn the_tangent_is_the_difference_of_the_forces() {
    for (name, mut system) in free_blocks() {
        deform(&mut system);
        let direction = noise(system.unknowns(), 1.0);
        let error = tangent_error(&mut system, 0.0, &direction, 1e-5);
        println!("{name}: {error:.1e}");
        assert!(error < 1e-7, "{name}: {error:.1e}");
    }
}

#[test]
fn rigid_motions_are_the_only_ones_without_stiffness() {
    for (name, mut system) in free_blocks() {
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(0.0, &mut values);
        let mut dense = DMatrix::zeros(system.unknowns(), system.unknowns());
        for (&(row, column), value) in pattern.iter().zip(&values) {
            dense[(row, column)] = *value;
            dense[(column, row)] = *value;
        }
        let mut eigenvalues: Vec<f64> = SymmetricEigen::new(dense).eigenvalues.iter().copied().collect();
        eigenvalues.sort_by(f64::total_cmp);
        let top = eigenvalues[eigenvalues.len() - 1];
        let rigid = if name.starts_with("Solid") { 6 } else { 3 };
        let largest = eigenvalues[..rigid].iter().fold(0.0_f64, |most, value| most.max(value.abs())) / top;
        println!("{name}: rigid {largest:.1e}, next {:.1e}", eigenvalues[rigid] / top);
        assert!(largest < 1e-10, "{name}: {largest:.1e}");
        assert!(eigenvalues[rigid] > 1e-4 * top, "{name}: {:.1e}", eigenvalues[rigid] / top);
    }
}

/// In unknowns that turn with the nodes; in fixed ones the change per radian is of order one.
#[test]
fn a_rigid_turn_leaves_the_tangent_as_it_is() {
    let step = 1e-5;
    for (name, mut system) in free_blocks() {
        let solid = system.solid();
        let spin = if name.starts_with("Solid") { Vec3::new(0.5, -0.3, 0.8) } else { Vec3::z() };
        let motion: Vec<f64> = (0..solid.len())
            .flat_map(|node| {
                let rate = spin.cross(&solid.position(node));
                rate.iter().copied().take(system.unknowns() / solid.len()).collect::<Vec<_>>()
            })
            .collect();
        let mut ends = [vec![0.0; system.pattern().len()], vec![0.0; system.pattern().len()]];
        for (sign, values) in [1.0, -1.0].into_iter().zip(&mut ends) {
            let motion: Vec<f64> = motion.iter().map(|q| sign * step * q).collect();
            system.turned_tangent([0.0; 2], &motion, values);
        }
        let change: Vec<f64> = ends[0].iter().zip(&ends[1]).map(|(p, m)| (p - m) / (2.0 * step)).collect();
        let left = norm(&change) / norm(&ends[0]);
        println!("{name}: {left:.1e}");
        assert!(left < 1e-6, "{name}: {left:.1e}");
    }
}

#[test]
fn a_turned_body_has_turned_forces() {
    for (name, mut system) in free_blocks() {
        deform(&mut system);
        system.evaluate(0.0);
        let solid = system.solid();
        let places: Vec<Vec3> = (0..solid.len()).map(|a| solid.position(a)).collect();
        let forces: Vec<Vec3> = (0..solid.len()).map(|a| solid.internal_force(a)).collect();
        let energy = solid.internal_energy();
        let size = forces.iter().fold(0.0_f64, |most, f| most.max(f.norm()));
        // In a plane about its normal, in space about an axis without symmetry.
        let axis = if name.starts_with("Solid") { Vec3::new(1.0, 2.0, -0.5) } else { Vec3::z() };
        for degrees in [33.0_f64, 90.0] {
            let turn = Rotation3::new(axis.normalize() * degrees.to_radians());
            places.iter().enumerate().for_each(|(a, x)| system.solid_mut().put(a, turn * x));
            system.evaluate(0.0);
            let off = (0..places.len())
                .map(|a| (system.solid().internal_force(a) - turn * forces[a]).norm())
                .fold(0.0, f64::max);
            let of_energy = (system.solid().internal_energy() - energy).abs() / energy;
            assert!(off < 1e-12 * size, "{name}, {degrees}°: {:.1e}", off / size);
            assert!(of_energy < 1e-12, "{name}, {degrees}°: {of_energy:.1e}");
        }
    }
}

#[test]
fn row_sums_need_no_matrix() {
    for (name, mut system) in free_blocks() {
        deform(&mut system);
        let n = system.unknowns();
        let (mut bound, mut exact) = (vec![0.0; n], vec![0.0; n]);
        system.row_sums(0.0, &mut bound);
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(0.0, &mut values);
        row_sums(&pattern, &values, &mut exact);
        // All unknowns of a node take the largest of theirs.
        let each = if name.starts_with("Solid") { 3 } else { 2 };
        for own in exact.chunks_mut(each) {
            let largest = own.iter().copied().fold(0.0, f64::max);
            own.fill(largest);
        }
        let ratios = bound.iter().zip(&exact).map(|(bound, exact)| bound / exact);
        let (least, most) = ratios.fold((f64::INFINITY, 0.0_f64), |(l, m), r| (l.min(r), m.max(r)));
        println!("{name}: {least:.3} to {most:.3} of the exact sums");
        assert!(least > 1.0 - 1e-12, "{name}: {least}");
        // Exact without a dilatation; with one the bound cannot see signs cancel.
        let loose = if name.contains("BondBased") { 1.0 + 1e-12 } else { 2.0 };
        assert!(most < loose, "{name}: {most}");
    }
}

#[test]
fn threads_change_no_bit_of_the_tangent() {
    for law in [Law::BondBased, Law::StateBased] {
        let tangent = |threads: usize| {
            let mut parts = block_parts(Space::Solid, law, [9, 6, 6]);
            parts.threads = threads;
            let mut system = StaticSolid::new(Solid::new(parts).unwrap());
            deform(&mut system);
            let mut values = vec![0.0; system.pattern().len()];
            system.tangent(0.0, &mut values);
            values
        };
        assert!(tangent(1) == tangent(3));
    }
}

#[test]
fn pairwise_bonds_couple_their_own_ends_alone() {
    let entries = |law| {
        let system = StaticSolid::new(Solid::new(block_parts(Space::PlaneStress, law, [20, 20, 1])).unwrap());
        (system.pattern().len(), system.solid().bonds())
    };
    let (pairwise, bonds) = entries(Law::BondBased);
    // Four entries for each pair of nodes with a bond, three on the diagonal of each node.
    assert_eq!(pairwise, 4 * bonds / 2 + 3 * 400);
    assert!(entries(Law::StateBased).0 > 2 * pairwise);
}
