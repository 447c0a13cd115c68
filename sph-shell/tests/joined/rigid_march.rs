//! Sets that are rigid, in time: momentum in free flight, energy, the stable step, the same bits, the static answer at rest.

use crate::common::{self, Y, at, energy_error, flat, free_shell, parts, records, supported, tee};
use explicit_dynamics::{
    Amplitude, Clock, Dynamics, Instant, MassScaled, Step, Transient, largest_eigenvalue,
};
use implicit_statics::{Newton, NewtonOptions};
use nalgebra::Matrix3;
use sph_core::{Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Formulation, Gravity, Load, Parts, Reach, RigidLoad, RigidSet, Shell, StaticShell,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICK: f64 = 0.1;

/// A heavy body on a patch of a plate, or round the joint of a tee, with three unlike moments of inertia.
fn set_on(cloud: &sph_core::Cloud) -> RigidSet {
    let particles = match cloud.joined.is_empty() {
        true => at(cloud, |x| x.x < 0.45 && x.y < 0.45),
        false => at(cloud, |x| x.x.abs() < 0.3 && x.z < 0.3),
    };
    let inertia = Matrix3::new(0.02, 0.004, 0.0, 0.004, 0.05, -0.003, 0.0, -0.003, 0.03);
    RigidSet { particles, at: Vec3::new(0.1, 0.3, -0.4), mass: 1.0, inertia, ..RigidSet::default() }
}

/// A free shell with that body that spins, drifts and shakes; its set.
fn thrown(cloud: sph_core::Cloud) -> (Shell, RigidSet) {
    let set = set_on(&cloud);
    let body = Shell::builder(parts(cloud, CELL, THICK));
    let mut body = body.rigid(vec![set.clone()]).build().unwrap();
    let (spin, drift) = (Vec3::new(0.9, -0.6, 1.5), Vec3::new(1.0, 0.5, -0.2));
    for a in 0..body.len() {
        let (x, d) = (body.position(a), body.director(a));
        let shake = if set.particles.contains(&(a as u32)) { 0.0 } else { 0.3 };
        body.set_rate(
            a,
            drift + spin.cross(&x) + Vec3::new(0.0, 0.0, shake * libm::sin(3.0 * x.y)),
            spin.cross(&d),
        );
    }
    (body, set)
}

/// What rectangles `a × b` of the set turn with beside their corners: `−m a²/6`, `−m b²/6` along their sides, and the inertia of
/// their directors by the thickness in place of the scaled one.
fn of_rigid_cells(body: &Shell, set: &RigidSet) -> Matrix3<f64> {
    let reference = body.reference();
    let cells = reference
        .cloud
        .cells
        .iter()
        .filter(|cell| cell.particles().iter().all(|a| set.particles.contains(a)));
    let of_cell = |cell: &sph_core::Cell| {
        let corners = cell.corners.map(|a| reference.cloud.positions[a as usize]);
        let (a, b) = (corners[1] - corners[0], corners[3] - corners[0]);
        let mass = common::DENSITY * THICK * a.cross(&b).norm();
        let excess = (a * a.transpose() + b * b.transpose()) * (mass / 6.0);
        let n = a.cross(&b).normalize();
        let scaled = cell.corners.map(|a| reference.inertias[a as usize] / reference.masses[a as usize]);
        let turning = mass * (THICK * THICK / 12.0 - scaled.iter().sum::<f64>() / 4.0);
        (Matrix3::identity() - n * n.transpose()) * turning + excess - Matrix3::identity() * excess.trace()
    };
    cells.map(of_cell).sum()
}

/// Momentum and moment of momentum: of the particles, whose directors of one sheet turn as the body does, and of the body's own mass.
fn momenta(body: &Shell, set: &RigidSet) -> (Vec3, Vec3) {
    let reference = body.reference();
    let mut sum = (0..body.len()).fold((Vec3::zeros(), Vec3::zeros()), |(p, l), a| {
        let (m, i) = (reference.masses[a], reference.inertias[a]);
        let v = body.velocity(a);
        let own = body.director(a).cross(&body.director_rate(a)) * i;
        (p + v * m, l + body.position(a).cross(&(v * m)) + own)
    });
    // Three particles of the set, no two in line with the third, tell its rotation and spin.
    let of = |k: usize| set.particles[k] as usize;
    let rest = |a: usize| reference.cloud.positions[a];
    let last = *set.particles.last().unwrap() as usize;
    let basis = |x: &dyn Fn(usize) -> Vec3, d: Vec3| {
        let e = x(last) - x(of(0));
        Matrix3::from_columns(&[d, e, d.cross(&e)])
    };
    let there = basis(&|a| body.position(a), body.director(of(0)));
    let here = basis(&rest, reference.cloud.frames[of(0)].n);
    let turn = there * here.try_inverse().unwrap();
    let (d, e) = (body.director(of(0)), body.position(last) - body.position(of(0)));
    let (v, w) = (body.director_rate(of(0)), body.velocity(last) - body.velocity(of(0)));
    let c = d.cross(&e);
    let spin = (d * w.dot(&c) - e * v.dot(&c) + c * v.dot(&e)) / c.norm_squared();
    let place = body.position(of(0)) + turn * (set.at - rest(of(0)));
    let speed = body.velocity(of(0)) + spin.cross(&(place - body.position(of(0))));
    sum.0 += speed * set.mass;
    let own = set.inertia + of_rigid_cells(body, set);
    sum.1 += place.cross(&(speed * set.mass)) + turn * own * turn.transpose() * spin;
    sum
}

#[test]
fn a_free_flight_keeps_momentum_moment_of_momentum_and_the_shape_of_the_body() {
    for cloud in [flat([8, 7], [1.0, 0.8]), tee(4, 1.0, 4)] {
        let joined = !cloud.joined.is_empty();
        let (mut body, set) = thrown(cloud);
        let arms = |body: &Shell| -> Vec<f64> {
            let x = |k: usize| body.position(set.particles[k] as usize);
            (1..set.particles.len()).map(|k| (x(k) - x(0)).norm()).collect()
        };
        let (start, before) = (momenta(&body, &set), arms(&body));
        let mut clock = Clock::start(&mut body, 1.0, 0.9, 0.0).unwrap();
        for _ in 0..2000 {
            clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        }
        let end = momenta(&body, &set);
        let (p, l) = ((end.0 - start.0).norm() / start.0.norm(), (end.1 - start.1).norm() / start.1.norm());
        let apart = arms(&body).iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let turned = body.director(set.particles[0] as usize).angle(&Vec3::z()).to_degrees();
        println!(
            "joined {joined}: linear {p:.1e}, angular {l:.1e}, shape {apart:.1e}, turned by {turned:.0}°"
        );
        // Round-off of 2000 steps. A joint inside the body is part of it.
        assert!(p < 1e-13 && l < 1e-12 && apart < 1e-14, "{p:.1e} {l:.1e} {apart:.1e}");
    }
}

#[test]
fn the_energy_error_of_a_free_flight_falls_with_the_square_of_the_step() {
    let errors = [0.8, 0.4, 0.2].map(|safety| energy_error(thrown(flat([8, 7], [1.0, 0.8])).0, safety));
    println!("{errors:?}");
    assert!(errors[1] < errors[0] / 3.0 && errors[2] < errors[1] / 3.0, "{errors:?}");
}

#[test]
fn a_rigid_set_shortens_no_step() {
    let omega = |mut body: Shell| largest_eigenvalue(&mut body, 120).ritz.sqrt();
    for thickness in [0.02, 0.5] {
        let free = omega(free_shell(flat([8, 7], [1.0, 0.8]), CELL, thickness));
        for mass in [0.0, 1.0] {
            let cloud = flat([8, 7], [1.0, 0.8]);
            let set = RigidSet { mass, inertia: Matrix3::identity() * mass, ..set_on(&cloud) };
            let body = Shell::builder(parts(cloud, CELL, thickness));
            let body = body.rigid(vec![set]).build().unwrap();
            let rigid = omega(body);
            println!("t = {thickness}, M = {mass}: free {free:.6e}, rigid {rigid:.6e}");
            assert!(rigid <= free * (1.0 + 1e-6), "{rigid} {free}");
        }
    }
}

fn cantilever(threads: usize) -> Shell {
    let cloud = flat([11, 5], [2.0, 0.8]);
    let clamp = supported(cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec(), Clamped);
    let set = RigidSet {
        particles: at(&cloud, |x| x.x > 1.5),
        at: Vec3::new(2.0, 0.3, 0.3),
        mass: 0.5,
        inertia: Matrix3::from_diagonal(&Vec3::new(0.02, 0.05, 0.03)),
        ..RigidSet::default()
    };
    let loads: Vec<Box<dyn Load>> = vec![
        Box::new(RigidLoad { set: 0, force: Vec3::new(0.02, 0.01, -0.05), couple: Y * 0.05 }),
        Box::new(Gravity { acceleration: Vec3::new(0.0, 0.0, -0.03) }),
    ];
    let loads = loads.into_iter().map(|load| AppliedLoad { load, amplitude: Amplitude::Constant }).collect();
    let body = Shell::builder(Parts { supports: vec![clamp], loads, threads, ..parts(cloud, CELL, 0.1) });
    body.rigid(vec![set]).build().unwrap()
}

#[test]
fn one_step_and_two_halves_give_the_same_bits() {
    let marched = |threads: usize, whole: bool| {
        let mut body = cantilever(threads);
        let dt = 1e-4;
        for number in 0..50 {
            let at = |number: f64| Instant { time: number * dt, level: 1.0 };
            let number = f64::from(number);
            let step = Step { from: at(number), to: at(number + 1.0), kick: dt, damping: 0.3 };
            if whole {
                body.advance(&step);
            } else {
                body.evaluate(step.from);
                body.kick(&step);
                body.drift(&step);
            }
        }
        body.motion().into_iter().flatten().flatten().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    let one = marched(1, true);
    assert!(one == marched(1, false) && one == marched(3, true));
}

#[test]
fn a_damped_march_comes_to_rest_where_newton_does() {
    let mut body = cantilever(1);
    let run = Transient { duration: 400.0, record_every: 50.0, damping: 0.5, safety: 0.9 };
    records(run, &mut body).unwrap();
    let mut lack = vec![0.0; 6 * body.len()];
    body.out_of_balance(&mut lack);
    let mut system = StaticShell::new(cantilever(1));
    let options = NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    for level in 1..=10 {
        newton.at_level(&mut system, 0.1 * f64::from(level)).unwrap();
    }
    let tip = body.len() - 1;
    let apart =
        (0..body.len()).map(|a| (body.position(a) - system.shell().position(a)).norm()).fold(0.0, f64::max);
    let moved = body.displacement(tip).norm();
    let left = lack.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    println!("moved {moved:.3}, apart {apart:.1e}, out of balance {left:.1e}");
    assert!(moved > 0.1 && apart < 1e-11 * moved, "{moved} {apart:.1e}");
}
