//! Stiffened shells in time: momentum and energy of a free flight, the stable step, the same bits for any number of processes and threads.

use crate::common::{DENSITY, YOUNG, curved, energy_error, momenta, parts, records};
use crate::shared::{plans, reported, shared};
use explicit_dynamics::{Clock, Dynamics, Transient};
use peers::together;
use shell_kinematics::BarSection;
use sph_core::Vec3;
use sph_shell::{Formulation, InSurface, Parts, Reach, Shell, Stiffener};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);

/// A curved sheet with two bars that cross, at a height, so thrown that it turns and bends.
fn thrown(counts: [usize; 2], threads: usize) -> Shell {
    let cloud = curved(counts);
    let lattice = cloud.lattice.unwrap();
    let section = BarSection::rectangle([YOUNG, 0.4 * YOUNG], 0.1, 0.3);
    // Bending in the surface as of a flat bar, .3 wide and .1 high.
    let in_surface = Some(InSurface { bending: YOUNG * 0.1 * 0.027 / 12.0, held: Vec::new() });
    let bar = |particles, height| {
        let (mass, in_surface) = (0.03 * DENSITY, in_surface.clone());
        Stiffener { particles, section, height, mass, in_surface }
    };
    let bars = vec![bar(lattice.column(counts[0] / 2), 0.25), bar(lattice.row(2), -0.25)];
    let parts = Parts { threads, ..parts(cloud, CELLS, 0.2) };
    let mut body = Shell::builder(parts).stiffeners(bars).build().unwrap();
    let spin = Vec3::new(0.3, -0.2, 0.5);
    for a in 0..body.len() {
        let (x, d) = (body.position(a), body.director(a));
        let bend = Vec3::new(0.0, 0.0, 0.5 * x.x * x.x);
        body.set_rate(a, spin.cross(&x) + bend, spin.cross(&d));
    }
    body
}

/// Momentum is kept to rounding, moment of momentum too: forces and couples of a bar cancel.
#[test]
fn a_free_flight_keeps_momentum_and_moment_of_momentum() {
    let mut body = thrown([9, 8], 1);
    let (before, _) = momenta(&body);
    let mut clock = Clock::start(&mut body, 1.0, 0.5, 0.0).unwrap();
    for _ in 0..2000 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let (after, sizes) = momenta(&body);
    let lost = [0, 1].map(|k| (after[k] - before[k]).norm() / sizes[k]);
    println!("{lost:?}");
    assert!(lost[0] < 3e-14 && lost[1] < 3e-13, "{lost:?}");
}

/// Of the second order: half the step leaves a quarter of the error.
#[test]
fn the_energy_error_falls_with_the_square_of_the_step() {
    let [coarse, fine] = [0.4, 0.2].map(|safety| energy_error(thrown([9, 8], 1), safety));
    println!("{coarse:.2e} {fine:.2e}");
    assert!(coarse < 1e-3 && fine < coarse / 3.0, "{coarse:.2e} {fine:.2e}");
}

/// The step that is found holds: a march at .95 of it neither gains energy nor breaks off.
#[test]
fn the_stable_step_knows_the_bars() {
    let mut body = thrown([9, 8], 1);
    let plain = Shell::builder(parts(curved([9, 8]), CELLS, 0.2)).build();
    let [stiff, free] = [body.stable_step(1.0).unwrap().dt, plain.unwrap().stable_step(1.0).unwrap().dt];
    println!("{stiff:.3e} with bars, {free:.3e} without");
    assert!(stiff < free && stiff > 0.4 * free, "{stiff} {free}");
    let run = Transient { duration: 3.0, record_every: 0.5, damping: 0.0, safety: 0.95 };
    let all = records(run, &mut body).unwrap();
    let start = all[0].energy.kinetic + all[0].energy.internal;
    assert!(all.iter().all(|record| record.balance_error.abs() < 0.05 * start));
}

#[test]
fn processes_and_threads_do_not_change_a_bit() {
    for plan in plans() {
        let alone = reported(&plan, thrown([40, 21], 1));
        assert!(reported(&plan, thrown([40, 21], 2)) == alone, "threads");
        for count in [2, 3] {
            let all = together(count, |peers| reported(&plan, shared(thrown([40, 21], 1), peers))).unwrap();
            assert!(all.into_iter().all(|found| found == alone), "{count} peers");
        }
    }
}
