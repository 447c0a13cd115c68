//! Solids in a fluid: nodes bear what acts on the points, their outermost row resists, and two clocks keep their bits.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;

use std::f64::consts::PI;

use explicit_dynamics::{
    BoundaryDriven, BoundaryLoad, BoundaryState, Bounds, Clock, Dynamics, Instant, March, MarchError,
    OutOfBounds, StableStep, Step, Transient, TwoClocks, Wetted, Work,
};
use lattices::{Random, displace, formulation, lattice, parts, plane, poisson};
use peridynamics::{
    Criterion, Elastic, Fracture, Idealisation, Law, Parts, Sheets, Solid, SolidError, Space,
};
use peridynamics::{Support, Supported};
use sph_core::{Block, Vec3};

const DX: f64 = 0.1;
const THICKNESS: f64 = 0.5;

fn solid(block: Block, space: Space) -> Solid {
    let material = Elastic { young: 100.0, poisson: poisson(space, Law::BondBased), density: 1.0 };
    let mut solid = Solid::new(parts(block, material, formulation(space, Law::BondBased))).unwrap();
    solid.wet().unwrap();
    solid
}

/// A plate in the plane, 12 × 5 nodes, half as thick as long units are.
fn sheet() -> Solid {
    solid(lattice(2, [12, 5, 1], [DX, DX, THICKNESS]), Space::PlaneStress)
}

fn under(body: &mut Solid, forces: &[[f64; 3]], seen: &[[f64; 3]], impedance: f64) -> Vec<Vec3> {
    body.apply_load(&BoundaryLoad { forces, found: forces, seen, impedance });
    body.evaluate(Instant { time: 0.0, level: 1.0 });
    (0..body.len()).map(|node| body.external_force(node)).collect()
}

#[test]
fn nodes_are_the_points_and_bear_their_forces() {
    for (mut body, width, area) in
        [(sheet(), THICKNESS, DX), (solid(lattice(3, [5, 4, 4], [DX; 3]), Space::Solid), 1.0, DX * DX)]
    {
        let mut dice = Random(4);
        displace(&mut body, |_| dice.vector(2) * 1e-3);
        (0..body.len()).for_each(|node| body.set_velocity(node, dice.vector(2)));
        let (mut state, mut velocities) = (BoundaryState::default(), Vec::new());
        body.boundary(&mut state);
        body.boundary_velocities(&mut velocities);
        let layout = body.boundary_layout();
        assert!(layout.points == body.len() && layout.thin.is_none() && state.middle.is_empty());
        assert!(layout.areas.iter().all(|a| (a - area).abs() < 1e-12 * area));
        let forces: Vec<[f64; 3]> = (0..body.len()).map(|_| dice.vector(2).into()).collect();
        let found = under(&mut body, &forces, &velocities, 0.0);
        for node in 0..body.len() {
            assert_eq!(Vec3::from(state.points[node]), body.position(node));
            assert_eq!(Vec3::from(velocities[node]), body.velocity(node));
            assert_eq!(found[node], Vec3::from(forces[node]) * width);
        }
    }
}

/// A fluid presses on three rows of a plate that moves against it; turned by any angle its outermost row resists once.
#[test]
fn the_outermost_row_resists() {
    let (z, speed, seen) = (7.0, 0.3, 0.1);
    for turn in [0.0, 0.25 * PI, 1.0, 0.5 * PI, 4.0] {
        let turned = |x: Vec3| nalgebra::Rotation3::from_axis_angle(&Vec3::z_axis(), turn) * x;
        let mut body = sheet();
        displace(&mut body, |x| turned(x) - x);
        let up = turned(Vec3::y());
        (0..body.len()).for_each(|node| body.set_velocity(node, up * speed + turned(Vec3::x())));
        let places = body.block().positions.clone();
        let row = |node: usize| (places[node].y / DX) as usize;
        let load = |rows: &dyn Fn(usize) -> bool| -> Vec<[f64; 3]> {
            (0..places.len())
                .map(|node| if rows(row(node)) { (-up * 1e-9).into() } else { [0.0; 3] })
                .collect()
        };
        let saw = vec![(up * seen).into(); places.len()];
        let total = |forces: Vec<Vec3>| forces.iter().sum::<Vec3>();
        let top = total(under(&mut body, &load(&|row| row > 1), &saw, z));
        let force = -z * 12.0 * DX * THICKNESS * (speed - seen);
        assert!((top.dot(&up) / force - 1.0).abs() < 1e-6 && top.cross(&up).norm() < 1e-12, "{turn}: {top}");
        assert!(total(under(&mut body, &load(&|_| false), &saw, z)) == Vec3::zeros());
        // Torn apart below its third row it has a second face, which the fluid reaches.
        for node in (0..places.len()).filter(|&node| row(node) > 2) {
            body.put(node, body.position(node) + up * (2.5 * DX));
        }
        let torn = total(under(&mut body, &load(&|_| true), &saw, z));
        assert!((torn.dot(&up) / force - 2.0).abs() < 1e-6, "{turn}: {torn} {force}");
    }
}

#[test]
fn in_space_a_face_resists_with_its_area() {
    let mut body = solid(lattice(3, [6, 5, 4], [DX; 3]), Space::Solid);
    (0..body.len()).for_each(|node| body.set_velocity(node, Vec3::new(0.2, 0.0, 0.4)));
    let forces = vec![[0.0, 0.0, 1e-9]; body.len()];
    let seen = vec![[0.0; 3]; body.len()];
    let total: Vec3 = under(&mut body, &forces, &seen, 7.0).iter().sum();
    let expected = -7.0 * 30.0 * DX * DX * 0.4;
    assert!((total.z / expected - 1.0).abs() < 1e-6 && total.x.abs() < 1e-12, "{total}");
    // What the fluid takes back: the force by the span.
    let mut impulses = vec![[0.0; 3]; body.len()];
    body.impedance_impulses(0.5, &mut impulses);
    let taken: f64 = impulses.iter().map(|impulse| impulse[2]).sum();
    assert!((taken / (0.5 * expected) - 1.0).abs() < 1e-12, "{taken}");
}

#[test]
fn sheets_stay_dry() {
    let material = Elastic { young: 100.0, poisson: 1.0 / 3.0, density: 1.0 };
    let formulation = formulation(Space::PlaneStress, Law::BondBased);
    let carrier = Idealisation::Sheets(Sheets { thickness: 1.0, formulation });
    let mut plate =
        Solid::new(Parts { formulation: carrier, ..parts(plane([6, 6], DX), material, formulation) })
            .unwrap();
    assert_eq!(plate.wet(), Err(SolidError::WetSheets));
    assert_eq!(plate.boundary_layout().points, 0);
}

/// A fluid that presses on the top row of nodes and yields by plane waves; in its points it keeps nothing but velocities.
struct Press {
    dt: f64,
    pressure: f64,
    forces: Vec<[f64; 3]>,
    velocities: Vec<[f64; 3]>,
    top: Vec<bool>,
}

impl Dynamics for Press {
    fn evaluate(&mut self, _: Instant) -> f64 {
        let impedance = self.impedance();
        for node in (0..self.top.len()).filter(|&node| self.top[node]) {
            self.forces[node][1] = -DX * (self.pressure + impedance * self.velocities[node][1]);
        }
        0.0
    }
    fn kick(&mut self, _: &Step) -> Work {
        Work::default()
    }
    fn drift(&mut self, _: &Step) {}
    fn stable_step(&mut self, _: f64) -> Result<StableStep, MarchError> {
        Ok(StableStep { dt: self.dt, holds: 1 })
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        Ok(())
    }
    fn stop(&mut self) {}
}

impl BoundaryDriven for Press {
    fn set_boundary(&mut self, _: usize, _: &BoundaryState, velocities: &[[f64; 3]]) {
        self.velocities.copy_from_slice(velocities);
    }
    fn boundary_forces(&self, _: usize) -> &[[f64; 3]] {
        &self.forces
    }
    // Half a space carries what it takes back away.
    fn apply_reactions(&mut self, _: usize, _: &[[f64; 3]]) {}
    fn impedance(&self) -> f64 {
        2.0
    }
    fn greatest_displacement(&self) -> f64 {
        DX
    }
}

type Coupled = TwoClocks<Press, Solid>;

/// A brittle beam that the fluid breaks off its clamp; a step of the fluid is four of its.
fn beam(threads: usize) -> Coupled {
    let block = lattice(2, [120, 9, 1], [DX, DX, THICKNESS]);
    let held = (0..block.len() as u32).filter(|&node| block.positions[node as usize].x < 3.0 * DX).collect();
    let held = Supported {
        nodes: held,
        support: Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() },
    };
    let top: Vec<bool> = block.positions.iter().map(|x| x.y > 8.0 * DX).collect();
    let material = Elastic { young: 100.0, poisson: 1.0 / 3.0, density: 1.0 };
    let criterion = Criterion::EnergyByStretch(2e-3);
    let mut body = Solid::new(Parts {
        supports: vec![held],
        fracture: Some(Fracture { criterion, unbreakable: Vec::new() }),
        threads,
        ..parts(block, material, formulation(Space::PlaneStress, Law::BondBased))
    })
    .unwrap();
    body.wet().unwrap();
    let dt = 3.999 * body.stable_step(0.8).unwrap().dt;
    let zero = vec![[0.0; 3]; body.len()];
    let fluid = Press { dt, pressure: 0.3, forces: zero.clone(), velocities: zero, top };
    TwoClocks::new(fluid, vec![Box::new(body)])
}

fn body(system: &Coupled) -> &Solid {
    system.structures().next().unwrap()
}

fn bits(system: &Coupled) -> Vec<u64> {
    let [rows, rates] = body(system).motion();
    let (own, broken) = (system.state(), body(system).broken());
    let numbers = rows.iter().chain(rates).flatten().chain(&own).chain(broken.iter().flatten());
    numbers.map(|x| x.to_bits()).collect()
}

const STEPS: u64 = 200;

#[test]
fn threads_do_not_change_a_bit_of_a_wet_solid() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut system = beam(threads);
            let mut clock = Clock::start(&mut system, 1.0, 0.8, 0.0).unwrap();
            (0..STEPS).for_each(|_| clock.step(&mut system, f64::INFINITY, |_| 1.0).unwrap());
            assert!(system.counts().most == 4 && body(&system).broken()[0].len() > 20);
            bits(&system)
        })
    };
    let one = run(1);
    for threads in [2, 4] {
        assert!(run(threads) == one, "{threads} threads give other bits");
    }
}

#[test]
fn a_breaking_solid_goes_on_to_the_same_bits() {
    let (mut whole, mut again) = (beam(1), beam(1));
    let dt = whole.fluid().dt;
    let run = Transient { duration: STEPS as f64 * dt, record_every: 40.0 * dt, damping: 0.0, safety: 0.8 };
    let mut march = March::start(run, &mut whole).unwrap();
    while march.state().is_none_or(|at| at.clock.steps < 151) {
        march.advance(&mut whole).unwrap();
    }
    let (at, own) = (march.state().unwrap().clone(), whole.state());
    let [rows, rates] = body(&whole).motion().map(<[[f64; 4]]>::to_vec);
    let ([broken, energy, work], velocities) = (body(&whole).broken(), whole.fluid().velocities.clone());
    march.finish(&mut whole).unwrap();
    assert!(!broken.is_empty() && broken.len() < body(&whole).broken()[0].len());
    let solid = again.structures_mut().next().unwrap();
    assert!(solid.take_up([&rows, &rates], [&broken, &energy, &work]));
    again.fluid_mut().velocities = velocities;
    assert!(again.set_state(&own));
    March::resume(run, at).finish(&mut again).unwrap();
    assert!(bits(&whole) == bits(&again));
}
