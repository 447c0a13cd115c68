//! Masses lumped where sheets meet: their inertia and weight in the march, and what they do to frequencies.

use std::f64::consts::FRAC_PI_2;

use crate::common::{at, folded, line, parts, supported};
use explicit_dynamics::{Amplitude, Clock};
use implicit_statics::{natural_modes, unwatched};
use nalgebra::{Matrix2, SymmetricEigen};
use shell_kinematics::{Isotropic, IsotropicSection};
use sph_core::{Cloud, Vec3};
use sph_shell::{AppliedLoad, Clamped, Formulation, Gravity, Parts, Reach, Shell, StaticShell, Supported};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICK: f64 = 0.02;
const WIDE: f64 = 0.2;
const YOUNG: f64 = 1200.0;

/// Two legs of length one at right angles, and a mass along their joint: on the particles of one leg, or of the other.
fn frame(cells: usize, mass: f64, leg: usize, clamped: bool, gravity: Option<Vec3>) -> Shell {
    let cloud: Cloud = folded(FRAC_PI_2, cells, WIDE, 2);
    let root = at(&cloud, |x| x.x < 1e-9);
    let knee: Vec<u32> = cloud.joined.iter().map(|group| group[leg]).collect();
    let masses: Vec<(u32, f64)> =
        line(&cloud, &knee).into_iter().map(|(a, share)| (a, 0.5 * mass * share)).collect();
    let applied = |acceleration| AppliedLoad {
        load: Box::new(Gravity { acceleration }),
        amplitude: Amplitude::Constant,
    };
    let held: Vec<Supported> = clamped.then(|| supported(root, Clamped)).into_iter().collect();
    let shell = Shell::builder(Parts {
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), THICK).unwrap()),
        supports: held,
        loads: gravity.map(applied).into_iter().collect(),
        ..parts(cloud, CELL, THICK)
    });
    shell.masses(masses).build().unwrap()
}

/// Weight and inertia of a joint are those of its particles and of what is lumped there: a free frame falls as one body. Without the
/// lumped mass in the inertia its joint would fall ten times too fast.
#[test]
fn a_free_frame_with_a_mass_at_its_knee_falls_without_strain() {
    let g = Vec3::new(0.3, -0.2, -1.0);
    for leg in [0, 1] {
        let mut body = frame(6, 2.0, leg, false, Some(g));
        let mut clock = Clock::start(&mut body, 1.0, 0.9, 0.0).unwrap();
        for _ in 0..500 {
            clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        }
        // The first kick is half a step.
        let wanted = g * clock.now.time;
        for a in 0..body.len() {
            let v = body.velocity(a);
            let across = v - g * (v.dot(&g) / g.norm_squared());
            assert!(across.norm() < 1e-12 * wanted.norm(), "{a}: {v} {wanted}");
            assert!((v.norm() - body.velocity(0).norm()).abs() < 1e-12 * wanted.norm(), "{a}: {v}");
        }
        assert!((body.velocity(0).norm() / wanted.norm() - 1.0).abs() < 2.0 / 500.0);
        let turning = (0..body.len()).map(|a| body.director_rate(a).norm()).fold(0.0, f64::max);
        body.evaluate_internal(true);
        let kinetic = 0.5 * body.reference().masses.iter().sum::<f64>() * wanted.norm_squared();
        println!("turning {turning:.1e}, stored {:.1e} of {kinetic:.1e}", body.stored_energy());
        // Rounding of positions far from where they began turns stiff directors.
        assert!(turning < 3e-11 * wanted.norm(), "{turning}");
        assert!(body.stored_energy() < 1e-20 * kinetic, "{} {kinetic}", body.stored_energy());
    }
}

/// The clamped leg as a beam with consistent masses, the other leg rigid on it, and a mass of 50 legs on the joint.
#[test]
fn a_mass_at_the_knee_of_a_frame_swings_as_a_beam_says() {
    let leg_mass = frame(4, 1.0, 0, true, None).reference().masses.iter().sum::<f64>() / 2.0 - 0.5;
    let bending = YOUNG * WIDE * THICK.powi(3) / 12.0;
    let mass = 50.0 * leg_mass;
    let stiffness = Matrix2::new(12.0, -6.0, -6.0, 4.0) * bending;
    let coupled = -11.0 / 210.0 * leg_mass;
    let inertia = Matrix2::new(
        mass + leg_mass * (1.0 + 13.0 / 35.0),
        coupled,
        coupled,
        leg_mass * (1.0 / 3.0 + 1.0 / 105.0),
    );
    let root = inertia.cholesky().unwrap().l().try_inverse().unwrap();
    let values = SymmetricEigen::new(root * stiffness * root.transpose()).eigenvalues;
    let exact = values.min();
    let mut errors = Vec::new();
    for cells in [5, 10, 20] {
        for leg in [0, 1] {
            let mut system = StaticShell::new(frame(cells, mass, leg, true, None));
            let found = natural_modes(&mut system, 0.0, 1, 0.0, &mut unwatched).unwrap().modes[0].eigenvalue;
            errors.push(found / exact - 1.0);
        }
    }
    println!("{errors:?}");
    // Bending of a strip of n cells, 1/4n²; on which leg the mass stands does not matter.
    for (pair, cells) in errors.chunks(2).zip([5.0_f64, 10.0, 20.0]) {
        assert!((pair[0] - pair[1]).abs() < 1e-9, "{errors:?}");
        assert!(pair[0].abs() < 1.2 / (4.0 * cells * cells) + 3e-4, "{errors:?}");
    }
}
