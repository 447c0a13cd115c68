//! The same bits for 1, 2 and 4 threads, and no allocation inside a step.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use std::alloc::System;
use std::sync::Mutex;

use common::{energy_formulations, flat};
use explicit_dynamics::{Clock, Dynamics};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cloud, CubicSpline, Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, CoupleAxis, Divergence, EdgeCouple, Formulation, Gravity, Parts, Pressure, Reach,
    Shell, Supported,
};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Tests of this file run one at a time: the counter belongs to the whole process.
static ALONE: Mutex<()> = Mutex::new(());

/// A plate large enough for several chunks of particles and packs, with a load of every kind.
fn body(formulation: Formulation, threads: usize) -> Shell {
    let cloud = flat([27, 23], [2.0, 1.5]);
    let sides = cloud.sides.clone().unwrap();
    let edge = sides.edge(Side::U1).iter().map(|&a| (a, cloud.edge_lengths[a as usize])).collect();
    let applied = |load| AppliedLoad { load, amplitude: explicit_dynamics::Amplitude::Ramp(0.1) };
    let loads = vec![
        applied(Box::new(EdgeCouple { edge, moment: 0.003, axis: CoupleAxis::Edge })),
        applied(Box::new(Pressure { value: 0.001, follower: true })),
        applied(Box::new(Gravity { acceleration: Vec3::new(0.0, 0.003, -0.01) })),
    ];
    let supports = vec![Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) }];
    Shell::builder(Parts {
        cloud,
        section: Box::new(IsotropicSection::new(Isotropic::new(1200.0, 0.3).unwrap(), 0.05).unwrap()),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports,
        loads,
        threads,
    })
    .build()
    .unwrap()
}

/// Positions and energies after some steps, as bits.
fn bits(formulation: Formulation, threads: usize) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut shell = body(formulation, threads);
        let mut clock = Clock::start(&mut shell, 1.0, 0.7, 0.01).unwrap();
        for _ in 0..60 {
            clock.step(&mut shell, f64::INFINITY, |_| 1.0).unwrap();
        }
        let energy = shell.evaluate(clock.now);
        let mut out: Vec<u64> = (0..shell.len())
            .flat_map(|a| shell.position(a).iter().map(|x| x.to_bits()).collect::<Vec<_>>())
            .collect();
        out.push(energy.to_bits());
        out.push(clock.kinetic.to_bits());
        out
    })
}

#[test]
fn threads_do_not_change_a_bit() {
    let _alone = ALONE.lock().unwrap();
    let strong = |divergence| Formulation::StrongForm {
        smoothing: 1.2,
        viscosity: 1.0,
        divergence,
        kernel: &CubicSpline,
    };
    let all = energy_formulations().into_iter().chain([
        ("strong-form", strong(Divergence::Sum)),
        ("strong-form, difference", strong(Divergence::Difference)),
    ]);
    for (name, formulation) in all {
        let one = bits(formulation, 1);
        for threads in [2, 4] {
            assert!(bits(formulation, threads) == one, "{name}: {threads} threads give other bits");
        }
    }
}

/// Ends a run of 40 steps, all recorded or none.
fn recorded(cloud: Cloud, every: bool) -> Vec<[u64; 6]> {
    let mut shell = common::free_shell(cloud, Formulation::StressPoint(Reach::Cell), 0.05);
    for a in 0..shell.len() {
        let x = shell.position(a);
        shell.set_rate(a, Vec3::new(x.y, 0.3 * x.z - x.x, x.x * x.y) * 0.1, Vec3::new(0.1, x.x, 0.0));
    }
    let mut clock = Clock::start(&mut shell, 1.0, 0.7, 0.01).unwrap();
    for _ in 0..40 {
        if every {
            clock.recorded_step(&mut shell).unwrap();
        } else {
            clock.step(&mut shell, f64::INFINITY, |_| 1.0).unwrap();
        }
    }
    (0..shell.len())
        .map(|a| {
            let (x, d) = (shell.position(a), shell.director(a));
            [x.x, x.y, x.z, d.x, d.y, d.z].map(f64::to_bits)
        })
        .collect()
}

#[test]
fn one_sweep_and_two_passes_give_the_same_bits() {
    // A step without a record runs in one fused sweep, a recorded one in two passes with a stop between.
    let _alone = ALONE.lock().unwrap();
    for cloud in [
        flat([27, 23], [2.0, 1.5]),
        common::disordered_curved([24, 31]),
        common::curved([5, 4]),
        common::scattered_curved(0.1),
    ] {
        assert!(recorded(cloud.clone(), false) == recorded(cloud, true));
    }
}

/// Allocations of 200 steps after a few to warm up.
fn allocations(threads: usize, mut shell: Shell) -> usize {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let mut clock = Clock::start(&mut shell, 1.0, 0.7, 0.01).unwrap();
        let mut march = |steps: usize| {
            for _ in 0..steps {
                clock.step(&mut shell, f64::INFINITY, |_| 1.0).unwrap();
            }
        };
        march(20);
        let region = Region::new(ALLOCATOR);
        march(200);
        region.change().allocations
    })
}

/// Peers too, whose shells are a plate under loads, one that yields, and a frame. The watch every 64 steps copies the state.
#[test]
fn a_step_of_peers_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    let cells = Formulation::StressPoint(Reach::Cell);
    let frame = || Shell::builder(common::parts(common::tee(12, 1.0, 40), cells, 0.1)).build().unwrap();
    let shells: [&(dyn Fn() -> Shell + Sync); 2] = [&|| body(cells, 1), &frame];
    for build in shells {
        let counted = peers::together(2, |peers| {
            let mut shell = build();
            shell.share(peers).unwrap();
            let mut clock = Clock::start(&mut shell, 1.0, 0.7, 0.01).unwrap();
            let mut march = |steps: usize| {
                for _ in 0..steps {
                    clock.step(&mut shell, f64::INFINITY, |_| 1.0).unwrap();
                }
            };
            march(20);
            let region = Region::new(ALLOCATOR);
            march(200);
            region.change().allocations
        });
        let counted = counted.unwrap();
        assert!(counted.iter().all(|counted| *counted < 30), "{counted:?} allocations in 200 steps");
    }
}

#[test]
fn a_step_allocates_nothing() {
    let _alone = ALONE.lock().unwrap();
    for threads in [1, 2] {
        // The test harness itself may allocate on its own thread now and then; a step that did would count 200.
        let cells = Formulation::StressPoint(Reach::Cell);
        let sheets = Parts { threads, ..common::parts(common::tee(5, 1.0, 5), cells, 0.1) };
        for shell in [body(cells, threads), Shell::builder(sheets).build().unwrap()] {
            let counted = allocations(threads, shell);
            assert!(counted < 20, "{counted} allocations in 200 steps on {threads} threads");
        }
    }
}
