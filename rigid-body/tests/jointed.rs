//! Joints: what they keep exactly, a pendulum of large amplitude, a chain of hinges, a crank against its closed form.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use explicit_dynamics::{Amplitude, Dynamics, Instant, Step, Work};
use rigid_body::{Joint, JointKind, Joints, Load, Parts, RigidBody, cuboid};
use sph_core::Vec3;

const G: f64 = 10.0;

fn block(min: [f64; 3], max: [f64; 3], gravity: f64) -> RigidBody {
    let outline = cuboid(min, max, 9.0);
    let mass = outline.filled(2.0).unwrap();
    let acceleration = Vec3::new(0.0, 0.0, -gravity);
    let loads = vec![Load { acceleration, amplitude: Amplitude::Constant, ..Load::default() }];
    RigidBody::new(Parts { outline, mass, supports: Vec::new(), loads, springs: Vec::new() }).unwrap()
}

/// Marches bodies on their joints; what is seen behind each step, with the kinetic energy and the work of loads in its middle.
fn march(
    bodies: &mut [RigidBody],
    joints: &mut Joints,
    [duration, dt]: [f64; 2],
    mut seen: impl FnMut(f64, &[RigidBody], &Joints, Work),
) {
    let mut external = 0.0;
    for number in 0..(duration / dt).round() as usize {
        let at = |step: usize| Instant { time: step as f64 * dt, level: 1.0 };
        let step = Step {
            from: at(number),
            to: at(number + 1),
            kick: if number == 0 { 0.5 * dt } else { dt },
            damping: 0.0,
        };
        bodies.iter_mut().for_each(|body| {
            body.evaluate(step.from);
        });
        if number == 0 {
            joints.brace(&mut bodies.iter_mut().collect::<Vec<_>>(), &Step { kick: 0.0, ..step });
        }
        joints.brace(&mut bodies.iter_mut().collect::<Vec<_>>(), &step);
        let mut work = Work::default();
        for body in &mut *bodies {
            let own = body.kick(&step);
            (work.kinetic, work.external) = (work.kinetic + own.kinetic, work.external + own.external);
        }
        joints.settle(&bodies.iter().collect::<Vec<_>>(), &step, &mut work);
        let share = if number == 0 { 1.0 } else { 0.5 };
        let kinetic = work.kinetic;
        let half = share * work.external;
        bodies.iter_mut().for_each(|body| body.drift(&step));
        seen(step.to.time, bodies, joints, Work { kinetic, external: external + half, ..work });
        external += work.external;
    }
}

/// The complete elliptic integral of the first kind by means.
fn quarter(m: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, (1.0 - m).sqrt());
    for _ in 0..10 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * std::f64::consts::PI / a
}

/// Time in which a bar let go level from a hinge at its end comes back: a swing of 90° to either side, `4 √(J/mgl) K(sin² 45°)`.
fn period_found(dt: f64) -> [f64; 2] {
    let mut bar = vec![block([0.0, -0.1, -0.1], [2.0, 0.1, 0.1], G)];
    let joint = Joint { on: 0, to: None, at: Vec3::zeros(), kind: JointKind::Hinge(Vec3::y()) };
    let mut joints = Joints::new(&[&bar[0]], &[joint]);
    let (mass, moment) = (bar[0].mass(), bar[0].moments().max() + bar[0].mass());
    let exact = 4.0 * (moment / (mass * G)).sqrt() * quarter(0.5);
    // It hangs straight down after a quarter, and once more after three.
    let (mut crossings, mut old, mut off) = (Vec::new(), [0.0, 1.0], 0.0_f64);
    march(&mut bar, &mut joints, [exact, dt], |t, bodies, _, _| {
        let x = bodies[0].position(bodies[0].centre() as usize);
        off = off.max((x.norm() - 1.0).abs()).max(x.y.abs());
        if x.x * old[1] < 0.0 {
            crossings.push(old[0] + (t - old[0]) * old[1] / (old[1] - x.x));
        }
        old = [t, x.x];
    });
    assert!(off < 1e-14, "the hinge holds to rounding: {off}");
    assert_eq!(crossings.len(), 2);
    [2.0 * (crossings[1] - crossings[0]) / exact - 1.0, crossings[0] / (0.25 * exact) - 1.0]
}

/// Of second order in the step: measured 8.5e-5 by steps of 1/271 of the period, 2.1e-5 by half of them.
#[test]
fn a_pendulum_of_large_amplitude_keeps_the_time_of_the_elliptic_integral() {
    let [coarse, fine] = [0.01, 0.005].map(period_found);
    println!("pendulum, period: {:e}, half the step {:e}", coarse[0], fine[0]);
    assert!(coarse[0].abs() < 2.6e-4 && fine[0].abs() < 6.5e-5, "{coarse:?} {fine:?}");
}

/// Two bars on hinges that lean, one off the plane of the other, under gravity: energy within 4.1e-5 of the greatest kinetic one without a trend, hinges to rounding.
#[test]
fn a_double_pendulum_keeps_its_energy() {
    let mut bars =
        vec![block([0.0, -0.1, -0.1], [1.0, 0.1, 0.1], G), block([1.0, -0.1, -0.1], [2.0, 0.1, 0.1], G)];
    let hinge = |on, to, x: f64, axis: Vec3| Joint {
        on,
        to,
        at: Vec3::new(x, 0.0, 0.0),
        kind: JointKind::Hinge(axis),
    };
    let all = [hinge(0, None, 0.0, Vec3::y()), hinge(1, Some(0), 1.0, Vec3::new(0.2, 1.0, 0.1))];
    let mut joints = Joints::new(&[&bars[0], &bars[1]], &all);
    assert_eq!(joints.len(), 10);
    let (mut most, mut scale, mut off) = (0.0_f64, 0.0_f64, 0.0_f64);
    march(&mut bars, &mut joints, [6.0, 1e-3], |_, bodies, _, work| {
        most = most.max((work.kinetic - work.external).abs());
        scale = scale.max(work.kinetic);
        // The middles of the faces that the hinge joins.
        let ends = [0, 1].map(|k| {
            let face: Vec<Vec3> = (0..8)
                .filter(|a| (bodies[k].rest()[*a].x - 1.0).abs() < 1e-9)
                .map(|a| bodies[k].position(a))
                .collect();
            face.iter().sum::<Vec3>() / face.len() as f64
        });
        off = off.max((ends[0] - ends[1]).norm());
    });
    println!("double pendulum, energy: {:e}, gap {off:e}", most / scale);
    // Measured 4.1e-5.
    assert!(most < 1.3e-4 * scale, "{most} {scale}");
    assert!(off < 1e-14, "{off}");
}

/// Bodies that fly on a ball joint, a hinge and a slider that lean: momentum, and moment of momentum about the origin, to rounding.
#[test]
fn joints_keep_momentum_and_moment_of_momentum() {
    let blocks = [0.0, 1.0, 2.0, 3.0].map(|x| block([x, -0.2, -0.1], [x + 0.8, 0.3, 0.1], 0.0));
    let mut bodies = Vec::from(blocks);
    bodies[0].set_out(&Vec3::new(0.5, 1.0, 0.0), &Vec3::new(1.0, 2.0, -1.0));
    bodies[3].set_out(&Vec3::new(0.0, -1.0, 0.4), &Vec3::new(0.0, 1.0, 3.0));
    let joint = |on, x: f64, kind| Joint { on, to: Some(on - 1), at: Vec3::new(x, 0.1, 0.0), kind };
    let all = [
        joint(1, 0.9, JointKind::Ball),
        joint(2, 1.9, JointKind::Hinge(Vec3::new(0.3, 1.0, 0.2))),
        joint(3, 2.9, JointKind::Slider(Vec3::new(1.0, 0.2, -0.3))),
    ];
    let mut joints = Joints::new(&bodies.iter().collect::<Vec<_>>(), &all);
    let sums = |bodies: &[RigidBody]| {
        let momentum = |body: &RigidBody| body.velocity(body.centre() as usize) * body.mass();
        let centre = |body: &RigidBody| body.position(body.centre() as usize);
        let linear: Vec3 = bodies.iter().map(momentum).sum();
        let angular: Vec3 =
            bodies.iter().map(|body| centre(body).cross(&momentum(body)) + body.moment_of_momentum()).sum();
        [linear, angular]
    };
    let (start, mut off, mut kinetic) = (sums(&bodies), 0.0_f64, Vec::new());
    march(&mut bodies, &mut joints, [4.0, 2e-3], |_, bodies, _, work| {
        let now = sums(bodies);
        off = off.max((now[0] - start[0]).norm()).max((now[1] - start[1]).norm());
        kinetic.push(work.kinetic);
    });
    println!("four bodies, momentum and its moment: {:e}", off / start[1].norm());
    // Measured 1.8e-15.
    assert!(off < 6e-15 * start[1].norm(), "{off} {}", start[1].norm());
    let [least, most] = [f64::min, f64::max].map(|of| kinetic.iter().copied().fold(kinetic[0], of));
    assert!(most - least < 1e-3 * most, "nothing takes energy: {least} {most}");
}

/// A crank of r turns at one rate and leads a slider by a rod of l: `x = r cos φ + √(l² − r² sin² φ)`. Three hinges and a slider say some things three times.
#[test]
fn a_slider_goes_where_its_crank_leads_it() {
    let (r, l) = (0.5, 1.5);
    let mut bodies = vec![
        block([0.0, -0.1, -0.1], [r, 0.1, 0.1], 0.0),
        block([r, -0.1, -0.1], [r + l, 0.1, 0.1], 0.0),
        block([r + l - 0.2, -0.1, -0.2], [r + l + 0.2, 0.1, 0.2], 0.0),
    ];
    let joint = |on, to, x: f64, kind| Joint { on, to, at: Vec3::new(x, 0.0, 0.0), kind };
    let hinge = JointKind::Hinge(Vec3::y());
    let all = [
        joint(0, None, 0.0, hinge),
        joint(1, Some(0), r, hinge),
        joint(2, Some(1), r + l, hinge),
        joint(2, None, r + l, JointKind::Slider(Vec3::x())),
    ];
    let mut joints = Joints::new(&bodies.iter().collect::<Vec<_>>(), &all);
    bodies[0].set_out(&Vec3::new(0.0, 0.0, -0.5 * r * 6.0), &Vec3::new(0.0, 6.0, 0.0));
    let (mut off, mut least, mut most) = (0.0_f64, f64::INFINITY, 0.0_f64);
    march(&mut bodies, &mut joints, [7.0, 2e-3], |_, bodies, _, _| {
        let at = |k: usize| bodies[k].position(bodies[k].centre() as usize);
        let (crank, x) = (at(0) / (0.5 * r), at(2).x);
        off = off.max((x - (r * crank.x + (l * l - r * r * crank.z * crank.z).sqrt())).abs());
        (least, most) = (least.min(x), most.max(x));
    });
    println!("slider and crank: {off:e}");
    // Measured 4e-15.
    assert!(off < 1.2e-14, "{off}");
    assert!(most > r + l - 1e-3 && least < l - r + 1e-3, "it goes to and fro: {least} {most}");
}

/// What sets out against a joint is stopped by it at once: a bar about its end goes on with `v = 3/2 v₀` there, of its moment of momentum about the hinge.
#[test]
fn a_joint_takes_at_once_what_sets_out_against_it() {
    let mut bar = vec![block([0.0, -0.001, -0.001], [2.0, 0.001, 0.001], 0.0)];
    let joint = Joint { on: 0, to: None, at: Vec3::zeros(), kind: JointKind::Hinge(Vec3::y()) };
    let mut joints = Joints::new(&[&bar[0]], &[joint]);
    bar[0].set_out(&Vec3::new(0.3, 0.2, 1.0), &Vec3::zeros());
    let mut first = None;
    march(&mut bar, &mut joints, [1e-3, 1e-3], |_, bodies, _, _| first = Some(bodies[0].spin()));
    // ω = m v₀ l/(m l² 4/3), downwards about y.
    assert!((first.unwrap() - Vec3::new(0.0, -0.75, 0.0)).norm() < 1e-6, "{first:?}");
    let [force, _] = joints.exerted(0);
    // It keeps the bar on its circle: m ω² l.
    assert!((force.x + bar[0].mass() * 0.75 * 0.75).abs() < 1e-2 * force.norm(), "{force:?}");
}
