//! A section of rubber: incompressible at every height, so that neither a thickness nor a history is kept.
//!
//! Membrane and curvature strains are those of the measure `green-lagrange`, half the change of C and the change of k, with no logarithm
//! between: what is strained at a height is then a function of them alone, and so is the energy.
//!
//! ```text
//! C(z) = C + 2 z λ₃ κ     λ₃ = 1/√det C of the mid-surface     ψ = Σ w W(C(z))
//! ```
//!
//! Exact for a flat sheet bent to a circle, thinning through the thickness included. In `c = (C11, C22, C12)` with `κ' = (2κ11, 2κ22, 2κ12)`,
//! the last the engineering component, `a = Σ w W,c`, `b = Σ w z W,c`, `A_n = Σ w zⁿ W,cc` and `l = ∂λ₃/∂c`,
//!
//! ```text
//! ∂ψ/∂c = a + (b·κ') l     ∂ψ/∂κ' = λ₃ b     ∂²ψ/∂κ'² = λ₃² A2     ∂²ψ/∂c∂κ' = λ₃ A1 + l ⊗ (b + λ₃ A2 κ')
//! ∂²ψ/∂c² = A0 + A1κ' ⊗ l + l ⊗ A1κ' + (κ'·A2κ') l ⊗ l + (b·κ') ∂²λ₃/∂c²
//! ```

use super::rubber::Rubber;
use crate::integrated_section::GAUSS;
use crate::pack::{Arithmetic, Pack};
use crate::section::{MaterialError, SHEAR_CORRECTION, Section, SectionScales};
use crate::strains::{Resultants, Strains};
use crate::tangent::{Matrix8, ZERO8};

/// What c has of e, and κ' of κ: 2, 2, 1.
const TWICE: [f64; 3] = [2.0, 2.0, 1.0];

/// Three packs, and a matrix over them.
type Vector = [Pack; 3];
type Matrix3 = [[Pack; 3]; 3];

/// Incompressible rubber at three Gauss points through the thickness, on the strains of [`crate::GreenLagrange`].
#[derive(Clone, Debug)]
pub struct RubberSection {
    material: Rubber,
    /// Height and weight \[L, L\].
    points: [(f64, f64); 3],
    scales: SectionScales,
}

/// C of the mid-surface and what follows from it.
struct Middle {
    c: Vector,
    /// κ'.
    bent: Vector,
    thickness: Pack,
    /// ∂λ₃/∂c.
    slope: Vector,
}

fn dot(a: &Vector, b: &Vector) -> Pack {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn times(a: &Matrix3, b: &Vector) -> Vector {
    a.each_ref().map(|row| dot(row, b))
}

/// `det C` and its gradient by c.
fn determinant(c: &Vector) -> (Pack, Vector) {
    (c[0] * c[1] - c[2] * c[2], [c[1], c[0], c[2] * -2.0])
}

/// Entry of the second derivative of `det C`.
fn curved(i: usize, j: usize) -> f64 {
    match (i, j) {
        (0, 1) | (1, 0) => 1.0,
        (2, 2) => -2.0,
        _ => 0.0,
    }
}

impl RubberSection {
    /// Rubber of that thickness at rest \[L\].
    ///
    /// # Errors
    /// [`MaterialError::Thickness`] unless the thickness is positive and finite.
    pub fn new(material: Rubber, thickness: f64) -> Result<Self, MaterialError> {
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(MaterialError::Thickness(thickness));
        }
        let [a, b, c] = [GAUSS[1][0], GAUSS[1][1], GAUSS[1][2]];
        let points = [a, b, c].map(|(z, w)| (0.5 * thickness * z, 0.5 * thickness * w));
        // E/(1 − ν²) with E = 3μ and ν = ½.
        let membrane = 4.0 * material.shear() * thickness;
        let scales = SectionScales {
            thickness,
            bending: membrane * thickness * thickness / 12.0,
            shear: SHEAR_CORRECTION * material.shear() * thickness,
            membrane,
        };
        Ok(Self { material, points, scales })
    }

    fn middle(&self, strains: &Strains) -> Middle {
        let unit = [1.0, 1.0, 0.0].map(Pack::splat);
        let scaled = |s: &Vector| -> Vector { std::array::from_fn(|i| s[i] * TWICE[i]) };
        let change = scaled(&strains.membrane);
        let c = std::array::from_fn(|i| change[i] + unit[i]);
        let (det, gradient) = determinant(&c);
        let thickness = unit[0] / det.sqrt();
        let factor = thickness / det * -0.5;
        Middle { c, bent: scaled(&strains.curvature), thickness, slope: gradient.map(|g| g * factor) }
    }

    /// C at a height.
    fn at(middle: &Middle, height: f64) -> Vector {
        std::array::from_fn(|i| middle.c[i] + middle.bent[i] * middle.thickness * height)
    }

    /// `W,c` at a height.
    fn gradient(&self, c: &Vector) -> Vector {
        let (det, gradient) = determinant(c);
        let [by_trace, by_det] = self.material.stored(c[0] + c[1], det).first;
        [gradient[0] * by_det + by_trace, gradient[1] * by_det + by_trace, gradient[2] * by_det]
    }

    /// `W,cc` at a height.
    fn hessian(&self, c: &Vector) -> Matrix3 {
        let (det, gradient) = determinant(c);
        let stored = self.material.stored(c[0] + c[1], det);
        let [tt, td, dd] = stored.second;
        let trace = [1.0, 1.0, 0.0];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let mixed = gradient[i] * trace[j] + gradient[j] * trace[i];
                tt * (trace[i] * trace[j])
                    + td * mixed
                    + dd * (gradient[i] * gradient[j])
                    + stored.first[1] * curved(i, j)
            })
        })
    }

    /// a and b.
    fn sums(&self, middle: &Middle) -> [Vector; 2] {
        let mut out = [[Pack::ZERO; 3]; 2];
        for &(z, w) in &self.points {
            let gradient = self.gradient(&Self::at(middle, z));
            for i in 0..3 {
                out[0][i] += gradient[i] * w;
                out[1][i] += gradient[i] * (w * z);
            }
        }
        out
    }
}

impl Section for RubberSection {
    fn resultants(&self, strains: &Strains) -> Resultants {
        let middle = self.middle(strains);
        let [a, b] = self.sums(&middle);
        let turned = dot(&b, &middle.bent);
        Resultants {
            membrane: std::array::from_fn(|i| (a[i] + turned * middle.slope[i]) * TWICE[i]),
            moment: std::array::from_fn(|i| b[i] * middle.thickness * TWICE[i]),
            shear: strains.shear.map(|gamma| gamma * self.scales.shear),
        }
    }

    fn tangent(&self, strains: &Strains) -> Matrix8 {
        let middle = self.middle(strains);
        let [_, b] = self.sums(&middle);
        let mut sums = [[[Pack::ZERO; 3]; 3]; 3];
        for &(z, w) in &self.points {
            let hessian = self.hessian(&Self::at(&middle, z));
            for (sum, factor) in sums.iter_mut().zip([w, w * z, w * z * z]) {
                for i in 0..3 {
                    for j in 0..3 {
                        sum[i][j] += hessian[i][j] * factor;
                    }
                }
            }
        }
        let [a0, a1, a2] = sums;
        let (det, gradient) = determinant(&middle.c);
        let (bent, slope, thickness) = (&middle.bent, &middle.slope, middle.thickness);
        let [once, twice] = [times(&a1, bent), times(&a2, bent)];
        let [turned, square] = [dot(&b, bent), dot(bent, &twice)];
        // ∂²λ₃/∂c² = ¾ λ₃/d² q ⊗ q − ½ λ₃/d q,c with q the gradient of d.
        let by_det = thickness / det;
        let mut out = ZERO8;
        for i in 0..3 {
            for j in 0..3 {
                let curvature =
                    by_det / det * 0.75 * (gradient[i] * gradient[j]) - by_det * (0.5 * curved(i, j));
                let both = TWICE[i] * TWICE[j];
                out[i][j] = (a0[i][j]
                    + (once[i] * slope[j] + slope[i] * once[j])
                    + square * (slope[i] * slope[j])
                    + turned * curvature)
                    * both;
                out[i][3 + j] = (thickness * a1[i][j] + slope[i] * (b[j] + thickness * twice[j])) * both;
                out[3 + j][i] = out[i][3 + j];
                out[3 + i][3 + j] = thickness * thickness * a2[i][j] * both;
            }
        }
        out[6][6] = Pack::splat(self.scales.shear);
        out[7][7] = out[6][6];
        out
    }

    fn energy(&self, strains: &Strains) -> Pack {
        let middle = self.middle(strains);
        let [g1, g2] = strains.shear;
        let mut energy = (g1 * g1 + g2 * g2) * (0.5 * self.scales.shear);
        for &(z, w) in &self.points {
            let c = Self::at(&middle, z);
            energy += self.material.stored(c[0] + c[1], determinant(&c).0).energy * w;
        }
        energy
    }

    /// Those at rest; a stretched sheet may be stiffer.
    fn scales(&self) -> SectionScales {
        self.scales
    }
}
