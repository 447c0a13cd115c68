//! Dynamic relaxation against Newton's method, and what it refuses.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::ops::ControlFlow;

use common::bars::Bars;
use common::hardening::Hardening;
use common::pendulum::Pendulum;
use common::{Arch, ArchWithSpring, Flat, Hencky, Potential, Softening};
use implicit_statics::{
    Damping, Equilibrium, EquilibriumError, Newton, NewtonOptions, OutOfBounds, Relaxation,
    RelaxationOptions, Relaxed, relax,
};

fn relaxed<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    options: &RelaxationOptions,
) -> Result<Relaxed, EquilibriumError> {
    relax(system, options, (0.0, level), |_| ControlFlow::Continue(()))
}

/// Both kinds of damping find what Newton's method finds, to 1e-4 of the way.
fn agrees<E: Equilibrium>(name: &str, mut system: E, level: f64) {
    let rest = system.save();
    Newton::new(&system, &NewtonOptions::default()).unwrap().at_level(&mut system, level).unwrap();
    let exact = system.save();
    let way = exact.iter().zip(&rest).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    for damping in [Damping::Kinetic, Damping::Rayleigh] {
        system.restore(&rest);
        let options = RelaxationOptions { damping, ..RelaxationOptions::default() };
        let found = relaxed(&mut system as &mut dyn Equilibrium, level, &options).unwrap();
        let off = system.save().iter().zip(&exact).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / way;
        println!("{name}, {damping:?}: {off:.1e} after {} evaluations", found.evaluations);
        assert!(off < 1e-4, "{name}, {damping:?}: {off:.1e} after {found:?}");
        assert!(found.residuals[found.residuals.len() - 1] <= found.bound);
    }
}

#[test]
fn relaxation_finds_what_newton_finds() {
    let arch = Arch { half: 10.0, height: 1.0, sideways: false };
    let limit = arch.limit();
    agrees("arch", Flat::new(arch), 0.9 * limit);
    let arch = Arch { half: 10.0, height: 1.0, sideways: false };
    agrees("arch on a spring", Flat::new(ArchWithSpring { arch, spring: 1e-3 }), 0.9 * limit);
    agrees("softening spring", Flat::new(Softening), 0.3);
    agrees("chain of directors", Pendulum::new(12), 0.02);
    agrees("bars with a moved end", Bars::new(30), 0.3);
}

/// Of the relative and the absolute bound the greater counts: the first at a load, the second where next to nothing acts.
#[test]
fn a_force_may_be_small_enough_whatever_acts() {
    let (tolerance, force) = (1e-9, 1e-4);
    let mut iterations = [Vec::new(), Vec::new()];
    for (found, force) in iterations.iter_mut().zip([0.0, force]) {
        for level in [1e-3, 0.2] {
            let mut system = Flat::new(Softening);
            let options = RelaxationOptions { tolerance, force, ..RelaxationOptions::default() };
            let relaxed = relaxed(&mut system, level, &options).unwrap();
            let residual = relaxed.residuals.last().copied().unwrap();
            assert!(residual <= relaxed.bound && relaxed.bound == force.max(tolerance * relaxed.load));
            found.push(relaxed.iterations);
        }
    }
    let [relative, both] = iterations;
    assert!(both.iter().zip(&relative).all(|(both, relative)| both < relative), "{both:?} {relative:?}");
}

#[test]
fn a_snap_through_lands_beyond() {
    let arch = Arch { half: 10.0, height: 1.0, sideways: false };
    let limit = arch.limit();
    let mut system = Flat::new(arch);
    relaxed(&mut system, 1.5 * limit, &RelaxationOptions::default()).unwrap();
    assert!(system.q[0] > 2.0 && (system.potential.level(system.q[0]) / limit - 1.5).abs() < 1e-5);
}

#[test]
fn what_is_not_found_is_said_and_the_state_stays() {
    // Beyond 1/e the softening spring has no equilibrium.
    let mut system = Flat::new(Softening);
    system.q[0] = 0.1;
    let options = RelaxationOptions { iterations: 300, ..RelaxationOptions::default() };
    let error = relaxed(&mut system, 0.5, &options).unwrap_err();
    let EquilibriumError::NotRelaxed { iterations: 300, residual, bound, .. } = error else {
        panic!("{error}")
    };
    assert!(residual > bound);
    assert!(error.to_string().contains("dynamic relaxation; allow more iterations"), "{error}");
    assert_eq!(system.q, [0.1]);

    let mut reports = 0;
    let ended = relax(&mut system, &options, (0.0, 0.5), |at| {
        reports += 1;
        if at.iterations < 200 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert!(matches!(ended, Err(EquilibriumError::Ended { iterations: 200, .. })), "{ended:?}");
    assert_eq!((reports, system.q[0]), (3, 0.1));

    system.forceless = Some(0.2..0.4);
    let error = relaxed(&mut system, 0.3, &options).unwrap_err();
    assert!(matches!(error, EquilibriumError::Force { .. }), "{error}");
    for (wrong, name) in [
        (RelaxationOptions { tolerance: 0.0, ..options.clone() }, "relaxation tolerance is 0"),
        (RelaxationOptions { iterations: 0, ..options.clone() }, "relaxation iterations is 0"),
        (RelaxationOptions { force: -1.0, ..options.clone() }, "relaxation force is -1"),
        (RelaxationOptions { safety: 0.9, ..options.clone() }, "relaxation safety is 0.9"),
    ] {
        let error = relaxed(&mut system, 0.3, &wrong).unwrap_err();
        assert!(error.to_string().starts_with(name), "{error}");
    }
}

#[test]
fn masses_follow_a_stiffness_that_grows() {
    let mut system = Flat::new(Hardening);
    let found = relaxed(&mut system, 1000.0, &RelaxationOptions::default()).unwrap();
    assert!(found.row_sums > 1, "{found:?}");
    assert!((system.q[0] + system.q[0].powi(3) - 1000.0).abs() < 1e-3, "{:?}", system.q);
}

#[test]
fn row_sums_are_those_of_the_tangent() {
    let mut chain = Flat::new(Hencky { links: 6 });
    let n = chain.unknowns();
    let mut dense = vec![0.0; n * n];
    chain.potential.hessian(&[0.0; 5], &mut |i, j, k| {
        dense[i * n + j] += k;
        if i != j {
            dense[j * n + i] += k;
        }
    });
    let mut sums = vec![0.0; n];
    chain.row_sums(0.0, &mut sums);
    for (i, sum) in sums.iter().enumerate() {
        let exact: f64 = dense[i * n..(i + 1) * n].iter().map(|k| k.abs()).sum();
        assert!((sum - exact).abs() < 1e-12 * exact, "{sum} {exact}");
    }
}

/// Springs of stiffness one in a row, held at one end and pulled at the other: `q_j = λ (j + 1)`.
struct Springs(usize);

impl Potential for Springs {
    fn unknowns(&self) -> usize {
        self.0
    }
    fn energy(&self, q: &[f64]) -> f64 {
        0.5 * (q[0].powi(2) + q.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>())
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        for j in 0..self.0 {
            let left = if j > 0 { q[j - 1] } else { 0.0 };
            let right = if j + 1 < self.0 { q[j + 1] } else { q[j] };
            out[j] = 2.0 * q[j] - left - right;
        }
    }
    fn hessian(&self, _: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        for j in 0..self.0 {
            add(j, j, if j + 1 < self.0 { 2.0 } else { 1.0 });
            if j > 0 {
                add(j, j - 1, -1.0);
            }
        }
    }
    fn load(&self, _: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        out[self.0 - 1] = 1.0;
    }
}

/// Evaluations of the forces at each of some levels of a chain, each answer held against the closed form.
fn evaluations(springs: usize, levels: &[f64], damping: Damping, tells_motions: bool) -> Vec<usize> {
    let mut chain = Flat::new(Springs(springs));
    chain.tells_motions = tells_motions;
    let options = RelaxationOptions { damping, tolerance: 1e-5, ..RelaxationOptions::default() };
    let mut relaxation = Relaxation::new(&options).unwrap();
    let mut before = 0.0;
    let mut spent = Vec::new();
    for &level in levels {
        let found = relaxation.to_level(&mut chain, (before, level), |_| ControlFlow::Continue(())).unwrap();
        // What is left of the force is 1e-5 of the load, and moves the softest mode by (2n/π)² times as much.
        let softest = (2.0 / std::f64::consts::PI * (springs + 1) as f64).powi(2);
        for (j, q) in chain.q.iter().enumerate() {
            let off = (q - level * (j + 1) as f64).abs();
            assert!(off < 1e-5 * level * softest, "{damping:?}, spring {j}: {q}");
        }
        spent.push(found.evaluations);
        before = level;
    }
    println!("{springs} springs, {damping:?}: {spent:?} evaluations");
    spent
}

#[test]
fn a_chain_settles_at_its_closed_form_in_few_evaluations() {
    // ω_max/ω_min = 4n/π, 255. Critical damping of the slowest mode takes half of that for each of the 11.5 times that 1e-5 is
    // e times less than one: 1500 evaluations a level. Measured: 393, 147, 167; 403, 92, 91.
    for damping in [Damping::Kinetic, Damping::Rayleigh] {
        let spent = evaluations(200, &[0.3, 0.4, 0.9], damping, false);
        assert!(spent[0] < 600 && spent[1..].iter().all(|&next| next < 250), "{damping:?}: {spent:?}");
    }
}

#[test]
fn a_straight_path_is_followed_without_a_move() {
    let spent = evaluations(50, &[0.3, 0.4, 0.9], Damping::Kinetic, true);
    assert!(spent[1..] == [1, 1], "{spent:?}");
}

/// A hardening spring that is outside of its model beyond a stretch of three.
struct Bounded;

impl Potential for Bounded {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        Hardening.energy(q)
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        Hardening.gradient(q, out);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        Hardening.hessian(q, add);
    }
    fn load(&self, q: &[f64], out: &mut [f64]) {
        Hardening.load(q, out);
    }
    fn within_bounds(&self, q: &[f64]) -> Result<(), OutOfBounds> {
        let (place, what, bound) = ("the spring".into(), "stretch", "at most 3");
        if q[0] <= 3.0 { Ok(()) } else { Err(OutOfBounds { place, what, value: q[0], bound }) }
    }
}

#[test]
fn a_start_that_leads_astray_is_given_up() {
    let mut spring = Flat::new(Bounded);
    spring.tells_motions = true;
    let mut relaxation = Relaxation::new(&RelaxationOptions::default()).unwrap();
    let mut to = |levels, spring: &mut Flat<Bounded>| {
        relaxation.to_level(spring, levels, |_| ControlFlow::Continue(())).map(|_| spring.q[0])
    };
    to((0.0, 0.1), &mut spring).unwrap();
    to((0.1, 0.2), &mut spring).unwrap();
    // A line through the first two levels points to 9.7: outside of the model. From where it stands it reaches two.
    let found = to((0.2, 10.0), &mut spring).unwrap();
    assert!((found - 2.0).abs() < 1e-5, "{found}");
    // What lies outside of the model from anywhere is refused, and the state stays.
    let refused = to((10.0, 100.0), &mut spring).unwrap_err();
    assert!(matches!(refused, EquilibriumError::Strayed { .. }), "{refused}");
    assert_eq!(spring.q, [found]);
}
