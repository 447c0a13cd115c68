//! Second derivatives of a point's energy with respect to its five vectors: the tangent that statics needs.
//!
//! With measures m(v) quadratic in the vectors v, strains ε(m) and resultants σ = C ε of the section,
//!
//! ```text
//! ∂²ψ/∂v² = Aᵀ (Jᵀ C J + Σ σ ∂²ε/∂m²) A + Σ s ∂²m/∂v²,   A = ∂m/∂v,  J = ∂ε/∂m,  s = Jᵀσ
//! ```
//!
//! Components are ordered membrane 11, 22, 12; curvature 11, 22, 12; shear 1, 2. Vectors are ordered x,1 x,2 d d,1 d,2.

use crate::pack::{Pack, Pack3};
use crate::placement::{MeasureForces, Placement};

/// A matrix over strains or measures.
pub type Matrix8 = [[Pack; 8]; 8];

/// A matrix over the components of the five vectors.
pub type Matrix15 = [[Pack; 15]; 15];

/// The zero matrix over strains.
pub const ZERO8: Matrix8 = [[Pack::ZERO; 8]; 8];

/// Which two vectors each measure multiplies, and by what: `m = Σ factor v_i·v_j`.
const PRODUCTS: [&[(usize, usize, f64)]; 8] = [
    &[(0, 0, 0.5)],
    &[(1, 1, 0.5)],
    &[(0, 1, 1.0)],
    &[(0, 3, 1.0)],
    &[(1, 4, 1.0)],
    &[(0, 4, 1.0), (1, 3, 1.0)],
    &[(0, 2, 1.0)],
    &[(1, 2, 1.0)],
];

impl MeasureForces {
    /// The eight forces in order.
    fn components(&self) -> [Pack; 8] {
        let [a, b, c] = self.membrane;
        let [d, e, f] = self.curvature;
        let [g, h] = self.shear;
        [a, b, c, d, e, f, g, h]
    }
}

impl Placement {
    fn vectors(&self) -> [Pack3; 5] {
        [self.x1, self.x2, self.d, self.d1, self.d2]
    }

    /// `A = ∂m/∂v`, one row a measure.
    pub fn measure_gradients(&self) -> [[Pack; 15]; 8] {
        let v = self.vectors();
        let mut rows = [[Pack::ZERO; 15]; 8];
        for (row, products) in rows.iter_mut().zip(PRODUCTS) {
            for &(i, j, factor) in products {
                for k in 0..3 {
                    row[3 * i + k] += v[j].0[k] * factor;
                    row[3 * j + k] += v[i].0[k] * factor;
                }
            }
        }
        rows
    }

    /// `Aᵀ D A + Σ s ∂²m/∂v²` for a symmetric `D` over the measures and forces `s` on them.
    pub fn tangent(&self, over_measures: &Matrix8, forces: &MeasureForces) -> Matrix15 {
        let a = self.measure_gradients();
        let mut out = [[Pack::ZERO; 15]; 15];
        for (i, row) in over_measures.iter().enumerate() {
            // D A, one row at a time.
            let mut product = [Pack::ZERO; 15];
            for (value, gradient) in row.iter().zip(&a) {
                for c in 0..15 {
                    product[c] += *value * gradient[c];
                }
            }
            for r in 0..15 {
                for c in 0..15 {
                    out[r][c] += a[i][r] * product[c];
                }
            }
        }
        add_second_derivatives(&mut out, &forces.components());
        out
    }
}

/// Adds `Σ s_m ∂²m/∂v²`: each product of two vectors puts its force on the diagonals of their blocks.
pub fn add_second_derivatives(out: &mut Matrix15, forces: &[Pack; 8]) {
    for (force, products) in forces.iter().zip(PRODUCTS) {
        for &(i, j, factor) in products {
            for k in 0..3 {
                out[3 * i + k][3 * j + k] += *force * factor;
                out[3 * j + k][3 * i + k] += *force * factor;
            }
        }
    }
}

/// `Jᵀ C J`.
pub fn congruence(j: &Matrix8, c: &Matrix8) -> Matrix8 {
    let mut cj = ZERO8;
    for r in 0..8 {
        for k in 0..8 {
            for s in 0..8 {
                cj[r][s] += c[r][k] * j[k][s];
            }
        }
    }
    let mut out = ZERO8;
    for r in 0..8 {
        for k in 0..8 {
            for s in 0..8 {
                out[r][s] += j[k][r] * cj[k][s];
            }
        }
    }
    out
}
