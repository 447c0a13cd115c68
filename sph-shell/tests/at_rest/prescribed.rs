//! Sets that are moved or turned by level: load rates, the column shortened by its end, the strip rolled by its end.

use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

use crate::common::{self, curved, energy_formulations, flat, parts, shake, shell};
use explicit_dynamics::{Amplitude, Damping, March, QuasiStatic};
use implicit_statics::{
    Control, CriticalOptions, End, Equilibrium, Path, PathOptions, Start, follow, linear_response,
    load_rate_error,
};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Held, Hinged, Load, Moved, Parts, Pressure, Reach, Rotated,
    Shell, ShellError, StaticShell, Support, Supported, SymmetryPlane,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn on(particles: &[u32], support: impl Support + 'static) -> Supported {
    Supported { particles: particles.to_vec(), support: Box::new(support) }
}

fn moved(direction: Vec3, by: f64) -> Moved {
    Moved { direction, by, amplitude: Amplitude::Constant }
}

fn rotated(axis: Vec3, by: f64) -> Rotated {
    Rotated { axis, by, amplitude: Amplitude::Constant }
}

#[test]
fn load_rates_are_derivatives_with_respect_to_the_level() {
    for (name, formulation) in energy_formulations() {
        let cloud = curved([7, 6]);
        let sides = cloud.sides.clone().unwrap();
        let supports = vec![
            on(sides.edge(Side::U0), Clamped),
            on(sides.edge(Side::U1), moved(Vec3::new(1.0, 0.3, -0.5), 0.05)),
            on(sides.edge(Side::U1), rotated(Vec3::new(0.2, 1.0, 0.4), 0.3)),
        ];
        let loads: Vec<Box<dyn Load>> = vec![
            Box::new(Pressure { value: 2.0, follower: true }),
            Box::new(Force { shares: vec![(9, 1.0)], total: Vec3::new(1.0, 2.0, 3.0) }),
        ];
        let mut body = shell(cloud, formulation, 0.2, &StretchCorrected, supports, loads);
        shake(&mut body, 0.03, 5);
        let mut system = StaticShell::new(body);
        let error = load_rate_error(&mut system, 0.7, 1e-4);
        assert!(error < 1e-8, "{name}: {error:.1e}");
    }
}

const LENGTH: f64 = 10.0;
const THICK: f64 = 0.1;
const YOUNG: f64 = 1200.0;
/// Bending stiffness of the strip of width one.
const EI: f64 = YOUNG * THICK * THICK * THICK / 12.0;

/// A strip without Poisson's ratio along x, one wide.
fn strip(particles: usize, supports: impl Fn(&sph_core::Sides) -> Vec<Supported>, end_force: f64) -> Shell {
    let cloud = flat([particles, 3], [LENGTH, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let edge = sides.edge(Side::U1);
    let shares = edge.iter().enumerate().map(|(i, &a)| (a, if i == 1 { 2.0 } else { 1.0 })).collect();
    let force = Force { shares, total: Vec3::x() * -end_force };
    let load = AppliedLoad { load: Box::new(force), amplitude: Amplitude::Constant };
    Shell::builder(Parts {
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), THICK).unwrap()),
        supports: supports(&sides),
        loads: if end_force == 0.0 { Vec::new() } else { vec![load] },
        ..parts(cloud, CELL, THICK)
    })
    .build()
    .unwrap()
}

fn levels(step: f64, until: f64) -> PathOptions {
    PathOptions::new(Control::Load { step, until })
}

fn run(system: &mut StaticShell, options: &PathOptions) -> Path {
    let path = follow(system, &Start::default(), options, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
    path
}

/// The force along −x that a set bears.
fn pressing(shell: &Shell, set: &[u32]) -> f64 {
    set.iter().map(|&a| -shell.reaction(a as usize).x).sum()
}

#[test]
fn a_column_shortened_by_its_end_buckles_at_the_load_of_one_that_is_pressed() {
    let euler = PI * PI * EI / (4.0 * LENGTH * LENGTH);
    let critical = CriticalOptions::default();
    let options = PathOptions { critical: Some(critical), ..levels(0.5, 1.5) };
    let mut pressed = StaticShell::new(strip(41, |s| vec![on(s.edge(Side::U0), Clamped)], euler));
    let by_force = run(&mut pressed, &options).critical[0].level * euler;

    let shortening = euler * LENGTH / (YOUNG * THICK);
    let supports = |s: &sph_core::Sides| {
        vec![on(s.edge(Side::U0), Clamped), on(s.edge(Side::U1), moved(-Vec3::x(), shortening))]
    };
    let shell = strip(41, supports, 0.0);
    let edge = shell.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let mut shortened = StaticShell::new(shell);
    let path = run(&mut shortened, &options);
    let point = &path.critical[0];
    assert!(path.points.iter().all(|point| point.converged.iterations <= 3), "{:?}", path.points);
    shortened.restore(&point.state);
    shortened.evaluate(point.state_level);
    let by_motion = pressing(shortened.shell(), &edge);
    println!("force {by_force} motion {by_motion} Euler {euler}");
    assert!((by_motion / by_force - 1.0).abs() < 1e-5, "{by_motion} {by_force}");
    assert!((by_force / euler - 1.0).abs() < 2e-3, "{by_force} {euler}");
}

#[test]
fn a_large_step_of_a_moved_edge_is_predicted() {
    // Without the predictor the cells at the edge are torn: the step is 40 % of a cell.
    let supports = |s: &sph_core::Sides| {
        vec![on(s.edge(Side::U0), Clamped), on(s.edge(Side::U1), moved(Vec3::x(), 0.1))]
    };
    let mut system = StaticShell::new(strip(41, supports, 0.0));
    let path = run(&mut system, &levels(1.0, 1.0));
    assert!(path.points[1].converged.iterations <= 4, "{:?}", path.points[1]);
    for a in 0..system.shell().len() {
        let (u, x) = (system.shell().displacement(a).x, system.shell().reference().cloud.positions[a].x);
        assert!((u - 0.1 * x / LENGTH).abs() < 1e-9, "{u} at {x}");
    }
}

#[test]
fn moved_sets_stand_beside_loads_in_linear_answers_and_along_arcs() {
    let supports = |s: &sph_core::Sides| {
        vec![on(s.edge(Side::U0), Clamped), on(s.edge(Side::U1), moved(Vec3::z(), 0.1))]
    };
    let shell = strip(21, supports, 1e-3);
    let edge = shell.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let mut system = StaticShell::new(shell);
    let rest = system.save();
    let motion = linear_response(&mut system, 0.0).unwrap();
    let part: Vec<f64> = motion.iter().map(|q| 1e-3 * q).collect();
    system.update(&part);
    system.evaluate(1e-3);
    let across: f64 = edge.iter().map(|&a| system.shell().reaction(a as usize).z).sum::<f64>() * 1e3;
    let exact = 3.0 * EI * 0.1 / LENGTH.powi(3);
    assert!((across / exact - 1.0).abs() < 3e-3, "{across} {exact}");
    let end = system.shell().displacement(edge[1] as usize);
    assert!((end.z - 1e-4).abs() < 1e-15 && end.x < 0.0, "{end:?}");

    system.restore(&rest);
    run(&mut system, &levels(0.5, 1.0));
    let by_load = system.save();
    system.restore(&rest);
    run(&mut system, &PathOptions::new(Control::ArcLength { first: 0.25, range: (-1.0, 1.0) }));
    let worst = system.save().iter().zip(&by_load).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(worst < 1e-8, "{worst}");
}

/// A strip clamped at one end whose other end turns upward by `angle` at level one.
fn rolled(particles: usize, angle: f64) -> Shell {
    let supports = |s: &sph_core::Sides| {
        vec![on(s.edge(Side::U0), Clamped), on(s.edge(Side::U1), rotated(-Vec3::y(), angle))]
    };
    strip(particles, supports, 0.0)
}

#[test]
fn a_strip_rolls_up_to_a_ring_by_its_end() {
    let shell = rolled(41, TAU);
    let edge = shell.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let mut system = StaticShell::new(shell);
    let options = levels(0.0625, 1.0);
    let mut worst = (0.0_f64, 0.0_f64);
    let path = follow(&mut system, &Start::default(), &options, |point, system| {
        system.evaluate(point.level());
        let (shell, angle) = (system.shell(), TAU * point.level());
        if angle > 0.0 {
            let moment: f64 = edge.iter().map(|&a| -shell.reaction_moment(a as usize).y).sum();
            let end = shell.position(edge[1] as usize);
            let radius = LENGTH / angle;
            let exact = Vec3::new(radius * libm::sin(angle), end.y, radius * (1.0 - libm::cos(angle)));
            worst.0 = worst.0.max((moment * LENGTH / (EI * angle) - 1.0).abs());
            worst.1 = worst.1.max((end - exact).norm() / LENGTH);
        }
        ControlFlow::Continue(())
    });
    assert_eq!(path.end, Ok(End::Reached));
    println!("moment within {:.1e}, end within {:.1e} of the length", worst.0, worst.1);
    // The chords of 40 cells that turn by 9° each.
    assert!(worst.0 < 3e-3 && worst.1 < 3e-3, "{worst:?}");
}

#[test]
fn a_march_with_a_turned_end_finds_the_same() {
    let angle = 0.6;
    let mut system = StaticShell::new(rolled(13, angle));
    run(&mut system, &levels(0.5, 1.0));
    system.evaluate(1.0);

    let mut marched = rolled(13, angle);
    let period = TAU / 3.516 * LENGTH * LENGTH * (common::DENSITY * THICK / EI).sqrt();
    let run = QuasiStatic {
        levels: vec![1.0],
        period: Some(period),
        ramp: 2.0,
        hold: 20.0,
        damping: Damping::Ratio(1.0),
        tolerance: 1e-14,
        accuracy: 1e-4,
        safety: 0.8,
    };
    let mut march = March::start(run, &mut marched).unwrap();
    let mut last = None;
    while let Some(record) = march.next_record(&mut marched).unwrap() {
        last = Some(record);
    }
    let edge = marched.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let found = system.shell();
    let moment = |shell: &Shell| edge.iter().map(|&a| shell.reaction_moment(a as usize).y).sum::<f64>();
    marched.evaluate_internal(true);
    for &a in &edge {
        let (d, x) = (marched.director(a as usize), marched.position(a as usize));
        let reported = Vec3::new(-libm::sin(angle), 0.0, libm::cos(angle));
        assert!((d - reported).norm() < 1e-12, "{d:?} is not {reported:?}");
        assert!((x - found.position(a as usize)).norm() < 1e-4 * LENGTH, "{x:?}");
    }
    assert!((moment(&marched) / moment(found) - 1.0).abs() < 1e-3, "{} {}", moment(&marched), moment(found));
    let record = last.unwrap();
    // The turned end does the work that the strip stores and damping takes.
    assert!(record.balance_error.abs() < 1e-3 * record.energy.internal, "{record:?}");
    assert!(record.energy.external > record.energy.internal, "{record:?}");
}

#[test]
fn contradictions_name_both_supports() {
    let build = |other: Box<dyn Support>| {
        let cloud = flat([5, 4], [2.0, 1.5]);
        let edge = cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
        let supports = vec![
            Supported { particles: edge.clone(), support: other },
            Supported { particles: edge, support: Box::new(rotated(Vec3::y(), 0.5)) },
        ];
        Shell::builder(Parts { supports, ..parts(cloud, CELL, 0.2) }).build()
    };
    let refused: [Box<dyn Support>; 3] =
        [Box::new(Clamped), Box::new(SymmetryPlane { normal: Vec3::x() }), Box::new(rotated(Vec3::y(), 0.5))];
    for other in refused {
        let Err(error) = build(other) else { panic!("accepted") };
        let ShellError::HeldDirector { rotated, other, .. } = error else { panic!("{error}") };
        assert_eq!(rotated + other, 1);
        for part in ["support 1", "support 0", "holds or turns as well"] {
            assert!(error.to_string().contains(part), "{error}");
        }
    }
    // A plane square to the axis holds no more than the rotation does; positions may be held beside it.
    let taken: [Box<dyn Support>; 3] = [
        Box::new(SymmetryPlane { normal: Vec3::y() }),
        Box::new(Hinged),
        Box::new(Held { displacement: vec![Vec3::z()], director: None }),
    ];
    for other in taken {
        assert!(build(other).is_ok());
    }
}
