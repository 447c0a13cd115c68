//! The same bits for 1, 2 and 4 threads, and no allocation inside a step.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use std::alloc::System;
use std::sync::Mutex;

use explicit_dynamics::{Amplitude, Bounds, Clock, Dynamics};
use lattices::{ALL, formulation, lattice, parts, poisson};
use peridynamics::{
    AppliedLoad, Criterion, Elastic, Fracture, Law, Parts, Plastic, Solid, Space, Support, Supported,
};
use sph_core::Vec3;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Tests of this file run one at a time: the counter belongs to the whole process.
static ALONE: Mutex<()> = Mutex::new(());

/// A limit that no bond comes to.
const FAR: Criterion = Criterion::Stretch { tension: 0.9, compression: None };

/// A block of several chunks of nodes, held at one end, pulled at the other by a prescribed motion and a load.
fn body(of: (Space, Law, Option<Plastic>), threads: usize) -> Solid {
    Solid::new(body_parts(of, threads)).unwrap()
}

fn body_parts((space, law, plastic): (Space, Law, Option<Plastic>), threads: usize) -> Parts {
    let block = match space {
        Space::Solid => lattice(3, [17, 9, 8], [0.1; 3]),
        Space::PlaneStress | Space::PlaneStrain => lattice(2, [41, 31, 1], [0.1; 3]),
    };
    let (count, layer) = (block.len() as u32, (block.len() / 17) as u32);
    let material = Elastic { young: 100.0, poisson: poisson(space, law), density: 1.0 };
    let amplitude = Amplitude::Ramp(0.1);
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let moved = Support::Moved { direction: Vec3::x(), by: 0.02, amplitude: amplitude.clone() };
    let load = (count / 2..count / 2 + layer).map(|node| (node, Vec3::new(0.01, 0.002, 0.0))).collect();
    Parts {
        supports: vec![
            Supported { nodes: (0..layer).collect(), support: held },
            Supported { nodes: (count - layer..count).collect(), support: moved },
        ],
        loads: vec![AppliedLoad { forces: load, amplitude }],
        plastic,
        threads,
        ..parts(block, material, formulation(space, law))
    }
}

/// Positions and energies after some steps, as bits.
fn bits(space: Space, law: Law, threads: usize) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut solid = body((space, law, None), threads);
        let mut clock = Clock::start(&mut solid, 1.0, 0.7, 0.01).unwrap();
        for _ in 0..40 {
            clock.step(&mut solid, f64::INFINITY, |_| 1.0).unwrap();
        }
        let energy = solid.evaluate(clock.now);
        let places = (0..solid.len()).flat_map(|node| <[f64; 3]>::from(solid.position(node)));
        places.chain([energy, clock.kinetic, clock.now.time]).map(f64::to_bits).collect()
    })
}

#[test]
fn threads_do_not_change_a_bit() {
    let _alone = ALONE.lock().unwrap();
    for (space, law) in ALL {
        let one = bits(space, law, 1);
        for threads in [2, 4] {
            assert!(bits(space, law, threads) == one, "{space:?} {law:?}: {threads} threads give other bits");
        }
    }
}

/// Allocations of 200 steps after a few to warm up.
fn allocations(of: (Space, Law, Option<Plastic>), threads: usize) -> usize {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut solid = body(of, threads);
        let mut clock = Clock::start(&mut solid, 1.0, 0.7, 0.01).unwrap();
        let mut march = |steps: usize| {
            for _ in 0..steps {
                clock.step(&mut solid, f64::INFINITY, |_| 1.0).unwrap();
            }
        };
        march(20);
        let region = Region::new(ALLOCATOR);
        march(200);
        region.change().allocations
    })
}

#[test]
fn a_step_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    // The last one flows from the first steps on.
    let soft = Plastic { yield_stress: 1e-9, hardening: 0.0 };
    for case in [
        (Space::PlaneStress, Law::BondBased, None),
        (Space::PlaneStress, Law::StateBased, None),
        (Space::Solid, Law::StateBased, Some(soft)),
    ] {
        for threads in [1, 2] {
            // The test harness itself may allocate on its own thread now and then; a step that did would count 200.
            let counted = allocations(case, threads);
            assert!(counted < 20, "{case:?}: {counted} allocations in 200 steps on {threads} threads");
        }
    }
}

/// Nor does a step of several, in each of them: pairwise bonds that may break, and such as yield.
#[test]
fn a_step_of_peers_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    let soft = Plastic { yield_stress: 1e-9, hardening: 0.0 };
    for (space, law, plastic) in [
        (Space::PlaneStress, Law::BondBased, None),
        (Space::PlaneStress, Law::StateBased, None),
        (Space::Solid, Law::StateBased, Some(soft)),
    ] {
        let counted = peers::together(2, |peers| {
            let mut solid = Solid::new(Parts {
                fracture: plastic.is_none().then_some(Fracture { criterion: FAR, unbreakable: Vec::new() }),
                ..body_parts((space, law, plastic), 1)
            })
            .unwrap();
            solid.share(peers).unwrap();
            let mut clock = Clock::start(&mut solid, 1.0, 0.7, 0.01).unwrap();
            (0..20).for_each(|_| clock.step(&mut solid, f64::INFINITY, |_| 1.0).unwrap());
            // The counter belongs to the process: it starts and ends where all meet.
            solid.within_bounds(Bounds::Motion).unwrap();
            let region = Region::new(ALLOCATOR);
            solid.within_bounds(Bounds::Motion).unwrap();
            (0..100).for_each(|_| clock.step(&mut solid, f64::INFINITY, |_| 1.0).unwrap());
            solid.within_bounds(Bounds::Motion).unwrap();
            region.change().allocations
        });
        for counted in counted.unwrap() {
            assert!(counted < 10, "{space:?} {law:?}: {counted} allocations in 100 steps of two peers");
        }
    }
}
