//! The assumed membrane strain of a quadrilateral: five tied strains, spread without locking.
//!
//! Two steps, both linear and both fixed once in the reference configuration:
//! covariant strains tied at the edges and the centre (MITC4+, \[ko2017\]) keep a warped element from locking in
//! membrane when it bends without stretching; seven enhanced strain modes (\[simo1990\], \[andelfinger1993\]),
//! eliminated at once because the membrane energy is quadratic in the assumed strain, keep it from locking in shear
//! when it bends in its plane.

use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector3};

/// Tied strains: the stretches of the edges 0–1, 3–2, 0–3, 1–2 and the shear at the centre, covariant.
pub type Ties = SVector<f64, 5>;

/// Assumed strain (E₁₁, E₂₂, 2E₁₂) of a point in its local axes, per tied strain.
pub type Spread = SMatrix<f64, 3, 5>;

/// Enhanced modes.
const MODES: usize = 7;
type Enhanced = SMatrix<f64, 3, MODES>;

/// A quadrature point as the membrane sees it.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Coordinates (r, s) in −1…1.
    pub at: [f64; 2],
    /// ∂(local coordinates)/∂(r, s): row a, column α \[L\].
    pub jacobian: Matrix2<f64>,
    /// Reference area of the point \[L²\].
    pub area: f64,
}

/// The spread of every quadrature point.
///
/// `centre` is the place of the middle, `distortion` holds (c_r, c_s): the components of the mesh's distortion
/// x_d = ¼(x₀ − x₁ + x₂ − x₃) in the plane of the middle, x_d = c_r x,_r + c_s x,_s + (normal part). The normal part,
/// which is what locks, is left out. `stiffness` is the membrane stiffness A \[F/L\].
pub fn spreads(
    places: &[Place; 4],
    centre: &Place,
    distortion: [f64; 2],
    stiffness: &Matrix3<f64>,
) -> [Spread; 4] {
    let tied = places.map(|place| voigt(&place.jacobian) * covariant(place.at, distortion));
    let modes = places.map(|place| enhanced(&place, centre));
    let mut own = SMatrix::<f64, MODES, MODES>::zeros();
    let mut coupling = SMatrix::<f64, MODES, 5>::zeros();
    for point in 0..4 {
        let weighted = modes[point].transpose() * stiffness * places[point].area;
        own += weighted * modes[point];
        coupling += weighted * tied[point];
    }
    // ∫Gᵀ A (E + Gα) = 0: the energy is least in the enhanced modes
    let amplitudes = own.cholesky().map(|factor| -factor.solve(&coupling)).unwrap_or_default();
    std::array::from_fn(|point| tied[point] + modes[point] * amplitudes)
}

/// Covariant strains (rr, ss, 2rs) at (r, s) per tied strain \[ko2017\].
///
/// Along r the strain of a bilinear surface is e_rr = p + s q + s² b, along s e_ss = p′ + r q′ + r² b, and
/// e_rs = e + (r q + s q′)/2 + rs b with b = x_d·u_d to first order. The edges give p + b ± q and p′ + b ± q′; in a flat
/// element b follows from the five by x_d = c_r x,_r + c_s x,_s, so that every affine motion is met exactly.
fn covariant([r, s]: [f64; 2], [c, d]: [f64; 2]) -> Spread {
    let scale = 1.0 / (c * c + d * d - 1.0);
    // b per (edge s = −1, edge s = +1, edge r = −1, edge r = +1, centre)
    let b = [
        0.5 * c * (c + 1.0) * scale,
        0.5 * c * (c - 1.0) * scale,
        0.5 * d * (d + 1.0) * scale,
        0.5 * d * (d - 1.0) * scale,
        2.0 * c * d * scale,
    ];
    let along_r = [0.5 * (1.0 - s), 0.5 * (1.0 + s), 0.0, 0.0, 0.0];
    let along_s = [0.0, 0.0, 0.5 * (1.0 - r), 0.5 * (1.0 + r), 0.0];
    let shear = [-0.25 * r, 0.25 * r, -0.25 * s, 0.25 * s, 1.0];
    Spread::from_fn(|component, tie| match component {
        0 => along_r[tie] + (s * s - 1.0) * b[tie],
        1 => along_s[tie] + (r * r - 1.0) * b[tie],
        _ => 2.0 * (shear[tie] + r * s * b[tie]),
    })
}

/// Seven enhanced modes at a place: r, rs along r; s, rs along s; r, s, rs in shear, in the axes of the centre and
/// scaled by the areas so that they do no work on constant resultants.
fn enhanced(place: &Place, centre: &Place) -> Enhanced {
    let [r, s] = place.at;
    let mut modes = Enhanced::zeros();
    (modes[(0, 0)], modes[(0, 1)]) = (r, r * s);
    (modes[(1, 2)], modes[(1, 3)]) = (s, r * s);
    (modes[(2, 4)], modes[(2, 5)], modes[(2, 6)]) = (r, s, r * s);
    voigt(&centre.jacobian) * modes * (centre.area / place.area)
}

/// Local components (11, 22, 2·12) of a strain from its covariant ones (rr, ss, 2rs).
fn voigt(jacobian: &Matrix2<f64>) -> Matrix3<f64> {
    let inverse = jacobian.try_inverse().unwrap_or_default();
    // e_ab = i_αa i_βb e_αβ
    let column = |covariant: Matrix2<f64>| {
        let local = inverse.transpose() * covariant * inverse;
        Vector3::new(local[(0, 0)], local[(1, 1)], 2.0 * local[(0, 1)])
    };
    Matrix3::from_columns(&[
        column(Matrix2::new(1.0, 0.0, 0.0, 0.0)),
        column(Matrix2::new(0.0, 0.0, 0.0, 1.0)),
        column(Matrix2::new(0.0, 0.5, 0.5, 0.0)),
    ])
}
