//! Water that comes in and goes out: plug flow, counts of what passes, levels, pulses, energies, the same bits however it is run.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{GRAVITY, lattice, march, recorded};
use explicit_dynamics::{Amplitude, Bounds, Clock, Dynamics};
use fluid_sph::{Fluid, FluidError, Formulation, Given, Liquid, Opening, Parts, Periods, Start, Wall};
use sph_core::Vec3;

const SPACING: f64 = 0.02;

fn opening(x: f64, into: f64, given: Given) -> Opening {
    Opening { at: Vec3::x() * x, into: Vec3::x() * into, given }
}

fn velocity(into: f64) -> Given {
    Given::Velocity { into, course: Amplitude::Constant, profile: Vec::new(), level: None }
}

fn level(level: f64) -> Given {
    Given::Pressure { at_level: 0.0, level }
}

/// A channel of a length and rows of water at a velocity, whose bed goes on five spacings beyond its ends.
fn parts(length: f64, rows: usize, at_start: f64) -> Parts {
    let columns = (length / SPACING).round() as usize;
    let positions = lattice([0.0, 0.0, -0.5 * SPACING], [columns, rows, 1], SPACING);
    let bed = lattice([-5.0 * SPACING, -3.0 * SPACING, -0.5 * SPACING], [columns + 10, 3, 1], SPACING);
    Parts {
        dimensions: 2,
        spacing: SPACING,
        velocities: vec![Vec3::x() * at_start; positions.len()],
        positions,
        liquid: Liquid { density: 1000.0, sound_speed: 12.0 * (GRAVITY * rows as f64 * SPACING).sqrt() },
        formulation: Formulation { viscosity: 0.002, slip: true, ..Formulation::default() },
        gravity: Vec3::y() * -GRAVITY,
        start: Start::Hydrostatic,
        walls: vec![Wall { points: bed, motion: None }],
        structures: Vec::new(),
        domain: None,
        threads: 1,
    }
}

fn opened(parts: Parts, openings: Vec<Opening>) -> Fluid {
    let room = 2 * parts.positions.len();
    let mut fluid = Fluid::new(parts).unwrap();
    fluid.open(openings, room).unwrap();
    fluid
}

/// Water without gravity between periodic sides.
fn plug(length: f64, speed: f64, openings: Vec<Opening>) -> Fluid {
    let still = parts(length, 10, speed);
    let liquid = Liquid { density: 1000.0, sound_speed: 10.0 };
    let formulation = Formulation { confined: true, ..Formulation::default() };
    let all = Parts {
        liquid,
        formulation,
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        walls: Vec::new(),
        ..still
    };
    let mut fluid = Fluid::repeated(all, Periods { low: Vec3::zeros(), lengths: Vec3::y() * 0.2 }).unwrap();
    let room = 2 * fluid.len();
    fluid.open(openings, room).unwrap();
    fluid
}

fn here(fluid: &Fluid) -> Vec<usize> {
    (0..fluid.len()).filter(|&i| fluid.is_here(i)).collect()
}

/// A lattice goes in and out as it is: no velocity and no density changes by a bit, and as many columns pass as the way has spacings.
#[test]
fn a_plug_keeps_its_speed_and_pressure() {
    for last in [Given::Free, velocity(-0.5), Given::Pressure { at_level: 0.0, level: 0.0 }] {
        let mut fluid =
            plug(0.4, 0.5, vec![opening(0.0, 1.0, velocity(0.5)), opening(0.4, -1.0, last.clone())]);
        march(&mut fluid, 0.6, |_, _| ());
        assert_eq!(fluid.passed(), [[150, 0], [0, 150]], "{last:?}");
        let all = here(&fluid);
        assert_eq!((all.len(), fluid.held()), (200, 200));
        for i in all {
            assert_eq!((fluid.velocities()[i], fluid.densities()[i]), (Vec3::x() * 0.5, 1000.0), "{last:?}");
        }
    }
}

/// A pulse of sound about a place that goes so far, to the right or to the left, and its greatest pressure about there at last over that at the start.
fn pulse(from: f64, way: f64, given: Given) -> f64 {
    let mut fluid = plug(1.2, 0.0, vec![opening(0.0, 1.0, given)]);
    let mut state: Vec<(String, Vec<f64>)> =
        fluid.state().into_iter().map(|(name, numbers)| (name.into(), numbers.into_owned())).collect();
    for (name, numbers) in &mut state {
        for i in here(&fluid) {
            let x = fluid.positions()[i].x - from;
            let own = 100.0 * (1.0 - (x / 0.2).powi(2)).max(0.0).powi(2);
            match name.as_str() {
                "densities" => numbers[i] = fluid.liquid().density_at(own),
                "velocities" => numbers[3 * i] = way.signum() * own / (1000.0 * 10.0),
                _ => {}
            }
        }
    }
    let named: Vec<(&str, &[f64])> =
        state.iter().map(|(name, numbers)| (name.as_str(), &numbers[..])).collect();
    fluid.set_state(&named).unwrap();
    march(&mut fluid, way.abs() / 10.0, |_, _| ());
    let at = |k: i32| {
        fluid.pressure_at(Vec3::new((from + way).abs() + 0.01 * f64::from(k), 0.1, 0.0)).unwrap() / 100.0
    };
    (-15..=15).map(at).fold(0.0, |most: f64, p| if p.abs() > most.abs() { p } else { most })
}

/// A given velocity sends sound back with its sign, a given pressure with the other one: of a pulse twenty spacings long, over the
/// same that goes as far without an end, measured .96 and −1.02.
#[test]
fn sound_comes_back() {
    let free = pulse(0.3, 0.6, velocity(0.0));
    for (given, sign) in [(velocity(0.0), 1.0), (Given::Pressure { at_level: 0.0, level: 0.0 }, -1.0)] {
        let back = pulse(0.3, -0.6, given.clone()) / free;
        println!("{given:?}: {back:.2}");
        assert!((back * sign - 1.0).abs() < 0.1, "{given:?}: {back}");
    }
}

/// Uniform flow, slower than its waves: velocity given where it comes in, level where it goes out. Depths at three sections, by pressures at the bed and by a gauge, whose half filled space
/// lies .1 spacing lower in water whose lattice is gone.
#[test]
fn a_slow_channel_keeps_its_depth() {
    let ends = vec![opening(0.0, 1.0, velocity(0.5)), opening(1.2, -1.0, level(0.2))];
    let mut fluid = opened(parts(1.2, 10, 0.5), ends);
    let (mut depths, mut count) = ([[0.0; 2]; 3], 0.0);
    march(&mut fluid, 3.0, |clock, fluid| {
        if clock.now.time > 1.0 && clock.steps.is_multiple_of(40) {
            count += 1.0;
            for (sum, x) in depths.iter_mut().zip([0.2, 0.6, 1.0]) {
                let pressure = fluid.pressure_at(Vec3::new(x, 0.05, 0.0)).unwrap();
                sum[0] += 0.05 + pressure / (1000.0 * GRAVITY);
                sum[1] += fluid.level_at(Vec3::x() * x);
            }
        }
    });
    let depths = depths.map(|sums| sums.map(|sum| sum / count / 0.2));
    assert!(depths.iter().flatten().all(|depth| (depth - 1.0).abs() < 0.02), "{depths:?}");
    let [[came, _], [_, went]] = fluid.passed()[..] else { panic!("two openings") };
    let flow = [came, went].map(|count| count as f64 * SPACING * SPACING / 3.0 / 0.1);
    assert!(flow.iter().all(|flow| (flow - 1.0).abs() < 0.02), "{flow:?}");
}

/// Flow that is faster than its waves: velocity and level given where it comes in, nothing where it goes out.
#[test]
fn a_fast_channel_keeps_its_depth() {
    let into =
        Given::Velocity { into: 3.0, course: Amplitude::Constant, profile: Vec::new(), level: Some(0.2) };
    let mut fluid =
        opened(parts(1.2, 10, 3.0), vec![opening(0.0, 1.0, into), opening(1.2, -1.0, Given::Free)]);
    march(&mut fluid, 1.0, |_, _| ());
    let depths = [0.2, 0.6, 1.0].map(|x| fluid.level_at(Vec3::x() * x) / 0.2);
    assert!(depths.iter().all(|depth| (depth - 1.0).abs() < 0.02), "{depths:?}");
}

/// From rest, by a course and a profile: what comes in is the integral of the velocity, what goes out and stays adds up, and so do energies: .12 % of the work is missing.
#[test]
fn what_comes_and_goes_is_counted() {
    let course = Amplitude::Table(vec![[0.0, 0.0], [0.6, 1.0], [1.2, 0.2]]);
    let into = Given::Velocity { into: 0.5, course, profile: vec![[0.0, 0.8], [0.2, 1.2]], level: Some(0.2) };
    let mut fluid =
        opened(parts(1.2, 10, 0.0), vec![opening(0.0, 1.0, into), opening(1.2, -1.0, level(0.2))]);
    let start = fluid.held() as u64;
    let rows = recorded(&mut fluid, 1.2, 0.3);
    let [[came, back], [wrong, went]] = fluid.passed()[..] else { panic!("two openings") };
    assert_eq!(start + came + wrong - back - went, fluid.held() as u64);
    // ∫U dt = .5 (.3 + .36) = .33, over a depth of .2: each row to half a particle.
    let flow = (came - back) as f64 * SPACING * SPACING / (0.33 * 0.2);
    assert!((flow - 1.0).abs() < 0.01, "{flow}");
    let last = rows.last().unwrap();
    println!("missing {:e}", last.balance_error / last.energy.external);
    assert!(
        last.balance_error.abs() < 4e-3 * last.energy.external.abs(),
        "{} {:?}",
        last.balance_error,
        last.energy
    );
}

fn bits(fluid: &Fluid) -> Vec<u64> {
    let numbers = fluid.state().into_iter().flat_map(|(_, numbers)| numbers.into_owned());
    numbers.map(f64::to_bits).collect()
}

/// For one thread and three, and gone on from a state in the middle.
#[test]
fn the_same_bits_however_it_is_run() {
    let ends = || vec![opening(0.0, 1.0, velocity(0.5)), opening(0.8, -1.0, level(0.19))];
    let made = |threads: usize| opened(Parts { threads, ..parts(0.8, 10, 0.4) }, ends());
    let run = |fluid: &mut Fluid, steps: usize| {
        let mut clock = Clock::start(fluid, 1.0, 1.0, 0.0).unwrap();
        (0..steps).for_each(|_| {
            clock.step(fluid, f64::INFINITY, |_| 1.0).unwrap();
        });
        clock
    };
    let (mut one, mut three) = (made(1), made(3));
    let mut clock = run(&mut one, 200);
    run(&mut three, 200);
    assert!(one.passed()[1][1] > 0, "{:?}", one.passed());
    assert_eq!(bits(&one), bits(&three));
    let mut other = made(1);
    let state: Vec<_> = one.state().into_iter().map(|(name, numbers)| (name, numbers.into_owned())).collect();
    let named: Vec<(&str, &[f64])> = state.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
    other.set_state(&named).unwrap();
    let mut again = clock.clone();
    for _ in 0..100 {
        clock.step(&mut one, f64::INFINITY, |_| 1.0).unwrap();
        again.step(&mut other, f64::INFINITY, |_| 1.0).unwrap();
    }
    assert_eq!(bits(&one), bits(&other));
}

/// The channel turned by a quarter and in a mirror: the order of sums changes with that of cells, so that round-off grows with the steps.
#[test]
fn turned_and_mirrored_it_is_the_same() {
    let ways: [fn(&Vec3) -> Vec3; 3] = [|v| *v, |v| Vec3::new(-v.y, v.x, v.z), |v| Vec3::new(-v.x, v.y, v.z)];
    let marched = |way: fn(&Vec3) -> Vec3| {
        let mut all = parts(0.6, 8, 0.4);
        let lists = [&mut all.positions, &mut all.velocities, &mut all.walls[0].points];
        lists.into_iter().for_each(|list| list.iter_mut().for_each(|v| *v = way(v)));
        all.gravity = way(&all.gravity);
        let ends = [opening(0.0, 1.0, velocity(0.5)), opening(0.6, -1.0, level(0.16))];
        let turned = |end: Opening| Opening { at: way(&end.at), into: way(&end.into), given: end.given };
        let mut fluid = opened(all, ends.into_iter().map(turned).collect());
        march(&mut fluid, 0.2, |_, _| ());
        fluid
    };
    let plain = marched(ways[0]);
    for way in &ways[1..] {
        let other = marched(*way);
        assert_eq!(plain.passed(), other.passed());
        let apart = |i: usize| (way(&plain.positions()[i]) - other.positions()[i]).norm();
        let off = here(&plain).into_iter().map(apart).fold(0.0, f64::max);
        assert!(off < 1e-9, "{off:e}");
    }
}

/// More than it has room for ends the march by a sentence.
#[test]
fn a_fluid_without_room_ends() {
    let mut fluid = Fluid::new(parts(0.4, 10, 0.5)).unwrap();
    let count = fluid.len();
    fluid.open(vec![opening(0.0, 1.0, velocity(0.5))], count + 5).unwrap();
    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
    let ended = (0..2000).find_map(|_| clock.step(&mut fluid, f64::INFINITY, |_| 1.0).err());
    let said = ended.unwrap().to_string();
    assert!(said.contains("most_particles"), "{said}");
    assert!(fluid.within_bounds(Bounds::Motion).is_ok());
}

#[test]
fn openings_that_cannot_be_are_refused() {
    let refused = |openings: Vec<Opening>, room: usize| {
        let mut fluid = Fluid::new(parts(0.4, 10, 0.0)).unwrap();
        fluid.open(openings, room).unwrap_err().to_string()
    };
    let slanted = Opening { at: Vec3::zeros(), into: Vec3::new(0.6, 0.8, 0.0), given: Given::Free };
    let at = |x: f64, into: f64| vec![opening(x, into, Given::Free)];
    for (openings, room, said) in [
        (vec![slanted], 400, "not across an axis"),
        (at(-0.1, 1.0), 400, "no fluid within a spacing"),
        (at(0.2, 1.0), 400, "fluid outside"),
        (at(0.4, -1.0), 100, "less room"),
        (vec![Opening { at: Vec3::zeros(), into: Vec3::y(), given: Given::Free }], 400, "a wall beyond it"),
        (vec![opening(0.0, 1.0, level(-0.1))], 400, "a level below"),
    ] {
        let found = refused(openings, room);
        assert!(found.contains(said), "{said}: {found}");
    }
    let mut published =
        Fluid::new(Parts { formulation: Formulation::published(), ..parts(0.4, 10, 0.0) }).unwrap();
    assert!(matches!(published.open(at(0.0, 1.0), 400), Err(FluidError::NotOpen(_))));
}
