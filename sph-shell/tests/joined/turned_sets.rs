//! Sets that turn as one body: a whole shell stores nothing on the way, a strip is twisted as St Venant says, in time as at rest.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use crate::common::{curved, flat, parts, shell};
use explicit_dynamics::{Amplitude, Clock, Dynamics};
use implicit_statics::{Control, End, PathOptions, Start, follow, linear_response, load_rate_error};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Side, Vec3};
use sph_shell::{
    Clamped, Formulation, Held, Moved, Parts, Reach, Shell, ShellError, StaticShell, Support, Supported,
    Turned,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn on(particles: &[u32], support: impl Support + 'static) -> Supported {
    Supported { particles: particles.to_vec(), support: Box::new(support) }
}

fn turned(axis: Vec3, point: Vec3, by: f64, amplitude: Amplitude) -> Turned {
    Turned { axis, point, by, amplitude }
}

#[test]
fn a_shell_that_is_turned_as_a_whole_stores_nothing_and_comes_back() {
    let cloud = curved([7, 6]);
    let all: Vec<u32> = (0..cloud.len() as u32).filter(|&a| a != 20).collect();
    let axis = Vec3::new(0.3, 1.0, -0.4);
    let turn = turned(axis, Vec3::new(0.5, -1.0, 2.0), TAU, Amplitude::Constant);
    let mut system =
        StaticShell::new(shell(cloud, CELL, 0.2, &StretchCorrected, vec![on(&all, turn)], vec![]));
    // One particle is free and goes along.
    let options = PathOptions::new(Control::Load { step: 0.125, until: 1.0 });
    let mut most = 0.0_f64;
    let path = follow(&mut system, &Start::default(), &options, |point, system: &mut StaticShell| {
        system.evaluate(point.level());
        most = most.max(system.shell().stored_energy());
        ControlFlow::Continue(())
    });
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
    let away = (0..system.shell().len()).map(|a| system.shell().displacement(a).norm()).fold(0.0, f64::max);
    println!("stored {most:.1e}, away {away:.1e}");
    // Newton's tolerance is relative to the forces that it met on the way.
    assert!(most < 1e-15 && away < 3e-10, "{most:.1e} {away:.1e}");
}

const YOUNG: f64 = 1200.0;
const THICK: f64 = 0.05;

/// A strip of width one, clamped at one end, the other turned about its long axis.
fn strip(length: f64, cells: [usize; 2], by: f64, amplitude: Amplitude) -> Shell {
    let cloud = flat([cells[0] + 1, cells[1] + 1], [length, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let axis = turned(Vec3::x(), Vec3::new(0.0, 0.5, 0.0), by, amplitude);
    Shell::builder(Parts {
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.3).unwrap(), THICK).unwrap()),
        supports: vec![on(sides.edge(Side::U0), Clamped), on(sides.edge(Side::U1), axis)],
        ..parts(cloud, CELL, THICK)
    })
    .build()
    .unwrap()
}

/// Moment about the axis that turns the end.
fn torque(shell: &Shell) -> f64 {
    let edge = shell.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let of = |&a: &u32| {
        let arm = shell.position(a as usize) - Vec3::new(0.0, 0.5, 0.0);
        (arm.cross(&shell.reaction(a as usize)) + shell.reaction_moment(a as usize)).x
    };
    edge.iter().map(of).sum()
}

fn solved(mut shell: StaticShell, step: f64) -> StaticShell {
    let options = PathOptions::new(Control::Load { step, until: 1.0 });
    let path = follow(&mut shell, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
    shell.evaluate(1.0);
    shell
}

/// Angle over torque of two lengths differ by ΔL/GJ, `J = b t³/3 (1 − 0.63 t/b)`: what the clamped ends stiffen is in both. Cells as wide
/// as the thickness do not resolve the layer at the free edges.
#[test]
fn a_strip_is_twisted_as_st_venant_says() {
    let shear = YOUNG / 2.6;
    let rigidity = shear * THICK.powi(3) / 3.0 * (1.0 - 0.63 * THICK);
    let angle = 1e-3;
    let soft = |length: f64, across: usize| {
        let cells = [(length as usize) * across, across];
        angle
            / torque(solved(StaticShell::new(strip(length, cells, angle, Amplitude::Constant)), 1.0).shell())
    };
    for (across, bound) in [(8, 1.6e-2), (16, 1.2e-2)] {
        let error = (soft(8.0, across) - soft(4.0, across)) * rigidity / 4.0 - 1.0;
        println!("{across} cells across: {error:.2e}");
        assert!(error.abs() < bound, "{error}");
    }
}

/// In time, slowly: the torque that is found at rest, and as much work as is stored.
#[test]
fn a_march_turns_the_end_as_statics_do() {
    let by = 0.8;
    let still = solved(StaticShell::new(strip(4.0, [24, 6], by, Amplitude::Constant)), 0.25);
    let (time, damping) = (3.0, 4.0);
    let mut body = strip(4.0, [24, 6], by, Amplitude::Smooth(time));
    let mut clock = Clock::start(&mut body, 1.0, 0.8, damping).unwrap();
    while clock.now.time < 4.0 * time {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let stored = body.evaluate(clock.now);
    let (found, wanted) = (torque(&body), torque(still.shell()));
    println!("{found} {wanted}, stored {stored} {}", still.shell().stored_energy());
    // Newton's tolerance.
    assert!((found / wanted - 1.0).abs() < 2e-8, "{found} {wanted}");
    assert!((stored / still.shell().stored_energy() - 1.0).abs() < 1e-13, "{stored}");
}

#[test]
fn rates_along_the_level_are_derivatives_and_what_opposes_a_turn_is_refused() {
    let mut system = solved(StaticShell::new(strip(4.0, [8, 4], 0.8, Amplitude::Constant)), 0.5);
    let error = load_rate_error(&mut system, 0.9, 1e-4);
    assert!(error < 1e-8, "{error:.1e}");
    assert!(linear_response(&mut system, 0.0).is_ok());

    let built = |other: Box<dyn Support>| {
        let cloud = flat([4, 3], [1.0, 1.0]);
        let turn = turned(Vec3::x(), Vec3::zeros(), 0.3, Amplitude::Constant);
        let supports = vec![on(&[9, 10, 11], turn), Supported { particles: vec![10], support: other }];
        Shell::builder(Parts { supports, ..parts(cloud, CELL, THICK) }).build().map(drop)
    };
    let hold = |direction| Box::new(Held { displacement: vec![direction], director: None });
    assert!(built(hold(Vec3::x())).is_ok(), "along its axis nothing turns");
    assert!(matches!(built(hold(Vec3::z())), Err(ShellError::Contradiction { particle: 10, .. })));
    assert!(matches!(
        built(Box::new(Clamped)),
        Err(ShellError::HeldDirector { .. } | ShellError::Contradiction { .. })
    ));
    let pulled = Moved { direction: Vec3::x(), by: 0.1, amplitude: Amplitude::Constant };
    assert!(built(Box::new(pulled)).is_ok(), "twisted and pulled");
}
