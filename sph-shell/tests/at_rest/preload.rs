//! Preloads: derivatives in both load cases, prestressed frequencies, buckling of what is left, order of two load cases.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::ControlFlow;

use crate::common::{POISSON, YOUNG, flat, parts, shake, shell};
use explicit_dynamics::Amplitude;
use implicit_statics::{
    BucklingOptions, Control, End, Equilibrium, NewtonOptions, PathOptions, Start, follow, linear_buckling,
    load_rate_error, natural_modes, stiffness_error, unwatched,
};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Held, Hinged, Load, LoadCase, Moved, Parts, Preloaded,
    Pressure, Reach, Rotated, Shell, StaticShell, Support, Supported, SymmetryPlane,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const LENGTH: f64 = 10.0;
const THICK: f64 = 0.1;
/// Euler's load of the strip of width one, hinged at both ends.
const EULER: f64 = PI * PI * YOUNG * THICK * THICK * THICK / (12.0 * LENGTH * LENGTH);

fn on(particles: &[u32], support: impl Support + 'static) -> Supported {
    Supported { particles: particles.to_vec(), support: Box::new(support) }
}

fn first(support: impl Support + 'static) -> Preloaded<Box<dyn Support>> {
    Preloaded(Box::new(support))
}

fn preloaded(load: impl Load + 'static) -> Box<dyn Load> {
    Box::new(Preloaded(Box::new(load) as Box<dyn Load>))
}

fn moved(direction: Vec3, by: f64) -> Moved {
    Moved { direction, by, amplitude: Amplitude::Constant }
}

/// Applies the preload in full and makes the other case the one that is under way.
fn preload(system: &mut StaticShell) {
    system.set_case(LoadCase::Preload);
    to_one(system);
    system.set_case(LoadCase::Loading);
}

/// Follows the case that is under way to level one.
fn to_one(system: &mut StaticShell) {
    let newton = NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() };
    let options = PathOptions { newton, ..PathOptions::new(Control::Load { step: 0.5, until: 1.0 }) };
    let path = follow(system, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached), "{:?}", path.points.last());
}

fn frequency_squared(system: &mut StaticShell) -> f64 {
    natural_modes(system, 0.0, 1, 0.0, &mut unwatched).unwrap().modes[0].eigenvalue
}

fn critical(system: &mut StaticShell) -> f64 {
    linear_buckling(system, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap().modes[0].level
}

#[test]
fn tangents_and_load_rates_are_derivatives_in_both_cases() {
    let patch = Cylinder { radius: 1.0, angles: [0.0, FRAC_PI_2], length: 0.8 };
    let cloud = lattice(&patch, [7, 4], EndWeights::Trapezoid).unwrap();
    let sides = cloud.sides.clone().unwrap();
    // All edges stay in planes, so that pressure has a potential.
    let supports = vec![
        on(sides.edge(Side::U0), Held { displacement: vec![Vec3::x()], director: None }),
        on(sides.edge(Side::U1), Held { displacement: vec![Vec3::z()], director: None }),
        on(sides.edge(Side::V0), Held { displacement: vec![Vec3::y()], director: None }),
        on(sides.edge(Side::V1), Held { displacement: vec![Vec3::y()], director: None }),
        on(&[9, 14], first(moved(Vec3::new(0.3, 0.1, 1.0), 0.03))),
        on(&[9, 14], moved(Vec3::new(1.0, -0.1, -0.3), -0.02)),
        on(&[10], first(Rotated { axis: Vec3::y(), by: 0.2, amplitude: Amplitude::Constant })),
        on(&[17], Rotated { axis: Vec3::y(), by: -0.1, amplitude: Amplitude::Constant }),
    ];
    let force = |z| Force { shares: vec![(11, 1.0), (12, 1.0)], total: Vec3::new(1.0, 0.5, z) };
    let loads: Vec<Box<dyn Load>> = vec![
        preloaded(Pressure { value: -9.0, follower: true }),
        Box::new(Pressure { value: 5.0, follower: true }),
        preloaded(force(2.0)),
        Box::new(force(-1.0)),
    ];
    let mut body = shell(cloud, CELL, 0.1, &StretchCorrected, supports, loads);
    shake(&mut body, 0.02, 5);
    let mut system = StaticShell::new(body);
    assert!(system.has_preload());
    let n = system.unknowns();
    for case in [LoadCase::Preload, LoadCase::Loading] {
        system.set_case(case);
        let rate = load_rate_error(&mut system, 0.6, 1e-4);
        let way: Vec<f64> = (0..n).map(|i| libm::sin(1.3 * i as f64)).collect();
        let stiffness = stiffness_error(&mut system, 0.6, &way, 2e-5);
        println!("{case:?}: load rate {rate:.1e}, tangent {stiffness:.1e}");
        assert!(rate < 1e-8 && stiffness < 2e-12, "{case:?}: {rate:.1e} {stiffness:.1e}");
    }
}

/// A strip along x without Poisson's ratio, hinged at both ends, under a preload and another force on its end, both pulling.
fn strip(cells: usize, first: f64, then: f64) -> StaticShell {
    let cloud = flat([cells + 1, 3], [LENGTH, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let shares: Vec<(u32, f64)> =
        sides.edge(Side::U1).iter().zip([1.0, 2.0, 1.0]).map(|(&a, s)| (a, s)).collect();
    let pull = |size: f64| Force { shares: shares.clone(), total: Vec3::x() * size };
    let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let mut loads = Vec::new();
    loads.extend((first != 0.0).then(|| applied(preloaded(pull(first)))));
    loads.extend((then != 0.0).then(|| applied(Box::new(pull(then)))));
    let held = Held { displacement: vec![Vec3::z()], director: None };
    let parts = Parts {
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), THICK).unwrap()),
        supports: vec![on(sides.edge(Side::U0), Hinged), on(sides.edge(Side::U1), held)],
        loads,
        ..parts(cloud, CELL, THICK)
    };
    StaticShell::new(Shell::builder(parts).build().unwrap())
}

/// With the stretch λ of the force N, `½ (λ² − 1) λ = N/EA`, the strip has the stiffness `N k²/λ + EI k⁴/λ²` against the
/// deflection sin kX, and its mass stays: `ω²/ω₀² = 1/λ² + N/(λ N_cr)`.
#[test]
fn a_pulled_strip_sings_higher_as_a_beam_column_says() {
    let mut errors = Vec::new();
    for cells in [10, 20, 40] {
        let unloaded = frequency_squared(&mut strip(cells, 0.0, 0.0));
        let mut largest = 0.0_f64;
        for ratio in [-0.5, 1.0, 4.0] {
            let force = ratio * EULER;
            let mut stretched = strip(cells, force, 0.0);
            preload(&mut stretched);
            let found = frequency_squared(&mut stretched) / unloaded;
            let mut stretch = 1.0_f64;
            for _ in 0..20 {
                let lack = 0.5 * (stretch * stretch - 1.0) * stretch - force / (YOUNG * THICK);
                stretch -= lack / (1.5 * stretch * stretch - 0.5);
            }
            let exact = 1.0 / (stretch * stretch) + ratio / stretch;
            largest = largest.max((found / exact - 1.0).abs());
            println!("{cells} cells, N/N_cr = {ratio}: {found} {exact}");
        }
        errors.push(largest);
    }
    println!("{errors:?}");
    assert!(errors[2] < 2.5e-3 && errors[0] > 3.0 * errors[1] && errors[1] > 3.0 * errors[2], "{errors:?}");
}

/// What is left of the square of a frequency runs straight to zero at the buckling load of the same lattice, and that of what is
/// left of the load is the rest of it: both but for the shortening, 8e-5 of the length at the buckling load.
#[test]
fn a_pressed_strip_loses_its_frequency_at_its_buckling_load() {
    let whole = critical(&mut strip(20, 0.0, -EULER));
    let unloaded = frequency_squared(&mut strip(20, 0.0, 0.0));
    for part in [0.25, 0.5, 0.99] {
        let mut pressed = strip(20, -part * whole * EULER, -EULER);
        preload(&mut pressed);
        let (frequency, rest) = (frequency_squared(&mut pressed) / unloaded, critical(&mut pressed));
        println!("{part}: {frequency} {}", rest / whole);
        assert!((frequency - (1.0 - part)).abs() < 1e-4, "{part}: {frequency}");
        assert!((rest / whole - (1.0 - part)).abs() < 1e-4, "{part}: {rest} of {whole}");
    }
}

/// A tube held along its axis under pressure from outside that follows it ovals at 3 D/R³; its lowest frequency, that of the oval,
/// goes as `ω² = ω₀² (1 − p/p_cr)`, and the pressure that is left to buckle it is the rest. This lattice buckles 5e-4 above.
#[test]
fn a_tube_under_follower_pressure_loses_the_frequency_of_its_oval() {
    let thickness: f64 = 0.01;
    let oval = 3.0 * YOUNG * thickness.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let quarter = |part: f64| {
        let patch = Cylinder { radius: 1.0, angles: [0.0, FRAC_PI_2], length: 0.1 };
        let cloud = lattice(&patch, [61, 2], EndWeights::Trapezoid).unwrap();
        let sides = cloud.sides.clone().unwrap();
        let plane = |side, normal| on(sides.edge(side), SymmetryPlane { normal });
        let supports = vec![
            plane(Side::U0, Vec3::x()),
            plane(Side::U1, Vec3::z()),
            plane(Side::V0, Vec3::y()),
            plane(Side::V1, Vec3::y()),
        ];
        let pressure = |part: f64| Pressure { value: -part * oval, follower: true };
        let mut loads: Vec<Box<dyn Load>> = vec![Box::new(pressure(1.0))];
        if part > 0.0 {
            loads.push(preloaded(pressure(part)));
        }
        let mut tube = StaticShell::new(shell(cloud, CELL, thickness, &StretchCorrected, supports, loads));
        if part > 0.0 {
            preload(&mut tube);
        }
        tube
    };
    let unloaded = frequency_squared(&mut quarter(0.0));
    for part in [0.25, 0.5, 0.9] {
        let mut tube = quarter(part);
        let (frequency, rest) = (frequency_squared(&mut tube) / unloaded, critical(&mut tube));
        println!("{part}: {frequency} {rest}");
        assert!((frequency - (1.0 - part)).abs() < 1.5e-3, "{part}: {frequency}");
        assert!((rest - (1.0 - part)).abs() < 1.5e-3, "{part}: {rest}");
    }
}

/// An elastic shell under dead loads and moved edges ends where it ends, whichever came first: pulled and then pushed aside, the
/// other way round, or at once.
#[test]
fn the_order_of_two_load_cases_does_not_matter() {
    let ends = |which: usize| {
        let cloud = flat([13, 4], [3.0, 0.6]);
        let sides = cloud.sides.clone().unwrap();
        let edge = sides.edge(Side::U1).to_vec();
        let (stretch, push) = (moved(Vec3::x(), 0.02), moved(Vec3::y(), 0.03));
        let lift = Force { shares: vec![(25, 1.0), (27, 2.0)], total: Vec3::new(0.0, 0.4, 1.2) };
        let mut supports = vec![on(sides.edge(Side::U0), Clamped)];
        let mut loads: Vec<Box<dyn Load>> = Vec::new();
        match which {
            0 => {
                supports.extend([on(&edge, stretch), on(&edge, push)]);
                loads.push(Box::new(lift));
            }
            1 => {
                supports.extend([on(&edge, first(stretch)), on(&edge, push)]);
                loads.push(preloaded(lift));
            }
            _ => {
                supports.extend([on(&edge, stretch), on(&edge, first(push))]);
                loads.push(Box::new(lift));
            }
        }
        let mut system = StaticShell::new(shell(cloud, CELL, 0.05, &StretchCorrected, supports, loads));
        if system.has_preload() {
            preload(&mut system);
        }
        to_one(&mut system);
        system.save()
    };
    let at_once = ends(0);
    let largest = at_once.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for which in [1, 2] {
        let apart = ends(which).iter().zip(&at_once).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("{which}: {:.1e}", apart / largest);
        assert!(apart < 1e-12 * largest, "{which}: {apart}");
    }
}
