//! Friction of a surface on tools: its tangent against differences, work against what is lost and stored, tools that turn.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use contact::{Friction, Law, Pose, Surface, ToolContact, ToolShape, Touch, Watch};
use sph_core::{Cell, Vec3};

const MU: f64 = 0.3;

/// A square of one cell, .1 thick, a tenth of a half thickness deep in a tool.
fn contact(tool: ToolShape) -> ToolContact {
    let cells = [Cell { corners: [0, 1, 2, 3], count: 4 }];
    ToolContact {
        tool: tool.checked().unwrap(),
        surface: Surface::new(&cells, &rest(), |_| 0.05),
        law: Law::new(0.0).unwrap(),
        stiffness: 7.0,
    }
}

fn rest() -> [Vec3; 4] {
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.045))
}

fn plane() -> ToolShape {
    ToolShape::Plane { point: Vec3::zeros(), normal: Vec3::z() }
}

/// What the square moved by a vector feels.
fn moved_by(contact: &ToolContact, friction: &mut Friction, by: Vec3, pose: &Pose) -> (Touch, [Vec3; 4]) {
    let mut forces = [Vec3::zeros(); 4];
    let at = |a: u32| rest()[a as usize] + by;
    let mut watch = Watch::new(&contact.surface);
    let touch = contact.forces(&mut watch, Some(friction), pose, at, |a, f| forces[a as usize] += f);
    (touch, forces)
}

fn friction(contact: &ToolContact) -> Friction {
    Friction::new(MU, contact.surface.vertices().len()).unwrap()
}

/// It sticks up to μ N, slides with μ N, sticks again where it turns back; the work done on it is what is stored and lost, in steps of any
/// size, for a straight way and for one that bends.
#[test]
fn work_is_what_friction_stores_and_loses() {
    let contact = contact(plane());
    let (mut friction, pose) = (friction(&contact), Pose::default());
    let (mut work, mut lost, mut before, mut held) = (0.0, 0.0, None::<(Vec3, Vec3)>, 0.0);
    let way = |t: f64| Vec3::new(0.02 * libm::sin(t), 0.01 * libm::sin(2.3 * t), 0.0);
    let mut largest = 0.0_f64;
    for step in 0..200 {
        let by = way(0.05 * f64::from(step));
        let (touch, _) = moved_by(&contact, &mut friction, by, &pose);
        let along = Vec3::new(touch.force.x, touch.force.y, 0.0);
        assert!(along.norm() <= MU * touch.force.z * (1.0 + 1e-12));
        largest = largest.max(along.norm() / touch.force.z);
        if let Some((old, force)) = before {
            work -= 0.5 * (force + along).dot(&(by - old));
        }
        before = Some((by, along));
        friction.commit(|_, energy| lost += energy);
        held = 0.5 * along.norm_squared() / 7.0;
        assert!((work - lost - held).abs() < 1e-15, "{step}: {work:e} {lost:e} {held:e}");
    }
    // The way is hundreds of times what sticks: nearly all work is lost.
    assert!((largest / MU - 1.0).abs() < 1e-12 && lost > 0.99 * work, "{largest} {lost:e} {work:e}");
    // Parting, it loses what it stored.
    let before = lost;
    moved_by(&contact, &mut friction, Vec3::z(), &pose);
    friction.commit(|_, energy| lost += energy);
    assert!(held > 0.0 && (lost - before - held).abs() < 1e-15);
    assert_eq!(friction.numbers().count(), 0);
}

/// A plane that turns below the square drags it as one does that moves, at every place by its own speed.
#[test]
fn a_tool_that_turns_drags() {
    let contact = contact(plane());
    let mut friction = friction(&contact);
    moved_by(&contact, &mut friction, Vec3::zeros(), &Pose::default());
    friction.commit(|_, _| ());
    let angle = 1e-4;
    let (_, forces) = moved_by(&contact, &mut friction, Vec3::zeros(), &Pose { moved: Vec3::zeros(), angle });
    // Vertices: corners with a sixth, the middle with a third, k = 7 times that; each corner takes a quarter of the middle.
    let spun = |x: Vec3| Vec3::new(-x.y, x.x, 0.0) * angle;
    for (place, force) in rest().iter().zip(forces) {
        let middle = spun(Vec3::new(0.5, 0.5, 0.0));
        let exact = (spun(*place) / 6.0 + middle / 12.0) * 7.0;
        // Half of the angle is what the chord lacks of it.
        assert!((Vec3::new(force.x, force.y, 0.0) - exact).norm() < 1.5e-4 * exact.norm(), "{force}");
    }
}

/// Stick and slip against differences; what the tangent leaves out is of the change of N, and of the bend of the face over the stretch:
/// 2e-3 of k measured on the drum.
#[test]
fn the_tangent_along_the_face_is_a_derivative() {
    let drum = ToolShape::Cylinder { point: Vec3::new(0.4, 0.0, -5.0), axis: Vec3::y(), radius: 5.0 };
    for (tool, bound) in [(plane(), 1e-8), (drum, 6e-3)] {
        let contact = contact(tool);
        for way in [1e-4, 0.01] {
            let mut friction = friction(&contact);
            moved_by(&contact, &mut friction, Vec3::zeros(), &Pose::default());
            friction.commit(|_, _| ());
            let by = Vec3::new(0.8, 0.6, 0.0) * way;
            let mut tangent = nalgebra::Matrix3::zeros();
            let at = |a: u32| rest()[a as usize] + by;
            contact.tangent(Some(&friction), &Pose::default(), at, |_, _, block| tangent += block);
            let mut rate = Vec3::zeros();
            let pace = Pose { moved: Vec3::new(0.3, -0.2, 0.0), angle: 0.1 };
            contact.rates(Some(&friction), &Pose::default(), &pace, at, |_, force| rate += force);
            let h = 1e-6;
            let slope = |ahead: &dyn Fn(f64) -> (Vec3, Pose), friction: &mut Friction| {
                let [low, high] = [-h, h].map(|h| {
                    let (more, pose) = ahead(h);
                    moved_by(&contact, friction, by + more, &pose).0.force
                });
                (high - low) / (2.0 * h)
            };
            for k in 0..2 {
                let change = slope(&|h| (Vec3::ith(k, h), Pose::default()), &mut friction);
                let error = (change - tangent.column(k)).xy().norm();
                assert!(error < bound * 7.0, "{tool:?} {way}: {error:e}");
            }
            let with_tool = |h: f64| (Vec3::zeros(), Pose { moved: pace.moved * h, angle: pace.angle * h });
            let error = (slope(&with_tool, &mut friction) - rate).xy().norm();
            assert!(error < bound * 7.0, "{tool:?} {way}: {error:e}");
        }
    }
}

#[test]
fn anchors_are_taken_up_to_the_same_bits() {
    let contact = contact(plane());
    let (mut one, pose) = (friction(&contact), Pose::default());
    for step in 0..3 {
        moved_by(&contact, &mut one, Vec3::x() * (1e-3 * f64::from(step)), &pose);
        one.commit(|_, _| ());
    }
    let numbers: Vec<f64> = one.numbers().collect();
    let mut other = friction(&contact);
    other.take_up(numbers.as_chunks().0);
    let by = Vec3::new(0.0, 0.004, 0.0);
    assert_eq!(moved_by(&contact, &mut one, by, &pose), moved_by(&contact, &mut other, by, &pose));
    assert_eq!(one.lost(), other.lost());
    assert_eq!(Friction::new(-0.1, 3), None);
}
