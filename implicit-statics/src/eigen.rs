//! A few extreme eigenpairs of a large operator that is symmetric in some inner product.

use crate::BalanceError;
use crate::solver::dense_eigen;
use crate::vectors::{dot, unstructured};

/// Krylov blocks in one sweep.
const DEPTH: usize = 4;
/// Vectors beyond those wanted, so that multiple eigenvalues are not missed.
const SPARE: usize = 4;
/// Sweeps allowed.
const SWEEPS: usize = 60;
/// Residual ‖Av − θv‖ relative to the eigenvalue; its error is the square of this.
const TOLERANCE: f64 = 1e-7;
/// Residual accepted when the eigenvalues have come to rest: rounding of the solves, not lack of sweeps.
const TOLERANCE_AT_REST: f64 = 1e-4;
/// Relative change of an eigenvalue at rest.
const REST: f64 = 1e-13;
/// A vector shorter than this share after orthogonalisation adds nothing.
const DEPENDENT: f64 = 1e-10;

/// An operator symmetric in the inner product `aᵀ G b`, `G` positive (semi-)definite.
pub(crate) trait Operator {
    /// `out = A v`.
    fn apply(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), BalanceError>;
    /// `out = G v`.
    fn weigh(&mut self, v: &[f64], out: &mut [f64]);
}

/// Which end of the spectrum is wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extreme {
    /// Largest magnitudes.
    Magnitude,
    /// Largest values, positive only.
    Positive,
}

/// Eigenpairs (θ, v) with `vᵀGv = 1`, by restarted block Krylov sweeps with full orthogonalisation and
/// Rayleigh–Ritz \[parlett1998\]. Fewer than wanted come back where no more (positive) ones exist.
pub(crate) fn extreme_pairs(
    operator: &mut dyn Operator,
    unknowns: usize,
    wanted: usize,
    extreme: Extreme,
) -> Result<Vec<(f64, Vec<f64>)>, BalanceError> {
    let block = (wanted + SPARE).min(unknowns);
    let mut start: Vec<Vec<f64>> = Vec::new();
    for k in 0..block {
        let mut image = vec![0.0; unknowns];
        operator.apply(&unstructured(unknowns, k), &mut image)?;
        start.push(image);
    }
    let mut before: Vec<f64> = Vec::new();
    let mut worst = f64::INFINITY;
    for sweep in 1..=SWEEPS {
        let (basis, images) = krylov_basis(operator, start)?;
        let pairs = ritz(operator, &basis, &images, extreme);
        let exhausted = basis.len() >= unknowns || basis.len() < block * DEPTH;
        let found = pairs.len().min(wanted);
        worst = pairs[..found].iter().map(|p| p.residual / p.value.abs()).fold(0.0, f64::max);
        let values: Vec<f64> = pairs[..found].iter().map(|p| p.value).collect();
        let rest = values.len() == before.len()
            && values.iter().zip(&before).all(|(a, b)| (a - b).abs() <= REST * a.abs());
        if found > 0
            && (worst <= TOLERANCE || (rest && worst <= TOLERANCE_AT_REST))
            && (found == wanted || rest || exhausted)
        {
            return Ok(pairs.into_iter().take(found).map(|p| (p.value, p.vector)).collect());
        }
        if found == 0 && (exhausted || sweep > SWEEPS / 4) {
            return Err(BalanceError::Modes {
                found,
                wanted,
                sweeps: sweep,
                residual: worst,
                bound: TOLERANCE,
            });
        }
        before = values;
        start = pairs.into_iter().take(block).map(|p| p.vector).collect();
        while start.len() < block {
            start.push(unstructured(unknowns, sweep * block + start.len()));
        }
    }
    let found = before.len();
    Err(BalanceError::Modes { found, wanted, sweeps: SWEEPS, residual: worst, bound: TOLERANCE })
}

/// A basis of vectors.
type Basis = Vec<Vec<f64>>;

/// G-orthonormal basis of span{X, AX, … } and its image under A.
fn krylov_basis(operator: &mut dyn Operator, start: Basis) -> Result<(Basis, Basis), BalanceError> {
    let (mut basis, mut weighted, mut images): (Basis, Basis, Basis) = Default::default();
    let mut block = start;
    for _ in 0..DEPTH {
        let from = basis.len();
        for vector in block {
            orthogonalise(operator, vector, &mut basis, &mut weighted);
        }
        for vector in &basis[from..] {
            let mut image = vec![0.0; vector.len()];
            operator.apply(vector, &mut image)?;
            images.push(image);
        }
        block = images[from..].to_vec();
    }
    Ok((basis, images))
}

/// Adds what a vector has beyond the basis, by Gram–Schmidt done twice.
fn orthogonalise(operator: &mut dyn Operator, mut vector: Vec<f64>, basis: &mut Basis, weighted: &mut Basis) {
    let mut image = vec![0.0; vector.len()];
    operator.weigh(&vector, &mut image);
    let length = dot(&vector, &image).max(0.0).sqrt();
    for _ in 0..2 {
        for (b, gb) in basis.iter().zip(weighted.iter()) {
            let share = dot(&vector, gb);
            vector.iter_mut().zip(b).for_each(|(v, b)| *v -= share * b);
        }
    }
    operator.weigh(&vector, &mut image);
    let rest = dot(&vector, &image).max(0.0).sqrt();
    if rest > DEPENDENT * length {
        basis.push(vector.iter().map(|v| v / rest).collect());
        weighted.push(image.iter().map(|g| g / rest).collect());
    }
}

struct Pair {
    value: f64,
    vector: Vec<f64>,
    residual: f64,
}

/// Rayleigh–Ritz pairs, the wanted end first.
fn ritz(operator: &mut dyn Operator, basis: &Basis, images: &Basis, extreme: Extreme) -> Vec<Pair> {
    let (m, n) = (basis.len(), basis[0].len());
    let mut small = vec![0.0; m * m];
    let mut weighted = vec![0.0; n];
    for j in 0..m {
        operator.weigh(&images[j], &mut weighted);
        for i in 0..m {
            let entry = 0.5 * dot(&basis[i], &weighted);
            small[i + j * m] += entry;
            small[j + i * m] += entry;
        }
    }
    let (values, vectors) = dense_eigen(m, &small);
    let mut order: Vec<usize> =
        (0..m).filter(|&k| extreme == Extreme::Magnitude || values[k] > 0.0).collect();
    order.sort_by(|&a, &b| values[b].abs().total_cmp(&values[a].abs()));
    let combine = |k: usize, of: &Basis| {
        let mut sum = vec![0.0; n];
        for (j, vector) in of.iter().enumerate() {
            let share = vectors[j + k * m];
            sum.iter_mut().zip(vector).for_each(|(s, v)| *s += share * v);
        }
        sum
    };
    let mut pairs = Vec::with_capacity(order.len());
    for k in order {
        let (value, vector) = (values[k], combine(k, basis));
        let mut left = combine(k, images);
        left.iter_mut().zip(&vector).for_each(|(l, v)| *l -= value * v);
        operator.weigh(&left, &mut weighted);
        let residual = dot(&left, &weighted).max(0.0).sqrt();
        pairs.push(Pair { value, vector, residual });
    }
    pairs
}
