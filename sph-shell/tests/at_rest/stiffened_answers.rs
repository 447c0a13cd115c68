//! Stiffened plates: a bar against the sheet that it stands for and against fine elements, many bars against their stiffness spread over the
//! surface, the buckling of a plate with one bar along its middle.

use std::f64::consts::PI;

use crate::common::{Sheets, X, Y, Z, at, flat, linear_energy, parts, supported};
use explicit_dynamics::Amplitude;
use implicit_statics::{
    BucklingOptions, Equilibrium, linear_buckling, linear_response, natural_modes, unwatched,
};
use shell_kinematics::{BarSection, GivenSection, Isotropic, IsotropicSection, Section, Stiffness};
use sph_core::Cloud;
use sph_shell::{
    AppliedLoad, Force, Formulation, Held, Load, Parts, Pressure, PressurePatch, Reach, Shell, StaticShell,
    Stiffener, Supported,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const YOUNG: f64 = 2e11;
const POISSON: f64 = 0.3;
const SHEAR: f64 = YOUNG / 2.6;
const THICK: f64 = 0.01;

fn isotropic(thickness: f64) -> Box<dyn Section> {
    Box::new(IsotropicSection::new(Isotropic::new(YOUNG, POISSON).unwrap(), thickness).unwrap())
}

/// A unit square simply supported along its edges, its corners held in the plane.
fn on_edges(cloud: &Cloud) -> Vec<Supported> {
    let edge = at(cloud, |x| x.z.abs() < 1e-9 && (x.x.min(x.y) < 1e-9 || x.x.max(x.y) > 1.0 - 1e-9));
    let place = |x: f64| at(cloud, |p| (p - X * x).norm() < 1e-9);
    let held = |displacement| Held { displacement, director: None };
    vec![
        supported(edge, held(vec![Z])),
        supported(place(0.0), held(vec![X, Y])),
        supported(place(1.0), held(vec![Y])),
    ]
}

fn shell(cloud: Cloud, section: Box<dyn Section>, loads: Vec<Box<dyn Load>>, bars: Vec<Stiffener>) -> Shell {
    let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let loads = loads.into_iter().map(applied).collect();
    let supports = on_edges(&cloud);
    let parts = Parts { section, supports, loads, density: 7800.0, ..parts(cloud, CELL, THICK) };
    Shell::builder(parts).stiffeners(bars).build().unwrap()
}

/// A bar along x at some y, of a rectangle.
fn bar(cloud: &Cloud, y: f64, [width, deep]: [f64; 2], height: f64) -> Stiffener {
    let particles = at(cloud, |x| (x.y - y).abs() < 1e-9);
    let section = BarSection::rectangle([YOUNG, SHEAR], width, deep);
    Stiffener { particles, section, height, mass: 7800.0 * width * deep, in_surface: None }
}

/// The plate of sections.rs on a blade whose upper edge lies in the middle surface: as a bar.
fn on_a_bar(deep: f64, loads: Vec<Box<dyn Load>>) -> Shell {
    let cloud = flat([33, 33], [1.0, 1.0]);
    let blade = bar(&cloud, 0.5, [THICK, deep], -0.5 * deep);
    shell(cloud, isotropic(THICK), loads, vec![blade])
}

/// The same with a sheet eight cells deep.
fn on_a_sheet(deep: f64, loads: Vec<Box<dyn Load>>) -> Shell {
    let sheets = Sheets::default().add(X * 0.0, [X, Y], [32, 32]).add(Y * 0.5, [X, -Z * deep], [32, 8]);
    shell(sheets.cloud(), isotropic(THICK), loads, Vec::new())
}

/// Deflections in the middle and a quarter aside under pressure on the plate.
fn deflections(body: impl Fn(Vec<Box<dyn Load>>) -> Shell) -> [f64; 2] {
    let free = body(Vec::new());
    let cloud = &free.reference().cloud;
    let plate = (0..cloud.cells.len() as u32).filter(|&c| {
        let cell = &cloud.cells[c as usize];
        cell.particles().iter().all(|&a| cloud.positions[a as usize].z.abs() < 1e-9)
    });
    let load: Box<dyn Load> = Box::new(PressurePatch {
        pressure: Pressure { value: -1e4, follower: false },
        cells: plate.collect(),
        factors: Vec::new(),
    });
    let mut system = StaticShell::new(body(vec![load]));
    let small = 1e-7;
    let response = linear_response(&mut system, 0.0).unwrap();
    system.update(&response.iter().map(|u| u * small).collect::<Vec<_>>());
    [0.5, 0.25].map(|y| {
        let cloud = &system.shell().reference().cloud;
        let a = at(cloud, |p| (p - X * 0.5 - Y * y).norm() < 1e-9)[0];
        -system.shell().displacement(a as usize).z / small
    })
}

fn frequencies(shell: Shell) -> Vec<f64> {
    let found = natural_modes(&mut StaticShell::new(shell), 0.0, 4, 0.0, &mut unwatched).unwrap().modes;
    found.iter().map(|mode| mode.eigenvalue.sqrt()).collect()
}

/// Deflections and the first four frequencies of a plate on a bar against those on the sheet that it stands for. Bar and plate have one director: where the bar
/// shears, the plate beside it has to, over the width of a cell, so that a deep bar is too stiff by a part of its shear; the deflection of a blade a tenth of its length deep is
/// shear to 8 %.
#[test]
fn a_plate_on_a_bar_is_one_on_its_blade() {
    for (deep, bounds) in [(0.05, [1e-2, 1e-2]), (0.1, [4e-2, 1e-2])] {
        let [bar, sheet] =
            [deflections(|loads| on_a_bar(deep, loads)), deflections(|loads| on_a_sheet(deep, loads))];
        let bent = [0, 1].map(|k| bar[k] / sheet[k] - 1.0);
        let [bar, sheet] =
            [frequencies(on_a_bar(deep, Vec::new())), frequencies(on_a_sheet(deep, Vec::new()))];
        let sung: Vec<f64> = bar.iter().zip(&sheet).map(|(bar, sheet)| bar / sheet - 1.0).collect();
        println!("{deep}: {bent:.4?} {sung:.4?}");
        assert!(bent.iter().all(|error| error.abs() < bounds[0]), "{deep}: {bent:?}");
        assert!(sung.iter().all(|error| error.abs() < bounds[1]), "{deep}: {sung:?}");
    }
}

/// Stiff against shear and soft in torsion, so that it does not matter how the plate hands these over.
fn bending(section: BarSection) -> BarSection {
    BarSection { shear: 100.0 * section.shear, torsion: 0.01 * section.torsion, ..section }
}

/// Bars the distance s apart are, ever closer, the stiffness of the plate and `EA/s` along them, at their height: what the spread of the
/// bars leaves falls with the square of s.
#[test]
fn many_bars_become_a_stiffness() {
    let n = 32;
    let load = || -> Vec<Box<dyn Load>> { vec![Box::new(Pressure { value: 1e4, follower: false })] };
    let (deep, height, share) = (0.04, 0.025, 0.1);
    let plate = YOUNG * THICK / (1.0 - POISSON * POISSON);
    let of_bars = bending(BarSection::rectangle([YOUNG, SHEAR], share, deep));
    let mut errors = Vec::new();
    for every in [8, 4, 2, 1] {
        let cloud = flat([n + 1, n + 1], [1.0, 1.0]);
        let spacing = every as f64 / n as f64;
        // All bars together are `share` wide over a width of one; one on an edge is a half.
        let bars = (0..=n / every).map(|i| {
            let part = spacing * if i == 0 || i == n / every { 0.5 } else { 1.0 };
            let whole = bar(&cloud, i as f64 * spacing, [share, deep], height);
            Stiffener { section: bending(whole.section).part(part), mass: whole.mass * part, ..whole }
        });
        let found = linear_energy(shell(cloud.clone(), isotropic(THICK), load(), bars.collect()));
        let (a, d) = (plate, plate * THICK * THICK / 12.0);
        let isotropic = |k: f64| [[k, POISSON * k, 0.0], [POISSON * k, k, 0.0], [0.0, 0.0, 0.35 * k]];
        let mut matrices = Stiffness {
            membrane: isotropic(a),
            coupling: [[0.0; 3]; 3],
            bending: isotropic(d),
            shear: [[5.0 / 6.0 * SHEAR * THICK, 0.0], [0.0, 5.0 / 6.0 * SHEAR * THICK]],
        };
        matrices.membrane[0][0] += of_bars.axial;
        matrices.coupling[0][0] += of_bars.axial * height;
        matrices.bending[0][0] += of_bars.bending + of_bars.axial * height * height;
        // A twist 2κ₁₂ turns bars by κ₁₂ along their length.
        matrices.bending[2][2] += of_bars.torsion / 4.0;
        matrices.shear[0][0] += of_bars.shear;
        let smeared = Box::new(GivenSection::new(matrices, THICK).unwrap());
        let applied = load().into_iter().map(|load| AppliedLoad { load, amplitude: Amplitude::Constant });
        let parts = Parts {
            section: smeared,
            material_axis: Some(X),
            supports: on_edges(&cloud),
            loads: applied.collect(),
            ..parts(cloud, CELL, THICK)
        };
        let smeared = linear_energy(Shell::builder(parts).build().unwrap());
        errors.push(found / smeared - 1.0);
    }
    println!("{errors:?}");
    assert!(errors[2].abs() < 2e-3 && errors[3].abs() < 4e-3, "{errors:?}");
    assert!(errors[0].abs() > 4.0 * errors[1].abs(), "{errors:?}");
}

/// `N b²/π²D` of a square plate under even compression along a bar in its middle, bent in one half wave each way: with `μ = π/a`, `r = √(N/D)`, `α² = μ(r + μ)`,
/// `β² = μ(r − μ)`, c half the width, halves that have no slope on the bar push it by their shear forces \[timoshenko1961, §9.11\]:
///
/// ```text
/// w = β cos βc sinh αy − α cosh αc sin βy      (EIμ⁴ − N(A/h)μ²) w(c) = 2D w‴(c)
/// ```
fn coefficient(gamma: f64, delta: f64) -> f64 {
    let (mu, c) = (PI, 0.5);
    let lack = |k: f64| {
        let load = k * PI * PI;
        let root = load.sqrt();
        let (alpha, beta) = ((mu * (root + mu)).sqrt(), (mu * (root - mu)).sqrt());
        let [sinh, cosh] = [libm::sinh(alpha * c), libm::cosh(alpha * c)];
        let [sin, cos] = [libm::sin(beta * c), libm::cos(beta * c)];
        let bent = beta * cos * sinh - alpha * cosh * sin;
        let pushed = alpha * beta * (alpha * alpha + beta * beta) * cos * cosh;
        (gamma * mu.powi(4) - load * delta * mu * mu) * bent - 2.0 * pushed
    };
    let (mut low, mut high) = (4.0, 15.9);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if lack(low) * lack(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// The closed form has no shear; what cells leave falls with the square of their size.
#[test]
fn a_plate_with_a_bar_along_its_middle_buckles_as_it_should() {
    for (gamma, delta) in [(5.0, 0.05), (5.0, 0.1), (5.0, 0.2)] {
        let exact = coefficient(gamma, delta);
        let mut errors = Vec::new();
        for n in [16, 32] {
            errors.push(buckling(n, gamma, delta) / exact - 1.0);
        }
        println!("γ = {gamma}, δ = {delta}: {exact:.3}, {errors:?}");
        assert!(errors[1].abs() < 1e-2 && errors[1].abs() < errors[0].abs(), "{errors:?}");
    }
}

/// The same of n cells a side, thin.
fn buckling(n: usize, gamma: f64, delta: f64) -> f64 {
    let thickness = 0.002;
    let cloud = flat([n + 1, n + 1], [1.0, 1.0]);
    let bending = YOUNG * thickness * thickness * thickness / (12.0 * (1.0 - POISSON * POISSON));
    let area = delta * thickness;
    let section = BarSection {
        axial: YOUNG * area,
        bending: gamma * bending,
        shear: SHEAR * area,
        torsion: 1e-6 * gamma * bending,
        gyration: gamma * bending / (YOUNG * area),
    };
    let particles = at(&cloud, |x| (x.y - 0.5).abs() < 1e-9);
    let rib = Stiffener { particles, section, height: 0.0, mass: 1.0, in_surface: None };
    // Even stress: on the end of the bar its own share.
    let pressed = |x: f64| {
        let end = at(&cloud, |p| (p.x - x).abs() < 1e-9);
        let share = |&a: &u32| {
            let y = cloud.positions[a as usize].y;
            let line = if (1e-9..=1.0 - 1e-9).contains(&y) { 1.0 } else { 0.5 } / n as f64;
            (a, line + if (y - 0.5).abs() < 1e-9 { delta } else { 0.0 })
        };
        let shares: Vec<(u32, f64)> = end.iter().map(share).collect();
        let total = X * ((1.0 + delta) * bending * PI * PI * (1.0 - 2.0 * x));
        let load: Box<dyn Load> = Box::new(Force { shares, total });
        load
    };
    let loads = [pressed(0.0), pressed(1.0)].map(|load| AppliedLoad { load, amplitude: Amplitude::Constant });
    // Directors along an edge do not turn about its normal: the edge stays straight.
    let held = |director| Held { displacement: vec![Z], director: Some(director) };
    let ends = at(&cloud, |x| x.x.min(1.0 - x.x) < 1e-9);
    let sides = at(&cloud, |x| x.y.min(1.0 - x.y) < 1e-9 && x.x.min(1.0 - x.x) > 1e-9);
    let mut supports = vec![supported(ends, held(Y)), supported(sides, held(X))];
    supports.extend(on_edges(&cloud).into_iter().skip(1));
    let parts = Parts {
        section: isotropic(thickness),
        supports,
        loads: loads.into(),
        ..parts(cloud, CELL, thickness)
    };
    let shell = Shell::builder(parts).stiffeners(vec![rib]).build().unwrap();
    let mut system = StaticShell::new(shell);
    linear_buckling(&mut system, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap().modes[0].level
}
