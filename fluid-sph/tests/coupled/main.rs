//! A fluid and its structures that several march together, structures whole with each: whole marches to the same bits.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod body;
#[path = "../common/mod.rs"]
mod common;

use body::Body;
use common::{disorder, lattice, pool};
use explicit_dynamics::{Bounds, Clock, Dynamics, March, Order, Transient, TwoClocks};
use fluid_sph::{Fluid, Formulation, Parts, Start};
use peers::{Peers, together};
use sph_core::Vec3;

/// A fluid with structures, and how they are marched.
#[derive(Clone)]
struct Case {
    parts: Parts,
    bodies: Vec<Body>,
    order: Order,
    centred: bool,
    impedance: bool,
}

type System = TwoClocks<Fluid, Body>;

impl Case {
    /// Structures of so many steps to about one of the fluid, their springs by the parts of a turn in one of theirs.
    fn new(mut parts: Parts, bodies: Vec<Body>, substeps: f64, turns: [f64; 2]) -> Self {
        let sound = parts.liquid.sound_speed;
        let dt = 0.3 * parts.formulation.smoothing * parts.spacing / sound / substeps;
        let bodies: Vec<Body> = bodies.into_iter().map(|body| body.with_step(dt, turns)).collect();
        parts.structures = bodies.iter().map(Body::structure).collect();
        Self { parts, bodies, order: Order::StructureFirst, centred: true, impedance: true }
    }

    fn fluid_first(self) -> Self {
        Self { order: Order::FluidFirst, ..self }
    }

    fn system(&self, peers: Option<Box<dyn Peers>>) -> System {
        let bodies = self.bodies.iter().cloned().map(Box::new).collect();
        let mut system = TwoClocks::new(Fluid::new(self.parts.clone()).unwrap(), bodies);
        (system.order, system.centred, system.impedance) = (self.order, self.centred, self.impedance);
        if let Some(peers) = peers {
            system.fluid_mut().share(peers).unwrap();
        }
        system
    }
}

/// All that is read of a march, as bits by name.
type Read = Vec<(String, Vec<u64>)>;

fn read(system: &mut System) -> Read {
    system.fluid_mut().bring();
    let fluid = system.fluid();
    let mut all: Vec<(String, Vec<f64>)> =
        fluid.state().into_iter().map(|(name, numbers)| (name.to_owned(), numbers.into_owned())).collect();
    let energies = fluid.energies();
    all.push(("energies".into(), vec![energies.kinetic, energies.compression, energies.viscous]));
    all.push(("clocks".into(), system.state()));
    for (number, body) in system.structures().enumerate() {
        let vectors = [fluid.structure_force(number), fluid.structure_moment(number, Vec3::x())];
        let forces = vectors.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
        all.push((format!("force on {number}"), forces));
        all.push((format!("pressures on {number}"), fluid.structure_pressures(number)));
        let moved = body.x.iter().chain(&body.v).flatten().copied().collect();
        all.push((format!("structure {number}"), moved));
        all.push((
            format!("energy of {number}"),
            system.energy(number).map(|e| e.external).into_iter().collect(),
        ));
        all.push((format!("ahead {number}"), system.impulse_ahead(number).unwrap().to_vec()));
    }
    all.into_iter().map(|(name, numbers)| (name, numbers.into_iter().map(f64::to_bits).collect())).collect()
}

fn marched(system: &mut System, clock: &mut Clock, steps: usize) {
    for _ in 0..steps {
        clock.step(system, f64::INFINITY, |_| 1.0).unwrap();
        system.within_bounds(Bounds::Motion).unwrap();
    }
}

/// A march of so many steps: what is read in the middle and at the end, and the clock.
fn march(
    case: &Case,
    steps: usize,
    peers: Option<Box<dyn Peers>>,
) -> (Read, String, [Vec<usize>; 2], [f64; 2]) {
    let mut system = case.system(peers);
    let first = system.fluid().own_particles().collect();
    let mut clock = Clock::start(&mut system, 1.0, 1.0, 0.0).unwrap();
    let mut found = Vec::new();
    for _ in 0..2 {
        marched(&mut system, &mut clock, steps / 2);
        found.extend(read(&mut system));
    }
    let force = system.fluid().structure_force(0).norm();
    let moved =
        system.structures().next().unwrap().x.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let last = system.fluid().own_particles().collect();
    let counts = system.counts();
    (found, format!("{clock:?} {counts:?}"), [first, last], [force, moved])
}

/// Whole marches alone and by several; how many particles changed owner, and how far the first structure went.
fn same(what: &str, case: &Case, steps: usize, counts: &[usize]) -> (usize, f64) {
    let (alone, clock, _, [force, moved]) = march(case, steps, None);
    println!("{what}: force {force}, moved {moved}, {clock}");
    assert!(force > 0.0, "{what}: no force");
    let mut changed = 0;
    for &count in counts {
        let all = together(count, |peers| march(case, steps, Some(peers))).unwrap();
        changed = 0;
        for (rank, (found, own_clock, [first, last], _)) in all.iter().enumerate() {
            for (found, alone) in found.iter().zip(&alone) {
                assert!(found == alone, "{what}, {count} peers, rank {rank}: {}", alone.0);
            }
            assert_eq!(own_clock, &clock, "{what}, {count} peers, rank {rank}");
            changed += first.iter().filter(|particle| last.binary_search(particle).is_err()).count();
        }
        println!("{what}: {changed} of {} changed owner, {count} peers", case.parts.positions.len());
    }
    (changed, moved)
}

/// A plate between water of two depths.
fn gate(substeps: f64) -> Case {
    let spacing = 0.025;
    let mut parts = pool(2, [0.5, 0.8, 0.0], [1.1, 0.8, 0.0], spacing);
    parts.positions.extend(lattice([0.6, 0.0, -0.5 * spacing], [20, 12, 1], spacing));
    disorder(&mut parts, 0.2, 0.3);
    let plate = Body::plate(0, [0.5375, 0.0, -0.5 * spacing], [1, 32, 1], spacing, 1500.0);
    Case::new(parts, vec![plate], substeps, [0.02, 0.2])
}

/// A column that falls on a block.
fn dam(dimensions: usize) -> Case {
    let spacing = if dimensions == 2 { 0.025 } else { 0.05 };
    let (water, basin) =
        if dimensions == 2 { ([0.5, 1.0, 0.0], [1.6, 1.0, 0.0]) } else { ([0.4, 0.3, 0.4], [0.9, 0.3, 0.5]) };
    let mut parts = pool(dimensions, water, basin, spacing);
    disorder(&mut parts, 0.2, 0.3);
    parts.liquid.sound_speed *= 0.5;
    let bodies = if dimensions == 2 {
        vec![Body::block([0.525, 0.0, -0.5 * spacing], [8, 12, 1], spacing, 800.0)]
    } else {
        let plate = Body::plate(0, [0.45, 0.0, 0.0], [1, 6, 4], spacing, 2000.0);
        vec![plate, Body::block([0.75, 0.05, 0.0], [3, 3, 4], spacing, 800.0)]
    };
    Case::new(parts, bodies, 2.5, [0.01, 0.1])
}

/// Water so long that each knows a small part, and a thin plate through its middle and a block on its surface that fly along.
fn flight(dimensions: usize) -> Case {
    let spacing = if dimensions == 2 { 0.025 } else { 0.05 };
    let depth = if dimensions == 2 { -0.5 * spacing } else { 0.0 };
    let (length, layers) = (4.0, 4.0 * spacing);
    let mut parts = pool(dimensions, [length, layers, 2.0 * spacing], [1.0; 3], spacing);
    parts.walls.clear();
    parts.start = Start::Uniform;
    parts.gravity = Vec3::zeros();
    let upper: Vec<Vec3> = parts.positions.iter().map(|p| p + Vec3::y() * (layers + 2.0 * spacing)).collect();
    parts.positions.extend(upper);
    parts.liquid.sound_speed = 10.0;
    disorder(&mut parts, 0.2, 0.2);
    let deep = if dimensions == 2 { 1 } else { 2 };
    let plate = Body::plate(1, [1.0, layers + 0.5 * spacing, depth], [20, 1, deep], spacing, 3000.0);
    let block = Body::block([2.0, 2.0 * layers + 2.0 * spacing, depth], [8, 3, deep], spacing, 3000.0);
    let bodies = vec![plate.moving([1.0, 0.0, 0.0]), block.moving([-1.5, 0.0, 0.0])];
    Case::new(parts, bodies, 1.0, [0.0, 0.1])
}

#[test]
fn gates_give_way_the_same_whoever_marches_them() {
    same("gate", &gate(3.2), 200, &[1, 2, 3, 4, 7]);
    same("gate, fluid first", &gate(2.4).fluid_first(), 200, &[2, 7]);
    same("gate, plain loads", &Case { centred: false, impedance: false, ..gate(1.0) }, 160, &[3]);
    let late = Case { centred: false, ..gate(2.4).fluid_first() };
    same("gate, fluid first, plain loads", &late, 160, &[4]);
    let mut threads = gate(2.4);
    threads.parts.threads = 2;
    same("gate, two threads each", &threads, 100, &[3]);
}

#[test]
fn dams_fall_on_structures_the_same_whoever_marches_them() {
    for dimensions in [2, 3] {
        let counts: &[usize] = if dimensions == 2 { &[1, 2, 3, 4, 7] } else { &[3, 7] };
        let (changed, _) = same("dam", &dam(dimensions), 300, counts);
        assert!(changed > 50, "{changed}");
        same("dam, fluid first", &dam(dimensions).fluid_first(), 200, &[4]);
    }
    let mut viscous = dam(2);
    viscous.parts.formulation =
        Formulation { kinematic_viscosity: 1e-2, xsph: 0.3, ..Formulation::default() };
    same("dam, viscous", &viscous, 200, &[4]);
}

/// Structures that go many times as far as neighbours are known, so that all is dealt out anew for them.
#[test]
fn structures_go_far_the_same_whoever_marches_them() {
    for dimensions in [2, 3] {
        let (_, moved) = same("flight", &flight(dimensions), 600, &[7]);
        assert!(moved > 6.0 * flight(dimensions).parts.spacing, "{moved}");
    }
    same("flight, fluid first", &flight(2).fluid_first(), 400, &[3]);
}

/// Records of a march, with works and energies.
#[test]
fn records_are_the_same_whoever_makes_them() {
    for case in [gate(2.4), dam(2).fluid_first()] {
        let run = |peers: Option<Box<dyn Peers>>| {
            let mut system = case.system(peers);
            let run = Transient { duration: 0.1, record_every: 0.005, damping: 0.0, safety: 1.0 };
            let (mut records, mut march) = (String::new(), March::start(run, &mut system).unwrap());
            while let Some(record) = march.next_record(&mut system).unwrap() {
                records += &format!("{record:?} {:?}\n", system.energy(0));
            }
            records
        };
        let alone = run(None);
        for count in [2, 7] {
            assert_eq!(together(count, |peers| run(Some(peers))).unwrap(), vec![alone.clone(); count]);
        }
    }
}

/// What is kept of a march in the middle: fluid, clocks, structures and the clock of the march.
type Kept = (Vec<(&'static str, Vec<f64>)>, Vec<f64>, Vec<Body>, Clock);

/// A state of some, taken up by others in the middle of a march that stand elsewhere.
#[test]
fn a_state_goes_on_with_any_number() {
    for case in [gate(2.4), dam(2).fluid_first()] {
        let (whole, words, ..) = march(&case, 160, None);
        let keep = |peers: Box<dyn Peers>| -> Kept {
            let mut system = case.system(Some(peers));
            let mut clock = Clock::start(&mut system, 1.0, 1.0, 0.0).unwrap();
            marched(&mut system, &mut clock, 80);
            system.fluid_mut().bring();
            let fluid =
                system.fluid().state().into_iter().map(|(name, own)| (name, own.into_owned())).collect();
            (fluid, system.state(), system.structures().cloned().collect(), clock)
        };
        let (fluid, clocks, bodies, clock) = together(3, keep).unwrap().swap_remove(1);
        let go_on = |peers: Option<Box<dyn Peers>>| {
            let mut system = case.system(peers);
            let mut other = Clock::start(&mut system, 1.0, 1.0, 0.0).unwrap();
            marched(&mut system, &mut other, 5);
            let arrays: Vec<(&str, &[f64])> = fluid.iter().map(|(name, own)| (*name, &own[..])).collect();
            system.fluid_mut().set_state(&arrays).unwrap();
            assert!(system.set_state(&clocks));
            system.structures_mut().zip(&bodies).for_each(|(own, body)| *own = body.clone());
            let mut clock = clock.clone();
            marched(&mut system, &mut clock, 80);
            (read(&mut system), format!("{clock:?} {:?}", system.counts()))
        };
        let last = whole[whole.len() / 2..].to_vec();
        assert!(go_on(None) == (last.clone(), words.clone()));
        for count in [1, 2, 4, 7] {
            let all = together(count, |peers| go_on(Some(peers))).unwrap();
            assert!(all.iter().all(|found| *found == (last.clone(), words.clone())), "{count} peers");
        }
    }
}

/// A fluid that is shared before its structures are put elsewhere than it was built with.
#[test]
fn structures_may_start_elsewhere() {
    let case = flight(2);
    let run = |peers: Option<Box<dyn Peers>>| {
        let mut fluid = Fluid::new(case.parts.clone()).unwrap();
        if let Some(peers) = peers {
            fluid.share(peers).unwrap();
        }
        let mut bodies = case.bodies.clone();
        bodies.iter_mut().for_each(|body| body.x.fill([0.7, 0.0, 0.0]));
        let mut system = TwoClocks::new(fluid, bodies.into_iter().map(Box::new).collect());
        let start = read(&mut system);
        let mut clock = Clock::start(&mut system, 1.0, 1.0, 0.0).unwrap();
        marched(&mut system, &mut clock, 60);
        (start, read(&mut system))
    };
    let alone = run(None);
    for count in [2, 7] {
        assert!(
            together(count, |peers| run(Some(peers))).unwrap().iter().all(|found| *found == alone),
            "{count}"
        );
    }
}
