//! The shell under way: energy, momentum, the stable step, reactions, supports.

use crate::common::{curved, energy_formulations, flat, free_shell, records, shell};
use explicit_dynamics::{
    Clock, Damping, Dynamics, Instant, MarchError, QuasiStatic, Transient, largest_eigenvalue,
};
use shell_kinematics::StretchCorrected;
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, Formulation, Hinged, Load, Moved, Reach, Shell, Supported, SymmetryPlane};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// A clamped strip that starts with a velocity across its plane, growing along it.
fn plucked(formulation: Formulation) -> Shell {
    let cloud = flat([13, 4], [4.0, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let supports = vec![Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) }];
    let mut body = shell(cloud, formulation, 0.3, &StretchCorrected, supports, Vec::new());
    for a in 0..body.len() {
        let x = body.position(a).x / 4.0;
        body.set_rate(a, Vec3::new(0.0, 0.0, 2.0 * x * x), Vec3::zeros());
    }
    body
}

/// Largest energy error over `duration`, in parts of the first energy.
fn energy_error(formulation: Formulation, safety: f64, duration: f64) -> f64 {
    let mut body = plucked(formulation);
    let run = Transient { duration, record_every: duration / 200.0, damping: 0.0, safety };
    let records = records(run, &mut body).unwrap();
    let start = records[0].energy.kinetic;
    records.iter().fold(0.0, |worst: f64, r| worst.max(r.balance_error.abs())) / start
}

#[test]
fn undamped_energy_error_is_bounded_and_falls_with_the_square_of_the_step() {
    // T1 = 2π L²/3.516 √(ρ·12/(E t²)) = 11.7 for the strip: ten periods.
    let duration = 117.0;
    for (name, formulation) in energy_formulations() {
        let (coarse, fine) =
            (energy_error(formulation, 0.4, duration), energy_error(formulation, 0.2, duration));
        println!("{name}: {coarse:.2e} at 0.4, {fine:.2e} at 0.2 of the limit");
        assert!(coarse <= 1e-3, "{name}: {coarse:.2e}");
        // Order two: a quarter; a third leaves room for the phase in which the records fall.
        assert!(fine < coarse / 3.0, "{name}: {fine:.2e} against {coarse:.2e}");
    }
}

#[test]
fn free_flight_keeps_momentum_and_moment_of_momentum() {
    let mut body = free_shell(curved([7, 6]), CELL, 0.2);
    let spin = Vec3::new(0.2, -0.1, 0.4);
    let drift = Vec3::new(1.0, 0.5, -0.2);
    for a in 0..body.len() {
        let (x, d) = (body.position(a), body.director(a));
        body.set_rate(
            a,
            drift + spin.cross(&x) + Vec3::new(0.0, 0.0, 0.3 * libm::sin(3.0 * x.y)),
            spin.cross(&d),
        );
    }
    // Velocities live half a step before positions: with the half kick undone, both are known at one time.
    let momenta = |body: &Shell| {
        let reference = body.reference();
        (0..body.len()).fold((Vec3::zeros(), Vec3::zeros()), |(p, l), a| {
            let (m, i) = (reference.masses[a], reference.inertias[a]);
            let v = body.velocity(a);
            (
                p + v * m,
                l + body.position(a).cross(&(v * m)) + body.director(a).cross(&body.director_rate(a)) * i,
            )
        })
    };
    let start = momenta(&body);
    let mut clock = Clock::start(&mut body, 1.0, 0.5, 0.0).unwrap();
    for _ in 0..2000 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let end = momenta(&body);
    let (p, l) = ((end.0 - start.0).norm() / start.0.norm(), (end.1 - start.1).norm() / start.1.norm());
    println!("linear {p:.1e}, angular {l:.1e}");
    // Central forces act at the positions of the kick: x × v is kept by kick and by drift, up to round-off.
    assert!(p < 1e-12 && l < 1e-11, "linear {p:.1e}, angular {l:.1e}");
}

#[test]
fn a_step_beyond_the_limit_diverges_and_names_a_particle() {
    let mut body = plucked(CELL);
    let run = Transient { duration: 50.0, record_every: 1.0, damping: 0.0, safety: 1.1 };
    match records(run, &mut body) {
        Err(MarchError::Diverged { particle, time, speed, bound, last_good, .. }) => {
            assert!(particle < body.len() && time > 0.0 && speed > bound);
            assert!(speed.is_finite(), "found before it was lost in the unbounded");
            assert!(last_good.is_some_and(|good| good.at.time <= time));
        }
        other => panic!("ran on: {other:?}"),
    }
    // Just below the limit it holds.
    let mut sound = plucked(CELL);
    let run = Transient { safety: 0.95, duration: 20.0, record_every: 1.0, damping: 0.0 };
    records(run, &mut sound).unwrap();
}

#[test]
fn stable_step_does_not_collapse_with_thickness() {
    // Measured: Δt c/Δ = 0.95 … 1.0 with scaled rotary inertia, 0.107 without at Δ/t = 10.
    for thickness in [0.1, 0.01, 0.001] {
        let mut body = free_shell(flat([11, 11], [1.0, 1.0]), CELL, thickness);
        let spectrum = largest_eigenvalue(&mut body, 40);
        let scaled = 2.0 / spectrum.bound().sqrt() * body.reference().sound_speed / 0.1;
        println!("t = {thickness}: {scaled:.3}");
        assert!((0.9..1.1).contains(&scaled), "t = {thickness}: {scaled}");
    }
}

#[test]
fn quasi_static_load_and_reaction_balance() {
    let cloud = flat([7, 4], [2.0, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let (clamp, tip) = (sides.edge(Side::U0).to_vec(), sides.edge(Side::U1).to_vec());
    let force = Vec3::new(0.3, 0.0, 0.2);
    let shares = tip.iter().map(|&a| (a, cloud.edge_lengths[a as usize])).collect();
    let loads: Vec<Box<dyn Load>> = vec![Box::new(Force { shares, total: force })];
    let supports = vec![Supported { particles: clamp.clone(), support: Box::new(Clamped) }];
    let mut body = shell(cloud, CELL, 0.2, &StretchCorrected, supports, loads);
    let path = QuasiStatic {
        levels: vec![1.0],
        period: Some(5.0),
        ramp: 2.0,
        hold: 20.0,
        damping: Damping::Ratio(1.0),
        tolerance: 1e-16,
        accuracy: 5e-3,
        safety: 0.8,
    };
    let records = records(path, &mut body).unwrap();
    body.evaluate(Instant { time: 0.0, level: 1.0 });
    let reaction: Vec3 = clamp.iter().map(|&a| body.reaction(a as usize)).sum();
    let last = records.last().unwrap();
    assert!(last.settled);
    assert!((reaction + force).norm() < 1e-6 * force.norm(), "{reaction} against {force}");
    assert!(last.balance_error.abs() < 1e-5 * last.energy.external, "{last:?}");
}

#[test]
fn kinetic_damping_finds_the_same_rest() {
    let settle = |damping| {
        let cloud = flat([9, 4], [2.0, 1.0]);
        let sides = cloud.sides.clone().unwrap();
        let supports = vec![
            Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) },
            Supported {
                particles: sides.edge(Side::U1).to_vec(),
                support: Box::new(Moved {
                    direction: Vec3::z(),
                    by: 0.5,
                    amplitude: explicit_dynamics::Amplitude::Constant,
                }),
            },
        ];
        let mut body = shell(cloud, CELL, 0.2, &StretchCorrected, supports, Vec::new());
        let path = QuasiStatic {
            levels: vec![0.5, 1.0],
            period: Some(2.0),
            ramp: 2.0,
            hold: 40.0,
            damping,
            tolerance: 1e-13,
            accuracy: 5e-3,
            safety: 0.8,
        };
        let records = records(path, &mut body).unwrap();
        assert!(records.last().unwrap().settled);
        records.last().unwrap().energy.internal
    };
    let (mass, kinetic) = (settle(Damping::Ratio(1.0)), settle(Damping::Kinetic));
    assert!((mass / kinetic - 1.0).abs() < 1e-6, "{mass} against {kinetic}");
}

#[test]
fn supports_hold_what_they_name() {
    let cloud = flat([6, 5], [1.0, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let supports = vec![
        Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) },
        Supported { particles: sides.edge(Side::U1).to_vec(), support: Box::new(Hinged) },
        Supported {
            particles: sides.edge(Side::V0).to_vec(),
            support: Box::new(SymmetryPlane { normal: Vec3::y() }),
        },
    ];
    let mut body = shell(cloud, CELL, 0.1, &StretchCorrected, supports, Vec::new());
    for a in 0..body.len() {
        body.set_rate(a, Vec3::new(0.1, 0.2, 0.5), Vec3::new(0.3, 0.4, 0.0));
    }
    let mut clock = Clock::start(&mut body, 1.0, 0.6, 0.0).unwrap();
    for _ in 0..300 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    for &a in sides.edge(Side::U0) {
        assert_eq!(body.displacement(a as usize), Vec3::zeros());
        assert_eq!(body.director(a as usize), Vec3::z());
    }
    for &a in sides.edge(Side::U1) {
        assert_eq!(body.displacement(a as usize), Vec3::zeros());
    }
    let rotated = sides.edge(Side::U1).iter().any(|&a| body.director(a as usize) != Vec3::z());
    assert!(rotated, "a hinge lets directors turn");
    for &a in sides.edge(Side::V0) {
        assert!(body.displacement(a as usize).y == 0.0 && body.director(a as usize).y.abs() < 1e-15);
    }
}
