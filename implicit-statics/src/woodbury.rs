//! Solutions and signs of pivots of a tangent with terms beside its pattern, by the factor of the pattern alone.
//!
//! With `K̄ = K + Σ c g gᵀ`, G the vectors side by side and C their numbers on a diagonal (Sherman, Morrison and Woodbury
//! \[hager1989\]; Sylvester's law on the matrix bordered by G and −C⁻¹ \[haynsworth1968\]):
//!
//! ```text
//! S = C⁻¹ + Gᵀ K⁻¹ G        K̄⁻¹ b = K⁻¹ b − K⁻¹ G S⁻¹ Gᵀ K⁻¹ b
//! negative eigenvalues:   n(K̄) = n(K) + p(S) − p(C)
//! ```
//!
//! n and p count what is below and above zero. A term costs one solve more with each factor, and two products of vectors a solve.

use crate::dense::dense_eigen;
use crate::inertia::Inertia;
use crate::rank_one::RankOne;
use crate::vectors::dot;

/// An eigenvalue of S below this share of its largest part counts as zero.
const ZERO: f64 = 1e-12;

/// Terms beside a factor.
#[derive(Default)]
pub(crate) struct Terms {
    terms: Vec<RankOne>,
    /// `K⁻¹ g` of each.
    answers: Vec<Vec<f64>>,
    /// `S⁻¹`, row by row.
    inverse: Vec<f64>,
}

impl Terms {
    /// Terms in scaled unknowns `x / s`; those that are zero are left out.
    pub fn scaled(terms: &[RankOne], scale: &[f64]) -> Self {
        let own = |term: &RankOne| RankOne {
            along: term.along.iter().zip(scale).map(|(g, s)| g * s).collect(),
            ..*term
        };
        let acts = |term: &&RankOne| term.factor != 0.0 && term.along.iter().any(|&g| g != 0.0);
        Self { terms: terms.iter().filter(acts).map(own).collect(), ..Self::default() }
    }

    /// Solves for the terms by the factor of K; the inertia of K̄ from that of K.
    pub fn complete(&mut self, inertia: Inertia, mut solve: impl FnMut(&mut [f64])) -> Inertia {
        let count = self.terms.len();
        let answer = |term: &RankOne| {
            let mut answer = term.along.clone();
            solve(&mut answer);
            answer
        };
        self.answers = self.terms.iter().map(answer).collect();
        let mut sums = vec![0.0; count * count];
        let mut largest = 0.0_f64;
        for i in 0..count {
            for j in 0..=i {
                let own = if i == j { 1.0 / self.terms[i].factor } else { 0.0 };
                let through = dot(&self.terms[i].along, &self.answers[j]);
                largest = largest.max(own.abs()).max(through.abs());
                (sums[i + j * count], sums[j + i * count]) = (own + through, own + through);
            }
        }
        let (values, vectors) = dense_eigen(count, &sums);
        let zero = values.iter().filter(|value| value.abs() <= ZERO * largest).count();
        let above = values.iter().filter(|&&value| value > ZERO * largest).count();
        self.inverse = vec![0.0; count * count];
        for (value, vector) in values.iter().zip(vectors.chunks_exact(count.max(1))) {
            // Of a singular one what is left points along its null direction.
            let value = if value.abs() > ZERO * largest { *value } else { ZERO * largest };
            for i in 0..count {
                for j in 0..count {
                    self.inverse[i * count + j] += vector[i] * vector[j] / value;
                }
            }
        }
        let stiffening = self.terms.iter().filter(|term| term.factor > 0.0).count();
        let negative = (inertia.negative + above).saturating_sub(stiffening);
        let unknowns = inertia.positive + inertia.negative + inertia.zero;
        Inertia { positive: unknowns - negative - zero, negative, zero }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Turns `K⁻¹ b` into `K̄⁻¹ b`.
    pub fn correct(&self, solved: &mut [f64]) {
        let count = self.terms.len();
        let along: Vec<f64> = self.terms.iter().map(|term| dot(&term.along, solved)).collect();
        for (row, answer) in self.inverse.chunks_exact(count.max(1)).zip(&self.answers) {
            let share = dot(row, &along);
            solved.iter_mut().zip(answer).for_each(|(sum, part)| *sum -= share * part);
        }
    }

    /// The terms in scaled unknowns.
    pub fn iter(&self) -> impl Iterator<Item = &RankOne> {
        self.terms.iter()
    }
}
