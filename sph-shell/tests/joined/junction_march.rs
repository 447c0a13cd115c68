//! Sheets that meet along a line, in time: momentum, energy, the stable step, the same bits, the static answer at rest.

use crate::common::{Sheets, X, Y, Z, at, energy_error, free_shell, line, parts, shell, supported, tee};
use explicit_dynamics::{Amplitude, Clock, Dynamics, Instant, MassScaled, Step, largest_eigenvalue};
use implicit_statics::{Newton, NewtonOptions};
use shell_kinematics::StretchCorrected;
use sph_core::Vec3;
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Parts, Reach, Rotated, Shell, StaticShell, SymmetryPlane,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// A free tee that spins, drifts and shakes.
fn thrown() -> Shell {
    let mut body = free_shell(tee(4, 1.0, 4), CELL, 0.1);
    let (spin, drift) = (Vec3::new(0.3, -0.2, 0.5), Vec3::new(1.0, 0.5, -0.2));
    for a in 0..body.len() {
        let (x, d) = (body.position(a), body.director(a));
        body.set_rate(
            a,
            drift + spin.cross(&x) + Vec3::new(0.0, 0.2 * x.x, 0.3 * libm::sin(3.0 * x.y)),
            spin.cross(&d),
        );
    }
    body
}

#[test]
fn free_flight_keeps_momentum_moment_of_momentum_and_right_angles() {
    let mut body = thrown();
    let joined = body.reference().cloud.joined.clone();
    let momenta = |body: &Shell| {
        let reference = body.reference();
        let mut sum = (0..body.len()).fold((Vec3::zeros(), Vec3::zeros()), |(p, l), a| {
            let (m, i) = (reference.masses[a], reference.inertias[a]);
            let v = body.velocity(a);
            let own = if joined.iter().flatten().any(|&b| b as usize == a) {
                Vec3::zeros()
            } else {
                body.director(a).cross(&body.director_rate(a)) * i
            };
            (p + v * m, l + body.position(a).cross(&(v * m)) + own)
        });
        for group in &joined {
            // ω from two directors at right angles, the spin of one number I for all.
            let [a, b] = [group[0], group[1]].map(|a| a as usize);
            let (d, e) = (body.director(a), body.director(b));
            let (v, w) = (body.director_rate(a), body.director_rate(b));
            let c = d.cross(&e);
            let spin = d * w.dot(&c) - e * v.dot(&c) + c * v.dot(&e);
            sum.1 += spin * group.iter().map(|&a| reference.inertias[a as usize]).sum::<f64>();
        }
        sum
    };
    let start = momenta(&body);
    let mut clock = Clock::start(&mut body, 1.0, 0.9, 0.0).unwrap();
    for _ in 0..2000 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let end = momenta(&body);
    let (p, l) = ((end.0 - start.0).norm() / start.0.norm(), (end.1 - start.1).norm() / start.1.norm());
    let right = joined.iter().map(|group| {
        let [d, e] = [group[0], group[1]].map(|a| body.director(a as usize));
        d.dot(&e).abs()
    });
    let right = right.fold(0.0, f64::max);
    let turned = body.director(0).angle(&Z).to_degrees();
    println!("linear {p:.1e}, angular {l:.1e}, right angles {right:.1e}, turned by {turned:.0}°");
    assert!(p < 1e-12 && l < 1e-12 && right < 1e-12, "{p:.1e} {l:.1e} {right:.1e}");
}

#[test]
fn the_energy_error_of_a_free_flight_falls_with_the_square_of_the_step() {
    let errors = [0.8, 0.4, 0.2].map(|safety| energy_error(thrown(), safety));
    println!("{errors:?}");
    assert!(errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0, "{errors:?}");
}

#[test]
fn tying_raises_no_frequency() {
    let omega = |mut body: Shell| largest_eigenvalue(&mut body, 120).ritz.sqrt();
    for (thickness, fold) in [(0.02, 90.0), (0.5, 90.0), (0.02, 1.0_f64)] {
        let leg = |n: usize| Sheets::default().add(Vec3::zeros(), [X, Y], [n, n]).cloud();
        let sheets =
            omega(free_shell(leg(4), CELL, thickness)).max(omega(free_shell(leg(6), CELL, thickness)));
        let fold = fold.to_radians();
        let tied = Sheets::default()
            .add(Vec3::zeros(), [X, Y], [6, 4])
            .add(X, [X * libm::cos(fold) + Z * libm::sin(fold), Y], [4, 4])
            .cloud();
        let tied = omega(free_shell(tied, CELL, thickness));
        println!("t = {thickness}: sheets {sheets:.6e}, tied {tied:.6e}");
        assert!(tied <= sheets * (1.0 + 1e-6), "{tied} {sheets}");
    }
}

/// A frame under a load: kick and drift one after the other, or in one go, with any threads, are the same bits.
#[test]
fn one_step_and_two_halves_give_the_same_bits() {
    let marched = |threads: usize, whole: bool| {
        let cloud = tee(4, 1.0, 4);
        let clamp = supported(at(&cloud, |x| x.x < -0.99), Clamped);
        let tip = at(&cloud, |x| x.z > 0.99).into_iter().map(|a| (a, 1.0)).collect();
        let force = Force { shares: tip, total: Vec3::new(1.0, 0.4, -0.3) };
        let applied = AppliedLoad { load: Box::new(force), amplitude: Amplitude::Constant };
        let mut body = Shell::builder(Parts {
            supports: vec![clamp],
            loads: vec![applied],
            threads,
            ..parts(cloud, CELL, 0.1)
        })
        .build()
        .unwrap();
        let dt = 0.5 * body.stable_step(1.0).unwrap().dt;
        let mut bits = Vec::new();
        for number in 0..20 {
            let at = |n: i32| Instant { time: dt * f64::from(n), level: 1.0 };
            let step = Step { from: at(number), to: at(number + 1), kick: dt, damping: 0.1 };
            let work = if whole {
                body.advance(&step)
            } else {
                body.evaluate(step.from);
                let work = body.kick(&step);
                body.drift(&step);
                work
            };
            bits.extend([work.kinetic, work.external, work.dissipated].map(f64::to_bits));
        }
        bits.extend(body.motion().into_iter().flatten().flatten().map(|x| x.to_bits()));
        bits
    };
    let expected = marched(1, true);
    assert!(expected == marched(1, false), "two halves");
    assert!(expected == marched(2, true), "two threads");
}

/// The joint of a tee turned by its support about y, half of it cut off by a symmetry plane: in time and without.
#[test]
fn a_march_turns_a_joint_as_newton_does_and_books_its_work() {
    let make = || {
        let cloud = tee(3, 0.5, 2);
        let joint = at(&cloud, |x| x.x.abs() < 1e-9 && x.z < 1e-9);
        let supports = vec![
            supported(at(&cloud, |x| x.x.abs() > 0.99), Clamped),
            supported(at(&cloud, |x| x.y < 1e-9), SymmetryPlane { normal: Y }),
            supported(joint, Rotated { axis: Y, by: 0.4, amplitude: Amplitude::Constant }),
        ];
        shell(cloud, CELL, 0.1, &StretchCorrected, supports, Vec::new())
    };
    let mut system = StaticShell::new(make());
    let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
    for step in 1..=8 {
        newton.at_level(&mut system, f64::from(step) / 8.0).unwrap();
    }
    let mut body = make();
    let dt = 0.7 * body.stable_step(1.0).unwrap().dt;
    let (mut spent, mut time) = (0.0, 0.0);
    while time < 60.0 {
        // A ramp that begins and ends gently.
        let level = |time: f64| {
            let s = (time / 20.0).min(1.0);
            s * s * (3.0 - 2.0 * s)
        };
        let at = |time: f64| Instant { time, level: level(time) };
        let work = body.advance(&Step { from: at(time), to: at(time + dt), kick: dt, damping: 0.6 });
        spent += work.external - work.dissipated;
        time += dt;
    }
    let off = (0..body.len()).map(|a| {
        let there = system.shell();
        (body.position(a) - there.position(a)).norm() + (body.director(a) - there.director(a)).norm()
    });
    let off = off.fold(0.0, f64::max);
    body.evaluate_internal(true);
    let lost = spent / body.stored_energy() - 1.0;
    println!("off by {off:.1e}, work {lost:.1e} more than the energy stored");
    assert!(off < 1e-6 && lost.abs() < 3e-3, "{off:.1e} {lost:.1e}");
}

#[test]
fn a_march_settles_where_newton_finds_the_balance() {
    let make = || {
        let cloud = tee(3, 0.5, 1);
        let clamp = supported(at(&cloud, |x| x.x.abs() > 0.99), Clamped);
        let tip = at(&cloud, |x| x.z > 0.99);
        let force = Force { shares: line(&cloud, &tip), total: Vec3::new(0.01, 0.0, 0.0) };
        shell(cloud, CELL, 0.1, &StretchCorrected, vec![clamp], vec![Box::new(force)])
    };
    let mut system = StaticShell::new(make());
    Newton::new(&system, &NewtonOptions::default()).unwrap().at_level(&mut system, 1.0).unwrap();
    let mut body = make();
    let mut clock = Clock::start(&mut body, 1.0, 0.8, 0.25).unwrap();
    while clock.now.time < 200.0 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let off =
        (0..body.len()).map(|a| (body.position(a) - system.shell().position(a)).norm()).fold(0.0, f64::max);
    let moved = (0..body.len()).map(|a| body.displacement(a).norm()).fold(0.0, f64::max);
    println!("moved {moved:.3}, off by {off:.1e}");
    assert!(moved > 0.05 && off < 1e-9 * moved, "{moved} {off:.1e}");
    let rates: &mut Vec<f64> = &mut vec![0.0; 6 * body.len()];
    body.rates(rates);
    assert!(rates.iter().all(|rate| rate.abs() < 1e-6));
}
