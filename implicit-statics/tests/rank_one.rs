//! Tangents with terms beside their pattern, held against the dense matrix.

mod common;

use common::{Flat, Softening};
use implicit_statics::{
    BucklingOptions, ConjugateOptions, Equilibrium, EquilibriumError, Inertia, RankOne, SymmetricSolver,
    conjugate_response, linear_buckling, natural_modes, tangent_error, unwatched,
};
use nalgebra::{DMatrix, DVector};

/// A reproducible stream of numbers in (−1, 1) (Knuth's MMIX generator).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A chain of springs with a stiffness of either sign at each link, fixed at one end, and terms over all of it.
struct Chain {
    links: Vec<f64>,
    terms: Vec<RankOne>,
    q: Vec<f64>,
}

impl Chain {
    fn new(n: usize, terms: usize, softer: bool, numbers: &mut Numbers) -> Self {
        let links = (0..n).map(|_| 1.5 + numbers.next() - if softer { 1.2 } else { 0.0 }).collect();
        let mut term =
            || RankOne { factor: 3.0 * numbers.next(), along: (0..n).map(|_| numbers.next()).collect() };
        Self { links, terms: (0..terms).map(|_| term()).collect(), q: vec![0.0; n] }
    }

    fn dense(&mut self) -> DMatrix<f64> {
        let n = self.links.len();
        let (pattern, mut values) = (self.pattern(), vec![0.0; 2 * n - 1]);
        self.tangent(0.0, &mut values);
        let mut matrix = DMatrix::zeros(n, n);
        for (&(i, j), &value) in pattern.iter().zip(&values) {
            (matrix[(i, j)], matrix[(j, i)]) = (value, value);
        }
        for term in &self.terms {
            let g = DVector::from_column_slice(&term.along);
            matrix += &g * g.transpose() * term.factor;
        }
        matrix
    }
}

impl Equilibrium for Chain {
    fn unknowns(&self) -> usize {
        self.links.len()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        let n = self.links.len();
        (0..n).map(|i| (i, i)).chain((1..n).map(|i| (i, i - 1))).collect()
    }

    fn internal(&mut self, _: f64, out: &mut [f64]) {
        let n = self.links.len();
        out.fill(0.0);
        for i in 0..n {
            let pull = self.links[i] * (self.q[i] - if i > 0 { self.q[i - 1] } else { 0.0 });
            out[i] += pull;
            if i > 0 {
                out[i - 1] -= pull;
            }
        }
        let q = self.q.clone();
        self.terms.iter().for_each(|term| term.add_product(1.0, &q, out));
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        out.fill(level);
    }

    fn load_rate(&mut self, _: f64, out: &mut [f64]) {
        out.fill(1.0);
    }

    fn tangent(&mut self, _: f64, values: &mut [f64]) {
        let n = self.links.len();
        for i in 0..n {
            values[i] = self.links[i] + self.links.get(i + 1).copied().unwrap_or(0.0);
        }
        (1..n).for_each(|i| values[n + i - 1] = -self.links[i]);
    }

    fn beside_pattern(&mut self, _: f64) -> Vec<RankOne> {
        self.terms.clone()
    }

    fn update(&mut self, increment: &[f64]) {
        self.q.iter_mut().zip(increment).for_each(|(q, d)| *q += d);
    }

    fn save(&self) -> Vec<f64> {
        self.q.clone()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.q.copy_from_slice(saved);
    }

    fn energy(&mut self) -> f64 {
        0.0
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.links.len()]
    }

    fn name_unknown(&self, unknown: usize) -> String {
        format!("link {unknown}")
    }
}

/// One to three terms of either sign, on tangents with negative eigenvalues too, in units of any size.
#[test]
fn terms_beside_the_pattern_are_those_of_the_dense_matrix() {
    let mut numbers = Numbers(11);
    let mut worst = [0.0_f64; 3];
    let mut fewer = 0;
    for trial in 0..300 {
        let (n, terms) = (2 + trial % 23, 1 + trial % 3);
        let mut chain = Chain::new(n, terms, trial % 2 == 0, &mut numbers);
        let matrix = chain.dense();
        let negative = matrix.clone().symmetric_eigenvalues().iter().filter(|e| **e < 0.0).count();
        let mut values = vec![0.0; 2 * n - 1];
        chain.tangent(0.0, &mut values);
        let mut solver = SymmetricSolver::new(n, &chain.pattern()).unwrap();
        let alone = solver.factor(&values).unwrap();
        let inertia = solver.factor_with(&values, &chain.terms).unwrap();
        assert_eq!(inertia, Inertia { positive: n - negative, negative, zero: 0 }, "{trial}");
        fewer += usize::from(inertia.negative < alone.negative);
        let exact = DVector::from_fn(n, |_, _| numbers.next());
        let right = &matrix * &exact;
        let mut x = right.as_slice().to_vec();
        solver.solve(&mut x).unwrap();
        let residual = (&matrix * DVector::from_column_slice(&x) - &right).norm() / right.norm();
        let mut image = vec![0.0; n];
        solver.product(exact.as_slice(), &mut image);
        let product = (DVector::from_column_slice(&image) - &right).norm() / right.norm();
        let along = exact.as_slice();
        let work = (solver.quadratic(along) - exact.dot(&right)).abs() / right.norm();
        worst = std::array::from_fn(|k| worst[k].max([residual, product, work][k]));
        // Without the terms the factor is again that of the pattern alone.
        assert_eq!(solver.factor(&values).unwrap(), alone);
    }
    println!("residual, product, work: {worst:?}; terms that make stable: {fewer} of 300");
    assert!(fewer > 20);
    // Rounding of matrices of up to 24 rows, the worst-conditioned of 300.
    assert!(worst.iter().all(|&miss| miss < 1e-13), "{worst:?}");
}

/// A term that takes the last stiffness away: one eigenvalue vanishes, and nothing is solved.
#[test]
fn a_term_may_make_the_whole_singular() {
    let (pattern, values) = ([(0, 0), (1, 1)], [2.0, 4.0]);
    let mut solver = SymmetricSolver::new(2, &pattern).unwrap();
    let term = RankOne { factor: -2.0, along: vec![1.0, 0.0] };
    let inertia = solver.factor_with(&values, &[term]).unwrap();
    assert_eq!(inertia, Inertia { positive: 1, negative: 0, zero: 1 });
    match solver.solve(&mut [1.0, 1.0]).unwrap_err() {
        EquilibriumError::Singular { zero: 1, unknown: 0, share } => assert!((share - 1.0).abs() < 1e-12),
        other => panic!("{other}"),
    }
}

/// The frequencies of the dense matrix, some of them found at all because inertia counts the terms.
#[test]
fn modes_are_those_of_the_whole() {
    let mut numbers = Numbers(5);
    let mut chain = Chain::new(40, 2, false, &mut numbers);
    chain.terms.iter_mut().for_each(|term| term.factor = term.factor.abs());
    let mut all: Vec<f64> = chain.dense().symmetric_eigenvalues().iter().copied().collect();
    all.sort_by(f64::total_cmp);
    let modes = natural_modes(&mut chain, 0.0, 6, 0.0, &mut unwatched).unwrap().modes;
    let miss = |(mode, exact): (&implicit_statics::Mode, &f64)| (mode.eigenvalue / exact - 1.0).abs();
    let worst = modes.iter().zip(&all).map(miss).fold(0.0, f64::max);
    println!("six frequencies squared: {worst:e}");
    assert!(worst < 1e-12, "rounding of forty springs: {worst:e}");
}

/// The whole tangent is the derivative of the forces; what has no place for terms says so.
#[test]
fn derivatives_know_the_terms_and_buckling_refuses_them() {
    let mut chain = Chain::new(9, 2, false, &mut Numbers(3));
    let direction: Vec<f64> = (0..9).map(|i| 1.0 - 0.2 * f64::from(i)).collect();
    assert!(tangent_error(&mut chain, 0.3, &direction, 1e-3) < 1e-10);
    let refused = linear_buckling(&mut chain, 0.0, &BucklingOptions::new(1), &mut unwatched).unwrap_err();
    assert!(matches!(refused, EquilibriumError::BesidePattern { what: "linear buckling", .. }), "{refused}");
    // A system that tells no rigid motions is refused before; one without terms is not refused at all.
    assert!(conjugate_response(&mut chain, 0.0, &ConjugateOptions::default()).is_err());
    let mut plain = Flat::new(Softening);
    assert!(plain.beside_pattern(0.0).is_empty());
}
