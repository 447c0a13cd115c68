//! Vibration and buckling of plates and membranes under initial stress, against closed forms.

use std::f64::consts::PI;

use crate::common::{
    self, DENSITY, POISSON, X, Y, YOUNG, Z, beam_parts, flat, parts, scattered_flat, supported,
};
use implicit_statics::{BucklingOptions, EquilibriumError, linear_buckling, natural_modes, unwatched};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{Force, Formulation, Held, InitialStress, Load, Parts, Reach, Shell, StaticShell, Supported};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn everywhere(cloud: &Cloud, membrane: [f64; 3]) -> InitialStress {
    let cells = (0..cloud.cells.len() as u32).collect();
    InitialStress { cells, axis: Some(X), membrane, bending: [0.0; 3] }
}

/// Edges of a plate that turn about themselves and do not move.
fn hinged(cloud: &Cloud, [a, b]: [f64; 2]) -> Vec<Supported> {
    let on = |inside: &dyn Fn(&Vec3) -> bool| common::at(cloud, |x| inside(x));
    let (ends, sides) =
        (on(&|x| x.x.min(a - x.x) < 1e-9), on(&|x| x.y.min(b - x.y) < 1e-9 && x.x.min(a - x.x) > 1e-9));
    let held = |director| Held { displacement: vec![X, Y, Z], director: Some(director) };
    // The director stays in the plane across the edge.
    vec![supported(ends, held(Y)), supported(sides, held(X))]
}

/// Squares of the lowest frequencies of a plate 10 × 8 with hinged edges under a stress resultant.
fn squares(cloud: &Cloud, thickness: f64, [n11, n22]: [f64; 2], count: usize) -> Vec<f64> {
    let supports = hinged(cloud, [10.0, 8.0]);
    let shell = Shell::builder(Parts { supports, ..parts(cloud.clone(), CELL, thickness) });
    let shell =
        shell.stresses(vec![everywhere(cloud, [n11 / thickness, n22 / thickness, 0.0])]).build().unwrap();
    let mut system = StaticShell::new(shell);
    assert!(system.unbalanced_stress() < 1e-14);
    let modes = natural_modes(&mut system, 0.0, count, 0.0, &mut unwatched).unwrap().modes;
    modes.iter().map(|mode| mode.eigenvalue).collect()
}

/// `(D k⁴ + N₁ k₁² + N₂ k₂²)/ρt` of m and n half waves.
fn exact(thickness: f64, [n11, n22]: [f64; 2], [m, n]: [f64; 2]) -> f64 {
    let bending = YOUNG * thickness.powi(3) / (12.0 * (1.0 - POISSON * POISSON));
    let (k1, k2) = ((m * PI / 10.0).powi(2), (n * PI / 8.0).powi(2));
    (bending * (k1 + k2).powi(2) + n11 * k1 + n22 * k2) / (DENSITY * thickness)
}

#[test]
fn a_plate_in_tension_sings_higher_and_pressed_lower() {
    let thickness = 0.1;
    let bending = YOUNG * thickness * thickness * thickness / (12.0 * (1.0 - POISSON * POISSON));
    let k = (PI / 10.0_f64).powi(2) + (PI / 8.0_f64).powi(2);
    let mut errors = Vec::new();
    for cells in [10, 20, 40] {
        let cloud = flat([cells + 1, cells + 1], [10.0, 8.0]);
        let mut worst = 0.0_f64;
        for ratio in [-0.5, 1.0, 10.0] {
            let force = [ratio * bending * k, 0.5 * ratio * bending * k];
            let found = squares(&cloud, thickness, force, 1)[0];
            let off = found / exact(thickness, force, [1.0, 1.0]) - 1.0;
            println!("{cells} cells, N = {ratio} D k²: {:.4} %", 100.0 * off);
            worst = worst.max(off.abs());
        }
        errors.push(worst);
    }
    println!("{errors:?}");
    assert!(errors[2] < 3e-3 && errors[0] > 3.0 * errors[1] && errors[1] > 3.0 * errors[2], "{errors:?}");
}

/// Of a membrane so thin that bending is nothing to its tension the lowest modes are those of the wave equation, in order. The pattern
/// of a cell has no gradient in its middle, and tension does not hold it: with 24 cells along the sheet the eighth mode is one of patterns, with 48
/// cells none of the first twenty is. On uneven cells patterns are softer yet.
#[test]
fn a_thin_membrane_has_the_modes_of_a_membrane() {
    let thickness = 1e-3;
    for (name, cloud, stretch, count) in [
        ("24 cells", flat([25, 21], [10.0, 8.0]), 1e-3, 7),
        ("48 cells", flat([49, 41], [10.0, 8.0]), 1e-3, 20),
        ("scattered", scattered_flat(0.25, [10.0, 8.0]), 1e-4, 8),
    ] {
        let force = [YOUNG * thickness * stretch, 2.0 * YOUNG * thickness * stretch];
        let all = (1..12).flat_map(|m| (1..12).map(move |n| [m.into(), n.into()]));
        let mut waves: Vec<f64> = all.map(|waves| exact(thickness, force, waves)).collect();
        waves.sort_by(f64::total_cmp);
        let found = squares(&cloud, thickness, force, count + 1);
        let off: Vec<f64> = found.iter().zip(&waves).map(|(f, w)| f / w - 1.0).collect();
        println!("{name}: {off:.4?}");
        assert!(off[..count].iter().all(|off| off.abs() < 0.06), "{name}: {off:?}");
        assert!(count > 7 || off[count] < -0.1, "{name}: {off:?}");
    }
}

/// The square of the frequency runs straight to zero where the stress reaches the load at which the plate buckles.
#[test]
fn a_plate_buckles_where_its_stress_reaches_the_critical_one() {
    let thickness = 0.1;
    let bending = YOUNG * thickness * thickness * thickness / (12.0 * (1.0 - POISSON * POISSON));
    // Equal in both directions: N_cr = D k².
    let critical = bending * ((PI / 10.0_f64).powi(2) + (PI / 8.0_f64).powi(2));
    let cloud = flat([21, 17], [10.0, 8.0]);
    let pressed = |part: f64| squares(&cloud, thickness, [-part * critical, -part * critical], 1)[0];
    let [none, half] = [pressed(0.0), pressed(0.5)];
    let reached = 0.5 * none / (none - half);
    println!("buckles at {reached} of the closed form");
    assert!((reached - 1.0).abs() < 5e-3, "{reached}");
    // On both sides of it: stable, and one direction that is not.
    let negative = |part: f64| {
        let supports = hinged(&cloud, [10.0, 8.0]);
        let shell = Shell::builder(Parts { supports, ..parts(cloud.clone(), CELL, thickness) });
        let stress = -part * reached * critical / thickness;
        let shell = shell.stresses(vec![everywhere(&cloud, [stress, stress, 0.0])]).build().unwrap();
        let found =
            linear_buckling(&mut StaticShell::new(shell), 0.0, &BucklingOptions::new(1), &mut unwatched);
        match found {
            Err(EquilibriumError::Unstable { negative, .. }) => negative,
            _ => 0,
        }
    };
    assert_eq!([negative(0.999), negative(1.001)], [0, 1]);
}

/// A plate that is pressed along x buckles later by its tension across: `λ = [D (k₁ + k₂)² + N₂ k₂]/k₁`, of the least m.
#[test]
fn tension_across_delays_buckling() {
    let thickness = 0.1_f64;
    let cloud = flat([33, 17], [16.0, 8.0]);
    let bending = YOUNG * thickness.powi(3) / 12.0;
    let sides = cloud.sides.clone().unwrap();
    let level = |tension: f64| {
        let held = |directions: &[Vec3], director| Held {
            displacement: directions.to_vec(),
            director: Some(director),
        };
        let ends = |side: Side| [sides.edge(side)[0], *sides.edge(side).last().unwrap()];
        let corners: Vec<u32> = [Side::U0, Side::U1].into_iter().flat_map(ends).collect();
        let inner = |side: Side| -> Vec<u32> {
            let edge = sides.edge(side);
            edge[1..edge.len() - 1].to_vec()
        };
        let supports = vec![
            supported(sides.edge(Side::U0).to_vec(), held(&[X, Z], Y)),
            supported(sides.edge(Side::U1).to_vec(), held(&[Z], Y)),
            supported(corners.clone(), Held { displacement: vec![Y], director: None }),
            supported(inner(Side::V0), held(&[Y, Z], X)),
            supported(inner(Side::V1), held(&[Y, Z], X)),
        ];
        let edge = sides.edge(Side::U1);
        let last = edge.len() - 1;
        let shares =
            edge.iter().enumerate().map(|(i, &a)| (a, if i == 0 || i == last { 0.5 } else { 1.0 })).collect();
        let load: Box<dyn Load> = Box::new(Force { shares, total: -8.0 * X });
        let shell = Shell::builder(beam_parts(cloud.clone(), thickness, supports, vec![load]));
        let shell =
            shell.stresses(vec![everywhere(&cloud, [0.0, tension / thickness, 0.0])]).build().unwrap();
        let mut system = StaticShell::new(shell);
        assert!(system.unbalanced_stress() < 1e-14);
        linear_buckling(&mut system, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap().modes[0].level
    };
    let exact = |tension: f64| {
        let k2 = (PI / 8.0).powi(2);
        let of = |m: f64| {
            let k1 = (m * PI / 16.0).powi(2);
            (bending * (k1 + k2).powi(2) + tension * k2) / k1
        };
        (1..9).map(|m| of(f64::from(m))).fold(f64::INFINITY, f64::min)
    };
    let across = bending * (PI / 8.0_f64).powi(2);
    for ratio in [0.0, 1.0, 5.0, -0.5] {
        let (found, exact) = (level(ratio * across), exact(ratio * across));
        println!("{ratio}: {found} {exact} {:.3} %", 100.0 * (found / exact - 1.0));
        assert!((found / exact - 1.0).abs() < 0.02, "{ratio}: {found} {exact}");
    }
}
