//! The sparse symmetric solver: symbolic.rs, dense.rs and the factor beside it are the only other files that see faer.

use faer::sparse::linalg::cholesky::SymbolicCholesky;
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};

use crate::EquilibriumError;
use crate::factor::Factor;
use crate::inertia::Inertia;
use crate::pattern::columns;
use crate::rank_one::RankOne;
use crate::symbolic::{analyse, multiplications};
use crate::vectors::{dot, norm, unstructured};
use crate::woodbury::Terms;

/// A pivot below this, after scaling to a unit diagonal, asks for the exact count of vanishing eigenvalues.
const SMALL_PIVOT: f64 = 1e-13;
/// Eigenvalues of the scaled matrix within ± this count as zero.
const ZERO_EIGENVALUE: f64 = 1e-12;
/// A diagonal entry below this share of the largest is rounding, not the stiffness of an unknown in other units.
const NO_STIFFNESS: f64 = 1e-15;
/// Largest entry of `|L||D||L|ᵀ` in units of the largest of the matrix up to which pivots need no exchange: the rounding of the
/// factor is then that of eigenvalues that count as zero.
const GROWTH: f64 = 100.0;
/// Residual in units of rounding of the product `|K||x|` that refinement would leave as it is.
const SETTLED: f64 = 4.0;
/// Residual guard relative to the right side.
const GUARD: f64 = 1e-8;
/// Residual guard in units of rounding of the product `|K||x|`: no solver can do better than that.
const GUARD_ROUNDINGS: f64 = 256.0;
/// Inverse iterations from a vector without structure to the null direction.
const NULL_ITERATIONS: usize = 4;

/// `K = L D Lᵀ`, and where that is not stable `K = L B Lᵀ` with Bunch–Kaufman pivots \[bunch1977\] inside supernodes, for one
/// fixed sparsity.
///
/// Ordering and symbolic factor are made once. Rows and columns are scaled by powers of two towards a unit
/// diagonal, which leaves the inertia and makes "zero" independent of units. Constraints must
/// be eliminated: pivots stay inside supernodes and saddle points lose accuracy, which the residual guard tells.
pub struct SymmetricSolver {
    unknowns: usize,
    matrix: SymbolicSparseColMat<usize>,
    slots: Vec<usize>,
    values: Vec<f64>,
    first: Vec<f64>,
    scale: Vec<f64>,
    peak: f64,
    symbolic: SymbolicCholesky<usize>,
    factor: Factor,
    inertia: Inertia,
    /// What the matrix has beside its pattern.
    terms: Terms,
}

impl SymmetricSolver {
    /// Orders and analyses a pattern: lower triangle with the whole diagonal, each entry once, any order.
    pub fn new(unknowns: usize, pattern: &[(usize, usize)]) -> Result<Self, EquilibriumError> {
        Self::placed(unknowns, pattern, None)
    }

    /// The same where the places of the unknowns are known: elimination goes along the body or by nested dissection, whichever
    /// multiplies less; without places by approximate minimum degree.
    pub fn placed(
        unknowns: usize,
        pattern: &[(usize, usize)],
        places: Option<&[[f64; 3]]>,
    ) -> Result<Self, EquilibriumError> {
        let (pointers, rows, slots) = columns(unknowns, pattern)?;
        let matrix = SymbolicSparseColMat::new_checked(unknowns, unknowns, pointers, None, rows);
        let symbolic = analyse(&matrix, places);
        Ok(Self {
            unknowns,
            values: vec![0.0; matrix.compute_nnz()],
            first: vec![0.0; unknowns],
            scale: vec![1.0; unknowns],
            peak: 1.0,
            factor: Factor::new(&symbolic, matrix.as_ref()),
            inertia: Inertia::default(),
            terms: Terms::default(),
            matrix,
            slots,
            symbolic,
        })
    }

    /// Entries of the factor, a measure of its cost.
    pub fn factor_entries(&self) -> usize {
        self.factor.entries()
    }

    /// Multiplications of one factorisation, its cost.
    pub fn multiplications(&self) -> f64 {
        multiplications(&self.symbolic)
    }

    /// Factorises for values in the order of the pattern.
    ///
    /// A singular matrix is no error here: its zeros are counted, and [`SymmetricSolver::solve`] refuses.
    pub fn factor(&mut self, values: &[f64]) -> Result<Inertia, EquilibriumError> {
        self.factor_with(values, &[])
    }

    /// The same of a matrix with terms beside its pattern.
    pub fn factor_with(&mut self, values: &[f64], terms: &[RankOne]) -> Result<Inertia, EquilibriumError> {
        if values.len() != self.slots.len() {
            let (length, expected) = (values.len(), self.slots.len());
            return Err(EquilibriumError::Length { name: "tangent values", length, expected });
        }
        for (&slot, &value) in self.slots.iter().zip(values) {
            self.values[slot] = value;
        }
        self.equilibrate()?;
        self.inertia = match self.factorise(0.0) {
            Some(inertia) => inertia,
            None => self.singular_inertia(),
        };
        self.terms = Terms::scaled(terms, &self.scale);
        if self.inertia.zero == 0 && !self.terms.is_empty() {
            let Self { factor, terms, .. } = self;
            self.inertia = terms.complete(self.inertia, |right| factor.substitute([right]));
        }
        Ok(self.inertia)
    }

    /// Inertia of the last factor.
    pub fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// Scaling `s` of the last factor: the solver sees `s_i K_ij s_j`; `v/s` and `s f` are free of units.
    pub fn scale(&self) -> &[f64] {
        &self.scale
    }

    /// Whether there is a factor to solve with.
    pub(crate) fn is_regular(&self) -> bool {
        self.inertia != Inertia::default() && self.inertia.zero == 0
    }

    /// The first stiffness that each unknown had, to which [`SymmetricSolver::scale`] refers.
    pub(crate) fn first_stiffness(&self) -> &[f64] {
        &self.first
    }

    /// Takes other stiffnesses for the first ones; zeros are found anew. The present factor stays as it is.
    pub(crate) fn refer_to(&mut self, first: &[f64]) {
        self.first.copy_from_slice(first);
    }

    /// Solves `K x = b` in place, with one step of refinement where more than rounding is left, and the guard
    /// ‖Kx − b‖ ≤ 1e-8 ‖b‖, or 256 roundings of |K||x| where the condition of K makes that the larger.
    pub fn solve(&mut self, right: &mut [f64]) -> Result<(), EquilibriumError> {
        self.solve_all([right])
    }

    /// The same for several right sides, which read the factor once: for each the same bits as alone.
    pub fn solve_all<const R: usize>(&mut self, mut rights: [&mut [f64]; R]) -> Result<(), EquilibriumError> {
        if self.inertia.zero > 0 {
            return Err(self.singular());
        }
        for right in &mut rights {
            right.iter_mut().zip(&self.scale).for_each(|(f, s)| *f *= s);
        }
        let scaled: [Vec<f64>; R] = std::array::from_fn(|r| rights[r].to_vec());
        self.backsolve(rights.each_mut().map(|right| &mut **right));
        for (right, scaled) in rights.into_iter().zip(&scaled) {
            let (residual, rounding) = self.residual(scaled, right);
            let mut left = self.force_norm(&residual);
            if left > SETTLED * rounding {
                let mut refined = residual;
                self.backsolve([&mut refined]);
                refined.iter_mut().zip(&*right).for_each(|(more, x)| *more += x);
                let after = self.force_norm(&self.residual(scaled, &refined).0);
                if after <= left {
                    right.copy_from_slice(&refined);
                    left = after;
                }
            }
            let bound = (GUARD * self.force_norm(scaled)).max(GUARD_ROUNDINGS * rounding);
            right.iter_mut().zip(&self.scale).for_each(|(x, s)| *x *= s);
            if left.is_nan() || left > bound {
                return Err(EquilibriumError::Solve { residual: left, bound });
            }
        }
        Ok(())
    }

    /// `b − K̂ x` with the scaled matrix, and the rounding of its sums, ε ‖ |K̂| |x| ‖: the matrix is read once.
    fn residual(&self, right: &[f64], x: &[f64]) -> (Vec<f64>, f64) {
        let (mut left, mut sizes) = (right.to_vec(), vec![0.0; self.unknowns]);
        let symbolic = self.matrix.as_ref();
        for (j, &xj) in x.iter().enumerate() {
            // The diagonal opens its column.
            let mut column = symbolic.col_range(j);
            let own = column.next().map_or(0.0, |k| self.values[k] * xj);
            let (mut sum, mut size) = (own, own.abs());
            for (&i, value) in symbolic.row_idx()[column.clone()].iter().zip(&self.values[column]) {
                let (there, here) = (value * xj, value * x[i]);
                left[i] -= there;
                sizes[i] += there.abs();
                sum += here;
                size += here.abs();
            }
            left[j] -= sum;
            sizes[j] += size;
        }
        for term in self.terms.iter() {
            term.add_product(-1.0, x, &mut left);
            term.add_magnitudes(x, &mut sizes);
        }
        let rounding = f64::EPSILON * self.force_norm(&sizes);
        (left, rounding)
    }

    /// `out = K x` with the values of the last factor.
    pub fn product(&self, x: &[f64], out: &mut [f64]) {
        let scaled: Vec<f64> = x.iter().zip(&self.scale).map(|(x, s)| x / s).collect();
        out.fill(0.0);
        self.subtract_product(&scaled, out);
        for i in 0..self.unknowns {
            out[i] /= -self.scale[i];
        }
    }

    /// ε ‖ |K| |x| ‖: rounding that evaluating forces of this stiffness at this displacement cannot avoid \[F\].
    pub fn rounding(&self, x: &[f64]) -> f64 {
        self.rounding_of(&x.iter().zip(&self.scale).map(|(x, s)| x / s).collect::<Vec<f64>>())
    }

    /// The same of a scaled displacement.
    fn rounding_of(&self, x: &[f64]) -> f64 {
        let mut sums = vec![0.0; self.unknowns];
        self.for_entries(|i, j, value| {
            sums[i] += (value * x[j]).abs();
            if i != j {
                sums[j] += (value * x[i]).abs();
            }
        });
        self.terms.iter().for_each(|term| term.add_magnitudes(x, &mut sums));
        f64::EPSILON * self.force_norm(&sums)
    }

    /// `xᵀ K x` with the values of the last factor.
    pub fn quadratic(&self, x: &[f64]) -> f64 {
        let mut image = vec![0.0; self.unknowns];
        self.product(x, &mut image);
        dot(x, &image)
    }

    /// Direction of the eigenvalue of least magnitude of the scaled matrix, by inverse iteration with the
    /// present factor: `s φ̂` with ‖φ̂‖ = 1.
    pub fn weakest_direction(&mut self) -> Vec<f64> {
        let mut direction = unstructured(self.unknowns, 0);
        for _ in 0..NULL_ITERATIONS {
            self.backsolve([&mut direction]);
            let norm = norm(&direction);
            direction.iter_mut().for_each(|d| *d /= norm);
        }
        direction.iter_mut().zip(&self.scale).for_each(|(d, s)| *d *= s);
        direction
    }

    fn singular(&mut self) -> EquilibriumError {
        let direction = self.weakest_direction();
        let share = |i: usize| (direction[i] / self.scale[i]).abs();
        let unknown = (0..self.unknowns).fold(0, |best, i| if share(i) > share(best) { i } else { best });
        EquilibriumError::Singular { zero: self.inertia.zero, unknown, share: share(unknown) }
    }

    /// Counts eigenvalues below −δ and below +δ by two shifted factors; keeps a factor that can be solved with.
    fn singular_inertia(&mut self) -> Inertia {
        let shifted = |solver: &mut Self, shift: f64| {
            solver.factorise(shift).unwrap_or_else(|| solver.factor.count_pivots().0).negative
        };
        let below_plus = shifted(self, -ZERO_EIGENVALUE * self.peak);
        let negative = shifted(self, ZERO_EIGENVALUE * self.peak);
        let zero = below_plus.saturating_sub(negative);
        if zero == 0 {
            self.factorise(0.0);
        }
        Inertia { positive: self.unknowns - negative - zero, negative, zero }
    }

    /// Scales by the first stiffness each unknown had, so that one that loses its stiffness later is seen.
    fn equilibrate(&mut self) -> Result<(), EquilibriumError> {
        let symbolic = self.matrix.as_ref();
        for j in 0..self.unknowns {
            let column = symbolic.col_range(j);
            if let Some(k) = column.clone().find(|&k| !self.values[k].is_finite()) {
                return Err(EquilibriumError::Tangent { row: symbolic.row_idx()[k], column: j });
            }
            if self.first[j] == 0.0 {
                self.first[j] = self.values[column.start].abs(); // the diagonal opens its column
            }
        }
        self.peak = 1.0;
        let top = self.first.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        for (scale, &first) in self.scale.iter_mut().zip(&self.first) {
            let stiffness = if first > NO_STIFFNESS * top { first } else { top };
            *scale = power_of_two(1.0 / stiffness.sqrt());
        }
        for j in 0..self.unknowns {
            for k in symbolic.col_range(j) {
                self.values[k] *= self.scale[symbolic.row_idx()[k]] * self.scale[j];
            }
            self.peak = self.peak.max(self.values[symbolic.col_range(j).start].abs());
        }
        Ok(())
    }

    /// Factors the scaled matrix plus a multiple of one; `None` when a pivot is too small to trust its sign.
    fn factorise(&mut self, shift: f64) -> Option<Inertia> {
        let shifted: Vec<f64>;
        let values = if shift == 0.0 {
            &self.values
        } else {
            let mut copy = self.values.clone();
            for j in 0..self.unknowns {
                copy[self.matrix.as_ref().col_range(j).start] += shift;
            }
            shifted = copy;
            &shifted
        };
        let trusted = SMALL_PIVOT * self.peak;
        self.factor.eliminate(values);
        let (inertia, smallest) = self.factor.count_pivots();
        let definite = inertia.negative == 0;
        if smallest > trusted && (definite || self.factor.growth() < GROWTH * self.peak) {
            return Some(inertia);
        }
        let matrix = SparseColMatRef::new(self.matrix.as_ref(), &values[..]);
        self.factor.eliminate_pivoted(&self.symbolic, matrix);
        let (inertia, smallest) = self.factor.count_pivots();
        (smallest > trusted).then_some(inertia)
    }

    fn backsolve<const R: usize>(&self, mut rights: [&mut [f64]; R]) {
        self.factor.substitute(rights.each_mut().map(|right| &mut **right));
        rights.into_iter().for_each(|right| self.terms.correct(right));
    }

    /// `out −= K̂ x` with the scaled matrix.
    fn subtract_product(&self, x: &[f64], out: &mut [f64]) {
        self.for_entries(|i, j, value| {
            out[i] -= value * x[j];
            if i != j {
                out[j] -= value * x[i];
            }
        });
        self.terms.iter().for_each(|term| term.add_product(-1.0, x, out));
    }

    fn for_entries(&self, mut visit: impl FnMut(usize, usize, f64)) {
        let symbolic = self.matrix.as_ref();
        for j in 0..self.unknowns {
            for k in symbolic.col_range(j) {
                visit(symbolic.row_idx()[k], j, self.values[k]);
            }
        }
    }

    /// Norm of a scaled force in unscaled units.
    fn force_norm(&self, scaled: &[f64]) -> f64 {
        scaled.iter().zip(&self.scale).map(|(f, s)| (f / s) * (f / s)).sum::<f64>().sqrt()
    }
}

fn power_of_two(value: f64) -> f64 {
    f64::from_bits(value.to_bits() & 0x7ff0_0000_0000_0000)
}
