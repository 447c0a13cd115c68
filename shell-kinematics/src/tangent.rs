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

/// The measures that each vector enters, and the vector it is multiplied by there: `∂m/∂v_i` is the other vector.
const FACTORS: [&[(usize, usize)]; 5] = [
    &[(0, 0), (2, 1), (3, 3), (5, 4), (6, 2)],
    &[(1, 1), (2, 0), (4, 4), (5, 3), (7, 2)],
    &[(6, 0), (7, 1)],
    &[(3, 0), (5, 1)],
    &[(4, 1), (5, 0)],
];

impl MeasureForces {
    /// The eight forces in order.
    #[inline(always)]
    pub fn components(&self) -> [Pack; 8] {
        let [a, b, c] = self.membrane;
        let [d, e, f] = self.curvature;
        let [g, h] = self.shear;
        [a, b, c, d, e, f, g, h]
    }
}

impl Placement {
    /// The five vectors in order.
    #[inline(always)]
    pub fn vectors(&self) -> [Pack3; 5] {
        [self.x1, self.x2, self.d, self.d1, self.d2]
    }

    /// `Σ f ∂m/∂v` for a factor of each measure, one row a vector.
    #[inline(always)]
    pub fn along_gradients(&self, factors: &[Pack; 8]) -> [Pack3; 5] {
        let v = self.vectors();
        std::array::from_fn(|i| {
            FACTORS[i].iter().fold(Pack3::ZERO, |sum, &(measure, other)| sum + v[other] * factors[measure])
        })
    }

    /// `Aᵀ D A + Σ s ∂²m/∂v²` for a symmetric `D` over the measures and forces `s` on them.
    #[inline(always)]
    pub fn tangent(&self, over_measures: &Matrix8, forces: &MeasureForces) -> Matrix15 {
        let v = self.vectors();
        let products = over_measures.each_ref().map(|row| self.along_gradients(row)); // D A
        let mut out = [[Pack::ZERO; 15]; 15];
        for i in 0..5 {
            for &(measure, other) in FACTORS[i] {
                for j in i..5 {
                    for k in 0..3 {
                        for l in 0..3 {
                            out[3 * i + k][3 * j + l] += v[other].0[k] * products[measure][j].0[l];
                        }
                    }
                }
            }
        }
        // Each product of two vectors puts its force on the diagonal of their block.
        let s = forces.components();
        for i in 0..5 {
            for &(measure, other) in FACTORS[i].iter().filter(|factor| factor.1 >= i) {
                for k in 0..3 {
                    out[3 * i + k][3 * other + k] += s[measure];
                }
            }
        }
        for row in 0..15 {
            for column in 0..row {
                out[row][column] = out[column][row];
            }
        }
        out
    }
}

/// `Jᵀ C J` for a symmetric `C`.
#[inline(always)]
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
        for s in r..8 {
            for k in 0..8 {
                out[r][s] += j[k][r] * cj[k][s];
            }
            out[s][r] = out[r][s];
        }
    }
    out
}
