//! Moving least squares on nodes in space: shape functions that reproduce a polynomial basis, with exact gradients.
//!
//! At a point x with the nodes x_I in its support \[belytschko1996\]
//!
//! ```text
//! φ_I = w_I p(ξ_I)·a       ∂φ_I/∂x_k = w_I p(ξ_I)·b_k + ∂_k w_I p(ξ_I)·a        ξ_I = (x_I − x)/s
//! M a = e₀                 M b_k = e_k/s_k − (∂M/∂x_k) a                        M = Σ_I w_I p pᵀ
//! ```
//!
//! The basis is centred at the point and scaled by the radii s of the support; ∂M/∂x_k differentiates the weights alone. The
//! shape functions are not one at their own node: a parameter is no displacement.

use crate::Vec3;
use crate::kernel::Kernel;
use crate::neighbours::CellList;

/// Greatest condition number (1-norm) of a moment matrix that is accepted.
const CONDITION_BOUND: f64 = 1e12;
/// Most terms of a basis.
const MOST: usize = 17;

/// The polynomials that the shape functions reproduce.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// `1, x, y, z`.
    Linear,
    /// All ten monomials up to degree two.
    Quadratic,
    /// The quadratic basis with `x³, x²y, xy², y³, x²z, xyz, y²z`, where z is the axis across a thin part and x, y are the
    /// two after it: a deflection of degree three with the rotations that follow it.
    Plate17 {
        /// Axis across the part, 0 to 2.
        across: usize,
    },
}

impl Basis {
    /// Number of monomials.
    pub fn terms(&self) -> usize {
        match self {
            Self::Linear => 4,
            Self::Quadratic => 10,
            Self::Plate17 { .. } => 17,
        }
    }

    /// Values of the monomials at ξ; the first four are `1, ξ₁, ξ₂, ξ₃`.
    fn values(&self, xi: [f64; 3]) -> [f64; MOST] {
        let mut p = [0.0; MOST];
        let [x, y, z] = xi;
        p[..4].copy_from_slice(&[1.0, x, y, z]);
        if *self != Self::Linear {
            p[4..10].copy_from_slice(&[x * x, y * y, z * z, x * y, y * z, x * z]);
        }
        if let Self::Plate17 { across } = *self {
            let (u, v, h) = (xi[(across + 1) % 3], xi[(across + 2) % 3], xi[across % 3]);
            let cubic = [u * u * u, u * u * v, u * v * v, v * v * v, u * u * h, u * v * h, v * v * h];
            p[10..].copy_from_slice(&cubic);
        }
        p
    }
}

/// Where a node has weight: within these radii of the point, as an ellipsoid or as a box with a product of weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// Whether weights are products over the axes.
    pub tensor: bool,
    /// Radius along each axis \[L\].
    pub radii: [f64; 3],
}

impl Support {
    /// A ball.
    pub fn sphere(radius: f64) -> Self {
        Self { tensor: false, radii: [radius; 3] }
    }

    /// An ellipsoid along the axes.
    pub fn ellipsoid(radii: [f64; 3]) -> Self {
        Self { tensor: false, radii }
    }

    /// A box along the axes.
    pub fn tensor(radii: [f64; 3]) -> Self {
        Self { tensor: true, radii }
    }
}

/// A weight of the scaled distance r, one axis or radially; it vanishes from r = 1 on.
#[derive(Clone, Copy)]
pub enum Weight {
    /// `(1−r)⁶(6 + 36r + 82r² + 72r³ + 30r⁴ + 5r⁵)/6`, C⁴ \[wu1995\].
    Csrbf2,
    /// A smoothing kernel stretched to the support.
    Kernel(&'static dyn Kernel),
}

impl Weight {
    /// Weight and its slope at `r ≥ 0`.
    pub fn at(&self, r: f64) -> (f64, f64) {
        if r >= 1.0 {
            return (0.0, 0.0);
        }
        match self {
            Self::Csrbf2 => {
                let (e, e2) = (1.0 - r, (1.0 - r) * (1.0 - r));
                let (e5, q) =
                    (e2 * e2 * e, 6.0 + r * (36.0 + r * (82.0 + r * (72.0 + r * (30.0 + 5.0 * r)))));
                let slope = 36.0 + r * (164.0 + r * (216.0 + r * (120.0 + 25.0 * r)));
                (e5 * e * q / 6.0, e5 * (e * slope - 6.0 * q) / 6.0)
            }
            Self::Kernel(kernel) => {
                let reach = kernel.support();
                (kernel.value(r * reach), reach * kernel.slope(r * reach))
            }
        }
    }
}

/// Shape functions at one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointShape {
    /// Nodes in the support, ascending.
    pub nodes: Vec<u32>,
    /// Values φ_I.
    pub values: Vec<f64>,
    /// Gradients ∂φ_I/∂x \[1/L\].
    pub gradients: Vec<[f64; 3]>,
}

/// Why there are no shape functions.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// A radius that is no length.
    #[error("the radius of the support along axis {axis} is {value}; it must be positive and finite")]
    Radius {
        /// Axis.
        axis: usize,
        /// Its value \[L\].
        value: f64,
    },
    /// Too few nodes near a point.
    #[error(
        "the point ({:.4e}, {:.4e}, {:.4e}) has {found} nodes in its support, the basis has {terms} terms; widen the support or take a smaller basis",
        .place[0], .place[1], .place[2]
    )]
    TooFew {
        /// Where \[L\].
        place: [f64; 3],
        /// Nodes found.
        found: usize,
        /// Terms of the basis.
        terms: usize,
    },
    /// Nodes in a plane, or nearly.
    #[error(
        "the {found} nodes in the support of ({:.4e}, {:.4e}, {:.4e}) do not determine {terms} terms: the condition number is {condition:.1e}, at most 1e12 is accepted; widen the support or take a smaller basis",
        .place[0], .place[1], .place[2]
    )]
    Condition {
        /// Where \[L\].
        place: [f64; 3],
        /// Nodes found.
        found: usize,
        /// Terms of the basis.
        terms: usize,
        /// Condition number found.
        condition: f64,
    },
}

/// Moving least squares over a set of nodes.
pub struct MovingLeastSquares {
    basis: Basis,
    support: Support,
    weight: Weight,
    /// Nodes in units of the radii.
    scaled: Vec<Vec3>,
    near: CellList,
}

impl MovingLeastSquares {
    /// Sorts the nodes.
    ///
    /// # Errors
    /// [`ShapeError::Radius`].
    pub fn new(nodes: &[Vec3], basis: Basis, support: Support, weight: Weight) -> Result<Self, ShapeError> {
        for (axis, value) in support.radii.into_iter().enumerate() {
            if !(value > 0.0 && value.is_finite()) {
                return Err(ShapeError::Radius { axis, value });
            }
        }
        let scaled: Vec<Vec3> = nodes.iter().map(|x| Vec3::from_fn(|k, _| x[k] / support.radii[k])).collect();
        let near = CellList::new(&scaled, 1.0);
        Ok(Self { basis, support, weight, scaled, near })
    }

    /// Shape functions and their gradients at a point.
    ///
    /// # Errors
    /// [`ShapeError::TooFew`], [`ShapeError::Condition`].
    pub fn at(&self, place: &Vec3) -> Result<PointShape, ShapeError> {
        let radii = self.support.radii;
        let centre = Vec3::from_fn(|k, _| place[k] / radii[k]);
        let reach = if self.support.tensor { 3.0_f64.sqrt() } else { 1.0 };
        let mut found = Vec::new();
        self.near.within(&centre, reach, &mut found);
        let terms = self.basis.terms();
        let mut entries = Vec::with_capacity(found.len());
        for node in found {
            let away = self.scaled[node as usize] - centre;
            let (w, slope) = self.weigh(&away);
            if w > 0.0 {
                entries.push((node, w, slope, self.basis.values(away.into())));
            }
        }
        let (place, found) = ([place.x, place.y, place.z], entries.len());
        if found < terms {
            return Err(ShapeError::TooFew { place, found, terms });
        }
        let mut moments = [[[0.0; MOST]; MOST]; 4];
        for (_, w, slope, p) in &entries {
            for (moment, weight) in moments.iter_mut().zip([*w, slope[0], slope[1], slope[2]]) {
                for i in 0..terms {
                    for j in 0..=i {
                        moment[i][j] += weight * p[i] * p[j];
                    }
                }
            }
        }
        let [moment, slopes @ ..] = moments;
        let inverse = inverse(&moment, terms);
        let condition = norm(&moment, terms) * inverse.as_ref().map_or(f64::INFINITY, |m| norm(m, terms));
        let Some(inverse) = inverse.filter(|_| condition <= CONDITION_BOUND) else {
            return Err(ShapeError::Condition { place, found, terms, condition });
        };
        let a: [f64; MOST] = std::array::from_fn(|i| lower(&inverse, i, 0));
        // In scaled coordinates: M b_k = e_k − (∂M/∂ξ_k) a.
        let b: [[f64; MOST]; 3] = std::array::from_fn(|k| {
            let mut right = [0.0; MOST];
            for i in 0..terms {
                right[i] = -(0..terms).map(|j| lower(&slopes[k], i, j) * a[j]).sum::<f64>();
            }
            right[k + 1] += 1.0;
            std::array::from_fn(|i| (0..terms).map(|j| lower(&inverse, i, j) * right[j]).sum())
        });
        let dot = |p: &[f64; MOST], v: &[f64; MOST]| (0..terms).map(|i| p[i] * v[i]).sum::<f64>();
        let mut out = PointShape::default();
        for (node, w, slope, p) in &entries {
            let value = dot(p, &a);
            out.nodes.push(*node);
            out.values.push(w * value);
            out.gradients.push(std::array::from_fn(|k| (w * dot(p, &b[k]) + slope[k] * value) / radii[k]));
        }
        Ok(out)
    }

    /// Weight of a node this far away in units of the radii, and its slopes as the point moves along the scaled axes.
    fn weigh(&self, away: &Vec3) -> (f64, [f64; 3]) {
        if self.support.tensor {
            let [x, y, z] = [0, 1, 2].map(|k| self.weight.at(away[k].abs()));
            let sign = |k: usize| if away[k] > 0.0 { -1.0 } else { 1.0 };
            let slopes = [sign(0) * x.1 * y.0 * z.0, sign(1) * x.0 * y.1 * z.0, sign(2) * x.0 * y.0 * z.1];
            return (x.0 * y.0 * z.0, slopes);
        }
        let r = away.norm();
        let (w, slope) = self.weight.at(r);
        let along = if r > 0.0 { -slope / r } else { 0.0 };
        (w, [along * away.x, along * away.y, along * away.z])
    }
}

/// Entry of a symmetric matrix given by its lower triangle.
fn lower(matrix: &[[f64; MOST]; MOST], i: usize, j: usize) -> f64 {
    if i >= j { matrix[i][j] } else { matrix[j][i] }
}

/// 1-norm of a symmetric matrix.
fn norm(matrix: &[[f64; MOST]; MOST], n: usize) -> f64 {
    (0..n).map(|i| (0..n).map(|j| lower(matrix, i, j).abs()).sum()).fold(0.0, f64::max)
}

/// Inverse of a positive definite matrix by Cholesky's factor; both by their lower triangles.
fn inverse(matrix: &[[f64; MOST]; MOST], n: usize) -> Option<[[f64; MOST]; MOST]> {
    let mut factor = *matrix;
    for j in 0..n {
        for k in 0..j {
            for i in j..n {
                factor[i][j] -= factor[i][k] * factor[j][k];
            }
        }
        if factor[j][j] <= 0.0 || factor[j][j].is_nan() {
            return None;
        }
        let pivot = factor[j][j].sqrt();
        for i in j..n {
            factor[i][j] /= pivot;
        }
    }
    let mut out = [[0.0; MOST]; MOST];
    for c in 0..n {
        let mut x = [0.0; MOST];
        x[c] = 1.0;
        for i in c..n {
            for k in c..i {
                x[i] -= factor[i][k] * x[k];
            }
            x[i] /= factor[i][i];
        }
        for i in (c..n).rev() {
            for k in i + 1..n {
                x[i] -= factor[k][i] * x[k];
            }
            x[i] /= factor[i][i];
            out[i][c] = x[i];
        }
    }
    Some(out)
}
