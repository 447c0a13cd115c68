//! The sparse solver against dense eigenvalues, and what it says of singular matrices.

use implicit_statics::{EquilibriumError, Inertia, SymmetricSolver};
use nalgebra::{DMatrix, DVector};

/// A reproducible stream of numbers in (−1, 1) (Knuth's MMIX generator).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

type Pattern = Vec<(usize, usize)>;

fn dense(n: usize, pattern: &Pattern, values: &[f64]) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(n, n);
    for (&(i, j), &v) in pattern.iter().zip(values) {
        matrix[(i, j)] = v;
        matrix[(j, i)] = v;
    }
    matrix
}

/// A sparse symmetric indefinite matrix with about `row` entries a row below the diagonal, in shuffled order.
fn indefinite(n: usize, row: usize, numbers: &mut Numbers) -> (Pattern, Vec<f64>) {
    let mut pattern: Pattern = (0..n).map(|i| (i, i)).collect();
    for i in 1..n {
        for _ in 0..row {
            let j = ((numbers.next().abs() * i as f64) as usize).min(i - 1);
            if !pattern.contains(&(i, j)) {
                pattern.insert(((i * 7) % pattern.len()).max(1), (i, j));
            }
        }
    }
    let values = pattern.iter().map(|_| numbers.next()).collect();
    (pattern, values)
}

#[test]
fn inertia_equals_the_dense_count_and_solutions_satisfy_their_equations() {
    let mut numbers = Numbers(1);
    for n in [1, 2, 3, 5, 8, 13, 30, 60, 120] {
        for row in [0, 1, 3, 8] {
            let (pattern, values) = indefinite(n, row, &mut numbers);
            let matrix = dense(n, &pattern, &values);
            let eigenvalues = matrix.clone().symmetric_eigenvalues();
            let negative = eigenvalues.iter().filter(|e| **e < 0.0).count();
            let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
            let inertia = solver.factor(&values).unwrap();
            assert_eq!(inertia, Inertia { positive: n - negative, negative, zero: 0 }, "{n} {row}");

            let exact = DVector::from_fn(n, |_, _| numbers.next());
            let right = &matrix * &exact;
            let mut x = right.as_slice().to_vec();
            solver.solve(&mut x).unwrap();
            let residual = (&matrix * DVector::from_column_slice(&x) - &right).norm();
            assert!(residual <= 1e-12 * right.norm(), "{n} {row} {residual:e}");
            let mut image = vec![0.0; n];
            solver.product(exact.as_slice(), &mut image);
            assert!((DVector::from_column_slice(&image) - &right).norm() <= 1e-13 * (1.0 + right.norm()));
        }
    }
}

#[test]
fn units_of_the_unknowns_do_not_change_the_count() {
    let mut numbers = Numbers(2);
    let n = 40;
    let (pattern, mut values) = indefinite(n, 3, &mut numbers);
    for (&(i, j), value) in pattern.iter().zip(&mut values) {
        if i == j {
            *value += 0.5 * value.signum(); // no unknown without a stiffness of its own
        }
    }
    let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
    let plain = solver.factor(&values).unwrap();
    let unit = |i: usize| if i.is_multiple_of(2) { 1e-6 } else { 1.0 };
    let scaled: Vec<f64> = pattern.iter().zip(&values).map(|(&(i, j), v)| unit(i) * v * unit(j)).collect();
    let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
    assert_eq!(solver.factor(&scaled).unwrap(), plain);
}

/// A chain of equal springs, held at `held` ends.
fn chain(n: usize, held: usize) -> (Pattern, Vec<f64>) {
    let pattern: Pattern = (0..n).map(|i| (i, i)).chain((1..n).map(|i| (i, i - 1))).collect();
    let end = |i: usize| if (i == 0 && held < 1) || (i == n - 1 && held < 2) { 1.0 } else { 2.0 };
    let values = pattern.iter().map(|&(i, j)| if i == j { end(i) } else { -1.0 }).collect();
    (pattern, values)
}

#[test]
fn a_free_chain_is_singular_and_never_solved() {
    for n in [2, 3, 10, 200] {
        let (pattern, values) = chain(n, 0);
        let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
        let inertia = solver.factor(&values).unwrap();
        assert_eq!(inertia, Inertia { positive: n - 1, negative: 0, zero: 1 }, "{n}");
        let mut x = vec![1.0; n];
        let error = solver.solve(&mut x).unwrap_err();
        let EquilibriumError::Singular { zero: 1, share, .. } = error else { panic!("{error}") };
        assert!((share - 1.0 / (n as f64).sqrt()).abs() < 0.3, "{n} {share}");
        // the same solver recovers with other values
        let (_, values) = chain(n, 2);
        assert_eq!(solver.factor(&values).unwrap().positive, n);
        solver.solve(&mut x).unwrap();
    }
}

#[test]
fn an_empty_row_is_counted_and_named() {
    let pattern: Pattern = vec![(0, 0), (1, 1), (2, 2), (2, 0)];
    let mut solver = SymmetricSolver::new(3, &pattern).unwrap();
    let inertia = solver.factor(&[2.0, 0.0, -3.0, 1.0]).unwrap();
    assert_eq!(inertia, Inertia { positive: 1, negative: 1, zero: 1 });
    let error = solver.solve(&mut [1.0, 1.0, 1.0]).unwrap_err();
    let EquilibriumError::Singular { zero: 1, unknown: 1, share } = error else { panic!("{error}") };
    assert!(share > 0.999);
    assert_eq!(solver.factor(&[0.0; 4]).unwrap().zero, 3);
}

/// A chain with a few multipliers fits into merged supernodes and is solved; larger ones are not promised.
#[test]
fn a_small_saddle_point_is_solved() {
    let n = 60;
    let multipliers = 20;
    let mut pattern: Pattern = (0..n + multipliers).map(|i| (i, i)).collect();
    pattern.extend((1..n).map(|i| (i, i - 1)));
    pattern.extend((0..multipliers).flat_map(|m| [(n + m, 3 * m), (n + m, 3 * m + 1)]));
    let values: Vec<f64> = pattern
        .iter()
        .map(|&(i, j)| match (i == j, i >= n) {
            (true, false) => 2.0,
            (true, true) => 0.0,
            (false, true) => {
                if j % 3 == 0 {
                    1.0
                } else {
                    -1.0
                }
            }
            (false, false) => -1.0,
        })
        .collect();
    let matrix = dense(n + multipliers, &pattern, &values);
    let mut solver = SymmetricSolver::new(n + multipliers, &pattern).unwrap();
    solver.factor(&values).unwrap();
    let right = DVector::from_fn(n + multipliers, |i, _| libm::sin(i as f64));
    let mut x = right.as_slice().to_vec();
    solver.solve(&mut x).unwrap();
    let residual = (&matrix * DVector::from_column_slice(&x) - &right).norm();
    assert!(residual <= 1e-12 * right.norm());
}

/// Unknowns almost without stiffness, each tied to others of a full block: their pivots want to leave their
/// supernodes, the factor grows, and the residual guard sees it. The count of signs survives.
#[test]
fn the_residual_guard_refuses_what_growth_has_spoilt() {
    let (loose, block) = (40, 100);
    for stiffness in [0.0, 1e-16, 1e-14, 1e-12] {
        let mut pattern = Pattern::new();
        let mut values = Vec::new();
        for l in 0..loose {
            pattern.push((l, l));
            values.push(stiffness);
            for b in (0..block).filter(|b| (l * 13 + b * b * 7) % 11 < 4) {
                pattern.push((loose + b, l));
                values.push(1.0 + 0.3 * libm::sin((l * b) as f64));
            }
        }
        for i in 0..block {
            for j in 0..=i {
                pattern.push((loose + i, loose + j));
                values.push(if i == j { 30.0 } else { libm::cos((i * j) as f64) });
            }
        }
        let n = loose + block;
        let eigenvalues = dense(n, &pattern, &values).symmetric_eigenvalues();
        let negative = eigenvalues.iter().filter(|e| **e < 0.0).count();
        let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
        let inertia = solver.factor(&values).unwrap();
        assert_eq!(inertia, Inertia { positive: n - negative, negative, zero: 0 });
        let error = solver.solve(&mut vec![1.0; n]).unwrap_err();
        assert!(matches!(error, EquilibriumError::Solve { .. }), "{error}");
        assert!(error.to_string().contains("eliminate constraints"));
    }
}

#[test]
fn faulty_patterns_and_values_are_refused() {
    let faulty = |pattern: &[(usize, usize)]| SymmetricSolver::new(2, pattern).err().unwrap().to_string();
    assert!(faulty(&[(0, 0)]).contains("entry (1, 1) of 2 unknowns is missing"));
    assert!(faulty(&[(0, 0), (1, 1), (0, 1)]).contains("is above the diagonal"));
    assert!(faulty(&[(0, 0), (1, 1), (1, 0), (1, 0)]).contains("is there twice"));
    assert!(faulty(&[(0, 0), (1, 1), (2, 0)]).contains("is outside"));
    assert!(SymmetricSolver::new(0, &[]).is_err());

    let mut solver = SymmetricSolver::new(2, &[(0, 0), (1, 1), (1, 0)]).unwrap();
    let error = solver.factor(&[1.0, 2.0, f64::NAN]).unwrap_err();
    assert_eq!(error, EquilibriumError::Tangent { row: 1, column: 0 });
    assert!(solver.factor(&[1.0]).is_err());
}

#[test]
fn factors_repeat_to_the_last_bit() {
    let mut numbers = Numbers(5);
    let (pattern, values) = indefinite(80, 4, &mut numbers);
    let solve = || {
        let mut solver = SymmetricSolver::new(80, &pattern).unwrap();
        solver.factor(&values).unwrap();
        let mut x = vec![1.0; 80];
        solver.solve(&mut x).unwrap();
        x
    };
    assert_eq!(solve(), solve());
}

#[test]
fn rounding_is_that_of_the_forces() {
    let mut numbers = Numbers(5);
    let (n, (pattern, values)) = (30, indefinite(30, 3, &mut numbers));
    let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
    solver.factor(&values).unwrap();
    let x: Vec<f64> = (0..n).map(|_| numbers.next()).collect();
    let thousandfold: Vec<f64> = x.iter().map(|x| 1000.0 * x).collect();
    let (once, larger) = (solver.rounding(&x), solver.rounding(&thousandfold));
    assert!(once > 0.0 && (larger / once - 1000.0).abs() < 1e-9, "{once:e} {larger:e}");
    assert_eq!(solver.rounding(&vec![0.0; n]), 0.0);
}

/// A lattice of points that couple over two spacings, numbered at random, with a matrix of positive eigenvalues.
fn lattice(counts: [usize; 3], numbers: &mut Numbers) -> (Vec<[f64; 3]>, Pattern, Vec<f64>) {
    let mut places = Vec::new();
    for i in 0..counts[0] * counts[1] * counts[2] {
        let (x, rest) = (i % counts[0], i / counts[0]);
        places.push([x, rest % counts[1], rest / counts[1]].map(|k| k as f64));
    }
    for i in (1..places.len()).rev() {
        places.swap(i, (numbers.next().abs() * i as f64) as usize);
    }
    let (mut pattern, mut values) = (Vec::new(), Vec::new());
    for (i, a) in places.iter().enumerate() {
        for (j, b) in places[..=i].iter().enumerate() {
            if (0..3).all(|k| (a[k] - b[k]).abs() < 2.5) {
                pattern.push((i, j));
                values.push(if i == j { 125.0 } else { numbers.next() });
            }
        }
    }
    (places, pattern, values)
}

#[test]
fn the_order_by_places_costs_less_and_changes_no_answer() {
    let mut numbers = Numbers(3);
    for (counts, share) in [([60, 4, 4], 0.9), ([11, 11, 11], 1.15)] {
        let (places, pattern, values) = lattice(counts, &mut numbers);
        let n = places.len();
        let force: Vec<f64> = (0..n).map(|_| numbers.next()).collect();
        let solve = |places: Option<&[[f64; 3]]>| {
            let mut solver = SymmetricSolver::placed(n, &pattern, places).unwrap();
            let inertia = solver.factor(&values).unwrap();
            assert_eq!(inertia, Inertia { positive: n, negative: 0, zero: 0 });
            let mut answer = force.clone();
            solver.solve(&mut answer).unwrap();
            (answer, solver.multiplications())
        };
        let (by_degree, by_places) = (solve(None), solve(Some(&places)));
        let ratio = by_places.1 / by_degree.1;
        assert!(ratio < share, "{counts:?}: {ratio} of the multiplications of minimum degree");
        let worst =
            by_places.0.iter().zip(&by_degree.0).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(worst < 1e-14, "{worst:e}"); // answers near 1/125, the condition number is near two
        // unknowns at one place are not divided
        let (same, _) = solve(Some(&vec![[0.0; 3]; n]));
        let worst = same.iter().zip(&by_degree.0).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(worst < 1e-14, "{worst:e}");
    }
}
