//! Friction of surfaces on each other: momentum of what sticks, tangent, work against what is lost and stored, folds, two parts at once, history.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{At, TOUCHING, Two, number, sheet};
use contact::{Mesh, SurfaceContact};
use nalgebra::Rotation3;
use sph_core::{Cell, Vec3};

const MU: f64 = 0.3;
fn sheets(up: Vec3, rugged: f64, friction: f64) -> Two {
    Two::new(5, up, rugged, TOUCHING, friction)
}

fn dot(a: &At, b: &At) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(f, u)| f.dot(u)).sum()
}

fn rough_way(two: &Two) -> At {
    [0, 1].map(|b: usize| {
        let of = |a: usize| Vec3::from_fn(|k, _| number(10_000 * b + 3 * a + k + 77));
        (0..two.at[b].len()).map(of).collect()
    })
}

const UP: Vec3 = Vec3::new(1.4, 1.2, 0.15);
/// Rough enough for anything to stick.
const ROUGH: f64 = 1e6;

/// Touches, and then is moved by a way.
fn moved(rugged: f64, friction: f64, by: Vec3) -> Two {
    let mut two = sheets(UP, rugged, friction);
    two.look();
    two.contact.commit();
    two.shift(by);
    two
}

/// The same by a way that it bears without a slip.
fn stuck(rugged: f64) -> Two {
    moved(rugged, ROUGH, Vec3::new(0.011, -0.007, 0.001))
}

/// Whether a place of the lower sheet lies off the rim of the upper one.
fn inside(x: &Vec3) -> bool {
    (x - Vec3::new(2.75, 2.8, 0.0)).xy().amax() < 1.1
}

#[test]
fn what_sticks_and_what_slips_has_neither_sum_nor_moment() {
    for friction in [ROUGH, 0.01] {
        let mut two = moved(0.1, friction, Vec3::new(0.011, -0.007, 0.001));
        two.look();
        assert_eq!(two.contact.lost() > 0.0, friction < 1.0);
        let forces = two.forces();
        let (mut sum, mut moment, mut size) = (Vec3::zeros(), Vec3::zeros(), 0.0);
        for b in 0..2 {
            for (x, force) in two.at[b].iter().zip(&forces[b]) {
                (sum, moment, size) = (sum + force, moment + x.cross(force), size + force.norm());
            }
        }
        assert!(forces[1].iter().sum::<Vec3>().xy().norm() > 1e-3 * size);
        assert!(sum.norm() < 1e-13 * size && moment.norm() < 1e-12 * size, "{sum} {moment} {size}");
    }
}

/// Differences over 1e-6 of a short way and of a longer one, after which some feet stand on other faces than their anchors, whose nodes the tangent
/// leaves out.
#[test]
fn what_sticks_has_an_energy_and_its_tangent_is_that_of_the_forces() {
    for (rugged, long, bound) in [(0.0, 1e-4, 1e-4), (0.1, 1e-5, 1e-5), (0.1, 1e-2, 1e-2)] {
        let mut two = moved(rugged, ROUGH, Vec3::new(1.1, -0.7, 0.1) * long);
        let way = rough_way(&two);
        two.look();
        assert_eq!(two.contact.lost(), 0.0);
        let (forces, tangent, home) = (two.forces(), two.tangent(&way), two.at.clone());
        let mut ends = Vec::new();
        for by in [-1e-6, 1e-6] {
            two.at = [0, 1].map(|b| home[b].iter().zip(&way[b]).map(|(x, u)| x + u * by).collect());
            ends.push((two.look().energy, two.forces()));
        }
        let slope = (ends[1].0 - ends[0].0) / 2e-6;
        let error = (slope + dot(&forces, &way)).abs() / dot(&forces, &forces).sqrt();
        let (mut off, mut most) = (0.0, 0.0);
        for b in 0..2 {
            for a in 0..tangent[b].len() {
                let change = (ends[1].1[b][a] - ends[0].1[b][a]) / 2e-6;
                off += (change - tangent[b][a]).norm_squared();
                most += change.norm_squared();
            }
        }
        let off = f64::sqrt(off / most);
        println!("{rugged} {long}: energy {error:.1e}, tangent {off:.1e}");
        assert!(error < 1e-7 && off < bound, "{rugged}: {error:.1e} {off:.1e}");
    }
}

/// Motions of the upper sheet along the lower one change no force across where neither has a rim: the tangent in slip is that of the forces.
#[test]
fn the_tangent_of_what_slips_is_that_of_forces_that_turn() {
    let mut two = moved(0.0, 0.05, Vec3::new(0.03, -0.02, 0.0));
    two.look();
    let home = two.at.clone();
    for along in [Vec3::x(), Vec3::new(0.3, 0.8, 0.0)] {
        let way = [vec![Vec3::zeros(); home[0].len()], vec![along; home[1].len()]];
        let mut pull = |by: f64| -> Vec<Vec3> {
            two.at[1] = home[1].iter().map(|x| x + along * by).collect();
            two.look();
            let forces = two.forces();
            forces[0].iter().zip(&home[0]).filter(|(_, x)| inside(x)).map(|(f, _)| *f).collect()
        };
        let (low, high) = (pull(-1e-6), pull(1e-6));
        pull(0.0);
        let tangent = two.tangent(&way);
        let found = tangent[0].iter().zip(&home[0]).filter(|(_, x)| inside(x)).map(|(f, _)| *f);
        let (mut off, mut most) = (0.0, 0.0);
        for ((low, high), found) in low.iter().zip(&high).zip(found) {
            let change = (high - low) / 2e-6;
            off += (change - found).norm_squared();
            most += change.norm_squared();
        }
        let error = f64::sqrt(off / most);
        println!("{along:?}: {error:.1e} of {most:.1e}");
        assert!(error < 4e-2 && most > 0.0, "{error:.1e}");
    }
}

/// It sticks, slides over many cells, and turns back; the work done on friction is what it stores and loses, in steps shorter and longer than the elastic
/// slip. Open is what is let go as rims pass, with a force of friction that an end of the step does not have.
#[test]
fn work_is_what_friction_stores_and_loses() {
    for (steps, long, bound) in [(800, 0.00625, 7e-5), (800, 0.05, 7e-4), (100, 0.4, 1.8e-2)] {
        let (up, mut without) = (Vec3::new(1.4, 1.2, 0.18), None::<Two>);
        let mut two = sheets(up, 0.0, MU);
        two.look();
        two.contact.commit();
        let smooth = without.get_or_insert_with(|| sheets(up, 0.0, 0.0));
        let (mut work, mut lost, mut before, mut largest) = (0.0, 0.0, None::<(Vec3, Vec3)>, 0.0_f64);
        let (home, mut held) = (two.at[1].clone(), 0.0);
        for step in 0..steps {
            let t = long * f64::from(step) * 0.1;
            let by = Vec3::new(0.9 * libm::sin(t), 0.7 * libm::sin(2.3 * t), 0.0);
            two.at[1] = home.iter().map(|x| x + by).collect();
            smooth.at = two.at.clone();
            held = two.look().energy - smooth.look().energy;
            lost += two.contact.lost();
            let [own, plain]: [Vec3; 2] = [&two, &*smooth].map(|two| two.forces()[1].iter().sum());
            let force = own - plain;
            largest = largest.max(force.norm() / plain.z);
            if let Some((old, last)) = before {
                work -= 0.5 * (force + last).dot(&(by - old));
            }
            before = Some((by, force));
            two.contact.commit();
        }
        let open = (work - lost - held).abs() / lost;
        println!("{long}: {largest:.6}, lost {lost:.4}, open {open:.1e}");
        assert!((largest / MU - 1.0).abs() < 0.01, "{largest}");
        assert!(lost > 0.01 && open < bound, "{work} {lost} {held}");
        let at = |b: usize| (0..two.at[b].len() as u32).map(move |a| (b, a));
        let nodes: f64 = at(0).chain(at(1)).map(|node| two.contact.lost_at(node)).sum();
        assert!((nodes / lost - 1.0).abs() < 1e-12);
    }
}

/// Both turned and moved together after they stuck: no energy, and forces turned with them.
#[test]
fn what_sticks_does_not_feel_a_motion_of_both() {
    let mut two = stuck(0.1);
    let (touch, forces) = (two.look(), two.forces());
    let turn = Rotation3::from_axis_angle(&Vec3::y_axis(), 0.7);
    two.at.iter_mut().flatten().for_each(|x| *x = turn * *x + Vec3::new(3.0, -2.0, 1.0));
    let other = two.look();
    assert!((other.energy / touch.energy - 1.0).abs() < 1e-12);
    for (a, b) in forces.iter().flatten().zip(two.forces().iter().flatten()) {
        assert!((turn * a - b).norm() < 1e-12, "{a} {b}");
    }
}

/// What parts has lost what its anchor stored; a history goes on to the same forces; that of others is not taken up.
#[test]
fn a_history_is_taken_up_and_what_parts_loses_what_was_stored() {
    let mut two = stuck(0.05);
    two.look();
    two.contact.commit();
    let smooth = sheets(UP, 0.05, 0.0);
    let history = two.contact.history();
    let mut other = Two { contact: sheets(UP, 0.05, ROUGH).contact, at: two.at.clone() };
    assert!(other.contact.take_up_history(&history));
    two.shift(Vec3::new(0.0, 0.002, 0.0));
    other.shift(Vec3::new(0.0, 0.002, 0.0));
    assert_eq!(two.look(), other.look());
    assert_eq!(two.forces(), other.forces());
    assert!(!other.contact.take_up_history(&history[1..]));
    let mut without = smooth.contact.clone();
    assert!(!without.take_up_history(&history) && without.take_up_history(&[]));
    two.shift(Vec3::new(0.0, -0.002, 0.0));
    let stuck = two.look().energy;
    let mut plain = Two { at: two.at.clone(), ..smooth };
    let stored = stuck - plain.look().energy;
    two.contact.commit();
    two.shift(Vec3::z());
    assert_eq!(two.look().energy, 0.0);
    assert!((two.contact.lost() / stored - 1.0).abs() < 1e-2, "{} {stored}", two.contact.lost());
}

/// What comes to touch in a long step has slipped from where it was.
#[test]
fn what_hovers_before_a_step_rubs_in_it() {
    let mut two = sheets(Vec3::new(1.4, 1.2, 0.25), 0.0, MU);
    two.look();
    two.contact.commit();
    let free = two.contact.clone();
    let home = two.at.clone();
    two.contact.hover(|(body, a)| home[body][a as usize]);
    two.shift(Vec3::new(0.1, 0.0, -0.07));
    two.look();
    let pull: Vec3 = two.forces()[1].iter().sum();
    // Rims of the one stand over the other, and are pushed aside a little.
    assert!((-pull.x / (MU * pull.z) - 1.0).abs() < 1e-2, "{pull}");
    assert!(two.contact.lost() > 0.0);
    let mut two = Two { contact: free, ..two };
    two.look();
    assert!(two.forces()[1].iter().sum::<Vec3>().x.abs() < 2e-2 * pull.x.abs());
}

/// A sheet between two others that are one body: each of its faces has its own friction.
#[test]
fn what_is_between_two_parts_of_a_surface_rubs_on_both() {
    let (cells, below) = sheet(6, 1.0, 0.0, 0.0);
    let count = below.len() as u32;
    let both: Vec<Vec3> = below.iter().copied().chain(below.iter().map(|x| x + Vec3::z() * 0.36)).collect();
    let upper = cells.iter().map(|cell| Cell { corners: cell.corners.map(|a| a + count), ..*cell });
    let all: Vec<Cell> = cells.iter().copied().chain(upper).collect();
    let (others, mut between) = sheet(5, 0.6, 0.1, 0.0);
    between.iter_mut().for_each(|x| *x += Vec3::new(1.4, 1.2, 0.18));
    let meshes = [Mesh::new(&all, &both, |_| 0.1), Mesh::new(&others, &between, |_| 0.1)];
    let contact = SurfaceContact::between(meshes, [&both, &between], TOUCHING).with_friction(MU);
    let mut two = Two { contact, at: [both, between] };
    two.look();
    two.contact.commit();
    two.shift(Vec3::new(0.1, 0.0, 0.0));
    two.look();
    let forces = two.forces();
    // Below, above: where no rim is near each side bears μ N, on nodes not quite those that bear N: 7e-3 over some ten cells.
    for side in [0, count as usize] {
        let own = || (0..count as usize).filter(|&a| inside(&two.at[0][a])).map(|a| forces[0][side + a]);
        let (pulled, pressed): (f64, f64) = (own().map(|f| f.x).sum(), own().map(|f| f.z.abs()).sum());
        assert!((pulled / (MU * pressed) - 1.0).abs() < 2e-2 && pressed > 0.1, "{pulled} {pressed}");
    }
}
