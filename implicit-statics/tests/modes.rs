//! Frequencies of chains and membranes, and linearised buckling loads, against closed forms.

mod common;

use std::f64::consts::PI;
use std::ops::ControlFlow;

use common::{Arch, Flat, Hencky, Softening};
use implicit_statics::{
    BucklingMode, BucklingOptions, Equilibrium, EquilibriumError, Mode, Prebuckling, Sign, Spectrum,
    unwatched,
};

type Pattern = Vec<(usize, usize)>;

/// The lowest modes, their count and their error bounds looked at.
fn lowest_modes(
    pattern: &Pattern,
    values: &[f64],
    masses: &[f64],
    count: usize,
    shift: f64,
) -> Result<Vec<Mode>, EquilibriumError> {
    let found = implicit_statics::lowest_modes(pattern, values, masses, count, shift, &mut unwatched)?;
    // One more where the last is one of several alike.
    assert!((count..=count + 1).contains(&found.counted.number), "{:?}", found.counted);
    assert!(found.modes.iter().all(|mode| mode.residual < 1e-7), "{:?}", found.modes);
    Ok(found.modes)
}

fn natural_modes<E: Equilibrium>(system: &mut E, count: usize) -> Result<Vec<Mode>, EquilibriumError> {
    Ok(implicit_statics::natural_modes(system, 0.0, count, 0.0, &mut unwatched)?.modes)
}

fn buckling<E: Equilibrium>(
    system: &mut E,
    level: f64,
    count: usize,
    sign: Sign,
) -> Result<Spectrum<BucklingMode>, EquilibriumError> {
    let options = BucklingOptions { sign, ..BucklingOptions::new(count) };
    implicit_statics::linear_buckling(system, level, &options, &mut unwatched)
}

fn linear_buckling<E: Equilibrium>(
    system: &mut E,
    level: f64,
    count: usize,
) -> Result<Vec<BucklingMode>, EquilibriumError> {
    let found = buckling(system, level, count, Sign::Positive)?;
    assert!(found.modes.iter().all(|mode| mode.residual < 1e-7), "{:?}", found.modes);
    Ok(found.modes)
}

#[test]
fn modes_of_a_chain_of_springs_and_masses() {
    for n in [3, 20, 400] {
        let pattern: Pattern = (0..n).map(|i| (i, i)).chain((1..n).map(|i| (i, i - 1))).collect();
        let values: Vec<f64> = pattern.iter().map(|&(i, j)| if i == j { 8.0 } else { -4.0 }).collect();
        let masses = vec![0.25; n];
        let count = n.min(6);
        let modes = lowest_modes(&pattern, &values, &masses, count, 0.0).unwrap();
        assert_eq!(modes.len(), count);
        for (m, mode) in modes.iter().enumerate() {
            let exact = 2.0 * 16.0_f64.sqrt() * libm::sin((m + 1) as f64 * PI / (2.0 * (n + 1) as f64));
            let error = mode.circular_frequency() / exact - 1.0;
            assert!(error.abs() < 1e-10, "{n} {m} {error:e}");
            let mass: f64 = mode.shape.iter().map(|x| 0.25 * x * x).sum();
            assert!((mass - 1.0).abs() < 1e-12);
        }
    }
}

/// A square membrane of springs has double frequencies: none is missed.
#[test]
fn double_frequencies_of_a_membrane() {
    let side = 15;
    let at = |i: usize, j: usize| i + side * j;
    let mut pattern = Pattern::new();
    for j in 0..side {
        for i in 0..side {
            pattern.push((at(i, j), at(i, j)));
            if i > 0 {
                pattern.push((at(i, j), at(i - 1, j)));
            }
            if j > 0 {
                pattern.push((at(i, j), at(i, j - 1)));
            }
        }
    }
    let values: Vec<f64> = pattern.iter().map(|&(i, j)| if i == j { 4.0 } else { -1.0 }).collect();
    let sine = |m: usize| 4.0 * libm::sin(m as f64 * PI / (2.0 * (side + 1) as f64)).powi(2);
    let mut exact: Vec<f64> = (1..=side).flat_map(|m| (1..=side).map(move |n| sine(m) + sine(n))).collect();
    exact.sort_by(f64::total_cmp);
    let masses = vec![1.0; side * side];
    let modes = lowest_modes(&pattern, &values, &masses, 12, 0.0).unwrap();
    for (mode, exact) in modes.iter().zip(&exact) {
        assert!((mode.eigenvalue / exact - 1.0).abs() < 1e-10, "{} {exact}", mode.eigenvalue);
    }
    // about a shift inside the spectrum: the nearest on both sides
    let shift = 0.4 * exact[7] + 0.6 * exact[8];
    exact.sort_by(|a, b| (a - shift).abs().total_cmp(&(b - shift).abs()));
    let modes = lowest_modes(&pattern, &values, &masses, 6, shift).unwrap();
    for (mode, exact) in modes.iter().zip(&exact) {
        assert!((mode.eigenvalue / exact - 1.0).abs() < 1e-10, "{} {exact}", mode.eigenvalue);
    }
}

#[test]
fn a_free_chain_shows_its_rigid_motion_with_a_shift_below_zero() {
    let n = 30;
    let pattern: Pattern = (0..n).map(|i| (i, i)).chain((1..n).map(|i| (i, i - 1))).collect();
    let end = |i: usize| if i == 0 || i == n - 1 { 1.0 } else { 2.0 };
    let values: Vec<f64> = pattern.iter().map(|&(i, j)| if i == j { end(i) } else { -1.0 }).collect();
    let masses = vec![1.0; n];
    assert!(matches!(
        lowest_modes(&pattern, &values, &masses, 3, 0.0),
        Err(EquilibriumError::Singular { .. })
    ));
    let modes = lowest_modes(&pattern, &values, &masses, 3, -0.01).unwrap();
    assert!(modes[0].eigenvalue.abs() < 1e-14);
    for (m, mode) in modes.iter().enumerate().skip(1) {
        let exact = 4.0 * libm::sin(m as f64 * PI / (2.0 * n as f64)).powi(2);
        assert!((mode.eigenvalue / exact - 1.0).abs() < 1e-10);
    }
}

/// Masses on every other unknown only: the others follow statically (Guyan's condensation is exact here).
#[test]
fn unknowns_without_mass_follow() {
    let n = 9;
    let pattern: Pattern = (0..n).map(|i| (i, i)).chain((1..n).map(|i| (i, i - 1))).collect();
    let values: Vec<f64> = pattern.iter().map(|&(i, j)| if i == j { 2.0 } else { -1.0 }).collect();
    let masses: Vec<f64> = (0..n).map(|i| (i % 2) as f64).collect();
    let modes = lowest_modes(&pattern, &values, &masses, 4, 0.0).unwrap();
    for (m, mode) in modes.iter().enumerate() {
        // two springs in series halve the stiffness: 4 masses on springs of ½
        let exact = 4.0 * 0.5 * libm::sin((m + 1) as f64 * PI / 10.0).powi(2);
        assert!((mode.eigenvalue / exact - 1.0).abs() < 1e-10, "{} {exact}", mode.eigenvalue);
    }
    assert!(lowest_modes(&pattern, &values, &masses, 5, 0.0).is_err());
}

#[test]
fn buckling_of_a_column_by_its_links() {
    let links = 40;
    let mut system = Flat::new(Hencky { links });
    let modes = linear_buckling(&mut system, 0.0, 3).unwrap();
    for (m, mode) in modes.iter().enumerate() {
        let exact = system.potential.critical(m + 1);
        assert!((mode.level / exact - 1.0).abs() < 1e-9, "{} {exact}", mode.level);
    }
    // Euler's π² EI/L² of the continuous column is met to the second order in the length of a link
    let euler = PI * PI;
    assert!((modes[0].level / euler - 1.0).abs() < 1.1 * euler / 12.0 / (links * links) as f64);
    for (i, y) in modes[0].shape.iter().enumerate() {
        assert!((y - libm::sin(PI * (i + 1) as f64 / links as f64)).abs() < 1e-6);
    }
    // from half the way the same load is found
    let modes = linear_buckling(&mut system, 5.0, 1).unwrap();
    assert!((modes[0].level / system.potential.critical(1) - 1.0).abs() < 1e-9);
    let beyond = linear_buckling(&mut system, 12.0, 1);
    assert_eq!(beyond, Err(EquilibriumError::Unstable { level: 12.0, negative: 1 }));
}

/// A prestress that comes with a displacement: K_xx = (b² + ℓ²ε)·2/ℓ³ with ε = −wh/ℓ² linear in the load gives
/// P = 2 b² h/ℓ³, as b² + ε ℓ² = 0 at w = b²/h and P = 2h² w/ℓ³.
#[test]
fn buckling_through_the_prestress_of_the_state() {
    for reference in [1.0, 1e-6, 1e6] {
        let (half, height) = (1.0, 20.0);
        let mut system = Scaled(Flat::new(Arch { half, height, sideways: true }), reference);
        let exact = 2.0 * half * half * height / system.0.potential.bar().powi(3);
        let modes = linear_buckling(&mut system, 0.0, 1).unwrap();
        assert!((modes[0].level * reference / exact - 1.0).abs() < 1e-8, "{} {exact}", modes[0].level);
        assert_eq!(system.0.q, vec![0.0, 0.0], "the state is put back");
    }
}

/// The same system with another unit of the level.
struct Scaled<E>(E, f64);

impl<E: Equilibrium> Equilibrium for Scaled<E> {
    fn unknowns(&self) -> usize {
        self.0.unknowns()
    }
    fn pattern(&self) -> Pattern {
        self.0.pattern()
    }
    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.0.internal(self.1 * level, out);
    }
    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.0.external(self.1 * level, out);
    }
    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.0.load_rate(level, out);
        out.iter_mut().for_each(|f| *f *= self.1);
    }
    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.0.tangent(self.1 * level, values);
    }
    fn update(&mut self, increment: &[f64]) {
        self.0.update(increment);
    }
    fn save(&self) -> Vec<f64> {
        self.0.save()
    }
    fn restore(&mut self, saved: &[f64]) {
        self.0.restore(saved);
    }
    fn energy(&mut self) -> f64 {
        self.0.energy()
    }
    fn masses(&self) -> Vec<f64> {
        self.0.masses()
    }
    fn name_unknown(&self, unknown: usize) -> String {
        self.0.name_unknown(unknown)
    }
}

#[test]
fn frequencies_of_a_state_and_what_is_refused() {
    let mut system = Flat::new(Softening);
    system.masses = vec![4.0];
    let modes = natural_modes(&mut system, 1).unwrap();
    assert!((modes[0].circular_frequency() - 0.5).abs() < 1e-14);
    system.q[0] = 2.0;
    let modes = natural_modes(&mut system, 1).unwrap();
    assert!((modes[0].eigenvalue + libm::exp(-2.0_f64) / 4.0).abs() < 1e-14);
    assert_eq!(modes[0].circular_frequency(), 0.0);
    assert_eq!(
        natural_modes(&mut system, 2).unwrap_err().to_string(),
        "number of modes is 2, must be between 1 and the number of unknowns with mass"
    );
    let mut straight = Flat::new(common::RigidColumn);
    assert!((linear_buckling(&mut straight, 0.0, 1).unwrap()[0].level - 1.0).abs() < 1e-9);
}

/// Springs whose stiffness changes with the load: critical levels as given, in any order and as dense as one likes.
struct Springs {
    levels: Vec<f64>,
    load: f64,
}

impl Springs {
    /// Stiffnesses over three decades, so that the inner product matters.
    fn stiffness(&self, i: usize) -> f64 {
        libm::pow(10f64, 3.0 * ((i * 7919) % self.levels.len()) as f64 / self.levels.len() as f64)
    }
}

impl Equilibrium for Springs {
    fn unknowns(&self) -> usize {
        self.levels.len()
    }
    fn pattern(&self) -> Pattern {
        (0..self.unknowns()).map(|i| (i, i)).collect()
    }
    fn internal(&mut self, _: f64, out: &mut [f64]) {
        out.fill(0.0);
    }
    fn external(&mut self, level: f64, out: &mut [f64]) {
        out.fill(level * self.load);
    }
    fn load_rate(&mut self, _: f64, out: &mut [f64]) {
        out.fill(self.load);
    }
    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        for (i, value) in values.iter_mut().enumerate() {
            *value = self.stiffness(i) * (1.0 - level / self.levels[i]);
        }
    }
    fn update(&mut self, _: &[f64]) {}
    fn save(&self) -> Vec<f64> {
        Vec::new()
    }
    fn restore(&mut self, _: &[f64]) {}
    fn energy(&mut self) -> f64 {
        0.0
    }
    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.unknowns()]
    }
    fn name_unknown(&self, unknown: usize) -> String {
        format!("spring {unknown}")
    }
}

/// Levels as a complete sphere has them: dense on both sides of zero, the lowest with all 2n + 1 of one degree.
fn dense(unknowns: usize) -> Springs {
    let level = |i: usize| {
        let x = (i / 2) as f64 / unknowns as f64;
        let crowd = 1.0 + 2.0 * (x - 0.01).max(0.0) + 6.0 * x * x;
        if i.is_multiple_of(2) { crowd } else { -1.1 * crowd }
    };
    Springs { levels: (0..unknowns).map(level).collect(), load: 1.0 }
}

/// 31 equal levels at the end of a dense spectrum, of which a block of four vectors sees four at a time.
#[test]
fn no_level_of_a_dense_spectrum_is_missing() {
    let mut system = dense(1200);
    let mut exact: Vec<f64> = system.levels.iter().copied().filter(|&level| level > 0.0).collect();
    exact.sort_by(f64::total_cmp);
    for count in [1, 40] {
        let found = buckling(&mut system, 0.0, count, Sign::Positive).unwrap();
        let inside = exact.iter().filter(|&&level| level < found.counted.to).count();
        assert_eq!(found.counted.number, inside);
        assert_eq!(found.modes.len(), count);
        for (mode, exact) in found.modes.iter().zip(&exact) {
            assert!((mode.level / exact - 1.0).abs() < 1e-9, "{} {exact}", mode.level);
            assert!(mode.residual < 1e-7, "{}", mode.residual);
        }
        // Found: two factorisations, 609 solves for the 40.
        assert!(found.effort.factorisations <= 3, "{:?}", found.effort);
        assert!(found.effort.solves <= 1000, "{:?}", found.effort);
    }
}

#[test]
fn levels_of_either_sign() {
    let mut system = dense(400);
    let mut exact = system.levels.clone();
    exact.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    let levels = |system: &mut Springs, sign| -> Vec<f64> {
        buckling(system, 0.0, 12, sign).unwrap().modes.iter().map(|mode| mode.level).collect()
    };
    for (sign, keep) in
        [(Sign::Positive, [1.0].as_slice()), (Sign::Negative, &[-1.0]), (Sign::Either, &[1.0, -1.0])]
    {
        let wanted = exact.iter().filter(|level| keep.contains(&level.signum()));
        for (found, exact) in levels(&mut system, sign).iter().zip(wanted) {
            assert!((found / exact - 1.0).abs() < 1e-9, "{sign:?} {found} {exact}");
        }
    }
}

/// A load that pulls everywhere: no positive level, said with the proof and the nearest negative one.
#[test]
fn a_load_that_stretches_is_reported_so() {
    let mut system = dense(2000);
    system.levels.iter_mut().for_each(|level| *level = -level.abs());
    let error = buckling(&mut system, 0.0, 1, Sign::Positive).unwrap_err();
    let EquilibriumError::Stretched { searched, other: Some(other) } = error else { panic!("{error}") };
    assert!((other + 1.0).abs() < 1e-9 && searched > 9e3, "{other} {searched}");
    assert!(error.to_string().starts_with("the load stretches the structure"), "{error}");
}

#[test]
fn a_search_is_ended_from_outside() {
    for most in [0, 1, 17] {
        let mut watch = |effort: &implicit_statics::Effort| {
            if effort.solves < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        let options = BucklingOptions::new(3);
        let ended = implicit_statics::linear_buckling(&mut dense(500), 0.0, &options, &mut watch).map(|_| ());
        let others = implicit_statics::natural_modes(&mut dense(500), 0.0, 3, 0.0, &mut watch).map(|_| ());
        for ended in [ended, others] {
            let Err(EquilibriumError::Stopped { solves }) = ended else { panic!("{ended:?}") };
            assert!((most..most + 4).contains(&solves), "{solves} solves, four of which are one, for {most}");
        }
    }
}

#[test]
fn stresses_alone_need_a_system_that_tells_them() {
    let options = BucklingOptions { prebuckling: Prebuckling::Stress, ..BucklingOptions::new(1) };
    let refused = implicit_statics::linear_buckling(&mut dense(10), 0.0, &options, &mut unwatched);
    assert_eq!(refused, Err(EquilibriumError::Inseparable));
}
