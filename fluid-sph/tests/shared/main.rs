//! A fluid that several march together: whole marches to the same bits, what is read of it, and what one marches alone.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

#[path = "../common/mod.rs"]
mod common;
mod waters;

use std::borrow::Cow;

use common::pool;
use explicit_dynamics::{Bounds, Clock, Dynamics, Instant, Step};
use fluid_sph::{Fluid, FluidError, Formulation, Parts, Scheme, Section, WallRule};
use peers::{Peers, together};
use sph_core::Vec3;
use waters::{blocks, dam, streams, tank};

/// Those who march together in these tests.
const COUNTS: [usize; 5] = [1, 2, 3, 4, 7];

/// A fluid of one of several, or alone.
fn built(parts: Parts, peers: Option<Box<dyn Peers>>) -> Fluid {
    let mut fluid = Fluid::new(parts).unwrap();
    if let Some(peers) = peers {
        fluid.share(peers).unwrap();
    }
    fluid
}

fn marched(fluid: &mut Fluid, clock: &mut Clock, steps: usize) {
    for _ in 0..steps {
        clock.step(fluid, f64::INFINITY, |_| 1.0).unwrap();
    }
}

/// All that is read of a fluid, as bits by name.
fn read(fluid: &mut Fluid) -> Vec<(&'static str, Vec<u64>)> {
    fluid.bring();
    let fluid = &*fluid;
    let mut all: Vec<(&str, Vec<f64>)> =
        fluid.state().into_iter().map(|(name, numbers)| (name, numbers.into_owned())).collect();
    let vector = |v: Vec3| vec![v.x, v.y, v.z];
    let energies = fluid.energies();
    all.push(("energies", vec![energies.kinetic, energies.compression, energies.potential]));
    all.push(("losses", vec![energies.viscous, energies.diffusion, fluid.greatest_density_error()]));
    all.push(("momentum", vector(fluid.momentum())));
    for wall in 0..fluid.walls() {
        all.push(("wall force", vector(fluid.wall_force(wall))));
        all.push(("wall moment", vector(fluid.wall_moment(wall, Vec3::x()))));
        all.push(("wall pressures", fluid.wall_pressures(wall)));
    }
    let point = Vec3::new(0.3, 0.1, 0.1);
    all.push(("gauges", vec![fluid.level_at(point), fluid.wet_length_at(point)]));
    all.push(("pressure", fluid.pressure_at(point).into_iter().collect()));
    let [min, max] = [Vec3::from([-9.0; 3]), Vec3::from([9.0; 3])];
    let section = Section { point, normal: Vec3::x(), min, max };
    all.push(("flux", vec![fluid.flux(&section, 0..fluid.len())]));
    all.push(("surface", fluid.free_surface().into_iter().map(|open| f64::from(u8::from(open))).collect()));
    all.into_iter().map(|(name, numbers)| (name, numbers.into_iter().map(f64::to_bits).collect())).collect()
}

/// What a march of one of those who share a fluid comes to: what is read, the clock, and whose particles were its own at the start and
/// at the end.
struct Found {
    read: Vec<(&'static str, Vec<u64>)>,
    clock: String,
    own: [Vec<usize>; 2],
}

/// A march of so many steps, by one of several or alone.
fn march(parts: &Parts, steps: usize, peers: Option<Box<dyn Peers>>) -> Found {
    let mut fluid = built(parts.clone(), peers);
    let first = fluid.own_particles().collect();
    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.1).unwrap();
    let mut found = Vec::new();
    for _ in 0..2 {
        marched(&mut fluid, &mut clock, steps / 2);
        fluid.within_bounds(Bounds::Motion).unwrap();
        found.extend(read(&mut fluid));
    }
    Found { read: found, clock: format!("{clock:?}"), own: [first, fluid.own_particles().collect()] }
}

/// Whole marches of a fluid, alone and by several; how many particles have another owner at the end than at the start.
fn same(what: &str, parts: &Parts, steps: usize, counts: &[usize]) -> usize {
    let alone = march(parts, steps, None);
    let mut changed = 0;
    for &count in counts {
        let all = together(count, |peers| march(parts, steps, Some(peers))).unwrap();
        for (rank, found) in all.iter().enumerate() {
            for (found, alone) in found.read.iter().zip(&alone.read) {
                assert!(found == alone, "{what}, {count} peers, rank {rank}: {}", alone.0);
            }
            assert_eq!(found.clock, alone.clock, "{what}, {count} peers, rank {rank}");
        }
        for end in 0..2 {
            let mut owned: Vec<usize> = all.iter().flat_map(|found| found.own[end].clone()).collect();
            owned.sort_unstable();
            assert!(owned.into_iter().eq(0..parts.positions.len()), "{what}: each has one owner");
        }
        let gone = |Found { own: [first, last], .. }: &Found| {
            first.iter().filter(|particle| last.binary_search(particle).is_err()).count()
        };
        changed = all.iter().map(gone).sum();
        println!("{what}: of {} particles {changed} changed owner, {count} peers", parts.positions.len());
    }
    changed
}

#[test]
fn dams_break_the_same_whoever_marches_them() {
    assert!(same("dam in a plane", &dam(2, 0.025), 400, &COUNTS) > 100);
    assert!(same("dam in space", &dam(3, 0.05), 200, &[2, 7]) > 100);
    let parts = Parts { threads: 2, ..dam(2, 0.025) };
    assert!(same("dam in a plane, two threads each", &parts, 300, &[3]) > 50);
}

#[test]
fn streams_pass_the_same_whoever_marches_them() {
    assert!(same("streams", &streams(2, 0.2, false), 200, &[4, 7]) > 300);
    assert!(same("streams between walls", &streams(2, 0.2, true), 200, &[7]) > 300);
    assert!(same("streams in space", &streams(3, 0.2, false), 200, &[7]) > 200);
    // Only walls go far.
    same("still water between walls", &streams(2, 0.0, true), 300, &[7]);
}

#[test]
fn tanks_slosh_the_same_whoever_marches_them() {
    for dimensions in [2, 3] {
        let parts = tank(dimensions, if dimensions == 2 { 0.025 } else { 0.05 });
        assert!(same("tank", &parts, 300, if dimensions == 2 { &COUNTS } else { &[3, 4] }) > 10);
    }
}

/// Laminar friction, mean velocities that move particles, no diffusion of density; water that stays at rest.
#[test]
fn other_terms_and_still_water() {
    let plain = Formulation::default();
    let formulations = [
        Formulation { kinematic_viscosity: 1e-2, ..plain },
        Formulation { xsph: 0.4, ..plain },
        Formulation { density_diffusion: 0.0, smoothing: 1.3, confined: true, ..plain },
    ];
    for formulation in formulations {
        for dimensions in [2, 3] {
            let parts = Parts { formulation, ..dam(dimensions, 0.05) };
            same(&format!("{formulation:?}"), &parts, 160, &[3]);
        }
    }
    same("still water", &pool(2, [0.6, 0.4, 0.0], [0.6, 0.4, 0.0], 0.025), 200, &[3]);
}

/// Blocks of random sizes that meet and fly on, some with a particle far off, where cells are cut off and everyone knows all.
#[test]
fn blocks_meet_the_same_whoever_marches_them() {
    let mut changed = 0;
    for seed in 0..12 {
        let dimensions = 2 + seed % 2;
        let parts = blocks(dimensions, seed * 7 + 1, seed % 3 == 0);
        changed += same(&format!("blocks {seed}"), &parts, 200, &[2 + seed % 6]);
    }
    assert!(changed > 100, "{changed}");
}

/// Three particles for seven: most have nothing, and all come through.
#[test]
fn shares_may_be_empty() {
    let mut parts = dam(2, 0.05);
    parts.positions.truncate(3);
    parts.velocities.truncate(3);
    same("three particles", &parts, 100, &[2, 7]);
    parts.walls.clear();
    same("three particles without walls", &parts, 100, &[7]);
}

/// Particles that go farther in a step than neighbours are known: everyone knows all. Bounds are not asked for.
#[test]
fn who_is_faster_than_sound_is_not_lost() {
    let mut parts = blocks(2, 3, false);
    parts.liquid.sound_speed = 1.0;
    // None comes towards another, which would shorten the step.
    parts.velocities.iter_mut().for_each(|velocity| *velocity = Vec3::new(6.0, 0.5, 0.0) + *velocity * 0.01);
    let run = |peers: Option<Box<dyn Peers>>| {
        let mut fluid = built(parts.clone(), peers);
        let (mut now, mut last, mut farthest) = (Instant { time: 0.0, level: 1.0 }, 0.0, 0.0_f64);
        for _ in 0..40 {
            let dt = fluid.stable_step(1.0).unwrap().dt;
            let to = Instant { time: now.time + dt, level: 1.0 };
            fluid.advance(&Step { from: now, to, kick: 0.5 * (last + dt), damping: 0.0 });
            (now, last) = (to, dt);
            fluid.bring();
            let speed = fluid.velocities().iter().map(|v| v.norm()).fold(0.0, f64::max);
            farthest = farthest.max(speed * dt / fluid.smoothing_length());
        }
        let words = fluid.within_bounds(Bounds::Motion).unwrap_err().to_string();
        (read(&mut fluid), words, farthest)
    };
    let alone = run(None);
    assert!(alone.2 > 1.0, "{} smoothing lengths", alone.2);
    for count in [2, 3] {
        for found in together(count, |peers| run(Some(peers))).unwrap() {
            assert!(found == alone, "{count} peers");
        }
    }
}

/// A march with records, which asks for energies and for what a kick does to them.
#[test]
fn records_are_the_same_whoever_makes_them() {
    let run = |peers: Option<Box<dyn Peers>>| {
        let mut fluid = built(tank(2, 0.05), peers);
        format!("{:?}", common::recorded(&mut fluid, 0.2, 0.01))
    };
    let alone = run(None);
    for count in COUNTS {
        assert_eq!(together(count, |peers| run(Some(peers))).unwrap(), vec![alone.clone(); count], "{count}");
    }
}

/// A state of some, taken up by others in the middle of a march.
#[test]
fn a_state_goes_on_with_any_number() {
    let parts = tank(2, 0.04);
    let whole = march(&parts, 200, None);
    let go_on = |state: &[(&'static str, Vec<f64>)], clock: &Clock, peers: Option<Box<dyn Peers>>| {
        let mut fluid = Fluid::new(parts.clone()).unwrap();
        let mut clock = clock.clone();
        if let Some(peers) = peers {
            fluid.share(peers).unwrap();
            // What it has done so far is forgotten with its own state.
            let mut other = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
            marched(&mut fluid, &mut other, 5);
        }
        let arrays: Vec<(&str, &[f64])> = state.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
        fluid.set_state(&arrays).unwrap();
        marched(&mut fluid, &mut clock, 100);
        (read(&mut fluid), format!("{clock:?}"))
    };
    let kept = together(3, |peers| {
        let mut fluid = Fluid::new(parts.clone()).unwrap();
        fluid.share(peers).unwrap();
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.1).unwrap();
        marched(&mut fluid, &mut clock, 100);
        fluid.bring();
        let own = |(name, numbers): (&'static str, Cow<'_, [f64]>)| (name, numbers.into_owned());
        (fluid.state().into_iter().map(own).collect::<Vec<_>>(), clock)
    });
    let (state, clock) = kept.unwrap().swap_remove(1);
    let last = &whole.read[whole.read.len() / 2..];
    let alone = go_on(&state, &clock, None);
    assert!(alone.0 == last && alone.1 == whole.clock);
    for count in [1, 2, 4] {
        let all = together(count, |peers| go_on(&state, &clock, Some(peers))).unwrap();
        assert!(all.iter().all(|found| *found == alone), "{count} peers");
    }
}

/// A copy of a fluid marches on its own, beside that of which it is one.
#[test]
fn copies_march_on_their_own() {
    let run = |peers: Option<Box<dyn Peers>>| {
        let mut fluid = built(dam(2, 0.05), peers);
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
        marched(&mut fluid, &mut clock, 30);
        let (mut copy, mut copied) = (fluid.clone(), clock.clone());
        for _ in 0..3 {
            marched(&mut copy, &mut copied, 20);
            marched(&mut fluid, &mut clock, 60);
        }
        [read(&mut copy), read(&mut fluid)]
    };
    let alone = run(None);
    assert!(alone[0] != alone[1]);
    assert!(together(3, |peers| run(Some(peers))).unwrap().iter().all(|found| *found == alone));
}

/// What leaves the range of the model is named by all with the same words.
#[test]
fn all_refuse_a_state_beyond_the_model() {
    type State = Vec<(&'static str, Vec<f64>)>;
    let words = |change: &dyn Fn(&mut State), peers: Option<Box<dyn Peers>>| {
        let domain = Some([Vec3::from([-1.0; 3]), Vec3::from([3.0; 3])]);
        let mut fluid = built(Parts { domain, ..dam(2, 0.05) }, peers);
        let own = |(name, numbers): (&'static str, Cow<'_, [f64]>)| (name, numbers.into_owned());
        let mut state: Vec<_> = fluid.state().into_iter().map(own).collect();
        change(&mut state);
        let arrays: Vec<(&str, &[f64])> = state.iter().map(|(name, numbers)| (*name, &numbers[..])).collect();
        fluid.set_state(&arrays).unwrap();
        let said = [Bounds::Motion, Bounds::Configuration].map(|bounds| fluid.within_bounds(bounds));
        said.map(|said| said.map_or_else(|refused| refused.to_string(), |()| "fine".to_owned()))
    };
    let changes: [&(dyn Fn(&mut State) + Sync); 4] = [
        &|_| (),
        &|state| state[0].1[3 * 150 + 1] = 3.5,
        &|state| [state[2].1[170], state[2].1[90]] = [f64::NAN, 3000.0],
        &|state| [state[1].1[3 * 60], state[1].1[3 * 180]] = [300.0, -300.0],
    ];
    for (number, change) in changes.into_iter().enumerate() {
        let alone = words(change, None);
        println!("{alone:?}");
        assert_eq!(alone.iter().all(|said| said == "fine"), number == 0, "{alone:?}");
        for count in [2, 3] {
            assert_eq!(
                together(count, |peers| words(change, Some(peers))).unwrap(),
                vec![alone.clone(); count]
            );
        }
    }
}

/// What one marches alone says so.
#[test]
fn what_is_not_shared_is_refused() {
    let refused = |parts: Parts| {
        let all = together(2, |peers| Fluid::new(parts.clone()).unwrap().share(peers));
        all.unwrap().swap_remove(1)
    };
    let parts = || dam(2, 0.1);
    let of = |formulation: Formulation| Parts { formulation, ..parts() };
    let predicted = Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() };
    let published = Formulation { walls: WallRule::Dynamic, ..Formulation::default() };
    let said: Vec<String> = [of(predicted), of(published)]
        .map(|parts| match refused(parts) {
            Err(FluidError::NotShared(what)) => what.to_owned(),
            other => format!("{other:?}"),
        })
        .to_vec();
    println!("{said:?}");
    assert!(said.iter().all(|what| what.starts_with("a fluid ")), "{said:?}");
    assert_eq!(refused(parts()), Ok(()));
}
