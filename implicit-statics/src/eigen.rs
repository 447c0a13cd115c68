//! Eigenpairs at one end of the spectrum of a large operator that is symmetric in some inner product.
//!
//! Block Lanczos with thick restarts \[wu2000\]: one vector after the other is multiplied and made orthogonal to all
//! others, so that a block of any width, restarts and invariant subspaces are one and the same loop. Kept Ritz vectors
//! stay in the basis, converged or not; full orthogonalisation leaves no copies \[parlett1998\].

use crate::EquilibriumError;
use crate::dense::dense_eigen;
use crate::vectors::{dot, unstructured};

/// Vectors of a block: eigenvalues of this multiplicity are found at once, others after a restart with a fresh vector.
pub(crate) const BLOCK: usize = 4;
/// Vectors multiplied between two restarts, beyond twice those wanted.
const SPARE: usize = 24;
/// Restarts allowed.
const RESTARTS: usize = 40;
/// Error bound of an eigenvalue asked for, relative; its error is about the square of this.
pub(crate) const TOLERANCE: f64 = 1e-8;
/// Error bound accepted when the eigenvalues have come to rest: rounding of the solves, not lack of vectors.
const TOLERANCE_AT_REST: f64 = 1e-4;
/// Relative change of an eigenvalue at rest.
const REST: f64 = 1e-13;
/// A vector shorter than this share after orthogonalisation adds nothing.
const DEPENDENT: f64 = 1e-10;

/// An operator symmetric in the inner product `aᵀ G b`, `G` positive (semi-)definite.
pub(crate) trait Operator {
    /// `v ← A v` for some vectors at once, each as if alone.
    fn apply(&mut self, vectors: &mut [Vec<f64>]) -> Result<(), EquilibriumError>;
    /// `out = G v`.
    fn weigh(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), EquilibriumError>;
}

/// Which end of the spectrum is wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// Largest magnitudes.
    Magnitude,
    /// Largest values.
    Largest,
    /// Least values.
    Least,
}

/// An approximate eigenpair within the basis.
pub(crate) struct Ritz {
    /// θ.
    pub value: f64,
    /// ‖Av − θv‖ in the norm of G, with ‖v‖ = 1: an eigenvalue lies so near.
    pub residual: f64,
    /// Shares of the basis in the vector.
    shares: Vec<f64>,
    /// What its image has in the vectors not yet multiplied.
    tail: Vec<f64>,
}

/// A G-orthonormal basis of which the first vectors have been multiplied.
pub(crate) struct Krylov {
    unknowns: usize,
    basis: Vec<Vec<f64>>,
    /// `basisᵀ G A b` for each vector b that has been multiplied.
    columns: Vec<Vec<f64>>,
    /// Whether no vector is left that is not in the span.
    complete: bool,
    seed: usize,
}

impl Krylov {
    /// Starts from images of given vectors, filled up to a block with vectors without structure.
    pub fn new(
        operator: &mut dyn Operator,
        unknowns: usize,
        start: &[Vec<f64>],
    ) -> Result<Self, EquilibriumError> {
        let mut krylov = Self { unknowns, basis: Vec::new(), columns: Vec::new(), complete: false, seed: 0 };
        for vector in start {
            krylov.add_image(operator, vector)?;
        }
        krylov.freshen(operator, BLOCK.saturating_sub(start.len()).max(1))?;
        Ok(krylov)
    }

    /// Adds images of vectors without structure.
    pub fn freshen(&mut self, operator: &mut dyn Operator, number: usize) -> Result<(), EquilibriumError> {
        for _ in 0..number.min(self.unknowns) {
            self.seed += 1;
            self.add_image(operator, &unstructured(self.unknowns, self.seed))?;
        }
        Ok(())
    }

    fn add_image(&mut self, operator: &mut dyn Operator, vector: &[f64]) -> Result<bool, EquilibriumError> {
        let mut images = [vector.to_vec()];
        operator.apply(&mut images)?;
        let [image] = images;
        Ok(self.orthogonalise(operator, image)?.1)
    }

    /// Adds what a vector has beyond the basis, by Gram–Schmidt done twice; gives its components and whether it had.
    fn orthogonalise(
        &mut self,
        operator: &mut dyn Operator,
        mut vector: Vec<f64>,
    ) -> Result<(Vec<f64>, bool), EquilibriumError> {
        let mut weighted = vec![0.0; self.unknowns];
        let mut components = vec![0.0; self.basis.len()];
        operator.weigh(&vector, &mut weighted)?;
        let length = dot(&vector, &weighted).max(0.0).sqrt();
        for _ in 0..2 {
            let shares: Vec<f64> = self.basis.iter().map(|b| dot(b, &weighted)).collect();
            for ((b, share), component) in self.basis.iter().zip(&shares).zip(&mut components) {
                vector.iter_mut().zip(b).for_each(|(v, b)| *v -= share * b);
                *component += share;
            }
            operator.weigh(&vector, &mut weighted)?;
        }
        let rest = dot(&vector, &weighted).max(0.0).sqrt();
        let adds = rest > DEPENDENT * length;
        if adds {
            components.push(rest);
            vector.iter_mut().for_each(|v| *v /= rest);
            self.basis.push(vector);
        }
        Ok((components, adds))
    }

    /// Multiplies until so many vectors are, or until no vector is left that is not in the span.
    pub fn grow(&mut self, operator: &mut dyn Operator, to: usize) -> Result<(), EquilibriumError> {
        while self.columns.len() < to {
            let next = self.columns.len();
            if next == self.basis.len() {
                self.freshen(operator, 1)?;
                if next == self.basis.len() {
                    self.complete = true;
                    break;
                }
            }
            let mut images = self.basis[next..self.basis.len().min(to)].to_vec();
            operator.apply(&mut images)?;
            for image in images {
                let (column, _) = self.orthogonalise(operator, image)?;
                self.columns.push(column);
            }
        }
        Ok(())
    }

    /// Whether the basis is all there is: its Ritz pairs are eigenpairs.
    pub fn complete(&self) -> bool {
        self.complete
    }

    /// Rayleigh–Ritz pairs of the vectors multiplied so far, the wanted end first.
    pub fn ritz(&self, end: End) -> Vec<Ritz> {
        let done = self.columns.len();
        let mut small = vec![0.0; done * done];
        for (j, column) in self.columns.iter().enumerate() {
            for i in 0..=j {
                small[i + j * done] = column[i];
                small[j + i * done] = column[i];
            }
        }
        let (values, vectors) = dense_eigen(done, &small);
        let mut order: Vec<usize> = (0..done).collect();
        match end {
            End::Magnitude => order.sort_by(|&a, &b| values[b].abs().total_cmp(&values[a].abs())),
            End::Largest => order.reverse(),
            End::Least => {}
        }
        let pair = |k: usize| {
            let shares = vectors[k * done..(k + 1) * done].to_vec();
            let mut tail = vec![0.0; self.basis.len() - done];
            for (column, share) in self.columns.iter().zip(&shares) {
                for (t, c) in tail.iter_mut().zip(column.get(done..).unwrap_or_default()) {
                    *t += share * c;
                }
            }
            Ritz { value: values[k], residual: dot(&tail, &tail).sqrt(), shares, tail }
        };
        order.into_iter().map(pair).collect()
    }

    /// The vector of a Ritz pair.
    pub fn vector(&self, ritz: &Ritz) -> Vec<f64> {
        let mut sum = vec![0.0; self.unknowns];
        for (vector, share) in self.basis.iter().zip(&ritz.shares) {
            sum.iter_mut().zip(vector).for_each(|(s, v)| *s += share * v);
        }
        sum
    }

    /// Keeps the first Ritz vectors and those not yet multiplied.
    pub fn restart(&mut self, ritz: &[Ritz]) {
        let kept: Vec<Vec<f64>> = ritz.iter().map(|pair| self.vector(pair)).collect();
        let tail = self.basis.split_off(self.columns.len());
        self.columns = (ritz.iter().enumerate())
            .map(|(k, pair)| {
                let mut column = vec![0.0; kept.len()];
                column[k] = pair.value;
                column.extend(&pair.tail);
                column
            })
            .collect();
        self.basis = kept;
        self.basis.extend(tail);
    }

    /// Vectors multiplied before a restart where so many pairs are wanted.
    pub fn depth(wanted: usize) -> usize {
        2 * wanted + SPARE
    }

    /// Multiplies and restarts until the wanted pairs have error bounds that suffice, `bound` giving the relative one.
    ///
    /// Fewer come back where the space is exhausted. `bound` is infinite for a value that cannot be one of those wanted.
    pub fn converge(
        &mut self,
        operator: &mut dyn Operator,
        wanted: usize,
        end: End,
        bound: &dyn Fn(&Ritz) -> f64,
    ) -> Result<Vec<Ritz>, EquilibriumError> {
        let depth = Self::depth(wanted);
        let mut before: Vec<f64> = Vec::new();
        let (mut worst, mut found) = (f64::INFINITY, 0);
        for _ in 0..RESTARTS {
            while !self.complete && self.columns.len() < depth {
                let step = BLOCK.max(self.columns.len() / 4);
                self.grow(operator, (self.columns.len() + step).min(depth))?;
                let ritz = self.ritz(end);
                if ritz.len() >= wanted && ritz[..wanted].iter().all(|pair| bound(pair) <= TOLERANCE) {
                    return Ok(ritz);
                }
            }
            let ritz = self.ritz(end);
            let first = &ritz[..wanted.min(ritz.len())];
            worst = first.iter().map(bound).fold(0.0, f64::max);
            found = first.iter().filter(|pair| bound(pair) <= TOLERANCE).count();
            let values: Vec<f64> = first.iter().map(|pair| pair.value).collect();
            let rest = values.len() == before.len()
                && values.iter().zip(&before).all(|(a, b)| (a - b).abs() <= REST * a.abs());
            if self.complete || (rest && worst <= TOLERANCE_AT_REST) {
                return Ok(ritz);
            }
            before = values;
            self.restart(&ritz[..(wanted + SPARE / 2).min(ritz.len())]);
            // Beyond the width of the block the copies of a multiple eigenvalue show themselves by rounding alone.
            self.freshen(operator, 1)?;
        }
        Err(EquilibriumError::Modes { found, wanted, residual: worst, bound: TOLERANCE })
    }
}
