//! Beams on springs: a strip in an elastic clamp, two strips whose tips a spring joins.

use crate::common::{DENSITY, Sheets, X, Y, YOUNG, Z, at, beam_parts, flat, supported};
use implicit_statics::{BucklingOptions, Newton, NewtonOptions, linear_buckling, natural_modes, unwatched};
use sph_core::{Side, Vec3};
use sph_shell::{Clamped, Force, Hinged, Load, Shell, SpringBetween, Springs, StaticShell, TurnSpring};

const LENGTH: f64 = 10.0;
const THICK: f64 = 0.1;
/// Bending stiffness of the strip of width one.
const EI: f64 = YOUNG * THICK * THICK * THICK / 12.0;

/// Shares of an edge of three particles.
fn shared(edge: &[u32], size: f64) -> Vec<(u32, f64)> {
    edge.iter().zip([0.25, 0.5, 0.25]).map(|(&a, s)| (a, s * size)).collect()
}

/// A strip of width one along x, hinged at its root with a spring of stiffness k about y, under a force at its tip.
fn elastic(cells: usize, k: f64, force: Vec3) -> Shell {
    let cloud = flat([cells + 1, 3], [LENGTH, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let (root, tip) = (sides.edge(Side::U0).to_vec(), sides.edge(Side::U1).to_vec());
    let load: Box<dyn Load> = Box::new(Force { shares: shared(&tip, 1.0), total: force });
    let hinge = supported(root.clone(), Hinged);
    let shell = Shell::builder(beam_parts(cloud, THICK, vec![hinge], vec![load]));
    let turning = vec![TurnSpring { stiffness: shared(&root, k), axis: Y * 2.0 }];
    shell.springs(Springs { turning, ..Springs::default() }).build().unwrap()
}

fn solved(shell: Shell) -> StaticShell {
    let mut system = StaticShell::new(shell);
    let options = NewtonOptions { tolerance: 1e-11, line_search: false, ..NewtonOptions::default() };
    Newton::new(&system, &options).unwrap().at_level(&mut system, 1.0).unwrap();
    system.evaluate(1.0);
    system
}

fn root_of(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        *(if (f(middle) > 0.0) == (f(low) > 0.0) { &mut low } else { &mut high }) = middle;
    }
    low
}

/// With κ = kL/EI: `w = FL³/3EI + FL²/k`; buckling under an end force `u tan u = κ`; vibration by the beam's determinant.
#[test]
fn a_strip_in_an_elastic_clamp_is_the_beam() {
    let kappa = 3.0;
    let k = kappa * EI / LENGTH;
    let force = 1e-4 * EI / LENGTH.powi(2);
    let lack = |x: f64| {
        let (sin, cos, sinh, cosh) = (libm::sin(x), libm::cos(x), libm::sinh(x), libm::cosh(x));
        // w = A sin + C sinh + B (cos − cosh), B = −κ (A + C)/2x.
        let row = |of_a: [f64; 2], of_b: f64| of_a.map(|a| a - kappa / (2.0 * x) * of_b);
        let second = row([-sin, sinh], -cos - cosh);
        let third = row([-cos, cosh], sin - sinh);
        second[0] * third[1] - second[1] * third[0]
    };
    let x = root_of(0.8, 1.87, lack);
    let square = x.powi(4) * EI / (DENSITY * THICK * LENGTH.powi(4));
    let u = root_of(0.5, 1.55, |u| u * libm::sin(u) - kappa * libm::cos(u));
    let critical = EI * u * u / LENGTH.powi(2);
    let mut errors = Vec::new();
    for cells in [10, 20, 40] {
        let system = solved(elastic(cells, k, Z * force));
        let shell = system.shell();
        let sides = shell.reference().cloud.sides.clone().unwrap();
        let way = shell.displacement(sides.edge(Side::U1)[1] as usize).z;
        let bent = way / (force * LENGTH.powi(3) / (3.0 * EI) + force * LENGTH.powi(2) / k) - 1.0;
        // The spring bears the moment of the force about the root.
        let root = sides.edge(Side::U0);
        let moment: f64 = root.iter().map(|&a| shell.reaction_moment(a as usize).y).sum();
        let tip = shell.position(sides.edge(Side::U1)[1] as usize);
        assert!((moment / (tip.x * force) - 1.0).abs() < 1e-8, "{moment} {}", tip.x * force);
        let whole = shell.support_resultant(Vec3::zeros());
        assert!((whole.moment.y / (tip.x * force) - 1.0).abs() < 1e-8, "{:?}", whole);
        let mut system = StaticShell::new(elastic(cells, k, Vec3::zeros()));
        let found = natural_modes(&mut system, 0.0, 1, 0.0, &mut unwatched).unwrap().modes[0].eigenvalue;
        let mut system = StaticShell::new(elastic(cells, k, X * -critical));
        let options = BucklingOptions::new(1);
        let level = linear_buckling(&mut system, 0.0, &options, &mut unwatched).unwrap().modes[0].level;
        errors.push([bent, found / square - 1.0, level - 1.0]);
    }
    println!("x {x}, u {u}: {errors:?}");
    for i in 0..3 {
        let of = |n: usize| errors[n][i].abs();
        // Second order in the cell but for shear and rotary inertia, which Euler's beam has not.
        assert!(of(2) < 1.2e-3 && of(0) > 3.0 * of(1), "{i}: {errors:?}");
    }
}

/// Two cantilevers over each other, tips joined by a spring k: `w₁ = F/(K + kK/(k + K))`, `w₂ = k w₁/(k + K)` with `K = 3EI/L³`.
#[test]
fn two_strips_joined_by_springs_share_a_force() {
    let beam = 3.0 * EI / LENGTH.powi(3);
    let (k, force) = (2.0 * beam, 1e-4 * EI / LENGTH.powi(2));
    let mut errors = Vec::new();
    for cells in [10, 20] {
        let strip = |sheets: Sheets, z: f64| sheets.add(Z * z, [X * LENGTH, Y], [cells, 2]);
        let cloud = strip(strip(Sheets::default(), 0.0), 0.4).apart();
        let tip = |z: f64| at(&cloud, |x| x.x > LENGTH - 1e-6 && (x.z - z).abs() < 1e-6);
        let (low, high) = (tip(0.0), tip(0.4));
        let clamp = supported(at(&cloud, |x| x.x < 1e-6), Clamped);
        let load: Box<dyn Load> = Box::new(Force { shares: shared(&low, 1.0), total: Z * force });
        let shell = Shell::builder(beam_parts(cloud, THICK, vec![clamp], vec![load]));
        let pairs = shared(&low, k).into_iter().zip(&high).map(|((a, k), &b)| ([a, b], k)).collect();
        let between = vec![SpringBetween { stiffness: pairs, direction: Z }];
        let shell = shell.springs(Springs { between, ..Springs::default() }).build().unwrap();
        let system = solved(shell);
        let shell = system.shell();
        let way = |on: &[u32]| shell.displacement(on[1] as usize).z;
        let one = force / (beam + k * beam / (k + beam));
        errors.push([way(&low) / one - 1.0, way(&high) / (k * one / (k + beam)) - 1.0]);
        let borne: f64 = high.iter().map(|&a| shell.reaction(a as usize).z).sum();
        assert!((borne / (k * (way(&low) - way(&high))) - 1.0).abs() < 1e-6, "{borne}");
        let whole = shell.support_resultant(Vec3::zeros());
        // Newton ends at the round-off of forces far larger than this load.
        assert!((whole.force.z / -force - 1.0).abs() < 2e-8, "{:?}", whole);
    }
    println!("{errors:?}");
    assert!((0..2).all(|i| errors[1][i].abs() < 1.2e-3 && errors[0][i].abs() > 3.0 * errors[1][i].abs()));
}
