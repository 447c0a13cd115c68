//! Coordinates in which elasticity is one and the yield criterion is diagonal.
//!
//! C, the stiffness of plane stress, and P, the matrix of the yield criterion `f² = σᵀPσ`, have a common basis V:
//!
//! ```text
//! Vᵀ C⁻¹ V = 1     Vᵀ P V = diag p     σ = V x     x = Vᵀ ε of elastic strains ε     f² = Σ p_i x_i²
//! ```

use super::functions::three;
use crate::layered_section::Orthotropic;
use crate::pack::Number;
use crate::section::Isotropic;

/// The common basis of a material, in the frame of a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Modes {
    /// V, rows 11, 22, 12.
    pub basis: [[f64; 3]; 3],
    /// p \[F/L²\].
    pub yielding: [f64; 3],
}

impl Modes {
    /// Von Mises' criterion, `P = ⅓ [[2, −1, 0], [−1, 2, 0], [0, 0, 6]]`: the mean stress, half the difference and the shear.
    pub fn von_mises(elastic: &Isotropic) -> Self {
        let [young, poisson, shear] = [elastic.young, elastic.poisson, elastic.shear()];
        let mean = (0.5 * young / (1.0 - poisson)).sqrt();
        let root = shear.sqrt();
        Self {
            basis: [[mean, root, 0.0], [mean, -root, 0.0], [0.0, 0.0, root]],
            yielding: [young / (3.0 * (1.0 - poisson)), 2.0 * shear, 2.0 * shear],
        }
    }

    /// Those of elasticity alone, in the axes of its fibre: V of `C = V Vᵀ`, lower; no criterion.
    pub fn of_fibre(elastic: &Orthotropic) -> Self {
        let [q11, q22, q12, q66] = elastic.plane_stress();
        let first = q11.sqrt();
        let below = q12 / first;
        Self {
            basis: [[first, 0.0, 0.0], [below, (q22 - below * below).sqrt(), 0.0], [0.0, 0.0, q66.sqrt()]],
            yielding: [0.0; 3],
        }
    }

    /// `Vᵀ s` of strains 11, 22, 2·12.
    #[inline(always)]
    pub fn of_strains<P: Number>(&self, s: &[P; 3]) -> [P; 3] {
        let v = &self.basis;
        three(|i| s[0] * v[0][i] + s[1] * v[1][i] + s[2] * v[2][i])
    }

    /// `V x`, stresses 11, 22, 12.
    #[inline(always)]
    pub fn stresses<P: Number>(&self, x: &[P; 3]) -> [P; 3] {
        let v = &self.basis;
        three(|i| x[0] * v[i][0] + x[1] * v[i][1] + x[2] * v[i][2])
    }
}
