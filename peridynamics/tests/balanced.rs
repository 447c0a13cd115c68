//! Balanced weights: uniform strains are in balance with the tractions on faces, and what follows from that.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use explicit_dynamics::{Amplitude, LinearisedDynamics};
use implicit_statics::{Equilibrium, linear_response, natural_modes, unwatched};
use lattices::{ALL, Random, displace, formulation, parts, poisson};
use nalgebra::Matrix3;
use peridynamics::{
    AppliedLoad, Correction, Elastic, Formulation, Idealisation, Influence, Law, Mirror, Parts, Sheets,
    Solid, Space, StaticSolid, Support, Supported,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

const YOUNG: f64 = 2.5;
/// Part of linear answers that is looked at.
const SMALL: f64 = 1e-8;

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
        let (mut solid, d) = (body(&block, shape), block.dimensions);
        let plane = Matrix3::from_fn(|a, b| if a < d && b < d { 1e-5 } else { 0.0 });
        let strain = Matrix3::from_fn(|_, _| random.next());
        let strain = (strain + strain.transpose()).component_mul(&plane);
        let sigma = stress(shape.space, poisson(shape.space, shape.law), &strain);
        let (mut forces, mut energy) = (vec![Vec3::zeros(); block.len()], 0.0);
        // What is of second order goes out of the difference.
        for sign in [1.0, -1.0] {
            displace(&mut solid, |x| strain * x * sign);
            solid.evaluate_internal(true);
            energy += 0.5 * solid.internal_energy();
            (0..block.len()).for_each(|node| forces[node] += solid.internal_force(node) * (0.5 * sign));
        }
        let tractions: Vec<Vec3> = areas(&block).iter().map(|a| sigma * a).collect();
        let size = tractions.iter().map(Vec3::norm).fold(0.0, f64::max);
        let apart = tractions.iter().zip(&forces).map(|(t, f)| (t - f).norm()).fold(0.0, f64::max) / size;
        // Measured 4e-10 and 2e-10 at most: terms of third order in strains of 1e-5, and rounding of places.
        assert!(apart < 1e-9, "{name}: {apart:.1e}");
        let whole = 0.5 * block.volumes.iter().sum::<f64>() * sigma.dot(&strain);
        assert!((energy / whole - 1.0).abs() < 1e-9, "{name}: {:.1e}", energy / whole - 1.0);
    }
}

/// Stiffnesses of pairwise bonds at rest, `−n·K n`, for each pair of nodes once.
fn stiffnesses(solid: &mut Solid) -> Vec<(usize, usize, f64)> {
    let (count, d) = (solid.len(), solid.block().dimensions);
    solid.evaluate_internal(false);
    let mut columns = Vec::new();
    for unknown in 0..3 * count {
        let mut one = vec![0.0; 3 * count];
        one[unknown] = if unknown % 3 < d { 1.0 } else { 0.0 };
        let mut out = vec![0.0; 3 * count];
        solid.apply(&one, &mut out);
        columns.push(out);
    }
    let x = solid.block().positions.clone();
    let mut out = Vec::new();
    for i in 0..count {
        for j in 0..i {
            let n = (x[j] - x[i]).normalize();
            let pair = |a: usize, b: usize| n[a] * n[b] * columns[3 * j + b][3 * i + a];
            let sum: f64 = (0..d).flat_map(|a| (0..d).map(move |b| (a, b))).map(|(a, b)| pair(a, b)).sum();
            out.push((i, j, -sum));
        }
    }
    out
}

#[test]
fn no_bond_pushes_back_and_what_holds_still_is_rigid() {
    for (space, cells) in [(Space::PlaneStress, [7, 5, 1]), (Space::Solid, [4, 3, 3])] {
        let block = edges(space.dimensions(), cells, [0.1; 3], 1.0);
        let mut solid = body(&block, balanced(space, Law::BondBased, 3.015));
        let all = stiffnesses(&mut solid);
        let most = all.iter().map(|bond| bond.2).fold(0.0, f64::max);
        // Rounding of the tangent.
        assert!(all.iter().all(|bond| bond.2 > -1e-12 * most), "{space:?}");
        for law in [Law::BondBased, Law::StateBased] {
            let mut system = StaticSolid::new(body(&block, balanced(space, law, 3.015)));
            let rigid = if space == Space::Solid { 6 } else { 3 };
            let found = natural_modes(&mut system, 0.0, rigid + 1, -1e-3, &mut unwatched).unwrap();
            let values: Vec<f64> = found.modes.iter().map(|mode| mode.eigenvalue).collect();
            // Waves along the body: of the order of its modulus over its size squared.
            assert!(values[..rigid].iter().all(|value| value.abs() < 1e-7), "{values:?}");
            assert!(values[rigid] > 1.0, "{values:?}");
        }
    }
}

/// The energy of the bonds across cracks, each stretched alike since all have one limit, over that of a long one far inside: how near
/// to what was asked a crack takes. Across the body from face to face, and along a face, so many rows below it.
#[test]
fn cracks_near_faces_take_about_what_is_asked() {
    let block = edges(2, [24, 18, 1], [1.0; 3], 1.0);
    let x: Vec<Vec3> = block.positions.iter().map(|x| x - block.positions[0]).collect();
    for influence in [Influence::Linear, Influence::Inverse] {
        for correction in [Correction::Even, Correction::Balanced] {
            let shape =
                Formulation { correction, influence, ..balanced(Space::PlaneStress, Law::BondBased, 3.015) };
            let all = stiffnesses(&mut body(&block, shape));
            let energy = |along: usize, row: f64, width: f64| -> f64 {
                let other = 1 - along;
                let middle = if along == 0 { 12.0 } else { 9.0 };
                let cut = |&&(i, j, _): &&(usize, usize, f64)| {
                    (x[i][other] - row) * (x[j][other] - row) < 0.0
                        && (0.5 * (x[i][along] + x[j][along]) - middle).abs() < 0.5 * width
                };
                all.iter().filter(cut).map(|&(i, j, c)| c * (x[i] - x[j]).norm_squared()).sum::<f64>() / width
            };
            let inside = energy(0, 8.5, 7.5);
            let rows = [0.5, 1.5, 2.5, 3.5].map(|row| energy(0, row, 7.5) / inside);
            let through = energy(1, 11.5, 18.0 + 1e-6) / inside;
            println!("{influence:?} {correction:?}: along a face {rows:.3?}, across {through:.4}");
            // Measured: even .69, 1.18, 1.23, 1.11 and 1.04; balanced 1.31, 1.22, 1.08, .97 and 1.05; the linear influence within .04.
            assert!(rows.iter().all(|ratio| (0.6..1.45).contains(ratio)) && (through - 1.0).abs() < 0.1);
        }
    }
}

/// The linear answer of a body, which is so small that it stays linear.
fn answer(
    mut parts: Parts,
    supports: Vec<Supported>,
    forces: Vec<(u32, Vec3)>,
    mirrors: &[Mirror],
) -> StaticSolid {
    parts.supports = supports;
    parts.loads = vec![AppliedLoad { forces, amplitude: Amplitude::Constant }];
    let mut system = StaticSolid::new(Solid::mirrored(parts, mirrors).unwrap());
    let answer = linear_response(&mut system, 0.0).unwrap();
    system.update(&answer.iter().map(|u| SMALL * u).collect::<Vec<_>>());
    system
}

/// Nodes of a face without displacement along directions, directors without part along others.
fn held(block: &Block, face: usize, displacement: &[Vec3], director: &[Vec3]) -> Supported {
    let nodes = block.faces[face].iter().map(|&(node, _)| node).collect();
    let (displacement, director) = (displacement.to_vec(), director.to_vec());
    Supported { nodes, support: Support::Held { displacement, director } }
}

/// A traction on a face.
fn traction(block: &Block, face: usize, value: Vec3) -> Vec<(u32, Vec3)> {
    block.faces[face].iter().map(|&(node, area)| (node, value * area)).collect()
}

/// Mean displacement of a face along an axis, weighted by area.
fn mean(system: &StaticSolid, face: usize, axis: usize) -> f64 {
    let shares = &system.solid().block().faces[face];
    let sum: f64 =
        shares.iter().map(|&(node, area)| area * system.solid().displacement(node as usize)[axis]).sum();
    sum / shares.iter().map(|share| share.1).sum::<f64>() / SMALL
}

fn pulled(space: Space, law: Law, correction: Correction) -> f64 {
    let block = edges(space.dimensions(), [12, 4, 4], [0.1; 3], 1.0);
    let shape = Formulation { correction, ..balanced(space, law, 3.015) };
    let material = Elastic { young: YOUNG, poisson: poisson(space, law), density: 1.0 };
    let mut supports = vec![held(&block, 0, &[Vec3::x()], &[])];
    for axis in 1..space.dimensions() {
        let middle = block.positions[0][axis] + 0.2;
        let mut line = held(&block, 0, &[Vec3::ith(axis, 1.0)], &[]);
        line.nodes.retain(|&node| (block.positions[node as usize][axis] - middle).abs() < 1e-6);
        supports.push(line);
    }
    let forces = traction(&block, 1, Vec3::x());
    let nu = material.poisson;
    let stiff = if space == Space::PlaneStrain { YOUNG / (1.0 - nu * nu) } else { YOUNG };
    let system = answer(parts(block, material, shape), supports, forces, &[]);
    mean(&system, 1, 0) / (1.2 / stiff) - 1.0
}

#[test]
fn the_loaded_end_of_a_bar_moves_as_far_as_its_strain_says() {
    for (space, law) in ALL {
        let [even, balanced] = [Correction::Even, Correction::Balanced].map(|c| pulled(space, law, c));
        println!("{space:?} {law:?}: {even:.1e} {balanced:.1e}");
        // Rounding of places in a displacement of 1e-8 of them; even weights are .1 to .19 off.
        assert!(balanced.abs() < 1e-6 && even > 0.05, "{space:?} {law:?}: {even:.1e} {balanced:.1e}");
    }
}

/// The deflection of a cantilever of 20 thicknesses over Euler's.
#[test]
fn few_layers_bend_as_a_beam() {
    for (law, horizon) in [(Law::BondBased, 3.015), (Law::StateBased, 3.015), (Law::StateBased, 2.015)] {
        let mut off = Vec::new();
        for layers in [3, 5, 8] {
            let (thickness, length) = (layers as f64, 20.0 * layers as f64);
            let block = edges(2, [20 * layers, layers, 1], [1.0; 3], 1.0);
            let material = Elastic { young: 1.0, poisson: poisson(Space::PlaneStress, law), density: 1.0 };
            let supports = vec![held(&block, 0, &[Vec3::x(), Vec3::y()], &[])];
            let forces = traction(&block, 1, Vec3::y() / thickness);
            let shape = balanced(Space::PlaneStress, law, horizon);
            let system = answer(parts(block, material, shape), supports, forces, &[]);
            off.push(mean(&system, 1, 1) / (4.0 * (length / thickness).powi(3)) - 1.0);
        }
        println!("{law:?} {horizon}: {off:.4?}");
        // Measured: .9 % at 3.015, 1.6 % at 2.015, and falling with the square of the layers; even weights are 6.4 % off at 3.015.
        assert!(
            off[2].abs() < 0.02 && off[2].abs() < 0.5 * off[1].abs() && off[1].abs() < 0.5 * off[0].abs()
        );
    }
}

/// Deflection of the middle of a square plate of two sheets, clamped or hard hinged, over that of a thin plate; a quarter of it.
fn plate(correction: Correction, cells: usize, clamped: bool) -> f64 {
    let (thickness, nu) = (0.01, 0.3);
    let h = 1.0 / cells as f64;
    let mut block = edges(2, [cells / 2, cells / 2, 1], [h, h, thickness], 1.0);
    let origin = block.positions[0];
    block.positions.iter_mut().for_each(|x| *x -= origin);
    let shape = Formulation { correction, ..balanced(Space::PlaneStress, Law::StateBased, 1.5) };
    let material = Elastic { young: 1.0, poisson: nu, density: 1.0 };
    let (all, flat) = ([Vec3::x(), Vec3::y(), Vec3::z()], [Vec3::x(), Vec3::y()]);
    let edge = |face: usize, along: Vec3| match clamped {
        true => held(&block, face, &all, &flat),
        false => held(&block, face, &[Vec3::z()], &[along]),
    };
    let supports = vec![edge(1, Vec3::y()), edge(3, Vec3::x())];
    let forces = (0..block.len()).map(|i| (i as u32, Vec3::z() * (block.volumes[i] / thickness))).collect();
    let parts = Parts {
        formulation: Idealisation::Sheets(Sheets { thickness, formulation: shape }),
        ..parts(block, material, shape)
    };
    let system = answer(parts, supports, forces, &[0, 1].map(|axis| Mirror { axis, at: 0.0 }));
    let rigidity = thickness.powi(3) / 12.0 / (1.0 - nu * nu);
    let thin = if clamped { 0.001_265_32 } else { 0.004_062_35 } / rigidity;
    system.solid().displacement(0).z / SMALL / thin - 1.0
}

#[test]
fn clamped_edges_of_plates_of_two_sheets_turn_nothing() {
    let off = |correction, clamped| [8, 16, 32].map(|cells| plate(correction, cells, clamped));
    let [even, balanced] = [Correction::Even, Correction::Balanced].map(|c| off(c, true));
    let [hinged, hinged_even] = [Correction::Balanced, Correction::Even].map(|c| off(c, false));
    println!("clamped {even:.4?} {balanced:.4?}, hinged {hinged_even:.4?} {hinged:.4?}");
    // Measured 5.1, 1.3 and .4 %, the last with .2 % of shear; even weights .106, .055 and .025.
    assert!(balanced[1].abs() < 0.02 && balanced[2].abs() < 0.008 && balanced[0].abs() < 0.08);
    assert!(even[1] > 0.04);
    assert!(hinged.iter().all(|off| off.abs() < 0.005));
}

#[test]
fn bodies_that_stand_on_no_faces_are_refused() {
    let centres = lattices::plane([9, 5], 1.0);
    let material = Elastic { young: 1.0, poisson: 0.3, density: 1.0 };
    let shape = balanced(Space::PlaneStress, Law::StateBased, 3.015);
    let refused =
        |block: Block| Solid::new(parts(block, material, shape)).err().map(|error| error.to_string());
    let lattice = BlockLattice {
        dimensions: 2,
        lengths: [9.0, 5.0, 1.0],
        spacing: [1.0; 3],
        origin: Vec3::zeros(),
        nodes: NodePlaces::Centres,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 1,
    };
    for block in [centres, lattice.block().unwrap()] {
        let words = refused(block).unwrap();
        assert!(words.contains("put the nodes on the edges"), "{words}");
    }
}
