//! Springs to the ground: frequencies, buckling and deflections in closed form, momentum, the stable step, derivatives.

use crate::common::{
    self, YOUNG, curved, disordered_flat, energy_formulations, flat, free_shell, parts, shake, shell_parts,
};
use explicit_dynamics::{Clock, Dynamics, LinearisedDynamics};
use implicit_statics::{
    BucklingOptions, Equilibrium, Newton, NewtonOptions, linear_buckling, natural_modes, stiffness_error,
    unwatched,
};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Side, Vec3};
use sph_shell::{
    Clamped, Force, Formulation, Load, Parts, Reach, Shell, ShellError, Spring, StaticShell, Supported,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const LENGTH: f64 = 10.0;
const THICK: f64 = 0.1;
/// Bending stiffness of the strip of width one.
const EI: f64 = YOUNG * THICK * THICK * THICK / 12.0;

fn equal(particles: impl IntoIterator<Item = u32>, each: f64, direction: Vec3) -> Spring {
    Spring { stiffness: particles.into_iter().map(|a| (a, each)).collect(), direction }
}

/// Springs of a stiffness in proportion to the masses let a free plate swing as one body: `ω² = k/m`.
#[test]
fn a_plate_on_springs_swings_as_one_mass() {
    let cloud = disordered_flat([6, 5], [1.0, 0.8]);
    let body = Shell::builder(parts(cloud.clone(), CELL, 0.3));
    let (k, axis) = (1e-4, Vec3::new(0.3, -1.0, 0.5));
    // Those of modes: three translations and two turns a particle.
    let of_modes = StaticShell::new(free_shell(cloud, CELL, 0.3)).vibrating_masses();
    let masses: Vec<f64> = of_modes.chunks_exact(5).map(|own| own[0]).collect();
    let whole: f64 = masses.iter().sum();
    let springs = (0..3).map(|i| {
        let direction = [axis, axis.cross(&Vec3::z()), axis.cross(&axis.cross(&Vec3::z()))][i];
        let size = k * (1 + i) as f64 / whole;
        Spring { stiffness: (0..).zip(&masses).map(|(a, m)| (a, size * m)).collect(), direction }
    });
    let body = body.springs(springs.collect::<Vec<_>>()).build().unwrap();
    let mut system = StaticShell::new(body);
    let found = natural_modes(&mut system, 0.0, 6, 0.0, &mut unwatched).unwrap().modes;
    for i in 0..3 {
        let exact = k * (1 + i) as f64 / whole;
        let nearest =
            found.iter().map(|mode| (mode.eigenvalue / exact - 1.0).abs()).fold(f64::INFINITY, f64::min);
        println!("{i}: {nearest:.1e}");
        assert!(nearest < 3e-9, "{i}: {nearest:.1e}");
    }
}

/// A cantilever of width one along x with a spring of stiffness k along z at its tip and a force there.
fn cantilever(cells: usize, k: f64, force: Vec3) -> Shell {
    let cloud = flat([cells + 1, 3], [LENGTH, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let tip = sides.edge(Side::U1).to_vec();
    let part = |size: f64| tip.iter().zip([0.25, 0.5, 0.25]).map(|(&a, s)| (a, s * size)).collect::<Vec<_>>();
    let load: Box<dyn Load> = Box::new(Force { shares: part(1.0), total: force });
    let loads = vec![sph_shell::AppliedLoad { load, amplitude: explicit_dynamics::Amplitude::Constant }];
    let springs = (k > 0.0).then(|| Spring { stiffness: part(k), direction: Vec3::z() * 3.0 });
    let shell = Shell::builder(Parts {
        section: Box::new(IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), THICK).unwrap()),
        supports: vec![Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) }],
        loads,
        ..parts(cloud, CELL, THICK)
    });
    shell.springs(springs.into_iter().collect::<Vec<_>>()).build().unwrap()
}

/// Beam and spring side by side: `w = F/(3EI/L³ + k)`, of which the spring bears `k w`.
#[test]
fn a_tip_spring_takes_its_share_of_the_force() {
    let (k, force) = (3.0 * EI / LENGTH.powi(3), 1e-4 * EI / LENGTH.powi(2));
    for (cells, bound) in [(10, 4e-3), (20, 1e-3)] {
        let mut system = StaticShell::new(cantilever(cells, k, Vec3::z() * force));
        Newton::new(
            &system,
            &NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() },
        )
        .unwrap()
        .at_level(&mut system, 1.0)
        .unwrap();
        system.evaluate(1.0);
        let shell = system.shell();
        let tip = shell.reference().cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
        let way = shell.displacement(tip[1] as usize).z;
        let borne: f64 = tip.iter().map(|&a| shell.reaction(a as usize).z).sum();
        let error = way * 2.0 * k / force - 1.0;
        println!("{cells} cells: {error:.2e}, borne {}", borne / force);
        assert!(error.abs() < bound, "{error}");
        assert!((borne + k * way).abs() < 1e-9 * force, "{borne} {}", k * way);
        // Clamp and spring bear all of it.
        let all = shell.support_resultant(Vec3::zeros());
        assert!((all.force.z + force).abs() < 1e-8 * force, "{} {force}", all.force);
    }
}

/// A cantilever on a tip spring: with κ = kL³/EI, `β³(1 + cos cosh) + κ (cosh sin − sinh cos) = 0`, βL for β.
#[test]
fn a_cantilever_on_a_tip_spring_has_its_frequency() {
    let kappa = 10.0;
    let lack = |b: f64| {
        b.powi(3) * (1.0 + libm::cos(b) * libm::cosh(b))
            + kappa * (libm::cosh(b) * libm::sin(b) - libm::sinh(b) * libm::cos(b))
    };
    let (mut low, mut high) = (1.8, 3.9);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if (lack(middle) > 0.0) == (lack(low) > 0.0) { &mut low } else { &mut high }) = middle;
    }
    let line = common::DENSITY * THICK;
    let exact = low.powi(4) * EI / (line * LENGTH.powi(4));
    let mut errors = Vec::new();
    for cells in [10, 20, 40] {
        let mut system = StaticShell::new(cantilever(cells, kappa * EI / LENGTH.powi(3), Vec3::z()));
        let found = natural_modes(&mut system, 0.0, 1, 0.0, &mut unwatched).unwrap().modes[0].eigenvalue;
        errors.push(found / exact - 1.0);
    }
    println!("βL = {low}: {errors:?}");
    // What is left with ever finer cells, 1.2e-4, are rotary inertia and shear, which Euler's beam has not.
    assert!(
        errors[2].abs() < 6e-4 && (errors[0] - errors[1]).abs() > 3.0 * (errors[1] - errors[2]).abs(),
        "{errors:?}"
    );
}

/// A column clamped below, on a spring above: with κ = kL³/EI and `P = EI u²/L²`, `tan u = u − u³/κ`.
#[test]
fn a_column_on_a_tip_spring_has_its_buckling_load() {
    let kappa = 10.0;
    let lack = |u: f64| libm::sin(u) - (u - u.powi(3) / kappa) * libm::cos(u);
    let (mut low, mut high) = (1.6, 4.4);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if (lack(middle) > 0.0) == (lack(low) > 0.0) { &mut low } else { &mut high }) = middle;
    }
    let exact = EI * low * low / (LENGTH * LENGTH);
    let error = |cells: usize| {
        let shell = cantilever(cells, kappa * EI / LENGTH.powi(3), Vec3::x() * -exact);
        let options = BucklingOptions::new(1);
        linear_buckling(&mut StaticShell::new(shell), 0.0, &options, &mut unwatched).unwrap().modes[0].level
            - 1.0
    };
    let errors = [10, 20, 40].map(error);
    println!("u = {low}: {errors:?}");
    assert!(errors[2].abs() < 1e-3 && errors[0].abs() > 3.0 * errors[1].abs(), "{errors:?}");
}

#[test]
fn tangents_are_derivatives_and_have_no_skew_part() {
    for (name, formulation) in energy_formulations().into_iter().take(2) {
        let cloud = curved([6, 5]);
        let held = cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec();
        let clamp = Supported { particles: held, support: Box::new(Clamped) };
        let body =
            Shell::builder(shell_parts(cloud, formulation, 0.1, &StretchCorrected, vec![clamp], vec![]));
        let mut body = body
            .springs(vec![
                equal([7, 8, 20], 300.0, Vec3::new(1.0, -2.0, 0.5)),
                equal([8, 29], 100.0, Vec3::y()),
            ])
            .build()
            .unwrap();
        shake(&mut body, 0.02, 3);
        let mut system = StaticShell::new(body);
        assert_eq!(system.skew_load_share(), 0.0);
        let n = system.unknowns();
        let way: Vec<f64> = (0..n).map(|i| libm::cos(0.7 * i as f64)).collect();
        let error = stiffness_error(&mut system, 0.0, &way, 1e-4);
        println!("{name}: {error:.1e}");
        assert!(error < 1e-12, "{name}: {error:.1e}");
    }
}

/// A free shell on springs: its momentum changes by what the ground exerts, and stiff springs shorten the stable step to `2/√(k/m)`.
#[test]
fn a_march_on_springs_keeps_its_balances() {
    let body = Shell::builder(parts(flat([6, 5], [1.0, 0.8]), CELL, 0.1));
    let k = 40.0;
    let mut body = body.springs(vec![equal([0, 7, 13], k, Vec3::new(0.0, 1.0, 2.0))]).build().unwrap();
    for a in 0..body.len() {
        body.set_rate(a, Vec3::new(0.1, -0.3, 0.4), Vec3::zeros());
    }
    let unit = Vec3::new(0.0, 1.0, 2.0).normalize();
    let momentum = |body: &Shell| -> Vec3 {
        (0..body.len()).map(|a| body.velocity(a) * body.reference().masses[a]).sum()
    };
    let mut clock = Clock::start(&mut body, 1.0, 0.5, 0.0).unwrap();
    let (mut impulse, start) = (Vec3::zeros(), momentum(&body));
    let mut first = true;
    for _ in 0..400 {
        let pull: f64 = [0, 7, 13].iter().map(|&a| k * body.displacement(a).dot(&unit)).sum();
        let before = clock.now.time;
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        // The first kick is half a step.
        let kick = (clock.now.time - before) * if std::mem::take(&mut first) { 0.5 } else { 1.0 };
        impulse -= unit * (pull * kick);
    }
    let lost = (momentum(&body) - start - impulse).norm() / start.norm();
    println!("momentum {lost:.1e}");
    assert!(lost < 1e-14, "{lost}");

    let mut stiff = free_shell(flat([6, 5], [1.0, 0.8]), CELL, 0.1);
    let before = stiff.stable_step(1.0).unwrap().dt;
    let (k, mass) = (1e7, stiff.reference().masses[7]);
    let stiff = Shell::builder(parts(flat([6, 5], [1.0, 0.8]), CELL, 0.1));
    let mut stiff = stiff.springs(vec![equal([7], k, Vec3::x())]).build().unwrap();
    let after = stiff.stable_step(1.0).unwrap().dt;
    let exact = 2.0 / (k / mass).sqrt();
    println!("stable step {before:.3e} {after:.3e} {exact:.3e}");
    assert!(after < 0.1 * before && (after / exact - 1.0).abs() < 0.02, "{after} {exact}");
    assert_eq!(stiff.unknowns(), 6 * stiff.len());
}

#[test]
fn springs_that_are_none_are_refused() {
    let body = || Shell::builder(parts(flat([4, 3], [1.0, 0.8]), CELL, 0.1));
    let refused =
        |particles: Vec<u32>, k| body().springs(vec![equal(particles, k, Vec3::x())]).build().map(drop);
    assert!(matches!(refused(vec![], 1.0), Err(ShellError::EmptySet(_))));
    assert!(matches!(refused(vec![12], 1.0), Err(ShellError::NoSuchParticle { particle: 12, .. })));
    assert!(matches!(refused(vec![1], -1.0), Err(ShellError::Spring { particle: 1, .. })));
}
