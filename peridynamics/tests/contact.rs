//! Contact: blocks that collide, fragments and walls.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use explicit_dynamics::{Dynamics, March, Transient};
use lattices::{formulation, lattice, parts, plane, poisson};
use peridynamics::{Contact, Criterion, Elastic, Fracture, Law, Parts, Solid, Space};
use sph_core::{Block, Vec3};

const DX: f64 = 1e-3;

/// Marches to the end; the greatest error of the energy balance over the energy at the start, and the least place along x at any record.
fn march(duration: f64, record_every: f64, body: &mut Solid) -> [f64; 2] {
    let run = Transient { duration, record_every, damping: 0.0, safety: 0.9 };
    let mut march = March::start(run, body).unwrap();
    let (mut errors, mut total, mut least) = (0.0_f64, 0.0, f64::INFINITY);
    while let Some(record) = march.next_record(body).unwrap() {
        if record.step == 0 {
            total = record.energy.kinetic;
        }
        errors = errors.max(record.balance_error.abs() / total);
        least = (0..body.len()).map(|node| body.position(node).x).fold(least, f64::min);
    }
    [errors, least]
}

/// Two equal blocks with a gap of three spacings between them.
fn two(space: Space) -> Block {
    let three = space == Space::Solid;
    let one = if three { lattice(3, [8, 5, 5], [DX; 3]) } else { plane([12, 10], DX) };
    let length = if three { 8.0 } else { 12.0 };
    let mut both = one.clone();
    both.positions.extend(one.positions.iter().map(|x| x + Vec3::x() * ((length + 3.0) * DX)));
    both.volumes.extend(&one.volumes);
    both
}

fn momentum(body: &Solid, half: usize) -> [f64; 2] {
    let of = |nodes: std::ops::Range<usize>| nodes.map(|node| body.mass(node) * body.velocity(node).x).sum();
    [of(0..half), of(half..body.len())]
}

/// A block runs into one at rest: they exchange their momenta and keep their energy.
#[test]
fn blocks_collide_and_part() {
    for (space, law) in [(Space::Solid, Law::StateBased), (Space::PlaneStress, Law::BondBased)] {
        let run = |threads: usize| {
            let block = two(space);
            let half = block.len() / 2;
            let material = Elastic { young: 70e9, poisson: poisson(space, law), density: 2700.0 };
            let mut body = Solid::new(Parts {
                contact: Some(Contact { distance: 1.0, walls: Vec::new() }),
                threads,
                ..parts(block, material, formulation(space, law))
            })
            .unwrap();
            (0..half).for_each(|node| body.set_velocity(node, Vec3::x() * 20.0));
            let [before, _] = momentum(&body, half);
            let [balance, _] = march(3e-4, 1e-6, &mut body);
            let [left, right] = momentum(&body, half).map(|p| p / before);
            // Measured 0.994 and 0.979: the blocks go on vibrating; 1.4e-3 and 3.2e-3.
            assert!((left + right - 1.0).abs() < 1e-12 && right - left > 0.94 && balance < 1e-2);
            body
        };
        let bodies = [1, 2, 4].map(run);
        assert!(bodies.iter().all(|body| body.motion() == bodies[0].motion()));
    }
}

/// A plate thrown at a wall breaks; none of its nodes passes.
#[test]
fn fragments_do_not_pass_a_wall() {
    let block = plane([20, 20], DX);
    let law = Law::BondBased;
    let material = Elastic { young: 70e9, poisson: poisson(Space::PlaneStress, law), density: 2700.0 };
    let mut body = Solid::new(Parts {
        fracture: Some(Fracture { criterion: Criterion::EnergyByStretch(50.0), unbreakable: Vec::new() }),
        contact: Some(Contact { distance: 1.0, walls: vec![[Vec3::zeros(), Vec3::x() * 2.0]] }),
        ..parts(block, material, formulation(Space::PlaneStress, law))
    })
    .unwrap();
    (0..body.len()).for_each(|node| body.set_velocity(node, Vec3::new(-100.0, 0.0, 0.0)));
    let [balance, least] = march(6e-5, 5e-7, &mut body);
    // Measured 0.40 dx, 386 fragments, 2.0e-3.
    assert!(least > 0.0 && body.fragments().len() > 10 && balance < 6e-3);
}

/// Where there is no contact to come, the step is that of the bonds; with contact it is shorter by a bounded part.
#[test]
fn contact_shortens_the_step_by_its_bound() {
    let step = |contact: Option<Contact>| {
        let material = Elastic { young: 70e9, poisson: 1.0 / 3.0, density: 2700.0 };
        let shape = formulation(Space::PlaneStress, Law::BondBased);
        let mut body = Solid::new(Parts { contact, ..parts(plane([20, 20], DX), material, shape) }).unwrap();
        body.stable_step(0.9).unwrap().dt
    };
    let ratio = step(Some(Contact { distance: 0.9, walls: Vec::new() })) / step(None);
    // Measured 0.810.
    assert!(ratio < 0.9 && ratio > 0.7);
}
