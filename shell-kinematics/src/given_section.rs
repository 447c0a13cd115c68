//! Sections whose stiffness is given, of whatever build: sandwich, corrugated or stiffened sheets.

use crate::pack::Pack;
use crate::section::{MaterialError, Section, SectionScales, linear_tangent};
use crate::stiffness::{Matrix3, Stiffness, mean_over_directions};
use crate::strains::{Resultants, Strains};
use crate::tangent::Matrix8;

/// Entries of a matrix and its transpose may differ by this part of its greatest entry: what ten written digits leave.
const ASYMMETRY: f64 = 1e-9;

/// A section of given stiffness, over the first axis of the point's frame.
#[derive(Clone, Copy, Debug)]
pub struct GivenSection {
    stiffness: Stiffness,
    scales: SectionScales,
}

impl GivenSection {
    /// Of a thickness \[L\], which says how far the faces are apart and, with a density, the mass per area and `ρt³/12` of turns.
    ///
    /// # Errors
    /// [`MaterialError::Thickness`]; [`MaterialError::Stiffness`] for a matrix that is not symmetric, and unless every strain stores energy:
    /// `[[A, B], [B, D]]` and S must be positive definite.
    pub fn new(stiffness: Stiffness, thickness: f64) -> Result<Self, MaterialError> {
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(MaterialError::Thickness(thickness));
        }
        let Stiffness { membrane, coupling, bending, shear } = &stiffness;
        for (what, matrix) in [("membrane", membrane), ("coupling", coupling), ("bending", bending)] {
            symmetric(what, matrix)?;
        }
        symmetric("shear", shear)?;
        let half = 0.5 * thickness;
        // Curvatures as the strains of the face: what the Cholesky factor compares then has one size.
        let whole: [[f64; 6]; 6] = std::array::from_fn(|i| {
            std::array::from_fn(|j| match (i < 3, j < 3) {
                (true, true) => membrane[i][j],
                (false, false) => bending[i - 3][j - 3] / (half * half),
                (true, false) => coupling[i][j - 3] / half,
                (false, true) => coupling[i - 3][j] / half,
            })
        });
        positive("membrane", membrane)?;
        positive("bending", bending)?;
        positive("coupling", &whole)?;
        positive("shear", shear)?;
        let stiffness = Stiffness {
            membrane: even(membrane),
            coupling: even(coupling),
            bending: even(bending),
            shear: even(shear),
        };
        let scales = stiffness.scales(thickness, fastest(&stiffness, thickness));
        Ok(Self { stiffness, scales })
    }
}

/// Whether a matrix is finite and symmetric.
fn symmetric<const N: usize>(what: &'static str, matrix: &[[f64; N]; N]) -> Result<(), MaterialError> {
    let refuse = |bound| Err(MaterialError::Stiffness { what, bound });
    let entries = matrix.as_flattened();
    if !entries.iter().all(|entry| entry.is_finite()) {
        return refuse("finite");
    }
    let most = entries.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let apart = |i: usize, j: usize| (matrix[i][j] - matrix[j][i]).abs() > ASYMMETRY * most;
    if (0..N).any(|i| (0..i).any(|j| apart(i, j))) { refuse("symmetric") } else { Ok(()) }
}

/// The symmetric part: that of an energy.
fn even<const N: usize>(matrix: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (matrix[i][j] + matrix[j][i])))
}

/// Whether a symmetric matrix is positive definite: whether it has a Cholesky factor.
fn positive<const N: usize>(what: &'static str, matrix: &[[f64; N]; N]) -> Result<(), MaterialError> {
    let mut factor = [[0.0; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let left = matrix[i][j] - (0..j).map(|k| factor[i][k] * factor[j][k]).sum::<f64>();
            if i > j {
                factor[i][j] = left / factor[j][j];
            } else if left > 1e-12 * matrix[i][i] {
                factor[i][i] = left.sqrt();
            } else {
                let bound = match what {
                    "coupling" => {
                        "so small that every strain with its curvature stores energy, [[A, B], [B, D]] positive definite"
                    }
                    _ => "positive definite, so that every strain stores energy",
                };
                return Err(MaterialError::Stiffness { what, bound });
            }
        }
    }
    Ok(())
}

/// No wave of displacements in the surface and turns meets more \[F/L\].
///
/// Turns times t/√12 have the mass of displacements, ρt for each area. A wave along n then meets the symmetric matrix of A(n), B(n)√12/t and
/// D(n)·12/t², each of two rows, `X(n) = Σ X:(·⊗n):(·⊗n)`; no eigenvalue of it is greater than that of the norms a, b, d of the three,
/// `(a + d)/2 + √(((a − d)/2)² + b²)`. The transverse shear S is no part of it: what it does to waves stands beside it, in [`SectionScales::shear`].
fn fastest(Stiffness { membrane, coupling, bending, .. }: &Stiffness, thickness: f64) -> f64 {
    let (a, d) = (stiffest(membrane), stiffest(bending) * 12.0 / (thickness * thickness));
    let b = largest(coupling) * libm::sqrt(12.0) / thickness;
    let half = 0.5 * (a - d).abs();
    // As it stands here the greater of the two to the bit where nothing couples them.
    a.max(d) + (libm::hypot(half, b) - half)
}

/// No direction is stiffer \[as the matrix\]: the mean over all directions and what changes with twice and four times the angle, as if
/// they were greatest in one direction, where they are in an orthotropic sheet.
///
/// A wave along n that moves along m meets `A:(m⊗n):(m⊗n)`, convex in the cosine between them and so greatest for m = ±n.
fn stiffest(m: &Matrix3) -> f64 {
    mean_over_directions(m) + changing(m)
}

/// What changes with twice and four times the angle, each where it is greatest.
fn changing(m: &Matrix3) -> f64 {
    let twice = [0.5 * (m[0][0] - m[1][1]), m[0][2] + m[1][2]];
    let four = [(m[0][0] + m[1][1] - 2.0 * m[0][1] - 4.0 * m[2][2]) / 8.0, 0.5 * (m[0][2] - m[1][2])];
    libm::hypot(twice[0], twice[1]) + libm::hypot(four[0], four[1])
}

/// The size of `m:(m⊗n):(m⊗n)`, of a matrix of either sign, is nowhere greater \[as the matrix\].
///
/// With c the cosine between m and n and α the sum of their angles it is `P c² + K` and what changes with α, of which the share of twice the angle has
/// a factor c: linear in c² between its ends, K across and P + K along, the mean over all directions.
fn largest(m: &Matrix3) -> f64 {
    let across = (m[0][0] + m[1][1] - 2.0 * m[0][1] + 4.0 * m[2][2]) / 8.0;
    mean_over_directions(m).abs().max(across.abs()) + changing(m)
}

impl Section for GivenSection {
    fn linear(&self) -> bool {
        true
    }

    fn resultants(&self, strains: &Strains) -> Resultants {
        self.stiffness.resultants(strains)
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        linear_tangent(self)
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.resultants(strains).work(strains) * 0.5
    }

    /// No wave in the surface, of the membrane or of bending, is faster than the scale of the membrane says; transverse shear is no part of it.
    fn scales(&self) -> SectionScales {
        self.scales
    }
}
