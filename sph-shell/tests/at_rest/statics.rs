//! The consistent tangent against differences of the energy, and symmetric by construction.

use crate::common::{
    self, RandomNumbers, curved, derivatives_agree, disordered_curved, energy_formulations, flat,
    scattered_curved, shake, shake_unknowns, shell,
};
use implicit_statics::{Equilibrium, EquilibriumError, Newton, NewtonOptions};
use shell_kinematics::{Isotropic, IsotropicSection, strain_measures};
use sph_core::{Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Held, Load, Parts, Shell, StaticShell, Supported, SymmetryPlane,
};

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
                // These motions turn some of the wide stencils of scattered particles inside out, which has no logarithm.
                if strain.name() == "logarithmic" && cloud_name == "scattered" && !name.contains("cell") {
                    continue;
                }
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
                let body = shell(cloud.clone(), formulation, 0.2, strain, supports, loads);
                let mut system = StaticShell::new(body);
                // Along the unknowns, so that directors stay in planes of symmetry; twice, so that forces run along them.
                shake_unknowns(&mut system, 0.02, 17);
                shake_unknowns(&mut system, 0.02, 18);
                // Dead loads have no stiffness: at level 0 the tangent is that of the energy alone.
                let what = format!("{name} on {cloud_name}, {}", strain.name());
                derivatives_agree(&mut system, 0.0, &what);
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
    system.internal(0.0, &mut force);
    let mut dice = RandomNumbers(8);
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
        assert!(matches!(error, EquilibriumError::Mechanism { zero, .. } if zero == free), "{error}");
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
    // Five degrees of freedom a particle; two directions that are not square to each other hold a plane.
    let skew = vec![Vec3::new(3.0, 0.0, 0.0), Vec3::new(1.0, 1.0, 0.0)];
    for (supports, left) in [
        (all(vec![], Some(Vec3::x())), 4),
        (all(skew, None), 3),
        (all(vec![Vec3::x(), Vec3::y(), Vec3::z()], Some(Vec3::y())), 1),
    ] {
        let mut system = pushed(supports);
        assert_eq!(system.unknowns(), 30 * left);
        assert_eq!(system.shell().dof(), 30 * left);
        // A motion of the unknowns leaves what is held.
        system.update(&vec![0.01; 30 * left]);
        let (u, d) = (system.shell().displacement(7), system.shell().director(7));
        match left {
            4 => assert!(d.x == 0.0 && d.y != 0.0 && u.norm() > 0.0),
            3 => assert!(libm::hypot(u.x, u.y) < 1e-17 && u.z == 0.01),
            _ => assert!(u.norm() == 0.0 && d.y == 0.0 && d.x != 0.0),
        }
    }
}

#[test]
fn modes_turn_with_the_inertia_of_the_shell_itself() {
    let body = common::free_shell(flat([6, 5], [2.0, 1.5]), energy_formulations()[0].1, 0.2);
    // A turn counts as an arc: its radius is the power of two nearest to the spacing √(3/30) = .316.
    let arc = 0.25;
    let masses = StaticShell::new(body).masses();
    // Three translations and two turns a particle: ρ t A and ρ t A t²/12, though t is half a spacing.
    for particle in masses.chunks_exact(5) {
        assert!(particle[..3].iter().all(|m| *m == particle[0]));
        assert!(
            particle[3..].iter().all(|i| (i * arc * arc / (particle[0] * 0.04 / 12.0) - 1.0).abs() < 1e-14)
        );
    }
}

#[test]
fn answers_do_not_depend_on_the_unit_of_length() {
    // Turns count as arcs: between units of length 10⁹ apart the pivots of turns keep their size beside those of
    // translations, where they would differ by 10¹⁸ and pass for a mechanism.
    let tip = |unit: f64| {
        let cloud = flat([9, 3], [10.0 * unit, unit]);
        let sides = cloud.sides.clone().unwrap();
        let shares = sides.edge(Side::U1).iter().map(|&a| (a, 1.0)).collect();
        let loads: Vec<Box<dyn Load>> = vec![Box::new(Force { shares, total: Vec3::z() * 1e-3 })];
        let supports =
            vec![Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) }];
        let material = Isotropic::new(common::YOUNG / (unit * unit), common::POISSON).unwrap();
        let parts = common::parts(cloud, energy_formulations()[0].1, 0.2 * unit);
        let body = Shell::builder(Parts {
            section: Box::new(IsotropicSection::new(material, 0.2 * unit).unwrap()),
            supports,
            loads: loads
                .into_iter()
                .map(|load| AppliedLoad { load, amplitude: explicit_dynamics::Amplitude::Constant })
                .collect(),
            ..parts
        })
        .build()
        .unwrap();
        let mut system = StaticShell::new(body);
        Newton::new(&system, &NewtonOptions::default()).unwrap().at_level(&mut system, 1.0).unwrap();
        system.shell().displacement(sides.edge(Side::U1)[1] as usize).z / unit
    };
    let usual = tip(1.0);
    for unit in [1e9, 1e-9] {
        let other = tip(unit);
        // Newton's tolerance of 1e-9, far from a limit point.
        assert!((other / usual - 1.0).abs() < 1e-8, "unit {unit:e}: {other} against {usual}");
    }
}
