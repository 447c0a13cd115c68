//! Material axes and layered sections: isotropic shells do not see the axes, laminated ones keep every invariant.

use std::f64::consts::FRAC_PI_3;

use crate::common::{
    AXIS, RandomNumbers, curved, disordered_curved, disordered_flat, energy, energy_formulations, flat,
    laminated, parts, shake, unsymmetric,
};
use explicit_dynamics::largest_eigenvalue;
use implicit_statics::Equilibrium;
use nalgebra::Rotation3;
use shell_kinematics::{LayeredSection, Orthotropic, Ply, Section, Strains};
use sph_core::{Cloud, CubicSpline, SpaceError, Vec3};
use sph_shell::{Divergence, Formulation, Parts, Reach, Shell, ShellError, StaticShell};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn clouds() -> [(&'static str, Cloud); 3] {
    [
        ("flat", flat([6, 5], [2.0, 1.5])),
        ("curved", curved([7, 6])),
        ("disordered", disordered_curved([7, 6])),
    ]
}

fn forces(shell: &mut Shell) -> Vec<[f64; 6]> {
    shell.evaluate_internal(false);
    (0..shell.len()).map(|a| shell.internal_force(a)).collect()
}

fn greatest(forces: &[[f64; 6]]) -> f64 {
    forces.iter().flatten().fold(0.0, |m: f64, f| m.max(f.abs()))
}

fn worst(f: &[[f64; 6]], g: &[[f64; 6]]) -> f64 {
    f.iter().flatten().zip(g.iter().flatten()).fold(0.0, |worst: f64, (f, g)| worst.max((f - g).abs()))
}

fn each_case(mut check: impl FnMut(&str, Cloud, Formulation)) {
    for (cloud_name, cloud) in clouds() {
        for (name, formulation) in energy_formulations() {
            check(&format!("{name} on a {cloud_name} cloud"), cloud.clone(), formulation);
        }
    }
}

#[test]
fn isotropic_shells_do_not_see_the_axes() {
    let strong = Formulation::StrongForm {
        smoothing: 1.2,
        viscosity: 0.1,
        divergence: Divergence::Sum,
        kernel: &CubicSpline,
    };
    let mut formulations = energy_formulations();
    formulations.push(("strong form", strong));
    for (cloud_name, cloud) in clouds() {
        for &(name, formulation) in &formulations {
            let built = |axis| {
                let mut shell =
                    Shell::builder(Parts { material_axis: axis, ..parts(cloud.clone(), formulation, 0.2) })
                        .build()
                        .unwrap();
                shake(&mut shell, 0.1, 4);
                let mut dice = RandomNumbers(6);
                for a in 0..shell.len() {
                    shell.set_rate(a, dice.vector(), dice.vector());
                }
                forces(&mut shell)
            };
            let (free, aligned) = (built(None), built(Some(AXIS)));
            // Round-off of some hundred products of either sign.
            let error = worst(&free, &aligned) / greatest(&free);
            assert!(error < 1e-12, "{name} on a {cloud_name} cloud: {error:.1e}");
        }
    }
}

#[test]
fn force_is_the_derivative_of_the_energy() {
    each_case(|name, cloud, formulation| {
        let mut body = laminated(cloud, formulation, AXIS);
        shake(&mut body, 0.08, 11);
        let mut system = StaticShell::new(body);
        let n = system.unknowns();
        let mut force = vec![0.0; n];
        system.internal(0.0, &mut force);
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(0.0, &mut values);
        let mut dice = RandomNumbers(8);
        let v: Vec<f64> = (0..n).map(|_| dice.roll()).collect();
        let home = system.save();
        let mut at = |size: f64| {
            system.restore(&home);
            let step: Vec<f64> = v.iter().map(|x| size * x).collect();
            system.update(&step);
            system.energy()
        };
        let h = 1e-5;
        let slope = (at(h) - at(-h)) / (2.0 * h);
        let exact: f64 = force.iter().zip(&v).map(|(f, v)| f * v).sum();
        // Truncation 1e-10, round-off of the energy 1e-16/1e-5.
        assert!((slope / exact - 1.0).abs() < 1e-6, "{name}: {slope} {exact}");
        let h = 2e-4;
        let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|factor| at(factor * h));
        let bend = (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * h * h);
        let exact: f64 = pattern
            .iter()
            .zip(&values)
            .map(|(&(i, j), k)| if i == j { k * v[i] * v[i] } else { 2.0 * k * v[i] * v[j] })
            .sum();
        // Truncation h⁴, round-off 1e-16 U/h² with U of the order of vᵀKv h²·1e3.
        assert!((bend / exact - 1.0).abs() < 1e-6, "{name}: {bend} {exact}");
    });
}

#[test]
fn forces_and_moments_cancel() {
    each_case(|name, cloud, formulation| {
        let mut body = laminated(cloud, formulation, AXIS);
        shake(&mut body, 0.2, 3);
        let forces = forces(&mut body);
        let (mut force, mut moment) = (Vec3::zeros(), Vec3::zeros());
        for (a, f) in forces.iter().enumerate() {
            let (fx, fd) = (Vec3::new(f[0], f[1], f[2]), Vec3::new(f[3], f[4], f[5]));
            force += fx;
            moment += body.position(a).cross(&fx) + body.director(a).cross(&fd);
        }
        // Round-off of some tens of forces of either sign.
        let scale = greatest(&forces);
        assert!(force.norm() < 1e-12 * scale, "{name}: net force {:.1e}", force.norm() / scale);
        assert!(moment.norm() < 1e-11 * scale, "{name}: net moment {:.1e}", moment.norm() / scale);
    });
}

#[test]
fn rotated_clouds_with_rotated_axes_give_rotated_forces() {
    let rotation = Rotation3::from_scaled_axis(Vec3::new(0.3, 2.0, -1.0));
    for (name, cloud) in clouds() {
        let mut rotated = laminated(cloud.transformed(&rotation, &Vec3::zeros()), CELL, rotation * AXIS);
        let mut body = laminated(cloud, CELL, AXIS);
        shake(&mut body, 0.1, 21);
        for a in 0..body.len() {
            rotated.set_state(a, rotation * body.position(a), rotation * body.director(a));
        }
        let f: Vec<[f64; 6]> = forces(&mut body)
            .iter()
            .map(|f| {
                let [x, d] = [rotation * Vec3::new(f[0], f[1], f[2]), rotation * Vec3::new(f[3], f[4], f[5])];
                [x.x, x.y, x.z, d.x, d.y, d.z]
            })
            .collect();
        let error = worst(&f, &forces(&mut rotated)) / greatest(&f);
        assert!(error < 1e-12, "{name}: {error:.1e}");
    }
}

#[test]
fn plies_count_from_the_axis() {
    // The axis rotated by an angle about the normal, or every ply rotated by it.
    let build = |axis, turn| {
        let section = Box::new(unsymmetric(turn));
        let cloud = disordered_flat([6, 5], [2.0, 1.5]);
        let mut shell =
            Shell::builder(Parts { section, material_axis: Some(axis), ..parts(cloud, CELL, 0.2) })
                .build()
                .unwrap();
        shake(&mut shell, 0.1, 5);
        forces(&mut shell)
    };
    let (sin, cos) = libm::sincos(FRAC_PI_3);
    let (axis, plies) = (build(Vec3::new(cos, sin, 0.0), 0.0), build(Vec3::x(), FRAC_PI_3));
    assert!(worst(&axis, &plies) < 1e-12 * greatest(&axis));
    let unrotated = build(Vec3::x(), 0.0);
    assert!(worst(&axis, &unrotated) > 1e-3 * greatest(&axis));
}

#[test]
fn a_uniform_stretch_stores_what_the_section_says() {
    let section = unsymmetric(0.0);
    let area = 2.0 * 1.5;
    // Stretch e along y, the axis: Green–Lagrange strain e + e²/2 in the first component.
    let e: f64 = 1e-3;
    let mut strains = Strains::default();
    strains.membrane[0] = shell_kinematics::Pack::splat(e + 0.5 * e * e);
    let expected = area * section.energy(&strains).lanes()[0];
    for (name, formulation) in energy_formulations() {
        for cloud in [flat([7, 6], [2.0, 1.5]), disordered_flat([7, 6], [2.0, 1.5])] {
            let mut body = laminated(cloud, formulation, Vec3::y());
            for a in 0..body.len() {
                let x = body.position(a);
                body.set_state(a, Vec3::new(x.x, x.y * (1.0 + e), x.z), Vec3::z());
            }
            // Gradients exact on linear fields to 1e-12; the strain is a thousandth of them.
            assert!((energy(&mut body) / expected - 1.0).abs() < 1e-8, "{name}");
        }
    }
}

#[test]
fn the_stable_step_is_that_of_the_fastest_wave() {
    // One direction of fibres, along the lattice and across it: Δt c/Δ as for one isotropic material (tests/march.rs).
    let fibre = Orthotropic::new(12000.0, 600.0, 0.25, 400.0, 400.0).unwrap();
    let plies = [Ply { material: fibre, thickness: 0.01, angle: 0.0 }];
    for degrees in [0.0_f64, 30.0, 45.0] {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let section = Box::new(LayeredSection::new(&plies).unwrap());
        let material_axis = Some(Vec3::new(cos, sin, 0.0));
        let made = parts(flat([11, 11], [1.0, 1.0]), CELL, 0.01);
        let mut body = Shell::builder(Parts { section, material_axis, ..made }).build().unwrap();
        let spectrum = largest_eigenvalue(&mut body, 40);
        let scaled = 2.0 / spectrum.bound().sqrt() * body.reference().sound_speed / 0.1;
        println!("{degrees}°: {scaled:.3}");
        assert!(scaled > 0.9, "{degrees}°: {scaled}");
    }
}

#[test]
fn an_axis_that_stands_on_the_shell_is_refused() {
    let section = Box::new(unsymmetric(0.0));
    let parts =
        Parts { section, material_axis: Some(Vec3::z()), ..parts(flat([5, 5], [1.0, 1.0]), CELL, 0.2) };
    let error = Shell::builder(parts).build().err().unwrap();
    assert!(matches!(error, ShellError::Space(SpaceError::AxisNormal { .. })), "{error}");
}
