//! The consistent tangent against differences of the energy, and symmetric by construction.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{Dice, curved, disordered_curved, energy_formulations, flat, scattered_curved, shake, shell};
use implicit_statics::Equilibrium;
use shell_kinematics::strain_measures;
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, Load, StaticShell, Supported, SymmetryPlane};

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
