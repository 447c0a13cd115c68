//! Thin-walled sections and stiffened plates: torsion in closed form, distortion and deflections against fine shells of elements.

use crate::common::{Sheets, X, Y, Z, at, parts};
use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use shell_kinematics::{Isotropic, IsotropicSection};
use sph_core::{Cloud, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Held, Load, Parts, Reach, Shell, StaticShell, Supported,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// The linear answer: `f·u`, and the displacements of all particles.
fn linear(
    cloud: Cloud,
    [young, poisson, thickness]: [f64; 3],
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> (f64, Vec<Vec3>) {
    let section = IsotropicSection::new(Isotropic::new(young, poisson).unwrap(), thickness).unwrap();
    let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let loads = loads.into_iter().map(applied).collect();
    let body = Parts { section: Box::new(section), supports, loads, ..parts(cloud, CELL, thickness) };
    let mut system = StaticShell::new(Shell::builder(body).build().unwrap());
    let mut load = vec![0.0; system.unknowns()];
    system.load_rate(0.0, &mut load);
    let u = linear_response(&mut system, 0.0).unwrap();
    let work = load.iter().zip(&u).map(|(f, u)| f * u).sum();
    const SMALL: f64 = 1e-7;
    system.update(&u.iter().map(|u| u * SMALL).collect::<Vec<f64>>());
    let moved = (0..system.shell().len()).map(|a| system.shell().displacement(a) / SMALL).collect();
    (work, moved)
}

fn on(particles: Vec<u32>, support: impl sph_shell::Support + 'static) -> Supported {
    Supported { particles, support: Box::new(support) }
}

/// A box of section one by one about the y axis, five long, n cells a side.
fn tube(n: usize) -> Cloud {
    let wall = |sheets: Sheets, origin: Vec3, across: Vec3| sheets.add(origin, [across, Y * 5.0], [n, 5 * n]);
    let corner = -(X + Z) * 0.5;
    let sheets = wall(wall(Sheets::default(), corner, X), corner + Z, X);
    wall(wall(sheets, corner, Z), corner + X, Z).cloud()
}

/// Forces on the particles of a wall at the free end of a box, by their share of its edge.
fn along_edge(cloud: &Cloud, wall: impl Fn(&Vec3) -> bool, n: usize, direction: Vec3) -> Box<dyn Load> {
    let end = at(cloud, |x| x.y > 5.0 - 1e-9 && wall(x));
    let corner = |x: &Vec3| x.x.abs() > 0.5 - 1e-9 && x.z.abs() > 0.5 - 1e-9;
    let mut shares = Vec::new();
    for a in end {
        let place = &cloud.positions[a as usize];
        // Two sheets stand at a corner: each time it comes a quarter of a cell.
        shares.push((a, if corner(place) { 0.25 } else { 1.0 } / n as f64));
    }
    Box::new(Force { shares, total: direction })
}

const MILD: [f64; 3] = [1e6, 0.3, 0.05];

#[test]
fn a_box_twists_as_st_venant_says() {
    let [young, poisson, t] = MILD;
    let exact = 5.0 / (young / (2.0 * (1.0 + poisson)) * (t + 4.0 * t.powi(3) / 3.0));
    for n in [2, 4, 8] {
        let cloud = tube(n);
        // A quarter of the torque in each wall, half a width off the axis; the foot is held in its plane alone.
        let walls = [(Z, X), (X, -Z), (-Z, -X), (-X, Z)];
        let loads = walls
            .map(|(out, direction)| along_edge(&cloud, |x| x.dot(&out) > 0.5 - 1e-9, n, direction * 0.5));
        let foot = at(&cloud, |x| x.y < 1e-9);
        // Three corners keep the foot in its plane; a square box does not warp.
        let corners =
            at(&cloud, |x| x.y < 1e-9 && x.x.abs() > 0.5 - 1e-9 && x.z.abs() > 0.5 - 1e-9 && x.x + x.z < 0.5);
        let held = |displacement| Held { displacement, director: None };
        let supports = vec![on(foot, held(vec![X, Z])), on(corners, held(vec![Y]))];
        let (work, _) = linear(cloud, MILD, supports, loads.into());
        let error = work / exact - 1.0;
        println!("torsion, {n} cells a side: {:.4} %", 100.0 * error);
        assert!(error.abs() < 6e-4, "{n}: {error:.2e}");
    }
}

#[test]
fn a_box_is_distorted_as_elements_say() {
    for (n, bound) in [(4, 3e-2), (8, 7e-3), (16, 2e-3)] {
        let cloud = tube(n);
        let loads = vec![
            along_edge(&cloud, |x| x.x > 0.5 - 1e-9, n, -Z),
            along_edge(&cloud, |x| x.x < -0.5 + 1e-9, n, Z),
        ];
        let foot = at(&cloud, |x| x.y < 1e-9);
        let (work, _) = linear(cloud, MILD, vec![on(foot, Clamped)], loads);
        println!("distortion, {n} cells a side: {work:.4e}, {:.3} %", 100.0 * (work / 1.786e-3 - 1.0));
        assert!((work / 1.786e-3 - 1.0).abs() < bound, "{n}: {work:.4e}");
    }
}

/// A square plate on a rib along its middle, with a flange or without, n cells a side and m down the rib.
fn stiffened(n: usize, m: usize, flange: bool) -> Cloud {
    let mut sheets = Sheets::default().add(Vec3::zeros(), [X, Y], [n, n]).add(Y * 0.5, [X, -Z * 0.1], [n, m]);
    if flange {
        sheets = sheets.add(Y * 0.47 - Z * 0.1, [X, Y * 0.06], [n, 4]);
    }
    sheets.cloud()
}

#[test]
fn stiffened_plates_bend_as_elements_say() {
    for (flange, [centre, quarter]) in [(false, [1.488e-4, 2.638e-4]), (true, [7.018e-5, 2.130e-4])] {
        for (n, m, bound) in [(16, 4, 2.6e-2), (32, 8, 6e-3)] {
            let cloud = stiffened(n, m, flange);
            let edge = at(&cloud, |x| x.z.abs() < 1e-9 && (x.x.min(x.y) < 1e-9 || x.x.max(x.y) > 1.0 - 1e-9));
            let place = |x: f64, y: f64| at(&cloud, |p| (p - X * x - Y * y).norm() < 1e-9)[0];
            let (middle, aside) = (place(0.5, 0.5), place(0.5, 0.25));
            let held = |displacement| Held { displacement, director: None };
            let supports = vec![
                on(edge, held(vec![Z])),
                on(vec![place(0.0, 0.0)], held(vec![X, Y])),
                on(vec![place(1.0, 0.0)], held(vec![Y])),
            ];
            let plate: Vec<bool> = cloud.positions.iter().map(|x| x.z.abs() < 1e-9).collect();
            let own = |a: &u32| plate[*a as usize];
            let force = cloud.cells.iter().filter(|cell| cell.particles().iter().all(own));
            let mut shares = vec![0.0; cloud.len()];
            for cell in force {
                cell.particles().iter().for_each(|&a| shares[a as usize] += 0.25 / (n * n) as f64);
            }
            let shares = (0..).zip(shares).filter(|share| share.1 > 0.0).collect();
            let load = Force { shares, total: -Z * 1e4 };
            let (_, moved) = linear(cloud, [2e11, 0.3, 0.01], supports, vec![Box::new(load)]);
            let found = [middle, aside].map(|a| -moved[a as usize].z);
            let errors = [found[0] / centre - 1.0, found[1] / quarter - 1.0];
            println!(
                "flange {flange}, {n}×{m}: {found:?} {:.2} {:.2} %",
                100.0 * errors[0],
                100.0 * errors[1]
            );
            assert!(errors.iter().all(|error| error.abs() < bound), "{flange} {n}: {errors:?}");
        }
    }
}
