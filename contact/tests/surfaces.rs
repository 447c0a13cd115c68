//! Two surfaces in contact: derivatives, momentum, no ripple, even forces under even pressure, the same answer turned, mirrored and whatever the list.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{TOUCHING, Two, number, sheet};
use contact::{Law, Mesh, Moving, Node, Pace, SurfaceContact, Touching};
use nalgebra::{Matrix3, Rotation3};
use sph_core::Vec3;

fn sheets(up: Vec3, rugged: f64, touching: Touching) -> Two {
    Two::new(9, up, rugged, touching, 0.0)
}

fn way(two: &Two) -> [Vec<Vec3>; 2] {
    [0, 1].map(|b: usize| {
        let of = |a: usize| Vec3::from_fn(|k, _| number(10_000 * b + 3 * a + k + 77));
        (0..two.at[b].len()).map(of).collect()
    })
}

/// Differences over 1e-6: of the energy 1e-9, of forces 2e-7 where one of hundreds of feet leaves its feature on the way.
#[test]
fn forces_are_the_gradient_of_the_energy_and_the_tangent_that_of_the_forces() {
    for (rugged, up, edges) in [(0.02, 0.13, false), (0.1, 0.2, false), (0.1, 0.15, true)] {
        let law = Law::new(0.05).unwrap();
        let mut two = sheets(Vec3::new(0.6, 0.2, up), rugged, Touching { edges, law, ..TOUCHING });
        let way = way(&two);
        let touch = two.look();
        assert!(touch.greatest_depth > 0.2 && touch.greatest_depth < 0.99, "{touch:?}");
        let (forces, tangent, home) = (two.forces(), two.tangent(&way), two.at.clone());
        let mut ends = Vec::new();
        for by in [-1e-6, 1e-6] {
            two.at = home.clone();
            two.at = two.moved(&way, by);
            ends.push((two.look().energy, two.forces()));
        }
        let slope = (ends[1].0 - ends[0].0) / 2e-6;
        let dot = |a: &[Vec<Vec3>; 2], b: &[Vec<Vec3>; 2]| -> f64 {
            a.iter().flatten().zip(b.iter().flatten()).map(|(f, u)| f.dot(u)).sum()
        };
        let size = dot(&forces, &forces).sqrt();
        let error = (slope + dot(&forces, &way)).abs() / size;
        println!("{rugged} {edges}: energy {error:.1e}");
        assert!(error < 1e-7, "{rugged} {edges}: {error:.1e}");
        if edges {
            assert!(two.contact.greatest_crossing() > 0.0);
            continue;
        }
        let (mut off, mut most) = (0.0, 0.0);
        for b in 0..2 {
            for a in 0..tangent[b].len() {
                let change = (ends[1].1[b][a] - ends[0].1[b][a]) / 2e-6;
                off += (change - tangent[b][a]).norm_squared();
                most += change.norm_squared();
            }
        }
        let error = (off / most).sqrt();
        println!("{rugged}: tangent {error:.1e}");
        assert!(error < 1e-5, "{rugged}: {error:.1e}");
    }
}

#[test]
fn forces_have_neither_sum_nor_moment() {
    for edges in [false, true] {
        let mut two = sheets(Vec3::new(0.4, 0.3, 0.11), 0.2, Touching { edges, ..TOUCHING });
        two.look();
        let forces = two.forces();
        let (mut sum, mut moment, mut size) = (Vec3::zeros(), Vec3::zeros(), 0.0);
        for b in 0..2 {
            for (x, force) in two.at[b].iter().zip(&forces[b]) {
                (sum, moment, size) = (sum + force, moment + x.cross(force), size + force.norm());
            }
        }
        assert!(size > 0.1);
        assert!(sum.norm() < 1e-13 * size && moment.norm() < 1e-12 * size, "{sum} {moment} {size}");
    }
}

/// Along ways that no cell knows, over a rugged surface: no energy jumps by more than the greatest force times the step.
#[test]
fn the_energy_is_continuous_on_any_way() {
    let (step, mut met, mut worst) = (1e-3, 0, 0.0_f64);
    for seed in 0..30 {
        let mut two = sheets(Vec3::new(0.6, 0.2, 0.26), 0.1, TOUCHING);
        let direction = Vec3::from_fn(|k, _| number(31 * seed + k)) - Vec3::z() * number(31 * seed + 2) * 0.8;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..300 {
            two.at[1].iter_mut().for_each(|x| *x += direction * step);
            let touch = two.look();
            // The barrier bends the energy too much for the rule of the trapeze.
            if touch.greatest_depth > 0.6 {
                break;
            }
            let energy = touch.energy;
            met += 1;
            let force = two.forces()[1].iter().sum::<Vec3>().dot(&direction);
            if let Some((before, slope)) = last {
                let error = (energy - before + 0.5 * (force + slope) * step).abs();
                worst = worst.max(error / energy.max(1e-2));
            }
            last = Some((energy, force));
        }
    }
    println!("{met} {worst:.1e}");
    assert!(met > 2000 && worst < 1e-4, "{met} {worst:.1e}");
}

/// Wide sheets of unlike cells pressed on each other by a fixed depth: nodal forces away from rims are those of the pressure within 8 %.
#[test]
fn an_even_depth_makes_even_forces_on_unlike_cells() {
    for (ratio, count) in [(1.0, 8), (1.7, 13), (2.4, 19), (4.0, 30)] {
        let (cells, below) = sheet(8, 1.0, 0.0, 0.0);
        let (others, mut above) = sheet(count, 1.0 / ratio, 0.3, 0.0);
        above.iter_mut().for_each(|x| *x += Vec3::new(1.13, -1.07, 0.19));
        let meshes = [Mesh::new(&cells, &below, |_| 0.1), Mesh::new(&others, &above, |_| 0.1)];
        let mut contact = SurfaceContact::between(meshes, [&below, &above], TOUCHING);
        contact.look(|(body, a)| [&below, &above][body][a as usize]);
        let mut forces = vec![0.0; below.len()];
        contact.forces(|(body, a), force| {
            if body == 0 {
                forces[a as usize] -= force.z;
            }
        });
        // κ u over an area: one a node inside.
        let exact = TOUCHING.stiffness * 0.01;
        let mut worst: f64 = 0.0;
        let inner = |x: &Vec3| (x - Vec3::new(4.0, 4.0, 0.0)).amax() < 1.5;
        for (_, force) in below.iter().zip(&forces).filter(|(x, _)| inner(x)) {
            worst = worst.max((force / exact - 1.0).abs());
        }
        println!("{ratio}: {worst:.3}");
        assert!(worst < 0.08, "{ratio}: {worst}");
    }
}

#[test]
fn turned_mirrored_and_in_other_units_the_answer_is_the_same() {
    let turn =
        Rotation3::from_axis_angle(&Vec3::y_axis(), 0.7) * Rotation3::from_axis_angle(&Vec3::x_axis(), 1.9);
    let mirror = Matrix3::from_diagonal(&Vec3::new(1.0, -1.0, 1.0));
    for (map, unit) in [(*turn.matrix(), 1.0), (mirror, 1.0), (Matrix3::identity(), 1000.0)] {
        let mut plain = sheets(Vec3::new(0.6, 0.2, 0.13), 0.1, Touching { edges: true, ..TOUCHING });
        let touching = Touching {
            distance: TOUCHING.distance * unit,
            skin: TOUCHING.skin * unit,
            edges: true,
            ..TOUCHING
        };
        let mut other = sheets(Vec3::new(0.6, 0.2, 0.13), 0.1, touching);
        let of = |body: usize| plain.at[body].iter().map(|x| map * x * unit).collect::<Vec<_>>();
        let at = [of(0), of(1)];
        let meshes = [0, 1].map(|b| other.contact.meshes()[b].clone());
        // The same cells where the other places are.
        let cells = [sheet(6, 1.0, 0.0, 0.1).0, sheet(9, 0.6, 0.1, 0.1).0];
        let meshes: [Mesh; 2] = std::array::from_fn(|b| {
            let mesh = Mesh::new(&cells[b], &at[b], |_| 0.1 * unit);
            assert_eq!(mesh.faces(), meshes[b].faces());
            mesh
        });
        other.contact = SurfaceContact::between(meshes, [&at[0], &at[1]], touching);
        other.at = at;
        let energies = [plain.look().energy, other.look().energy];
        assert!((energies[1] / (energies[0] * unit.powi(4)) - 1.0).abs() < 1e-11, "{energies:?}");
        for (plain, other) in plain.forces().iter().flatten().zip(other.forces().iter().flatten()) {
            assert!((map * plain * unit.powi(3) - other).norm() < 1e-11 * unit.powi(3));
        }
    }
}

/// What is near is found anew only when something has moved: forces are those of a new list to the bit.
#[test]
fn an_old_list_and_a_new_one_give_the_same_bits() {
    let mut two = sheets(Vec3::new(0.6, 0.2, 0.25), 0.05, Touching { edges: true, ..TOUCHING });
    for i in 0..60 {
        // Common motion takes nobody anywhere.
        two.at.iter_mut().flatten().for_each(|x| *x += Vec3::new(0.3, 0.1, 0.0));
        two.at[1].iter_mut().for_each(|x| x.z -= 0.002);
        let touch = two.look();
        let mut fresh = Two { contact: two.contact.clone(), at: two.at.clone() };
        fresh.contact.list(|(body, a)| two.at[body][a as usize]);
        assert_eq!(fresh.look(), touch);
        assert_eq!(fresh.forces(), two.forces(), "{i}");
    }
    assert!(two.contact.lists() < 4 && two.look().greatest_depth > 0.1, "{}", two.contact.lists());
}

/// Sheets that would fly through each other stop on the way, by less than all of their distance; those that part or fly together go all of theirs.
#[test]
fn nothing_leaps_through_what_it_may_touch() {
    for gap in [0.19, 0.3, 1.5] {
        let two = sheets(Vec3::new(0.6, 0.2, gap), 0.0, TOUCHING);
        let reach = |by: f64, common: Vec3| {
            let at = |(body, a): Node| two.at[body][a as usize];
            two.contact.reach(at, |(body, a)| at((body, a)) + Vec3::z() * (by * body as f64) + common)
        };
        for by in [-0.5 * gap, -1.1 * gap, -3.0 * gap, -40.0 * gap] {
            let share = reach(by, Vec3::zeros());
            let gone = share * -by;
            assert!(gone <= 0.85 * gap && (share == 1.0 || gone > 0.02 * gap), "{gap} {by}: {share}");
        }
        assert_eq!(reach(0.0, Vec3::new(100.0, 3.0, -7.0)), 1.0);
        assert_eq!(reach(0.1, Vec3::zeros()), 1.0);
    }
}

/// Both bodies at a speed.
struct At(f64);

impl Moving for At {
    fn mass(&self, _: Node) -> f64 {
        1.0
    }

    fn velocity(&self, _: Node) -> Vec3 {
        Vec3::z() * self.0
    }

    fn greatest_speed(&self) -> f64 {
        self.0
    }
}

/// What is listed and apart rests for as many steps as twice the speed needs to close the gap; a step that is bounded by D over the speed is not left out.
#[test]
fn surfaces_rest_while_nothing_can_touch_though_they_are_listed() {
    let (gap, stable) = (0.15, 1e-2);
    let waits = |two: &mut Two, speed: f64| {
        let touch = two.look();
        let mut pace = Pace::new(&two.contact, |_| 1.0);
        let step = pace.shortened((&two.contact, &touch), stable, 1.0, &At(speed));
        (pace.waits(), step)
    };
    for speed in [0.0, 0.1, 0.4, 1.0] {
        let mut two = sheets(Vec3::new(0.6, 0.2, 0.2 + gap), 0.0, TOUCHING);
        let (steps, step) = waits(&mut two, speed);
        assert!(steps > 0.0 && steps <= 16.0 && step == stable, "{speed}: {steps} {step}");
        // Each side at twice its speed for all of these steps.
        two.shift(Vec3::z() * -(4.0 * speed * stable * steps));
        assert_eq!(two.look().area, 0.0, "{speed}: {steps}");
        two.shift(Vec3::z() * (4.0 * speed * stable * steps - gap - 0.01));
        assert_eq!(waits(&mut two, speed).0, 0.0);
    }
    let mut two = sheets(Vec3::new(0.6, 0.2, 0.2 + gap), 0.0, TOUCHING);
    let (steps, step) = waits(&mut two, 8.0);
    assert!(steps == 0.0 && step < stable, "{steps} {step}");
}
