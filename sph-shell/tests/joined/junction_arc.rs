//! Paths by arc length through joints of every kind: Lee's frame, whose corner is shared, a rigid set, or hung on the column.

use std::ops::ControlFlow;

use crate::common::{self, Sheets, X, Y, Z, at, beam_parts, supported};
use implicit_statics::{Control, CriticalOptions, PathOptions, Start, follow};
use nalgebra::Matrix3;
use sph_core::{Cloud, Vec3};
use sph_shell::{DirectorHold, Force, Held, Hinged, Holds, RigidSet, Shell, StaticShell, Supported, Tie};

const THICK: f64 = 2.0 / 120.0;
const WIDE: f64 = 3.0 / 120.0;
/// Bending stiffness of a leg.
const EI: f64 = common::YOUNG * THICK * THICK * THICK * WIDE / 12.0;

/// How the beam holds on to the column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Joint {
    /// Particles of both on one place.
    Shared,
    /// The same particles as one rigid set.
    Rigid,
    /// Edge of the beam on cells of the column, of which there are two across to one.
    Tied,
}

/// Two legs of length one, n cells each, hinged at both ends and free to move in their plane alone, under a force of 20 EI/L² that
/// presses on the upper one a fifth from the joint.
fn frame(n: usize, joint: Joint) -> Shell {
    let column =
        Sheets::default().add(Vec3::zeros(), [Z, Y * WIDE], [n, if joint == Joint::Tied { 2 } else { 1 }]);
    let both = column.add(Z, [X, Y * WIDE], [n, 1]);
    let cloud = match joint {
        Joint::Shared => both.cloud(),
        Joint::Rigid | Joint::Tied => both.apart(),
    };
    let corner = at(&cloud, |x| x.x < 1e-9 && x.z > 1.0 - 1e-9);
    let apart = |cloud: &Cloud| -> Vec<u32> {
        (0..cloud.len() as u32).filter(|a| joint == Joint::Shared || !corner.contains(a)).collect()
    };
    // The column's own head where the beam hangs on it: what hangs has the supports of its host.
    let head: Vec<u32> =
        corner.iter().copied().filter(|&a| joint == Joint::Tied && a < 3 * (n as u32 + 1)).collect();
    let supports: Vec<Supported> = vec![
        supported(at(&cloud, |x| x.z < 1e-9 || x.x > 1.0 - 1e-9), Hinged),
        supported([apart(&cloud), head.clone()].concat(), Held { displacement: vec![Y], director: Some(Y) }),
    ];
    let pressed = at(&cloud, |x| (x.x - 0.2).abs() < 1e-9).into_iter().map(|a| (a, 1.0)).collect();
    let force = Force { shares: pressed, total: -Z * (20.0 * EI) };
    let body = Shell::builder(beam_parts(cloud, THICK, supports, vec![Box::new(force)]));
    let body = match joint {
        Joint::Shared => body,
        Joint::Rigid => {
            let holds =
                Holds { translations: vec![Y], director: DirectorHold::InPlane(Y), ..Holds::default() };
            let at = Z + Y * (0.5 * WIDE);
            body.rigid(vec![RigidSet {
                particles: corner,
                at,
                mass: 0.0,
                inertia: Matrix3::zeros(),
                holds: vec![holds],
            }])
        }
        Joint::Tied => {
            let edge = corner.iter().copied().filter(|a| !head.contains(a)).collect();
            body.ties(vec![Tie { edge, host: (0..2 * n as u32).collect() }])
        }
    };
    body.build().unwrap()
}

/// Largest level down to .8 of it on the other side, in units of EI/L², and points of the path.
fn limit(body: Shell) -> (f64, usize) {
    let mut system = StaticShell::new(body);
    let options = PathOptions {
        critical: Some(CriticalOptions::default()),
        largest: 4.0,
        ..PathOptions::new(Control::ArcLength { first: 0.02, range: (-0.2, 0.95) })
    };
    let (mut top, mut points) = (0.0_f64, 0);
    follow(&mut system, &Start::default(), &options, |point, _| {
        (top, points) = (top.max(point.level()), points + 1);
        if point.level() < 0.8 * top { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    (20.0 * top, points)
}

/// The limit of fine meshes of this frame is 18.555 EI/L²; one point a cell approaches it from above with the square of cells.
#[test]
fn lees_frame_snaps_at_its_limit_load() {
    for (n, bound) in [(10, 1.5e-2), (20, 4e-3)] {
        let (top, points) = limit(frame(n, Joint::Shared));
        println!("{n} cells a leg: limit {top:.4} EI/L², {points} points");
        assert!((top / 18.555 - 1.0).abs() < bound, "{n}: {top}");
    }
}

#[test]
fn a_corner_that_is_rigid_or_hangs_snaps_at_the_same_load() {
    let shared = limit(frame(10, Joint::Shared)).0;
    for (joint, bound) in [(Joint::Rigid, 1e-6), (Joint::Tied, 5e-3)] {
        let (top, points) = limit(frame(10, joint));
        println!("{joint:?}: {top:.8} against {shared:.8} EI/L², {points} points");
        assert!((top / shared - 1.0).abs() < bound, "{joint:?}: {top} {shared}");
    }
}
