//! Shells that several march together whose particles depend on each other, or whose sections have a memory: the same bits as one marches them.

use crate::common::{self, Sheets, X, Y, Z, at, parts, supported};
use crate::shared::{plans, reported, shared};
use explicit_dynamics::Amplitude;
use nalgebra::Matrix3;
use peers::together;
use shell_kinematics::{Hardening, Isotropic, Logarithmic, Plastic, PlasticSection};
use sph_core::Vec3;
use sph_shell::{
    AppliedLoad, BodySpring, Clamped, Force, Formulation, Gravity, Holds, Moved, Parts, Pressure, Reach,
    RigidLoad, RigidSet, Shell, Spring, SpringBetween, Springs, Support, Tie,
};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);

fn applied(load: impl sph_shell::Load + 'static) -> AppliedLoad {
    AppliedLoad { load: Box::new(load), amplitude: Amplitude::Constant }
}

fn set(particles: Vec<u32>, at: Vec3, mass: f64, holds: Vec<Holds>) -> RigidSet {
    let inertia = Matrix3::from_diagonal(&Vec3::new(0.02, 0.05, 0.03)) * mass;
    RigidSet { particles, at, mass, inertia, holds }
}

/// Two plates that meet along a line, with a heavy body round the end of one and a moved one on the other, between which there is a spring; a rib hangs
/// on the larger plate. Chunks end in the middle of each of them.
fn frame(threads: usize) -> Shell {
    let cloud = Sheets::default()
        .add(-X, [X * 2.0, Y], [24, 40])
        .add(Vec3::zeros(), [Z, Y], [13, 40])
        .add(Vec3::new(-0.9, 0.51, 0.0), [X * 0.8, Z * 0.3], [31, 6])
        .cloud();
    let on_plate = |a: &u32| cloud.positions[*a as usize].z.abs() < 1e-9;
    let host = (0..24 * 40).collect();
    let edge = (25 * 41 + 14 * 41..cloud.len() as u32).filter(on_plate).collect();
    let end = at(&cloud, |x| x.x > 0.7 && on_first(x));
    let top = at(&cloud, |x| x.z > 0.9);
    let held = at(&cloud, |x| x.x < -0.999);
    let lifted = Moved { direction: Z, by: 0.02, amplitude: Amplitude::Ramp(0.1) };
    let sets = vec![
        set(end, Vec3::new(1.1, 0.4, -0.2), 0.3, Vec::new()),
        set(top, Vec3::new(0.1, 0.5, 1.1), 0.0, vec![lifted.holds()]),
    ];
    let some = |step: usize| (0..cloud.len() as u32).step_by(step);
    let ends = some(5).filter(|a| 2 * a + 1 < cloud.len() as u32).map(|a| ([a, 2 * a + 1], 0.3));
    let springs = Springs {
        ground: vec![Spring { stiffness: some(3).map(|a| (a, 0.1)).collect(), direction: Z }],
        between: vec![SpringBetween { stiffness: ends.collect(), direction: X }],
        of_bodies: vec![
            BodySpring::Turning { body: 0, stiffness: 0.5, axis: Y },
            BodySpring::Between { bodies: [0, 1], stiffness: 2.0, direction: Z },
        ],
        ..Springs::default()
    };
    let loads = vec![
        applied(Gravity { acceleration: Vec3::new(0.0, 0.1, -0.4) }),
        applied(Pressure { value: 0.03, follower: true }),
        applied(RigidLoad { set: 0, force: X * 0.1, couple: Y * 0.05 }),
    ];
    let supports = vec![supported(held, Clamped)];
    let parts = Parts { supports, loads, threads, ..parts(cloud, CELLS, 0.05) };
    let ties = vec![Tie { edge, host }];
    Shell::builder(parts).ties(ties).rigid(sets).springs(springs).build().unwrap()
}

/// Places of the first plate beside the joint.
fn on_first(x: &Vec3) -> bool {
    x.z.abs() < 1e-9
}

/// A strip that yields in bending and is let go again.
fn yielding(threads: usize) -> Shell {
    let cloud = common::flat([121, 13], [3.0, 0.3]);
    let sides = cloud.sides.clone().unwrap();
    let elastic = Isotropic::new(common::YOUNG, common::POISSON).unwrap();
    let curve = Hardening::voce(0.5, 0.2, 10.0).unwrap();
    let section = Box::new(PlasticSection::new(Plastic::new(elastic, curve), 0.05, 4).unwrap());
    let tip = sides.edge(sph_core::Side::U1).iter().map(|&a| (a, 1.0)).collect();
    let loads = vec![AppliedLoad {
        load: Box::new(Force { shares: tip, total: Z * 0.05 - X * 0.02 }),
        amplitude: Amplitude::Ramp(0.01),
    }];
    let supports = vec![supported(sides.edge(sph_core::Side::U0).to_vec(), Clamped)];
    let parts =
        Parts { section, strain: &Logarithmic, supports, loads, threads, ..parts(cloud, CELLS, 0.05) };
    Shell::builder(parts).build().unwrap()
}

/// Both shells by every plan: records, motion, reactions and histories, on one thread or on two.
#[test]
fn what_depends_on_others_and_what_remembers_tells_the_same_whoever_marches_it() {
    let bodies: [fn(usize) -> Shell; 2] = [frame, yielding];
    for (name, body) in ["frame", "yielding"].into_iter().zip(bodies) {
        for (number, plan) in plans().into_iter().enumerate() {
            let alone = reported(&plan, body(1));
            assert!(alone.0.len() > 2, "{name}: {:?}", alone.0);
            for count in [1, 2, 3, 4, 7] {
                let threads = 1 + (count + number) % 2;
                let all = together(count, |peers| reported(&plan, shared(body(threads), peers))).unwrap();
                for (rank, found) in all.into_iter().enumerate() {
                    assert!(found == alone, "{name}: {count} peers, rank {rank}, {threads} threads");
                }
            }
        }
    }
    // They are what they are said to be.
    let frame = frame(1);
    assert_eq!(frame.rigid_bodies()[0], 2);
    assert!(frame.len() > 3 * peers::CHUNK && frame.tied().1 > 30, "{:?}", frame.tied());
    let mut yielded = yielding(1);
    common::records(plans()[0].clone(), &mut yielded).unwrap();
    assert!(yielded.history().iter().any(|number| *number != 0.0));
}

/// A history that several brought is one from which others go on: three march half, one or two the rest.
#[test]
fn a_march_goes_on_with_other_peers() {
    let plan = &plans()[0];
    let first = |mut shell: Shell| {
        common::records(plan.clone(), &mut shell).unwrap();
        shell.bring();
        let [state, rates] = shell.motion().map(<[[f64; 6]]>::to_vec);
        (state, rates, shell.history())
    };
    let kept = together(3, |peers| first(shared(yielding(1), peers))).unwrap();
    let (state, rates, history) = &kept[2];
    let second = |mut shell: Shell| {
        assert!(shell.take_up([state, rates]) && shell.take_up_history(history));
        reported(plan, shell)
    };
    let alone = second(yielding(1));
    for count in [1, 2, 4] {
        let all = together(count, |peers| second(shared(yielding(1), peers))).unwrap();
        assert!(all.iter().all(|found| *found == alone), "{count} peers");
    }
}
