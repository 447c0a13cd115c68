//! Divergence consistency: the smallest change of the gradients after which a constant flux sums to the edge normals.

use crate::error::SpaceError;
use crate::sampling::correction::monomials;
use crate::sampling::operator::SamplingOperator;
use crate::surface::cloud::{Cloud, check_length};

/// Entries change in proportion to their kernel weight, but no less than this part of the greatest one.
const SMALLEST_WEIGHT: f64 = 1e-4;

/// Regularisation relative to the mean diagonal: fixes the free multipliers, disturbs the others by this part.
const REGULARISATION: f64 = 1e-9;

/// Relative residual at which the conjugate gradients stop.
const TOLERANCE: f64 = 1e-10;

/// Residual over spacing that counts as none.
const NEGLIGIBLE: f64 = 1e-9;

/// Solutions at most; each after the first removes what the regularisation of the one before has left.
const PASSES: usize = 4;

/// A monomial whose remainder after orthogonalisation is smaller than this (relative) depends on the others.
const DEPENDENT: f64 = 1e-8;

/// What [`make_divergence_consistent`] did. Residuals are the largest `|T_b·(Σ_p w_p G − r_b)|` over the mean spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConsistencyReport {
    /// Conjugate-gradient iterations.
    pub iterations: usize,
    /// Residual of the operator as given, dimensionless.
    pub residual_before: f64,
    /// Residual of the operator as changed, dimensionless.
    pub residual_after: f64,
}

/// Changes G so that for every particle b and both its tangents `T_βb·Σ_p w_p (G₁ t₁ + G₂ t₂) = T_βb·r_b`.
///
/// `r_b` are the cloud's edge normals, zero inside: the discrete divergence theorem, which lets a constant stress be in
/// equilibrium with its edge tractions. Among all such changes the one with least `Σ δG²/ω` is taken (ω: kernel
/// weights), and every point keeps polynomials up to its order exact; `orders` has one entry, or one per point. The
/// multipliers solve `(C Q Cᵀ + ε) λ = residual` with `Q = Ω − ΩBᵀ(BΩBᵀ)⁺BΩ` per point, by conjugate gradients with
/// Jacobi scaling, and `δG = Q Cᵀλ`.
///
/// The conditions contradict each other where areas and edges do not integrate the polynomials that the rows keep:
/// order 2 needs weights exact on linear functions, order 3 on quadratic ones (Gregory end weights on a lattice), and
/// a curved lattice has flat cells inside exact edges (a residual of second order in the spacing). What remains then
/// is reported; judge it. The number of iterations grows with the number of particles in a row.
pub fn make_divergence_consistent(
    operator: &mut SamplingOperator,
    cloud: &Cloud,
    orders: &[u8],
) -> Result<ConsistencyReport, SpaceError> {
    check_length("particles of operator and cloud", operator.particle_count, cloud.len())?;
    if orders.len() != 1 {
        check_length("orders", orders.len(), operator.points.len())?;
    }
    let system = Conditions::new(operator, cloud, orders);
    let largest = |residual: &[f64]| residual.iter().fold(0.0, |m: f64, r| m.max(r.abs())) / cloud.spacing();
    let mut missing = system.residual(operator, cloud);
    let residual_before = largest(&missing);
    let mut report = ConsistencyReport { iterations: 0, residual_before, residual_after: residual_before };
    for _ in 0..PASSES {
        if report.residual_after <= NEGLIGIBLE {
            break;
        }
        let (multipliers, iterations) = system.solve(&missing, 0.1 * NEGLIGIBLE * cloud.spacing())?;
        let (change1, change2) = system.spread(&multipliers);
        system.add(&mut operator.g1, change1);
        system.add(&mut operator.g2, change2);
        missing = system.residual(operator, cloud);
        report.iterations += iterations;
        let previous = std::mem::replace(&mut report.residual_after, largest(&missing));
        if report.residual_after > 0.1 * previous {
            break; // what is left contradicts the rows
        }
    }
    Ok(report)
}

/// The linear conditions C on the gradient numbers, and the projection Q on changes that keep rows exact.
///
/// Multipliers and residuals are stored as 2b + β.
struct Conditions {
    offsets: Vec<u32>,
    particles: Vec<u32>,
    /// `w_p T_βb·t_α` of each entry, as `[[t₁·T₁, t₁·T₂], [t₂·T₁, t₂·T₂]]`.
    tangents: Vec<[[f64; 2]; 2]>,
    /// Root of ω of each entry.
    roots: Vec<f64>,
    /// For each point orthonormal rows that span √Ω Bᵀ, one after the other.
    bases: Vec<f64>,
    base_offsets: Vec<usize>,
    unknowns: usize,
}

impl Conditions {
    fn new(operator: &SamplingOperator, cloud: &Cloud, orders: &[u8]) -> Conditions {
        let mut conditions = Conditions {
            offsets: operator.offsets.clone(),
            particles: operator.particles.clone(),
            tangents: Vec::with_capacity(operator.particles.len()),
            roots: operator.kernel_weights.iter().map(|w| w.max(SMALLEST_WEIGHT).sqrt()).collect(),
            bases: Vec::new(),
            base_offsets: vec![0],
            unknowns: 2 * cloud.len(),
        };
        for (p, point) in operator.points.iter().enumerate() {
            let entries = operator.entries(p);
            let mut plane = Vec::new();
            for &b in &operator.particles[entries.clone()] {
                let (own, arm) = (&cloud.frames[b as usize], cloud.positions[b as usize] - point.position);
                let along = |t: crate::Vec3| [point.weight * t.dot(&own.t1), point.weight * t.dot(&own.t2)];
                conditions.tangents.push([along(point.frame.t1), along(point.frame.t2)]);
                plane.push([arm.dot(&point.frame.t1), arm.dot(&point.frame.t2)]);
            }
            let order = if orders.len() == 1 { orders[0] } else { orders[p] };
            let roots = &conditions.roots[entries];
            conditions.bases.extend(orthonormal_rows(&plane, roots, order));
            conditions.base_offsets.push(conditions.bases.len());
        }
        conditions
    }

    /// `T_βb·(r_b − Σ_p w_p G)`: what the operator misses.
    fn residual(&self, operator: &SamplingOperator, cloud: &Cloud) -> Vec<f64> {
        let mut residual = self.collect(&operator.g1, &operator.g2);
        for (b, (frame, r)) in cloud.frames.iter().zip(&cloud.edge_normals).enumerate() {
            residual[2 * b] = frame.t1.dot(r) - residual[2 * b];
            residual[2 * b + 1] = frame.t2.dot(r) - residual[2 * b + 1];
        }
        residual
    }

    /// C G.
    fn collect(&self, g1: &[f64], g2: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.unknowns];
        for (entry, &b) in self.particles.iter().enumerate() {
            let [along1, along2] = self.tangents[entry];
            for beta in 0..2 {
                sums[2 * b as usize + beta] += along1[beta] * g1[entry] + along2[beta] * g2[entry];
            }
        }
        sums
    }

    /// Q Cᵀ λ, for both components of G.
    fn spread(&self, multipliers: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let component = |alpha: usize| {
            let mut change: Vec<f64> = self
                .particles
                .iter()
                .enumerate()
                .map(|(entry, &b)| {
                    let tangent = self.tangents[entry][alpha];
                    let b = 2 * b as usize;
                    self.roots[entry] * (tangent[0] * multipliers[b] + tangent[1] * multipliers[b + 1])
                })
                .collect();
            self.keep_rows(&mut change);
            change.iter_mut().zip(&self.roots).for_each(|(g, root)| *g *= root);
            change
        };
        (component(0), component(1))
    }

    /// Removes from `scaled`, a change over √ω, what would alter the sums that rows keep exact.
    fn keep_rows(&self, scaled: &mut [f64]) {
        for p in 0..self.offsets.len() - 1 {
            let entries = self.offsets[p] as usize..self.offsets[p + 1] as usize;
            let count = entries.len().max(1);
            let change = &mut scaled[entries];
            self.bases(p).chunks_exact(count).for_each(|row| remove(change, row));
        }
    }

    /// Adds `change` to the gradient numbers `g`, cleaned of rounding: contradicting conditions make large multipliers.
    fn add(&self, g: &mut [f64], mut change: Vec<f64>) {
        change.iter_mut().zip(&self.roots).for_each(|(change, root)| *change /= root);
        self.keep_rows(&mut change);
        g.iter_mut().zip(change.iter().zip(&self.roots)).for_each(|(g, (change, root))| *g += root * change);
    }

    /// Orthonormal rows of point `p`, one after the other.
    fn bases(&self, p: usize) -> &[f64] {
        &self.bases[self.base_offsets[p]..self.base_offsets[p + 1]]
    }

    /// Diagonal of C Q Cᵀ.
    fn diagonal(&self) -> Vec<f64> {
        let mut diagonal = vec![0.0; self.unknowns];
        for p in 0..self.offsets.len() - 1 {
            let first = self.offsets[p] as usize;
            let count = self.offsets[p + 1] as usize - first;
            for k in 0..count {
                let kept: f64 = self.bases(p).chunks_exact(count).map(|row| row[k] * row[k]).sum();
                let free = self.roots[first + k].powi(2) * (1.0 - kept).max(0.0);
                let [along1, along2] = self.tangents[first + k];
                for beta in 0..2 {
                    diagonal[2 * self.particles[first + k] as usize + beta] +=
                        free * (along1[beta] * along1[beta] + along2[beta] * along2[beta]);
                }
            }
        }
        diagonal
    }

    /// Multipliers λ of `(C Q Cᵀ + ε) λ = target`, and the number of iterations; residuals below `least` need no work.
    fn solve(&self, target: &[f64], least: f64) -> Result<(Vec<f64>, usize), SpaceError> {
        let mut diagonal = self.diagonal();
        let shift = REGULARISATION * diagonal.iter().sum::<f64>() / self.unknowns.max(1) as f64;
        diagonal.iter_mut().for_each(|d| *d += shift);
        let mut multipliers = vec![0.0; self.unknowns];
        let goal = (TOLERANCE * dot(target, target).sqrt()).max(least);
        if shift == 0.0 {
            return Ok((multipliers, 0)); // triangles only: nothing can be changed
        }
        let scaled = |r: &[f64]| -> Vec<f64> { r.iter().zip(&diagonal).map(|(r, d)| r / d).collect() };
        let mut residual = target.to_vec();
        let mut preconditioned = scaled(&residual);
        let mut direction = preconditioned.clone();
        let mut energy = dot(&residual, &preconditioned);
        let limit = 1000 + 10 * self.unknowns;
        for iteration in 1..=limit {
            let (g1, g2) = self.spread(&direction);
            let mut image = self.collect(&g1, &g2);
            image.iter_mut().zip(&direction).for_each(|(y, x)| *y += shift * x);
            let step = energy / dot(&direction, &image);
            for i in 0..self.unknowns {
                multipliers[i] += step * direction[i];
                residual[i] -= step * image[i];
            }
            if dot(&residual, &residual).sqrt() <= goal {
                return Ok((multipliers, iteration));
            }
            preconditioned = scaled(&residual);
            let next = dot(&residual, &preconditioned);
            for i in 0..self.unknowns {
                direction[i] = preconditioned[i] + next / energy * direction[i];
            }
            energy = next;
        }
        let residual = TOLERANCE * dot(&residual, &residual).sqrt() / goal;
        Err(SpaceError::NotConverged { iterations: limit, residual, bound: TOLERANCE })
    }
}

/// Orthonormal rows that span `√ω (1, ξ, η, …)` up to `order`, by Gram–Schmidt done twice; dependent rows drop out,
/// which makes the pseudo-inverse of `BΩBᵀ` exact.
fn orthonormal_rows(plane: &[[f64; 2]], roots: &[f64], order: u8) -> Vec<f64> {
    let size = plane.iter().map(|x| libm::hypot(x[0], x[1])).fold(0.0, f64::max);
    let mut rows: Vec<f64> = Vec::new();
    for (i, j) in std::iter::once((0, 0)).chain(monomials(order)) {
        let mut row: Vec<f64> =
            plane.iter().zip(roots).map(|(x, w)| w * (x[0] / size).powi(i) * (x[1] / size).powi(j)).collect();
        let length = dot(&row, &row).sqrt();
        for _ in 0..2 {
            rows.chunks_exact(plane.len()).for_each(|earlier| remove(&mut row, earlier));
        }
        let rest = dot(&row, &row).sqrt();
        if rest > DEPENDENT * length {
            rows.extend(row.iter().map(|x| x / rest));
        }
    }
    rows
}

/// Removes from `vector` its part along the unit vector `row`.
fn remove(vector: &mut [f64], row: &[f64]) {
    let part = dot(vector, row);
    vector.iter_mut().zip(row).for_each(|(x, r)| *x -= part * r);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
