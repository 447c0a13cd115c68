//! Springs against turning and between two sets: derivatives of their energy, rigid motions, frequencies, what is refused.

use crate::common::{
    DENSITY, RandomNumbers, Sheets, X, Y, Z, at, curved, flat, free_shell, parts, shell_parts, spectrum,
    supported,
};
use explicit_dynamics::{Clock, Dynamics, largest_eigenvalue};
use implicit_statics::{Equilibrium, stiffness_error};
use nalgebra::{Matrix3, Rotation3};
use shell_kinematics::StretchCorrected;
use sph_core::{Side, Vec3};
use sph_shell::{
    BodySpring, Clamped, DirectorHold, Formulation, Holds, Reach, RigidSet, Shell, ShellError, SpringBetween,
    Springs, StaticShell, TurnSpring,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICK: f64 = 0.1;

/// The rotation of a rigid set from rest, by a director and the chord of two of its particles.
fn rotation(shell: &Shell, [a, b]: [usize; 2]) -> Matrix3<f64> {
    let cloud = &shell.reference().cloud;
    let triad = |d: Vec3, e: Vec3| {
        let c = d.cross(&e).normalize();
        Matrix3::from_columns(&[d, c.cross(&d), c])
    };
    let there = triad(shell.director(a), shell.position(b) - shell.position(a));
    there * triad(cloud.frames[a].n, cloud.positions[b] - cloud.positions[a]).transpose()
}

/// Its twist about an axis: `tan φ/2 = e·(axial vector of R)/(1 + tr R)`.
fn twist(turn: &Matrix3<f64>, axis: &Vec3) -> f64 {
    let axial =
        Vec3::new(turn[(2, 1)] - turn[(1, 2)], turn[(0, 2)] - turn[(2, 0)], turn[(1, 0)] - turn[(0, 1)]);
    2.0 * libm::atan(axis.dot(&axial) / (1.0 + turn.trace()))
}

/// Signed angle between what directors at rest and now have across an axis.
fn turned(axis: &Vec3, rest: &Vec3, d: &Vec3) -> f64 {
    let across = |v: &Vec3| (v - axis * axis.dot(v)).normalize();
    let (from, to) = (across(rest), across(d));
    libm::acos(from.dot(&to)).copysign(axis.dot(&from.cross(&to)))
}

#[test]
fn forces_and_tangent_are_derivatives_of_the_energy() {
    let set = |particles: Vec<u32>, at: Vec3, holds: Vec<Holds>| RigidSet {
        particles,
        at,
        mass: 1.0,
        inertia: Matrix3::identity() * 0.1,
        holds,
    };
    let slid = Holds { translations: vec![Vec3::new(0.6, 0.0, 0.8)], ..Holds::default() };
    let axes = [Vec3::new(0.2, 1.0, 0.1).normalize(), Vec3::new(0.5, -0.3, 0.8).normalize()];
    let (n, m) = (Vec3::new(1.0, -2.0, 0.5).normalize(), Vec3::new(0.2, 0.1, 1.0).normalize());
    let cloud = curved([8, 6]);
    let ends = [[12_u32, 15], [36, 39]];
    let places = [Vec3::new(0.3, 1.9, 1.4), Vec3::new(-0.2, 0.6, 2.2)];
    let clamp = supported(cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec(), Clamped);
    let body = Shell::builder(shell_parts(cloud.clone(), CELL, 0.2, &StretchCorrected, vec![clamp], vec![]));
    let particles = |[a, b]: [u32; 2]| vec![a, a + 1, b - 1, b];
    let rigid = [set(particles(ends[0]), places[0], vec![]), set(particles(ends[1]), places[1], vec![slid])];
    let body = body.rigid(rigid.to_vec());
    let k = 30.0;
    let body = body
        .springs(Springs {
            turning: vec![
                TurnSpring { stiffness: vec![(20, k), (21, 2.0 * k)], axis: axes[0] * 3.0 },
                TurnSpring { stiffness: vec![(14, k), (21, k)], axis: axes[1] },
            ],
            between: vec![SpringBetween { stiffness: vec![([20, 44], 5.0 * k), ([37, 9], k)], direction: n }],
            of_bodies: vec![
                BodySpring::Turning { body: 0, stiffness: k, axis: axes[0] },
                BodySpring::Turning { body: 1, stiffness: 2.0 * k, axis: axes[1] },
                BodySpring::Between { bodies: [1, 0], stiffness: 3.0 * k, direction: m },
            ],
            ..Springs::default()
        })
        .build()
        .unwrap();
    let stored = |shell: &Shell| {
        let rest = |a: usize| shell.reference().cloud.frames[a].n;
        let of = |a: usize, axis: &Vec3| 0.5 * k * turned(axis, &rest(a), &shell.director(a)).powi(2);
        let apart =
            |a: usize, b: usize| 0.5 * k * n.dot(&(shell.displacement(b) - shell.displacement(a))).powi(2);
        let turns = ends.map(|[a, b]| rotation(shell, [a as usize, b as usize]));
        let way = |i: usize| {
            let first = ends[i][0] as usize;
            let arm = places[i] - shell.reference().cloud.positions[first];
            shell.displacement(first) + turns[i] * arm - arm
        };
        of(20, &axes[0])
            + 2.0 * of(21, &axes[0])
            + of(14, &axes[1])
            + of(21, &axes[1])
            + 5.0 * apart(20, 44)
            + apart(37, 9)
            + 0.5 * k * twist(&turns[0], &axes[0]).powi(2)
            + k * twist(&turns[1], &axes[1]).powi(2)
            + 1.5 * k * m.dot(&(way(0) - way(1))).powi(2)
    };
    let mut system = StaticShell::new(body);
    assert_eq!(system.skew_load_share(), 0.0);
    let count = system.unknowns();
    for seed in [3, 4] {
        let mut dice = RandomNumbers(seed);
        let increment: Vec<f64> = (0..count).map(|_| 0.1 * dice.roll()).collect();
        system.update(&increment);
    }
    let lack = |system: &mut StaticShell| {
        let (mut internal, mut external) = (vec![0.0; count], vec![0.0; count]);
        system.internal(1.0, &mut internal);
        system.external(1.0, &mut external);
        internal.iter().zip(&external).map(|(f, e)| f - e).collect::<Vec<f64>>()
    };
    let forces = lack(&mut system);
    let home = system.save();
    let turning: Vec<usize> = (0..count).filter(|&i| system.name_unknown(i).contains("rigid body")).collect();
    assert_eq!(turning.len(), 6);
    let mut dice = RandomNumbers(7);
    let random: Vec<f64> = (0..count).map(|_| dice.roll()).collect();
    let alone = |i: usize| (0..count).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
    for v in std::iter::once(random).chain(turning.iter().map(|&i| alone(i))) {
        let h = 2e-4;
        let mut along = |factor: f64| {
            system.restore(&home);
            system.update(&v.iter().map(|x| factor * h * x).collect::<Vec<f64>>());
            system.energy() + stored(system.shell())
        };
        let [a, b, d, e] = [-2.0, -1.0, 1.0, 2.0].map(&mut along);
        system.restore(&home);
        let first = (a - 8.0 * b + 8.0 * d - e) / (12.0 * h);
        let slope: f64 = forces.iter().zip(&v).map(|(f, v)| f * v).sum();
        let errors = [(first / slope - 1.0).abs(), stiffness_error(&mut system, 1.0, &v, h)];
        println!("force {:.1e}, tangent {:.1e}", errors[0], errors[1]);
        // Truncation h⁴ and the round-off of U and of forces over h.
        assert!(errors[0] < 3e-11 && errors[1] < 6e-12, "{errors:?}");
    }
}

/// Two free sheets joined along an edge on one place: any common rigid motion does no work; a march keeps both momenta. Where the edges
/// stand apart, momentum is kept.
#[test]
fn springs_between_sheets_know_no_common_motion() {
    for gap in [0.0, 0.2] {
        let sheets = Sheets::default().add(Vec3::zeros(), [X, Y * 0.8], [5, 4]).add(
            X * (1.0 + gap),
            [X * 0.9 + Z * 0.3, Y * 0.8],
            [5, 4],
        );
        let cloud = sheets.apart();
        let edge = |x: f64, first: u32| {
            let on = at(&cloud, |p| (p.x - x).abs() < 1e-9);
            on.into_iter().filter(|a| (*a >= 30) == (first == 30)).collect::<Vec<_>>()
        };
        let pairs: Vec<_> =
            edge(1.0, 0).into_iter().zip(edge(1.0 + gap, 30)).map(|(a, b)| ([a, b], 8.0)).collect();
        assert_eq!(pairs.len(), 5);
        let made = || {
            let body = Shell::builder(parts(cloud.clone(), CELL, 0.1));
            let all = [X, Y, Z].map(|direction| SpringBetween { stiffness: pairs.clone(), direction });
            body.springs(Springs { between: all.into(), ..Springs::default() }).build().unwrap()
        };
        let mut body = made();
        let turn = match gap == 0.0 {
            true => Rotation3::from_scaled_axis(Vec3::new(0.3, -1.0, 0.7)),
            false => Rotation3::identity(),
        };
        for a in 0..body.len() {
            body.set_state(a, turn * body.position(a) + Vec3::new(1.0, 2.0, 3.0), turn * body.director(a));
        }
        let mut system = StaticShell::new(body);
        let mut force = vec![0.0; system.unknowns()];
        system.external(0.0, &mut force);
        let worst = force.iter().fold(0.0_f64, |worst, f| worst.max(f.abs()));
        let mut body = made();
        for a in 0..body.len() {
            let x = body.position(a);
            body.set_rate(
                a,
                Vec3::new(0.1, -0.3, 0.4) + X.cross(&x) * 0.5 + Z * libm::sin(3.0 * x.x),
                Vec3::zeros(),
            );
        }
        let momenta = |body: &Shell| {
            (0..body.len()).fold([Vec3::zeros(); 2], |[p, l], a| {
                let m = body.velocity(a) * body.reference().masses[a];
                let own = body.director(a).cross(&body.director_rate(a)) * body.reference().inertias[a];
                [p + m, l + body.position(a).cross(&m) + own]
            })
        };
        let start = momenta(&body);
        let mut clock = Clock::start(&mut body, 1.0, 0.5, 0.0).unwrap();
        for _ in 0..1000 {
            clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        }
        let end = momenta(&body);
        let lost = [0, 1].map(|i| (end[i] - start[i]).norm() / start[i].norm());
        println!("gap {gap}: force {worst:.1e}, momentum and moment {lost:?}");
        assert!(worst < 6e-15 && lost[0] < 3e-15, "{worst:.1e} {lost:?}");
        // Between places that stand apart at rest the force along `u_b − u_a` is not along the line that joins them.
        assert!(if gap == 0.0 { lost[1] < 2e-14 } else { lost[1] > 1e-3 }, "{lost:?}");
    }
}

/// One director on a stiff spring shortens the step to `2/√(k/I)`; a hinged body turns with `ω² = k/J_p`, two free bodies swing against each other
/// with `k (1/m₁ + 1/m₂)`.
#[test]
fn stiff_springs_have_their_frequencies() {
    let mut stiff = free_shell(flat([6, 5], [1.0, 0.8]), CELL, 0.1);
    let before = stiff.stable_step(1.0).unwrap().dt;
    let (k, inertia) = (1e6, stiff.reference().inertias[7]);
    let turning = vec![TurnSpring { stiffness: vec![(7, k)], axis: X }];
    let stiff = Shell::builder(parts(flat([6, 5], [1.0, 0.8]), CELL, 0.1));
    let mut stiff = stiff.springs(Springs { turning, ..Springs::default() }).build().unwrap();
    let after = stiff.stable_step(1.0).unwrap().dt;
    let exact = 2.0 / (k / inertia).sqrt();
    println!("stable step {before:.3e} {after:.3e} {exact:.3e}");
    assert!(after < 0.1 * before && (after / exact - 1.0).abs() < 0.02, "{after} {exact}");

    let axis = Vec3::new(0.0, 0.6, 0.8);
    let hinged = || {
        let body = Shell::builder(parts(flat([5, 4], [1.0, 0.8]), CELL, THICK));
        let hold =
            Holds { translations: vec![X, Y, Z], director: DirectorHold::InPlane(axis), ..Holds::default() };
        let inertia = Matrix3::identity() * 2.0;
        let at = Vec3::new(0.9, 0.1, 0.3);
        let set = RigidSet { particles: (0..20).collect(), at, mass: 0.5, inertia, holds: vec![hold] };
        let body = body.rigid(vec![set]);
        let of_bodies = vec![BodySpring::Turning { body: 0, stiffness: 7.0, axis: axis * 2.0 }];
        body.springs(Springs { of_bodies, ..Springs::default() }).build().unwrap()
    };
    // A plate a × b × t about its middle, moved to the hinge.
    let (a, b) = (1.0, 0.8);
    let mass = DENSITY * THICK * a * b;
    let [x, y, t] = [a, b, THICK].map(|side: f64| side * side);
    let plate = Vec3::new(y + t, x + t, x + y) * (mass / 12.0);
    let arm = axis.cross(&(Vec3::new(0.5 * a, 0.5 * b, 0.0) - Vec3::new(0.9, 0.1, 0.3)));
    let exact = 7.0 / (2.0 + axis.component_mul(&axis).dot(&plate) + mass * arm.norm_squared());
    let found = spectrum(hinged());
    let in_time = largest_eigenvalue(&mut hinged(), 20).ritz / exact - 1.0;
    println!("hinged: {:.1e} {in_time:.1e}", found[0] / exact - 1.0);
    assert!(found.len() == 1 && (found[0] / exact - 1.0).abs() < 1e-12 && in_time.abs() < 1e-8);

    let pair = || {
        let sheets = Sheets::default().add(Vec3::zeros(), [X, Y], [3, 3]).add(X * 3.0, [X, Y * 2.0], [3, 3]);
        let body = Shell::builder(parts(sheets.apart(), CELL, THICK));
        let set = |first: u32, at: Vec3| RigidSet {
            particles: (first..first + 16).collect(),
            at,
            ..RigidSet::default()
        };
        let body = body.rigid(vec![set(0, Vec3::new(0.5, 0.5, 0.0)), set(16, Vec3::new(3.5, 1.0, 0.0))]);
        let of_bodies = vec![BodySpring::Between { bodies: [0, 1], stiffness: 5.0, direction: Z }];
        body.springs(Springs { of_bodies, ..Springs::default() }).build().unwrap()
    };
    let exact = 5.0 * (1.0 / (DENSITY * THICK) + 1.0 / (2.0 * DENSITY * THICK));
    let found = spectrum(pair());
    let in_time = largest_eigenvalue(&mut pair(), 20).ritz / exact - 1.0;
    println!("pair: {:.1e} {in_time:.1e}, {:.1e}", found[11] / exact - 1.0, found[10]);
    assert!(
        (found[11] / exact - 1.0).abs() < 1e-12 && found[10].abs() < 1e-12 * exact && in_time.abs() < 1e-8
    );
}

#[test]
fn springs_that_are_none_are_refused() {
    let refused = |springs: Springs| {
        Shell::builder(parts(flat([4, 3], [1.0, 0.8]), CELL, 0.1)).springs(springs).build().err().unwrap()
    };
    let turning =
        |stiffness, axis| Springs { turning: vec![TurnSpring { stiffness, axis }], ..Springs::default() };
    let between = |stiffness| Springs {
        between: vec![SpringBetween { stiffness, direction: X }],
        ..Springs::default()
    };
    assert!(matches!(refused(turning(vec![], X)), ShellError::EmptySet(_)));
    assert!(matches!(refused(turning(vec![(1, 0.0)], X)), ShellError::Spring { particle: 1, .. }));
    let along = refused(turning(vec![(3, 1.0)], Z + X * 0.01));
    assert!(matches!(along, ShellError::SpringAlongDirector { particle: 3, .. }));
    assert!(matches!(
        refused(between(vec![([2, 12], 1.0)])),
        ShellError::NoSuchParticle { particle: 12, .. }
    ));
    assert!(matches!(refused(between(vec![([2, 2], 1.0)])), ShellError::SpringOnItself { particle: 2 }));
    let of_bodies = vec![BodySpring::Turning { body: 0, stiffness: 1.0, axis: X }];
    let body = Springs { of_bodies, ..Springs::default() };
    assert!(matches!(refused(body), ShellError::SpringOfBody { set: 0, .. }));
}
