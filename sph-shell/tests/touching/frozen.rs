//! Contact that is frozen in a state: its forces are linear about it, its tangent the one that it had, and where it would change is found.

use crate::common::{YOUNG, flat, parts};
use contact::{Law, ToolShape, Turn, stiffness};
use explicit_dynamics::Amplitude;
use implicit_statics::Equilibrium;
use sph_core::{Cylinder, EndWeights, Vec3, lattice};
use sph_shell::{Formulation, LoadCase, OwnContact, Reach, Shell, StaticShell, Tool};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICKNESS: f64 = 0.15;

fn plane(z: f64, friction: f64) -> Tool {
    Tool {
        shape: ToolShape::Plane { point: Vec3::z() * z, normal: Vec3::new(0.05, 0.0, 1.0) },
        moved: Vec3::zeros(),
        turn: 0.0,
        friction,
        amplitude: Amplitude::Constant,
        case: LoadCase::Loading,
        law: Law::SHARP,
        stiffness: stiffness(YOUNG, THICKNESS, 0.19),
    }
}

/// A tube, open along its length, pressed flat until its walls are in each other, and in a rough plane below.
fn pressed() -> StaticShell {
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.0], length: 0.6 };
    let cloud = lattice(&shape, [31, 5], EndWeights::Trapezoid).unwrap();
    let rest = cloud.positions.clone();
    let own = OwnContact {
        law: Law::SHARP,
        stiffness: 0.5 * stiffness(YOUNG, THICKNESS, 0.19),
        edges: false,
        friction: 0.0,
    };
    let builder = Shell::builder(parts(cloud, CELL, THICKNESS)).touching_itself(own);
    let mut shell = builder.tools(vec![plane(-0.12, 0.3)]).build().unwrap();
    for (a, x) in rest.iter().enumerate() {
        let d = shell.director(a);
        shell.set_state(a, Vec3::new(x.x, x.y + 0.03 * x.z, 0.06 * x.z), Vec3::new(d.x, d.y, d.z * 3.0));
    }
    let mut system = StaticShell::new(shell);
    system.evaluate(0.0);
    system.commit();
    system
}

fn external(system: &mut StaticShell) -> Vec<f64> {
    let mut out = vec![0.0; system.unknowns()];
    system.external(0.0, &mut out);
    out
}

#[test]
fn frozen_contact_is_linear_about_its_state() {
    let mut system = pressed();
    let mut before = vec![
        0.0;
        {
            system.pattern_changed(0.0);
            system.pattern().len()
        }
    ];
    system.tangent(0.0, &mut before);
    let touched = external(&mut system);
    system.freeze_contact(0.0);
    assert!(system.shell().own_touch().unwrap().area > 0.3 && system.shell().touches()[0].area > 0.1);
    let frozen = external(&mut system);
    let scale = touched.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(touched.iter().zip(&frozen).all(|(a, b)| (a - b).abs() < 1e-14 * scale));
    let mut after = vec![0.0; system.pattern().len()];
    system.tangent(0.0, &mut after);
    let most = before.iter().fold(0.0_f64, |most, k| most.max(k.abs()));
    assert!(before.iter().zip(&after).all(|(a, b)| (a - b).abs() < 1e-14 * most));
    // Lifted by a whole thickness nothing touches any more; what is frozen pulls as a spring does, twice as far twice as much.
    let lift = |system: &mut StaticShell, way: f64| {
        let rest = system.save();
        let up: Vec<f64> = system.rigid_motions().unwrap().iter().map(|row| way * row[2]).collect();
        system.update(&up);
        let found = external(system);
        system.restore(&rest);
        let change: Vec<f64> = found.iter().zip(&frozen).map(|(a, b)| a - b).collect();
        change
    };
    let (once, twice) = (lift(&mut system, THICKNESS), lift(&mut system, 2.0 * THICKNESS));
    let size = once.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(size > 0.1 * scale);
    assert!(once.iter().zip(&twice).all(|(a, b)| (2.0 * a - b).abs() < 1e-12 * size));
    // Frozen again it is that of the new state, in which nothing touches the plane.
    let up: Vec<f64> = system.rigid_motions().unwrap().iter().map(|row| 9.0 * row[2]).collect();
    system.update(&up);
    system.freeze_contact(0.0);
    assert_eq!(system.shell().touches()[0].area, 0.0);
}

/// A flat plate that stands a gap off a plane, or presses on it, and slides along it.
#[test]
fn where_contact_would_change_is_found() {
    let of = |depth: f64| {
        let cloud = flat([5, 4], [1.0, 0.8]);
        let tool = Tool {
            shape: ToolShape::Plane { point: Vec3::z() * (depth - 0.5 * THICKNESS), normal: Vec3::z() },
            ..plane(0.0, 0.5)
        };
        let shell = Shell::builder(parts(cloud, CELL, THICKNESS)).tools(vec![tool]).build().unwrap();
        let mut system = StaticShell::new(shell);
        system.evaluate(0.0);
        system.commit();
        system.freeze_contact(0.0);
        system
    };
    let along = |system: &StaticShell, way: [f64; 3]| -> Vec<f64> {
        let all = system.rigid_motions().unwrap();
        all.iter().map(|row| (0..3).map(|k| way[k] * row[k]).sum()).collect()
    };
    let change = |depth: f64, way: [f64; 3]| {
        let mut system = of(depth);
        let motion = along(&system, way);
        system.first_change(&motion).map(|change| (change.turn, change.share))
    };
    let is = |found: Option<(Turn, f64)>, turn: Turn, share: f64| {
        assert!(found.is_some_and(|own| own.0 == turn && (own.1 / share - 1.0).abs() < 1e-6), "{found:?}");
    };
    is(change(-0.01, [0.0, 0.0, -0.04]), Turn::Closes, 0.25);
    is(change(0.01, [0.0, 0.0, 0.04]), Turn::Opens, 0.25);
    // |s| = μ N/k = μ times the depth.
    is(change(0.01, [0.02, 0.0, 0.0]), Turn::Slips, 0.25);
    // Pressed on as it slides, and let go: |s| = μ (depth ± the way across).
    is(change(0.01, [0.02, 0.0, 0.02]), Turn::Slips, 1.0 / 6.0);
    assert_eq!(change(-0.01, [0.0, 0.0, 0.04]), None);
    assert_eq!(change(0.01, [0.0, 0.0, -0.04]), None);
}
