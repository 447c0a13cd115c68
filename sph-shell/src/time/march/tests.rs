//! One sweep, two passes and peers: the same bits on many layouts.

// Said here too: `cargo xtask tidy` reads files one by one.
#[cfg(test)]
use explicit_dynamics::{Amplitude, LinearisedDynamics};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{
    Cell, Cloud, Cylinder, EndWeights, Patch, Plate, Side, Vec3, jittered_lattice, lattice, poisson_cloud,
};

use super::*;
use crate::Parts;
use crate::conditions::couple::{CoupleAxis, EdgeCouple};
use crate::conditions::loads::{AppliedLoad, Force, Gravity, Load};
use crate::conditions::preload::Preloaded;
use crate::conditions::pressure::{Pressure, PressurePatch};
use crate::conditions::springs::{Spring, SpringBetween, Springs, TurnSpring};
use crate::conditions::supports::{Clamped, Supported};
use crate::formulation::{Formulation, Reach};
use crate::gather::Places;
use crate::time::fused::Fused;

/// Layouts that are tried.
const LAYOUTS: usize = 80;

/// Whole numbers that look random.
#[derive(Clone)]
struct RandomNumbers(u64);

impl RandomNumbers {
    /// One from `low` to `high`, both included.
    fn roll(&mut self, low: usize, high: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (self.0 >> 33) as usize % (high - low + 1)
    }
}

/// A cloud of 500 to 2700 particles: one to six chunks, so that parts have borders anywhere in a row.
fn layout(number: usize, dice: &mut RandomNumbers) -> Cloud {
    let (plate, roof) =
        (Plate { lengths: [2.0, 1.5] }, Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 });
    let patch: &dyn Patch = if dice.roll(0, 1) == 0 { &plate } else { &roof };
    let odd = [2 * dice.roll(10, 25) + 1, 2 * dice.roll(12, 26) + 1];
    match number % 5 {
        0 => lattice(patch, [odd[0], odd[1]], EndWeights::Trapezoid).unwrap(),
        // one row of cells, whose particles lie side by side or the length of the strip apart
        1 => {
            let long = dice.roll(260, 1350);
            let (counts, lengths) = match dice.roll(0, 1) {
                0 => ([long, 2], [long as f64, 1.0]),
                _ => ([2, long], [1.0, long as f64]),
            };
            lattice(&Plate { lengths }, counts, EndWeights::Trapezoid).unwrap()
        }
        2 => jittered_lattice(patch, odd, 0.25, number as u64).unwrap(),
        3 => poisson_cloud(patch, 0.01 * dice.roll(4, 6) as f64, number as u64).unwrap(),
        _ => with_triangles(&lattice(patch, odd, EndWeights::Trapezoid).unwrap(), dice.roll(66, 90)),
    }
}

/// Every so many cells one is cut in two.
pub(crate) fn with_triangles(cloud: &Cloud, every: usize) -> Cloud {
    let cut = |(number, cell): (usize, &Cell)| {
        let [a, b, c, d] = cell.corners;
        if number % every == 0 {
            vec![Cell::triangle([a, b, c]), Cell::triangle([a, c, d])]
        } else {
            vec![*cell]
        }
    };
    let cells = cloud.cells.iter().enumerate().flat_map(cut).collect();
    let normals = cloud.frames.iter().map(|frame| frame.n).collect();
    let cut = Cloud::from_cells(cloud.positions.clone(), Some(normals), cells).unwrap();
    Cloud { sides: cloud.sides.clone(), ..cut }
}

/// Loads of every kind. The edge is not in a row, so that a couple about it reads particles far from those that it turns.
fn loads(cloud: &Cloud) -> Vec<AppliedLoad> {
    let edge = cloud.sides.as_ref().unwrap().edge(Side::U1);
    let part = |a: &u32| (*a, 1.0 + 0.01 * f64::from(*a % 7));
    let unlike: Vec<(u32, f64)> =
        [0, 1, 2].iter().flat_map(|&i| edge.iter().skip(i).step_by(3)).map(part).collect();
    let shares = (0..cloud.len() as u32).step_by(5).map(|a| part(&a)).collect();
    let patch = PressurePatch {
        pressure: Pressure { value: -0.03, follower: false },
        cells: (0..cloud.cells.len() as u32).rev().step_by(3).collect(),
        factors: (0..cloud.len()).map(|a| 1.0 / (1.0 + a as f64)).collect(),
    };
    let preloaded: Box<dyn Load> = Box::new(Pressure { value: 0.01, follower: false });
    let all: Vec<Box<dyn Load>> = vec![
        Box::new(Pressure { value: 0.01, follower: true }),
        Box::new(Gravity { acceleration: Vec3::new(0.1, 0.2, -0.3) }),
        Box::new(Force { shares, total: Vec3::new(0.3, -0.1, 0.2) }),
        Box::new(EdgeCouple { edge: unlike.clone(), moment: 0.01, axis: CoupleAxis::Edge }),
        Box::new(EdgeCouple { edge: unlike, moment: 0.02, axis: CoupleAxis::Fixed(Vec3::x()) }),
        Box::new(patch),
        Box::new(Preloaded(preloaded)),
    ];
    all.into_iter().map(|load| AppliedLoad { load, amplitude: Amplitude::Ramp(1e-5) }).collect()
}

/// Springs of every kind on particles; between pairs that stand far from each other.
fn springs(cloud: &Cloud) -> Springs {
    let count = cloud.len() as u32;
    let some = |step: usize| (0..count).step_by(step).map(|a| (a, 0.1 + 0.001 * f64::from(a)));
    let axis = Vec3::new(0.3, 0.2, 0.0).normalize();
    let turns = |a: u32| cloud.frames[a as usize].n.cross(&axis).norm() > 0.2;
    let pairs = (0..count / 2).step_by(3).map(|a| ([a, count - 1 - a], 0.2 + 0.001 * f64::from(a)));
    Springs {
        ground: vec![Spring { stiffness: some(2).collect(), direction: Vec3::new(0.1, 0.2, 1.0) }],
        turning: vec![TurnSpring { stiffness: some(3).filter(|(a, _)| turns(*a)).collect(), axis }],
        between: vec![SpringBetween { stiffness: pairs.collect(), direction: Vec3::z() }],
        of_bodies: Vec::new(),
    }
}

/// What acts on a shell from outside: nothing, a pressure, or all there is, with a function that pulls each particle to the middle of all.
#[derive(Clone, Copy, PartialEq)]
enum Acting {
    Nothing,
    Pressure,
    All,
}

const ACTING: [Acting; 3] = [Acting::Nothing, Acting::Pressure, Acting::All];

/// The shell of a cloud, clamped at an edge, under what acts on it; positions and rates are rough.
fn body(cloud: Cloud, acting: Acting, threads: usize, dice: &mut RandomNumbers) -> Shell {
    let held = cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec();
    let size = 0.05 * cloud.spacing();
    let mut loads = loads(&cloud);
    loads.truncate(match acting {
        Acting::Nothing => 0,
        Acting::Pressure => 1,
        Acting::All => loads.len(),
    });
    let springs = if acting == Acting::All { springs(&cloud) } else { Springs::default() };
    let mut shell = Shell::builder(Parts {
        cloud,
        section: Box::new(IsotropicSection::new(Isotropic::new(1200.0, 0.3).unwrap(), 0.05).unwrap()),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: vec![Supported { particles: held, support: Box::new(Clamped) }],
        loads,
        threads,
    })
    .springs(springs)
    .build()
    .unwrap();
    if acting == Acting::All {
        shell.push(Box::new(|_, x, v, f| {
            let middle = [0, 1, 2].map(|k| x.iter().map(|x| x[k]).sum::<f64>() / x.len() as f64);
            for (a, f) in f.iter_mut().enumerate() {
                *f = [0, 1, 2].map(|k| 0.1 * (middle[k] - x[a][k]) - 0.2 * v[a][k]);
            }
        }));
    }
    let mut rough = || {
        let mut one = || size * (dice.roll(0, 2000) as f64 / 1000.0 - 1.0);
        Vec3::new(one(), one(), one())
    };
    for a in 0..shell.len() {
        shell.set_state(a, shell.position(a) + rough(), shell.director(a) + rough());
        shell.set_rate(a, rough(), rough());
    }
    shell
}

/// Some steps from a motion; everything they leave, as bits.
fn marched(shell: &mut Shell, from: &[Vec<Row>; 2], advance: impl Fn(&mut Shell, &Step) -> Work) -> Vec<u64> {
    assert!(shell.take_up([&from[0], &from[1]]));
    let mut bits = Vec::new();
    for number in 0..3 {
        if number == 2 {
            // A particle that is moved by hand, of the first chunk and of the last but one.
            for a in [0, shell.len() / parallel::CHUNK * parallel::CHUNK - 1] {
                shell.set_state(
                    a,
                    shell.position(a) + Vec3::new(1e-3, 2e-3, -1e-3),
                    Vec3::new(0.1, 0.2, 1.0),
                );
            }
        }
        let at = |time: f64| Instant { time, level: 1.0 };
        let dt = 1e-5;
        let time = f64::from(number) * dt;
        let work = advance(shell, &Step { from: at(time), to: at(time + dt), kick: dt, damping: 0.3 });
        bits.extend([work.kinetic, work.external, work.dissipated].map(f64::to_bits));
    }
    shell.bring();
    bits.extend(shell.motion().into_iter().flatten().flatten().map(|x| x.to_bits()));
    bits
}

#[test]
fn one_sweep_gives_the_same_bits_on_many_layouts_and_threads() {
    let mut dice = RandomNumbers(3);
    let mut several = 0;
    for number in 0..LAYOUTS {
        let mut shell = body(layout(number, &mut dice), ACTING[number % 3], 1, &mut dice);
        several += usize::from(shell.len() > 2 * parallel::CHUNK);
        let from = shell.motion().map(<[Row]>::to_vec);
        let expected = marched(&mut shell, &from, |shell, step| {
            shell.evaluate(step.from);
            let work = shell.kick(step);
            shell.drift(step);
            work
        });
        for threads in [1, 2, 3, 4] {
            let places = Places::new(&shell.points.packs, &shell.reference.operator);
            shell.evaluation.plan =
                Some(Fused::plan(&shell.points.packs, &places, [0..shell.len(), 0..shell.len()], threads));
            let found = marched(&mut shell, &from, Shell::advance);
            assert!(found == expected, "layout {number} of {} particles, {threads} threads", shell.len());
        }
    }
    assert!(several >= LAYOUTS / 2, "{several} of several chunks");
}

/// One to seven march the same layouts together, on a thread each and on two: motion, work, energy, forces, the stable step, speeds and what is out of
/// balance.
#[test]
fn peers_march_to_the_same_bits_on_many_layouts() {
    let mut dice = RandomNumbers(3);
    for number in 0..LAYOUTS {
        let cloud = layout(number, &mut dice);
        let thrown = dice.clone();
        let acting = ACTING[number % 3];
        let march = |share: Option<Box<dyn peers::Peers>>, threads: usize| {
            let mut shell = body(cloud.clone(), acting, threads, &mut thrown.clone());
            if let Some(peers) = share {
                shell.share(peers).unwrap();
            }
            let from = shell.motion().map(<[Row]>::to_vec);
            let mut bits = marched(&mut shell, &from, Shell::advance);
            bits.push(u64::from(shell.within_bounds(Bounds::Configuration).is_ok()));
            bits.push(shell.evaluate(Instant { time: 1.0, level: 1.0 }).to_bits());
            let mut vectors = [vec![0.0; 6 * shell.len()], vec![0.0; 6 * shell.len()]];
            shell.out_of_balance(&mut vectors[0]);
            MassScaled::rates(&shell, &mut vectors[1]);
            let [force, rates] = &vectors;
            bits.extend([shell.dot(force, rates), shell.displaced(), shell.fastest().1].map(f64::to_bits));
            if number % 8 == 0 {
                bits.push(shell.stable_step(1.0).unwrap().dt.to_bits());
            }
            shell.bring();
            let forces =
                |a| [shell.reaction(a), shell.reaction_moment(a)].map(|f| f.map(f64::to_bits).into());
            bits.extend((0..shell.len()).flat_map(forces).flat_map(|force: [u64; 3]| force));
            bits
        };
        let alone = march(None, 1);
        body(cloud.clone(), acting, 1, &mut dice);
        for count in [1, 2, 3, 4, 7] {
            let threads = 1 + (number + count) % 2;
            let all = peers::together(count, |peers| march(Some(peers), threads)).unwrap();
            let same = all.iter().all(|found| *found == alone);
            assert!(same, "layout {number}, {count} peers on {threads} threads each");
        }
    }
}
