//! A solid that several march together: whole marches of many random bodies to the bits of one who marches alone, what is read
//! at their end, and what one marches alone.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod bodies;
#[path = "../lattices/mod.rs"]
mod lattices;
mod reported;

use bodies::{Body, body};
use explicit_dynamics::{
    Amplitude, Bounds, Damping, Dynamics, Exert, Instant, Plan, QuasiStatic, Step, Transient,
};
use lattices::{Random, formulation, lattice, parts, poisson};
use peers::{CHUNK, Peers, together};
use peridynamics::{Elastic, Idealisation, Law, Parts, Sheets, Solid, SolidError, Space, Support, Supported};
use reported::{differing, read, reported};
use sph_core::Vec3;

const DX: f64 = 0.1;
/// Bodies that are tried.
const BODIES: usize = 24;
/// How many march each together: every third is marched by all of these, the others by the last three.
const COUNTS: [usize; 5] = [1, 4, 2, 3, 7];

fn transient() -> Plan {
    Transient { duration: 0.2, record_every: 0.04, damping: 0.2, safety: 0.8 }.into()
}

#[test]
fn marches_of_many_bodies_tell_the_same_whoever_makes_them() {
    let mut random = Random(11);
    // With more than two chunks, breaking, yielding, mirrored and breaking, yielding and breaking.
    let mut tried = [0; 5];
    for number in 0..BODIES {
        let body = body(number, &mut random);
        let march = |peers: Option<Box<dyn Peers>>| {
            let mut solid = body.shared(peers);
            let before = solid.broken()[0].len();
            let (words, _) = reported(&transient(), &mut solid, u64::MAX, None);
            let bits = read(&mut solid);
            let broken = solid.broken()[0].len() > before;
            (words, bits, broken, solid.flowed()[1].iter().any(|&past| past > 0.0))
        };
        let alone = march(None);
        let (broken, flowed, nodes) = (alone.2, alone.3, body.parts.block.len());
        let mirrored = !body.mirrors.is_empty();
        let seen = [nodes > 2 * CHUNK, broken, flowed, mirrored && broken, flowed && broken];
        tried.iter_mut().zip(seen).for_each(|(tried, seen)| *tried += usize::from(seen));
        for &count in &COUNTS[if number % 3 == 0 { 0 } else { 2 }..] {
            let all = together(count, |peers| march(Some(peers))).unwrap();
            for (rank, found) in all.iter().enumerate() {
                let differs = differing(&found.0, &alone.0);
                assert!(differs.is_none(), "body {number}, {count} peers, rank {rank}: {differs:?}");
                assert!(
                    *found == alone,
                    "body {number} of {nodes} nodes, {count} peers, rank {rank}: {seen:?}"
                );
            }
        }
    }
    println!("{tried:?}");
    assert!(tried.iter().zip([15, 12, 2, 3, 1]).all(|(tried, least)| *tried >= least), "{tried:?}");
}

/// Marches up to the middle by some, from there by others: to the bits of one who marches alone.
#[test]
fn a_march_goes_on_with_another_number_of_peers() {
    let mut random = Random(5);
    let mut broken = 0;
    for number in 0..6 {
        let body = body(number, &mut random);
        let mut alone = body.build();
        let (mut words, _) = reported(&transient(), &mut alone, u64::MAX, None);
        let expected = read(&mut alone);
        broken += usize::from(!alone.broken()[0].is_empty());
        for (first, then) in [(3, 2), (1, 4), (2, 7)] {
            let halved = together(first, |peers| {
                let mut solid = body.shared(Some(peers));
                let (words, state) = reported(&transient(), &mut solid, 8, None);
                solid.bring();
                (words, state.unwrap(), solid.motion().map(<[_]>::to_vec), solid.broken(), solid.flowed())
            });
            let (before, state, motion, broken, flowed) = halved.unwrap().pop().unwrap();
            let ends = together(then, |peers| {
                let mut solid = body.shared(Some(peers));
                assert!(solid.take_up(
                    motion.each_ref().map(|rows| &rows[..]),
                    broken.each_ref().map(|array| &array[..])
                ));
                assert!(solid.take_up_flow(flowed.each_ref().map(|array| &array[..])));
                let (words, _) = reported(&transient(), &mut solid, u64::MAX, Some(&state));
                (words, read(&mut solid))
            });
            let behind = words.split_off(before.len());
            assert!(words == before, "body {number}, {first} peers");
            for end in ends.unwrap() {
                assert!(end.0 == behind && end.1 == expected, "body {number}, {first} peers, then {then}");
            }
            words.extend(behind);
        }
    }
    assert!(broken >= 3, "{broken} broken");
}

/// A block that is pulled until it rests at each level: the checks of rest decide alike.
#[test]
fn quasi_static_marches_rest_alike() {
    let plan: Plan = QuasiStatic {
        levels: vec![0.5, 1.0],
        period: None,
        ramp: 1.0,
        hold: 0.5,
        damping: Damping::Ratio(0.5),
        tolerance: 1e-3,
        accuracy: 0.5,
        safety: 0.8,
    }
    .into();
    for (space, law) in [(Space::PlaneStress, Law::BondBased), (Space::Solid, Law::StateBased)] {
        let block = if space == Space::Solid {
            lattice(3, [20, 8, 9], [DX; 3])
        } else {
            lattice(2, [50, 24, 1], [DX; 3])
        };
        let (count, layer) = (block.len() as u32, if space == Space::Solid { 72 } else { 24 });
        let held =
            Support::Held { displacement: vec![Vec3::x(), Vec3::y(), Vec3::z()], director: Vec::new() };
        let moved = Support::Moved { direction: Vec3::x(), by: 0.05, amplitude: Amplitude::Constant };
        let supports = vec![
            Supported { nodes: (0..layer).collect(), support: held },
            Supported { nodes: (count - layer..count).collect(), support: moved },
        ];
        let material = Elastic { young: 100.0, poisson: poisson(space, law), density: 1.0 };
        let parts = Parts { supports, ..parts(block, material, formulation(space, law)) };
        let body = Body { parts, mirrors: Vec::new(), rates: Vec::new() };
        let march = |peers: Option<Box<dyn Peers>>| {
            let mut solid = body.shared(peers);
            let (words, _) = reported(&plan, &mut solid, u64::MAX, None);
            (words, read(&mut solid))
        };
        let alone = march(None);
        assert!(alone.0.len() > 2, "{:?}", alone.0);
        for count in [2, 3, 7] {
            for found in together(count, |peers| march(Some(peers))).unwrap() {
                let differs = differing(&found.0, &alone.0);
                assert!(differs.is_none(), "{space:?} {law:?}, {count} peers: {differs:?}");
                assert!(found == alone, "{space:?} {law:?}, {count} peers");
            }
        }
    }
}

/// A plain plate of three chunks.
fn plate() -> Parts {
    let material = Elastic { young: 100.0, poisson: 1.0 / 3.0, density: 1.0 };
    parts(lattice(2, [60, 20, 1], [DX; 3]), material, formulation(Space::PlaneStress, Law::BondBased))
}

/// Each moves its own nodes alone, and all of them are somebody's.
#[test]
fn nodes_are_shared_out() {
    let body = Body { parts: plate(), mirrors: Vec::new(), rates: Vec::new() };
    let owned = together(4, |peers| body.shared(Some(peers)).own_nodes()).unwrap();
    assert_eq!(owned, [0..0, 0..512, 512..1024, 1024..1200]);
    assert_eq!(body.build().own_nodes(), 0..1200);
    // What another moves stands still here until it is brought.
    let stood = together(2, |peers| {
        let rank = peers.rank();
        let mut solid = body.shared(Some(peers));
        (0..1200).for_each(|node| solid.set_velocity(node, Vec3::x()));
        let at = Instant { time: 0.0, level: 1.0 };
        let to = Instant { time: 1e-3, level: 1.0 };
        solid.advance(&Step { from: at, to, kick: 1e-3, damping: 0.0 });
        let other = if rank == 0 { 1199 } else { 0 };
        let before = solid.displacement(other);
        solid.bring();
        (before, solid.displacement(other).x > 0.0)
    });
    assert_eq!(stood.unwrap(), vec![(Vec3::zeros(), true); 2]);
}

/// A node that outruns all waves is named by all.
#[test]
fn all_name_the_fastest_node() {
    let words = |peers: Option<Box<dyn Peers>>| {
        let mut rates = vec![Vec3::zeros(); 1200];
        (rates[700], rates[1100]) = (Vec3::x() * 1e3, Vec3::x() * -1e3);
        let solid = Body { parts: plate(), mirrors: Vec::new(), rates }.shared(peers);
        solid.within_bounds(Bounds::Motion).unwrap_err().to_string()
    };
    let alone = words(None);
    assert!(alone.contains("700"), "{alone}");
    for count in [2, 3, 5] {
        assert_eq!(together(count, |peers| words(Some(peers))).unwrap(), vec![alone.clone(); count]);
    }
}

/// What one marches alone says so, and is as it was.
#[test]
fn what_is_not_shared_is_refused() {
    let refused = |build: &(dyn Fn() -> Solid + Sync)| {
        let all = together(2, |peers| {
            let mut solid = build();
            match solid.share(peers) {
                Err(SolidError::NotShared(what)) if solid.own_nodes() == (0..solid.len()) => what,
                _ => "not refused",
            }
        });
        all.unwrap()[0]
    };
    let sheets = || {
        let Idealisation::Bonds(formulation) = plate().formulation else { unreachable!() };
        let formulation = Idealisation::Sheets(Sheets { thickness: DX, formulation });
        Solid::new(Parts { formulation, ..plate() }).unwrap()
    };
    let wet = || {
        let mut solid = Solid::new(plate()).unwrap();
        solid.wet().unwrap();
        solid
    };
    let pushed = || {
        let mut solid = Solid::new(plate()).unwrap();
        let exert: Exert = Box::new(|_, _, _, _| ());
        solid.push(exert);
        solid
    };
    let said = [refused(&sheets), refused(&wet), refused(&pushed)];
    println!("{said:?}");
    assert!(said.iter().all(|what| what.starts_with("a ")), "{said:?}");
    assert_eq!(refused(&|| Solid::new(plate()).unwrap()), "not refused");
    // Nor may it come into a fluid later.
    let later = together(2, |peers| {
        let mut solid = Solid::new(plate()).unwrap();
        solid.share(peers).unwrap();
        solid.wet()
    });
    assert_eq!(later.unwrap(), vec![Err(SolidError::NotShared("a solid in a fluid")); 2]);
}
