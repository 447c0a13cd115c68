//! Rigid bodies in time: free tops, gravity, supports, springs.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use explicit_dynamics::{Amplitude, Dynamics, Instant, Joinable};
use nalgebra::Matrix3;
use rigid_body::{Load, MassProperties, Parts, RigidBody, RotationHold, Spring, Support, cuboid};
use sph_core::Vec3;

/// A block of unlike edges along the axes about the origin.
fn parts() -> Parts {
    let outline = cuboid([-0.5, -1.0, -1.5], [0.5, 1.0, 1.5], 1.0);
    let mass = outline.filled(2.0).unwrap();
    Parts { outline, mass, supports: Vec::new(), loads: Vec::new(), springs: Vec::new() }
}

/// Kinetic energy.
fn energy(body: &RigidBody) -> f64 {
    let v = body.velocity(body.centre() as usize);
    0.5 * (body.mass() * v.norm_squared() + body.spin().dot(&body.moment_of_momentum()))
}

fn march(body: &mut RigidBody, duration: f64, dt: f64, mut seen: impl FnMut(&RigidBody)) {
    let steps = (duration / dt).round() as usize;
    for number in 0..steps {
        let at = |step: usize| Instant { time: step as f64 * dt, level: 1.0 };
        // Velocities are those of the middle of a step: the first kick spans a half of one.
        let kick = if number == 0 { 0.5 * dt } else { dt };
        let step = explicit_dynamics::Step { from: at(number), to: at(number + 1), kick, damping: 0.0 };
        body.evaluate(step.from);
        body.kick(&step);
        body.drift(&step);
        seen(body);
    }
}

/// Jacobian elliptic functions sn, cn, dn by descending Landen transformations (Abramowitz and Stegun 16.4).
fn jacobi(u: f64, m: f64) -> [f64; 3] {
    let (mut a, mut c) = (vec![1.0], vec![m.sqrt()]);
    let mut b = (1.0 - m).sqrt();
    for n in 0..12 {
        let (mean, half) = (0.5 * (a[n] + b), 0.5 * (a[n] - b));
        b = (a[n] * b).sqrt();
        a.push(mean);
        c.push(half);
    }
    let mut phi = 4096.0 * a[12] * u;
    let mut before = phi;
    for n in (1..=12).rev() {
        before = phi;
        phi = 0.5 * (phi + libm::asin(c[n] / a[n] * libm::sin(phi)));
    }
    let (sin, cos) = libm::sincos(phi);
    [sin, cos, cos / libm::cos(before - phi)]
}

/// Euler's top with three unlike moments over five of its periods, against the closed form in elliptic functions: moment of momentum to the last
/// bit, the energy within 1.5e-5 without a trend, the spin in the body with the square of the step.
#[test]
fn a_free_top_keeps_its_moment_of_momentum_and_its_energy_and_follows_euler() {
    // J3 > J2 > J1: the block is longest along z, so that the moments descend from x to z.
    let start = Vec3::new(1.0, 0.0, 1.2);
    let duration = 12.0;
    let errors = [0.02, 0.01].map(|dt| {
        let mut body = RigidBody::new(parts()).unwrap();
        let [j1, j2, j3] = <[f64; 3]>::from(body.moments());
        assert!(j1 > j2 && j2 > j3);
        body.set_out(&Vec3::new(0.3, 0.2, -0.1), &start);
        let (momentum, whole) = (body.moment_of_momentum(), energy(&body));
        let (square, twice) = (momentum.norm_squared(), momentum.dot(&start));
        // 2E J2 < L²: about the axis of the greatest moment cn, about the middle one sn, about the least dn exchange with the other sign.
        let (mut worst, mut drift) = (0.0_f64, 0.0_f64);
        let mut number = 0;
        march(&mut body, duration, dt, |body| {
            number += 1;
            assert_eq!(body.moment_of_momentum(), momentum);
            drift = drift.max((energy(body) / whole - 1.0).abs());
            let t = dt * f64::from(number);
            let of_least = square < twice * j2;
            // In the order in which Landau and Lifshitz, §37, write them: I3 > I2 > I1 and L² > 2E I2, or with 1 and 3 exchanged.
            let [i1, i2, i3] = if of_least { [j1, j2, j3] } else { [j3, j2, j1] };
            let rate = ((i3 - i2) * (square - twice * i1) / (i1 * i2 * i3)).abs().sqrt();
            let m = ((i2 - i1) * (twice * i3 - square) / ((i3 - i2) * (square - twice * i1))).abs();
            let [_, cn, dn] = jacobi(rate * t, m);
            let one = ((twice * i3 - square) / (i1 * (i3 - i1))).abs().sqrt() * cn;
            let three = ((square - twice * i1) / (i3 * (i3 - i1))).abs().sqrt() * dn;
            let exact = if of_least { [one, three] } else { [three, one] };
            // Axes of the body from two vertices that lie along them at rest.
            let (rest, now) = (body.rest(), body.positions());
            let axes = [Vec3::x(), Vec3::z()].map(|axis| {
                let along =
                    |x: &Vec3| (x - rest[0]).cross(&axis).norm() < 1e-12 && (x - rest[0]).dot(&axis) > 0.1;
                let other = rest.iter().position(along).unwrap();
                (now[other] - now[0]).normalize()
            });
            for k in 0..2 {
                worst = worst.max((body.spin().dot(&axes[k]) - exact[k]).abs());
            }
        });
        assert!(drift < 3.0 * 1.5e-5 * (dt / 0.01).powi(2), "{drift:e} at {dt}");
        worst
    });
    let order = libm::log2(errors[0] / errors[1]);
    assert!((order - 2.0).abs() < 0.1 && errors[1] < 3e-4, "{errors:?} of order {order}");
}

/// A ball that spins about an oblique axis turns by the exact angle, however long the step: rounding, 2e-15 a step measured.
#[test]
fn a_body_of_equal_moments_turns_exactly() {
    let outline = cuboid([-1.0; 3], [1.0; 3], 1.0);
    let mass = outline.filled(1.0).unwrap();
    let mut body = RigidBody::new(Parts { outline, mass, ..parts() }).unwrap();
    let spin = Vec3::new(0.3, -0.4, 1.2);
    body.set_out(&Vec3::zeros(), &spin);
    march(&mut body, 10.0, 0.1, |_| ());
    assert!((body.turned() - spin * 10.0).norm() < 1e-12, "{:?}", body.turned());
    let corner = body.rest()[0];
    let (axis, angle) = (spin.normalize(), 13.0);
    let along = axis * axis.dot(&corner);
    let exact = along + (corner - along) * libm::cos(angle) + axis.cross(&corner) * libm::sin(angle);
    assert!((body.position(0) - exact).norm() < 1e-12, "{:?} {exact:?}", body.position(0));
}

/// Free fall from rest: central differences are exact under a constant force, and the centre goes as ½ g t².
#[test]
fn a_body_falls_as_a_stone_and_momentum_is_what_loads_bring() {
    let gravity = Load { acceleration: Vec3::new(0.0, 0.0, -9.81), ..Load::default() };
    let couple = Load { couple: Vec3::new(0.5, 0.0, 0.0), amplitude: Amplitude::Constant, ..Load::default() };
    let mut body = RigidBody::new(Parts { loads: vec![gravity, couple], ..parts() }).unwrap();
    let centre = body.centre() as usize;
    march(&mut body, 1.0, 0.05, |_| ());
    assert!((body.position(centre).z + 0.5 * 9.81).abs() < 1e-13);
    // At the middle of the last step.
    assert!((body.moment_of_momentum() - Vec3::new(0.5 * 0.975, 0.0, 0.0)).norm() < 1e-14);
}

/// A body on a spring along z at its centre, and one against turning made of two: frequencies of one degree of freedom, from zeros of the motion.
#[test]
fn a_body_swings_on_its_springs_at_the_frequency_of_its_mass() {
    let k = 40.0;
    let springs = |parts: &Parts| {
        let ends = [0, 1].map(|end| {
            let x = Vec3::new(0.0, if end == 0 { -1.0 } else { 1.0 }, 0.0);
            let at = parts
                .outline
                .vertices
                .iter()
                .position(|v| (v.y - x.y).abs() < 1e-12 && v.x.abs() > 0.4 && v.z.abs() < 0.6);
            at.unwrap() as u32
        });
        ends.map(|particle| Spring { particle, stiffness: k, direction: Vec3::z() }).to_vec()
    };
    let base = parts();
    let springs = springs(&base);
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], rotation: RotationHold::Fixed };
    let mut body = RigidBody::new(Parts { springs, supports: vec![held], ..base }).unwrap();
    body.set_out(&Vec3::new(1.0, 1.0, 1.0), &Vec3::new(1.0, 1.0, 1.0));
    assert_eq!(body.velocity(0), Vec3::z(), "what is held stays at rest");
    let (omega, dt) = ((2.0 * k / body.mass()).sqrt(), 0.002);
    let mut worst = 0.0_f64;
    let mut number = 0;
    let centre = body.centre() as usize;
    march(&mut body, 3.0, dt, |body| {
        number += 1;
        let exact = libm::sin(omega * dt * f64::from(number)) / omega;
        worst = worst.max((body.position(centre).z - exact).abs() * omega);
    });
    // Central differences shorten the period by (ωΔt)²/24, 6e-7 of six radians.
    assert!(worst < 1e-5, "{worst:e}");
    let step = body.stable_step(1.0).unwrap().dt;
    assert!(step <= 2.0 / omega, "{step} {}", 2.0 / omega);
}

/// Prescribed motion and turn end where they are to, and the work of the supports is the kinetic energy while they last.
#[test]
fn supports_move_and_turn_a_body_and_pay_for_it() {
    let moved =
        Support::Moved { direction: Vec3::new(0.0, 2.0, 0.0), by: 0.7, amplitude: Amplitude::Smooth(1.0) };
    let rotated =
        Support::Rotated { axis: Vec3::new(1.0, 1.0, 0.0), by: 2.5, amplitude: Amplitude::Smooth(1.0) };
    let mut body = RigidBody::new(Parts { supports: vec![moved, rotated], ..parts() }).unwrap();
    let (dt, mut work) = (0.001, 0.0);
    let mut middle = 0.0_f64;
    for number in 0..1000_u32 {
        let at = |step: u32| Instant { time: f64::from(step) * dt, level: 1.0 };
        let kick = if number == 0 { 0.5 * dt } else { dt };
        let step = explicit_dynamics::Step { from: at(number), to: at(number + 1), kick, damping: 0.0 };
        body.evaluate(step.from);
        let done = body.kick(&step);
        middle = middle.max(done.kinetic);
        work += done.external;
        body.drift(&step);
        if number == 500 {
            assert!((energy(&body) / work - 1.0).abs() < 1e-3, "{} {work}", energy(&body));
        }
    }
    let centre = body.centre() as usize;
    assert!((body.position(centre) - Vec3::new(0.0, 0.7, 0.0)).norm() < 1e-13);
    let angle = Vec3::new(1.0, 1.0, 0.0).normalize() * 2.5;
    assert!((body.turned() - angle).norm() < 1e-12);
    assert!(work.abs() < 1e-4 * middle, "{work:e} of {middle}");
}

/// The masses of particles bound the kinetic energy of every motion, and of one particle they are exact.
#[test]
fn masses_of_particles_bound_the_kinetic_energy() {
    let mut body = RigidBody::new(parts()).unwrap();
    let all: Vec<u32> = (0..body.len() as u32).collect();
    let masses = body.masses(&all);
    let mut closest = 0.0_f64;
    for seed in 0..200 {
        let number = |k: i32| libm::sin(12.9898 * f64::from(seed * 7 + k) + 1.0);
        let v = Vec3::new(number(0), number(1), number(2));
        body.set_out(&v, &Vec3::new(number(3), number(4), number(5)));
        let sum: f64 = masses.iter().enumerate().map(|(a, m)| m * body.velocity(a).norm_squared()).sum();
        assert!(sum <= 2.0 * energy(&body) * (1.0 + 1e-12));
        closest = closest.max(sum / (2.0 * energy(&body)));
    }
    assert!(closest > 0.6, "{closest}");
    let [mass] = body.masses(&[body.centre()])[..] else { panic!("one") };
    assert!((mass / body.mass() - 1.0).abs() < 1e-14);
    // A corner: 1/m_e = 1/m + max_n (a × n)·J⁻¹(a × n), by the motion of the corner that costs least.
    let [corner] = body.masses(&[0])[..] else { panic!("one") };
    let arm = body.rest()[0];
    let inverse = Matrix3::from_diagonal(&body.moments().map(f64::recip));
    let least = (0..20_000).map(|k| {
        let (z, angle) = (-1.0 + f64::from(k) / 1e4, 2.399_963 * f64::from(k));
        let n =
            Vec3::new((1.0 - z * z).sqrt() * libm::cos(angle), (1.0 - z * z).sqrt() * libm::sin(angle), z);
        1.0 / (1.0 / body.mass() + arm.cross(&n).dot(&(inverse * arm.cross(&n))))
    });
    let least = least.fold(f64::INFINITY, f64::min);
    assert!((corner / least - 1.0).abs() < 1e-3 && corner <= least, "{corner} {least}");
}

#[test]
fn a_state_comes_back_to_the_same_bits() {
    let mut body = RigidBody::new(parts()).unwrap();
    body.set_out(&Vec3::x(), &Vec3::new(0.1, 2.0, 0.3));
    march(&mut body, 1.0, 0.01, |_| ());
    let mut other = RigidBody::new(parts()).unwrap();
    assert!(other.take_up(&body.state()) && !other.take_up(&[0.0; 3]));
    for body in [&mut body, &mut other] {
        march(body, 1.0, 0.01, |_| ());
    }
    assert_eq!(body.state(), other.state());
    let bad = MassProperties { mass: -1.0, ..parts().mass };
    assert!(RigidBody::new(Parts { mass: bad, ..parts() }).is_err());
    let spring = Spring { particle: 99, stiffness: 1.0, direction: Vec3::x() };
    assert!(RigidBody::new(Parts { springs: vec![spring], ..parts() }).is_err());
}
