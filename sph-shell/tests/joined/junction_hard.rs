//! Hard junctions: many sheets on one line, flat and folded-back ones, disorder and slivers beside it, free and turned far.

use crate::common::{
    RandomNumbers, Sheets, X, Y, YOUNG, Z, at, beam_parts, free_shell, line, linear_energy, spectrum,
    supported,
};
use implicit_statics::{Newton, NewtonOptions};
use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, CoupleAxis, EdgeCouple, Force, Formulation, Held, Reach, Shell, StaticShell};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const WIDE: f64 = 0.3;

/// Legs of length one from the line x = z = 0 at angles \[°\], n cells each, wide along y.
fn star(degrees: &[f64], n: usize, across: usize) -> Cloud {
    let leg = |sheets: Sheets, degrees: &f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        sheets.add(Vec3::zeros(), [X * cos + Z * sin, Y * WIDE], [n, across])
    };
    degrees.iter().fold(Sheets::default(), leg).cloud()
}

/// Angles at which sheets leave one line: evenly, all but flat, folded back to five degrees.
const STARS: [(&str, &[f64]); 5] = [
    ("six", &[0.0, 60.0, 120.0, 180.0, 240.0, 300.0]),
    ("six, unevenly", &[0.0, 5.0, 35.0, 100.0, 175.0, 290.0]),
    ("two at 5° between them", &[0.0, 5.0]),
    ("two at 30° between them", &[0.0, 30.0]),
    ("two at 175° between them", &[0.0, 175.0]),
];

/// Moves particles in the plane of their sheet at random by parts of a spacing, those on the line along it, all sheets alike; edges
/// stay.
fn disordered(cloud: &Cloud, reach: f64, n: usize, across: usize, seed: u64) -> Cloud {
    let mut moved = cloud.clone();
    let mut dice = RandomNumbers(seed);
    let (along, aside) = (reach / n as f64, reach * WIDE / across as f64);
    let row: Vec<f64> = (0..=across).map(|_| aside * dice.roll()).collect();
    for (a, x) in moved.positions.iter_mut().enumerate() {
        let out = Vec3::new(x.x, 0.0, x.z);
        let free = x.y > 1e-9 && x.y < WIDE - 1e-9;
        if out.norm() < 1e-9 {
            x.y += if free { row[a % (across + 1)] } else { 0.0 };
        } else if out.norm() < 1.0 - 1e-9 {
            let shift = out.normalize() * (along * dice.roll());
            *x += shift + Y * if free { aside * dice.roll() } else { 0.0 };
        }
    }
    let normals = moved.frames.iter().map(|frame| frame.n).collect();
    Cloud::from_sheets(moved.positions, Some(normals), moved.cells, moved.joined).unwrap()
}

/// Work of a couple on the joint of legs clamped at their ends, over that of beams: `M²/Σk`, `k = EI (4 + Φ)/L(1 + Φ)`.
fn turned_joint(cloud: Cloud, legs: usize) -> f64 {
    let thickness = 0.01_f64;
    let joint = at(&cloud, |x| libm::hypot(x.x, x.z) < 1e-9);
    let supports = vec![
        supported(at(&cloud, |x| libm::hypot(x.x, x.z) > 1.0 - 1e-9), Clamped),
        supported(joint.clone(), Held { displacement: vec![X, Z], director: None }),
    ];
    let firsts: Vec<u32> = cloud.joined.iter().map(|group| group[0]).collect();
    let mut edge = line(&cloud, &firsts);
    edge.sort_by(|a, b| cloud.positions[a.0 as usize].y.total_cmp(&cloud.positions[b.0 as usize].y));
    let couple = EdgeCouple { edge, moment: 1.0, axis: CoupleAxis::Fixed(Y) };
    let ei = YOUNG * thickness.powi(3) * WIDE / 12.0;
    let phi = 12.0 * ei / (5.0 / 12.0 * YOUNG * thickness * WIDE);
    let stiffness = legs as f64 * ei * (4.0 + phi) / (1.0 + phi);
    let body =
        Shell::builder(beam_parts(cloud, thickness, supports, vec![Box::new(couple)])).build().unwrap();
    2.0 * linear_energy(body) * stiffness
}

#[test]
fn stars_of_sheets_turn_as_beams_say() {
    for (name, degrees) in STARS {
        // One point a cell sees a moment that runs from −½ to 1 by the midpoint: second order, 3/4n² of the energy.
        for (n, bound) in [(5, 4e-2), (10, 1e-2), (20, 2.5e-3)] {
            let error = turned_joint(star(degrees, n, 2), degrees.len()) - 1.0;
            println!("{name}, {n} cells: {:.3} %", 100.0 * error);
            assert!(error.abs() < bound, "{name} {n}: {error}");
        }
    }
}

#[test]
fn free_stars_have_exactly_six_zero_modes() {
    for (name, degrees) in STARS {
        for thickness in [0.1, 0.01] {
            let values = spectrum(free_shell(star(degrees, 4, 2), CELL, thickness));
            println!("{name}, t = {thickness}: {:.1e} | {:.3e}", values[5].abs(), values[6]);
            assert!(values[6] > 1e3 * values[5].abs() && values[6] > 0.0, "{name}: {:?}", &values[..8]);
        }
    }
}

/// Disorder along and beside the line costs what it costs on a sheet without a line: the same with both halves in one plane.
#[test]
fn disorder_beside_a_junction_costs_what_it_does_elsewhere() {
    for (reach, bound) in [(0.25, 4e-3), (0.4, 1e-2)] {
        for (name, degrees) in STARS {
            let (n, across) = (10, 4);
            let even = turned_joint(star(degrees, n, across), degrees.len());
            let error =
                turned_joint(disordered(&star(degrees, n, across), reach, n, across, 5), degrees.len())
                    / even
                    - 1.0;
            println!("{name}, moved by {reach}: {:.3} %", 100.0 * error);
            assert!(error.abs() < bound, "{name}: {error}");
        }
    }
}

/// A cell at the line is drawn out to a sliver: its first corner beyond the line is moved along it, to about ten degrees.
#[test]
fn a_sliver_at_a_junction_changes_little() {
    let (n, across) = (10, 3);
    for (name, degrees) in STARS {
        let cloud = star(degrees, n, across);
        let even = turned_joint(cloud.clone(), degrees.len());
        let mut positions = cloud.positions.clone();
        // Particle (1, 1) of the first leg: beside the line, inside.
        let place = &mut positions[across + 2];
        place.x = 0.02;
        let normals = cloud.frames.iter().map(|frame| frame.n).collect();
        let sharp =
            Cloud::from_sheets(positions, Some(normals), cloud.cells.clone(), cloud.joined.clone()).unwrap();
        let error = turned_joint(sharp.clone(), degrees.len()) / even - 1.0;
        let values = spectrum(free_shell(star(degrees, 4, 2), CELL, 0.02));
        println!("{name}: {:.3} %, {:.1e} | {:.1e}", 100.0 * error, values[5], values[6]);
        assert!(error.abs() < 1e-2, "{name}: {error}");
    }
}

/// Six legs, one clamped, a force on the opposite one that turns the joint by more than 40°: the angles between all stay.
#[test]
fn a_star_turned_far_keeps_its_angles_and_newton_its_pace() {
    let degrees = STARS[1].1;
    let cloud = star(degrees, 6, 2);
    let tip = at(&cloud, |x| libm::hypot(x.x + 1.0, x.z) < 0.2 && libm::hypot(x.x, x.z) > 1.0 - 1e-9);
    let force = Force { shares: line(&cloud, &tip), total: Z * 2.5e-4 + Y * 0.5e-4 };
    let clamp = supported(at(&cloud, |x| (x.x - 1.0).abs() < 1e-9 && x.z.abs() < 1e-9), Clamped);
    let body =
        Shell::builder(beam_parts(cloud.clone(), 0.02, vec![clamp], vec![Box::new(force)])).build().unwrap();
    let mut system = StaticShell::new(body);
    let options = NewtonOptions { tolerance: 1e-10, line_search: false, keep: 0.0, ..Default::default() };
    let mut newton = Newton::new(&system, &options).unwrap();
    for step in 1..=10 {
        let residuals = newton.at_level(&mut system, f64::from(step) / 10.0).unwrap().residuals;
        assert!(residuals.len() < 12, "{residuals:?}");
    }
    let shell = system.shell();
    let group = &cloud.joined[0];
    let now = |k: usize| shell.director(group[k] as usize);
    let rest = |k: usize| cloud.frames[group[k] as usize].n;
    let off =
        (1..group.len()).map(|k| (now(0).dot(&now(k)) - rest(0).dot(&rest(k))).abs()).fold(0.0, f64::max);
    let turn = now(0).angle(&rest(0)).to_degrees();
    println!("turned by {turn:.0}°, angles off by {off:.1e}");
    assert!(turn > 40.0 && off < 1e-12, "{turn} {off:.1e}");
}
