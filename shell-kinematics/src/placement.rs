//! The five vectors of a point, their scalar products, and the transpose of those products.

use crate::pack::{Number, Pack, Pack3};

/// The first-order neighbourhood of a point of the shell.
///
/// A point at height ζ above the mid-surface lies at `x + ζ d` (`X = X_p + ζV`, eqs. 5–6 of
/// \[lin2013\]). Derivatives are taken along two orthonormal tangents of the *reference* surface,
/// so `x,α` and `d` are dimensionless and `d,α` is \[1/L\].
#[derive(Clone, Copy, Debug, Default)]
pub struct Placement<P = Pack> {
    /// `x,1`, the tangent along the first reference direction \[–\].
    pub x1: Pack3<P>,
    /// `x,2` \[–\].
    pub x2: Pack3<P>,
    /// The director `d` \[–\] (the paper's pseudo-normal V; sampled between particles it is a little shorter than one).
    pub d: Pack3<P>,
    /// `d,1` \[1/L\].
    pub d1: Pack3<P>,
    /// `d,2` \[1/L\].
    pub d2: Pack3<P>,
}

/// Scalar products of a [`Placement`]; their changes from the reference are the Green–Lagrange strains.
#[derive(Clone, Copy, Debug, Default)]
pub struct Measures<P = Pack> {
    /// `½ x,1·x,1`, `½ x,2·x,2`, `x,1·x,2` \[–\].
    pub membrane: [P; 3],
    /// `x,1·d,1`, `x,2·d,2`, `x,1·d,2 + x,2·d,1` \[1/L\].
    pub curvature: [P; 3],
    /// `x,1·d`, `x,2·d` \[–\].
    pub shear: [P; 2],
}

/// Derivatives of the energy per area with respect to the [`Measures`], in the same order.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeasureForces<P = Pack> {
    /// \[F/L\].
    pub membrane: [P; 3],
    /// \[F\].
    pub curvature: [P; 3],
    /// \[F/L\].
    pub shear: [P; 2],
}

/// Derivatives of the energy per area with respect to the vectors of a [`Placement`].
#[derive(Clone, Copy, Debug, Default)]
pub struct PlacementForces<P = Pack> {
    /// To `x,1`: the first-Piola force resultant `n¹` \[F/L\].
    pub n1: Pack3<P>,
    /// To `x,2` \[F/L\].
    pub n2: Pack3<P>,
    /// To `d` \[F/L\].
    pub q: Pack3<P>,
    /// To `d,1`: the moment resultant `m¹` \[F\].
    pub m1: Pack3<P>,
    /// To `d,2` \[F\].
    pub m2: Pack3<P>,
}

impl<P: Number> Placement<P> {
    /// The scalar products on which every strain measure is built.
    #[inline(always)]
    pub fn measures(&self) -> Measures<P> {
        let Placement { x1, x2, d, d1, d2 } = *self;
        Measures {
            membrane: [x1.dot(x1) * 0.5, x2.dot(x2) * 0.5, x1.dot(x2)],
            curvature: [x1.dot(d1), x2.dot(d2), x1.dot(d2) + x2.dot(d1)],
            shear: [x1.dot(d), x2.dot(d)],
        }
    }

    /// Transpose of the derivative of [`Placement::measures`]: forces on the five vectors.
    #[inline(always)]
    pub fn transpose(&self, f: &MeasureForces<P>) -> PlacementForces<P> {
        let Placement { x1, x2, d, d1, d2 } = *self;
        let [s11, s22, s12] = f.membrane;
        let [b11, b22, b12] = f.curvature;
        let [q1, q2] = f.shear;
        PlacementForces {
            n1: x1 * s11 + x2 * s12 + d * q1 + d1 * b11 + d2 * b12,
            n2: x2 * s22 + x1 * s12 + d * q2 + d2 * b22 + d1 * b12,
            q: x1 * q1 + x2 * q2,
            m1: x1 * b11 + x2 * b12,
            m2: x2 * b22 + x1 * b12,
        }
    }
}

impl<P: Number> Measures<P> {
    /// Changes with respect to a reference value.
    #[inline(always)]
    pub fn change(&self, reference: &Measures<P>) -> Measures<P> {
        let (a, b) = (self, reference);
        Measures {
            membrane: [
                a.membrane[0] - b.membrane[0],
                a.membrane[1] - b.membrane[1],
                a.membrane[2] - b.membrane[2],
            ],
            curvature: [
                a.curvature[0] - b.curvature[0],
                a.curvature[1] - b.curvature[1],
                a.curvature[2] - b.curvature[2],
            ],
            shear: [a.shear[0] - b.shear[0], a.shear[1] - b.shear[1]],
        }
    }
}
