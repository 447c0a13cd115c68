//! The same bits for 1, 2 and 4 threads and after a resume, and no allocation inside a step, of two who share it neither.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use std::alloc::System;
use std::sync::Mutex;

use common::{disorder, pool};
use explicit_dynamics::{Amplitude, BoundaryDriven, BoundaryLayout, BoundaryState, Clock, Face, ThinLayout};
use fluid_sph::{Fluid, Formulation, Given, Opening, Periods, Scheme, Structure, WallRule};
use peers::together;
use sph_core::Vec3;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Tests of this file run one at a time: the counter belongs to the whole process.
static ALONE: Mutex<()> = Mutex::new(());

fn methods() -> [Formulation; 4] {
    let kick = Formulation { kinematic_viscosity: 1e-3, ..Formulation::default() };
    [
        kick,
        Formulation { xsph: 0.3, walls: WallRule::Dynamic, ..kick },
        Formulation::published(),
        Formulation { scheme: Scheme::PredictorCorrector, ..kick },
    ]
}

/// Water that falls into a corner, of several chunks of particles.
fn water(dimensions: usize, formulation: Formulation, threads: usize) -> Fluid {
    let (size, box_size) =
        if dimensions == 2 { ([1.0, 2.0, 0.0], [2.0, 2.0, 0.0]) } else { ([0.4, 0.5, 0.5], [0.6, 0.5, 0.6]) };
    let mut parts = pool(dimensions, size, box_size, 0.05);
    disorder(&mut parts, 0.2, 1.0);
    Fluid::new(fluid_sph::Parts { formulation, threads, ..parts }).unwrap()
}

/// Disordered water in a periodic box over a floor.
fn repeated(threads: usize) -> Fluid {
    let mut parts = pool(2, [1.0, 0.6, 0.0], [1.0, 0.8, 0.0], 0.02);
    parts.walls[0].points.retain(|at| (0.0..1.0).contains(&at.x));
    disorder(&mut parts, 0.2, 1.0);
    let formulation = Formulation { kinematic_viscosity: 1e-3, xsph: 0.3, ..Formulation::default() };
    let periods = Periods { low: Vec3::zeros(), lengths: Vec3::x() };
    Fluid::repeated(fluid_sph::Parts { formulation, threads, ..parts }, periods).unwrap()
}

fn steps(fluid: &mut Fluid, clock: &mut Clock, count: usize) {
    for _ in 0..count {
        clock.step(fluid, f64::INFINITY, |_| 1.0).unwrap();
    }
}

fn bits(fluid: &Fluid) -> Vec<u64> {
    fluid
        .state()
        .iter()
        .flat_map(|(_, numbers)| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>())
        .collect()
}

/// Allocations in a round of steps, of the quietest of five: what the harness does beside must not count, nor what another who shares the fluid
/// begins before this one has ended.
fn allocations(mut round: impl FnMut()) -> usize {
    let of_round = |_| {
        let region = Region::new(ALLOCATOR);
        round();
        region.change().allocations
    };
    (0..5).map(of_round).min().unwrap()
}

#[test]
fn threads_change_no_bit() {
    let _alone = ALONE.lock().unwrap();
    for dimensions in [2, 3] {
        for formulation in methods() {
            let run = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                pool.install(|| {
                    let mut fluid = water(dimensions, formulation, threads);
                    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
                    steps(&mut fluid, &mut clock, 20);
                    bits(&fluid)
                })
            };
            let one = run(1);
            assert!(one == run(2), "{dimensions} {formulation:?}: 2 threads");
            assert!(one == run(4), "{dimensions} {formulation:?}: 4 threads");
        }
    }
}

#[test]
fn a_state_put_back_goes_on_to_the_same_bits() {
    let _alone = ALONE.lock().unwrap();
    for formulation in methods() {
        let mut fluid = water(2, formulation, 1);
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
        steps(&mut fluid, &mut clock, 30);
        let (kept, mut resumed_clock) = (fluid.clone(), clock.clone());
        steps(&mut fluid, &mut clock, 30);
        let state = kept.state();
        let arrays: Vec<(&str, &[f64])> = state.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
        let mut resumed = water(2, formulation, 1);
        resumed.set_state(&arrays).unwrap();
        steps(&mut resumed, &mut resumed_clock, 30);
        assert!(bits(&fluid) == bits(&resumed), "{formulation:?}");
        assert_eq!(clock, resumed_clock);
        assert!(resumed.set_state(&arrays[1..]).is_err());
    }
}

#[test]
fn a_step_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    for dimensions in [2, 3] {
        for formulation in methods() {
            let mut fluid = water(dimensions, formulation, 1);
            let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
            steps(&mut fluid, &mut clock, 3);
            let found = allocations(|| steps(&mut fluid, &mut clock, 10));
            assert_eq!(found, 0, "{dimensions} {formulation:?}");
        }
    }
}

#[test]
fn periodic_sides_neither_allocate_nor_see_threads() {
    let _alone = ALONE.lock().unwrap();
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut fluid = repeated(threads);
            let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
            steps(&mut fluid, &mut clock, 20);
            bits(&fluid)
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(4));
    let mut fluid = repeated(1);
    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
    steps(&mut fluid, &mut clock, 3);
    assert_eq!(allocations(|| steps(&mut fluid, &mut clock, 10)), 0);
}

/// Rounds in which columns come in and go out.
#[test]
fn a_step_of_what_comes_and_goes_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    let mut parts = pool(2, [0.8, 0.3, 0.0], [0.8, 0.4, 0.0], 0.02);
    parts.walls[0].points.retain(|at| at.y < 0.0);
    parts.velocities = vec![Vec3::x() * 0.5; parts.positions.len()];
    let mut fluid = Fluid::new(parts).unwrap();
    let of = |x: f64, into: f64, given: Given| Opening { at: Vec3::x() * x, into: Vec3::x() * into, given };
    let velocity =
        Given::Velocity { into: 0.5, course: Amplitude::Constant, profile: Vec::new(), level: None };
    let ends = vec![of(0.0, 1.0, velocity), of(0.8, -1.0, Given::Pressure { at_level: 0.0, level: 0.3 })];
    fluid.open(ends, 1000).unwrap();
    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
    steps(&mut fluid, &mut clock, 3);
    let before = fluid.passed();
    assert_eq!(allocations(|| steps(&mut fluid, &mut clock, 150)), 0);
    let after = fluid.passed();
    assert!(after[0][0] > before[0][0] + 45 && after[1][1] > before[1][1] + 45, "{before:?} {after:?}");
}

/// Between two deals, which still water needs once in thousands of steps.
#[test]
fn a_step_of_two_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    for dimensions in [2, 3] {
        for xsph in [0.0, 0.3] {
            let least = together(2, |peers| {
                let size = [0.6, 0.4, 0.4];
                let formulation = Formulation { xsph, ..Formulation::default() };
                let parts = pool(dimensions, size, size, if dimensions == 2 { 0.02 } else { 0.05 });
                let mut fluid = Fluid::new(fluid_sph::Parts { formulation, ..parts }).unwrap();
                fluid.share(peers).unwrap();
                let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
                steps(&mut fluid, &mut clock, 3);
                allocations(|| steps(&mut fluid, &mut clock, 10))
            });
            assert_eq!(least.unwrap(), [0; 2], "{dimensions} dimensions, XSPH {xsph}");
        }
    }
}

/// The same with a thin structure that is put somewhere in each step, and whose impulses the water takes.
#[test]
fn a_step_of_two_about_a_structure_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    let points: Vec<[f64; 3]> =
        (0..20).flat_map(|j| [0.28, 0.32].map(|x| [x, 0.02 * f64::from(j) + 0.01, 0.0])).collect();
    let middle: Vec<[f64; 3]> = (0..20).map(|j| [0.3, 0.02 * f64::from(j) + 0.01, 0.0]).collect();
    let faces = (0..40).map(|k| if k % 2 == 0 { Face::Back } else { Face::Front }).collect();
    let thin = Some(ThinLayout { thickness: 0.06, faces, edges: vec![false; 20] });
    let layout = BoundaryLayout { points: 40, areas: vec![0.02; 40], thin };
    let state = BoundaryState { points, middle, normals: vec![[1.0, 0.0, 0.0]; 20] };
    let least = together(2, |peers| {
        let size = [0.6, 0.4, 0.4];
        let structures = vec![Structure { layout: layout.clone(), state: state.clone() }];
        let mut parts = pool(2, size, size, 0.02);
        parts.positions.retain(|at| (at.x - 0.3).abs() > 0.04);
        let mut fluid = Fluid::new(fluid_sph::Parts { structures, ..parts }).unwrap();
        fluid.share(peers).unwrap();
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
        let mut about = |count: usize| {
            for _ in 0..count {
                fluid.set_boundary(0, &state, &[[0.0; 3]; 40]);
                steps(&mut fluid, &mut clock, 1);
                fluid.apply_reactions(0, &[[1e-3, 0.0, 0.0]; 40]);
            }
            assert!(fluid.boundary_forces(0).iter().all(|force| force[0] != 0.0));
        };
        about(3);
        allocations(|| about(10))
    });
    assert_eq!(least.unwrap(), [0; 2]);
}
