//! The consistent tangent against differences of the energy, and symmetric by construction.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{Dice, curved, disordered_curved, energy_formulations, flat, scattered_curved, shake, shell};
use implicit_statics::{BalanceError, Equilibrium, Newton, NewtonOptions};
use shell_kinematics::strain_measures;
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, Held, Load, StaticShell, Supported, SymmetryPlane};

/// `vᵀKv` with the lower triangle of the tangent.
fn quadratic(pattern: &[(usize, usize)], values: &[f64], v: &[f64]) -> f64 {
    pattern
        .iter()
        .zip(values)
        .map(|(&(i, j), k)| if i == j { k * v[i] * v[i] } else { 2.0 * k * v[i] * v[j] })
        .sum()
}

#[test]
fn the_tangent_is_the_second_derivative_of_the_energy() {
    for (cloud_name, cloud) in [
        ("flat", flat([7, 6], [2.0, 1.5])),
        ("curved", curved([7, 6])),
        ("disordered", disordered_curved([7, 6])),
        ("scattered", scattered_curved(0.45)),
    ] {
        for (name, formulation) in energy_formulations() {
            for strain in strain_measures() {
                let sides = cloud.sides.clone().unwrap();
                let supports = vec![
                    Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) },
                    Supported {
                        particles: sides.edge(Side::V0).to_vec(),
                        support: Box::new(SymmetryPlane { normal: Vec3::y() }),
                    },
                ];
                let shares = sides.edge(Side::U1).iter().map(|&a| (a, 1.0)).collect();
                let loads: Vec<Box<dyn Load>> =
                    vec![Box::new(Force { shares, total: Vec3::new(1.0, 2.0, 3.0) })];
                let mut body = shell(cloud.clone(), formulation, 0.2, strain, supports, loads);
                shake(&mut body, 0.05, 17);
                let mut system = StaticShell::new(body);
                let n = system.unknowns();
                let pattern = system.pattern();
                let mut values = vec![0.0; pattern.len()];
                // Dead loads have no stiffness: at level 0 the tangent is that of the energy alone.
                system.tangent(0.0, &mut values);
                let mut dice = Dice(3);
                let v: Vec<f64> = (0..n).map(|_| dice.roll()).collect();
                let home = system.save();
                let h = 2e-4;
                let mut at = |factor: f64| {
                    system.restore(&home);
                    let step: Vec<f64> = v.iter().map(|x| factor * h * x).collect();
                    system.update(&step);
                    system.energy()
                };
                let [a, b, c, d, e] = [at(-2.0), at(-1.0), at(0.0), at(1.0), at(2.0)];
                let found = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * h * h);
                let exact = quadratic(&pattern, &values, &v);
                let error = (found / exact - 1.0).abs();
                // Truncation h⁴, round-off 1e-16 U/h² with U of the order of vᵀKv h²·1e3.
                assert!(
                    error < 1e-6,
                    "{name} on {cloud_name}, {}: {found} {exact}: {error:.1e}",
                    strain.name()
                );
            }
        }
    }
}

#[test]
fn forces_along_the_unknowns_are_the_first_derivative() {
    let mut body = common::free_shell(curved([6, 5]), energy_formulations()[0].1, 0.2);
    shake(&mut body, 0.05, 2);
    let mut system = StaticShell::new(body);
    let n = system.unknowns();
    assert_eq!(n, 5 * 30);
    let mut force = vec![0.0; n];
    system.internal(&mut force);
    let mut dice = Dice(8);
    let v: Vec<f64> = (0..n).map(|_| dice.roll()).collect();
    let home = system.save();
    let h = 1e-5;
    let mut at = |factor: f64| {
        system.restore(&home);
        let step: Vec<f64> = v.iter().map(|x| factor * h * x).collect();
        system.update(&step);
        system.energy()
    };
    let found = (at(1.0) - at(-1.0)) / (2.0 * h);
    let exact: f64 = force.iter().zip(&v).map(|(f, v)| f * v).sum();
    assert!((found / exact - 1.0).abs() < 1e-8, "{found} {exact}");
}

/// A flat shell pushed at one corner, under the supports given.
fn pushed(supports: Vec<Supported>) -> StaticShell {
    let force = Force { shares: vec![(0, 1.0)], total: Vec3::z() };
    let cloud = flat([6, 5], [2.0, 1.5]);
    StaticShell::new(shell(
        cloud,
        energy_formulations()[0].1,
        0.2,
        strain_measures()[0],
        supports,
        vec![Box::new(force)],
    ))
}

#[test]
fn a_free_shell_is_a_mechanism_with_a_name() {
    let corner = |displacement: Vec<Vec3>| Supported {
        particles: vec![29],
        support: Box::new(Held { displacement, director: None }),
    };
    // Without support six motions are free; two translations held on a particle leave four.
    for (supports, free) in [(vec![], 6), (vec![corner(vec![Vec3::x(), Vec3::new(1.0, 1.0, 0.0)])], 4)] {
        let mut system = pushed(supports);
        let rest = system.save();
        let mut newton = Newton::new(&system, &NewtonOptions::default()).unwrap();
        let error = newton.at_level(&mut system, 1.0).unwrap_err();
        assert!(matches!(error, BalanceError::Mechanism { zero, .. } if zero == free), "{error}");
        let message = error.to_string();
        for part in ["the structure moves freely, mostly in particle ", "moving along (", "support it"] {
            assert!(message.contains(part), "{message}");
        }
        assert_eq!(system.save(), rest);
    }
}

#[test]
fn directions_that_are_held_are_no_unknowns() {
    let all = |displacement, director| {
        vec![Supported { particles: (0..30).collect(), support: Box::new(Held { displacement, director }) }]
    };
    // Five freedoms a particle; two directions that are not square to each other hold a plane.
    let skew = vec![Vec3::new(3.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0)];
    for (supports, left) in [
        (all(vec![], Some(Vec3::x())), 4),
        (all(skew, None), 3),
        (all(vec![Vec3::x(), Vec3::y(), Vec3::z()], Some(Vec3::y())), 1),
    ] {
        let mut system = pushed(supports);
        assert_eq!(system.unknowns(), 30 * left);
        assert_eq!(system.shell().freedoms(), 30 * left);
        // A motion of the unknowns leaves what is held.
        system.update(&vec![0.01; 30 * left]);
        let (u, d) = (system.shell().displacement(7), system.shell().director(7));
        match left {
            4 => assert!(d.x == 0.0 && d.y != 0.0 && u.norm() > 0.0),
            3 => assert!(u.x.hypot(u.y) < 1e-17 && u.z == 0.01),
            _ => assert!(u.norm() == 0.0 && d.y == 0.0 && d.x != 0.0),
        }
    }
}

#[test]
fn modes_turn_with_the_inertia_of_the_shell_itself() {
    let body = common::free_shell(flat([6, 5], [2.0, 1.5]), energy_formulations()[0].1, 0.2);
    let masses = StaticShell::new(body).masses();
    // Three translations and two turns a particle: ρ t A and ρ t A t²/12, though t is half a spacing.
    for particle in masses.chunks_exact(5) {
        assert!(particle[..3].iter().all(|m| *m == particle[0]));
        assert!(particle[3..].iter().all(|i| (i / (particle[0] * 0.04 / 12.0) - 1.0).abs() < 1e-14));
    }
}
