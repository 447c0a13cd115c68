//! Linear elastic moduli in material axes: isotropic and orthotropic.

use crate::Tensor;
use crate::error::ElasticError;
use crate::voigt::PAIRS;

/// Constants of an orthotropic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthotropic {
    /// Young's moduli along the three axes \[F/L²\].
    pub young: [f64; 3],
    /// Poisson's ratios ν₁₂, ν₂₃, ν₁₃: contraction along the second axis under stress along the first.
    pub poisson: [f64; 3],
    /// Shear moduli G₁₂, G₂₃, G₁₃ \[F/L²\].
    pub shear: [f64; 3],
}

/// Stresses of strains: `σ = C ε`, six by six in material axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Moduli {
    stiffness: [[f64; 6]; 6],
    compliance: [[f64; 6]; 6],
    isotropic: bool,
}

impl Moduli {
    /// Moduli without preferred directions, from Young's modulus \[F/L²\] and Poisson's ratio.
    ///
    /// # Errors
    /// [`ElasticError::Constant`].
    pub fn isotropic(young: f64, poisson: f64) -> Result<Self, ElasticError> {
        positive("Young's modulus", young)?;
        if !(poisson > -1.0 && poisson < 0.5) {
            let (what, bound) = ("Poisson's ratio", "above -1 and below 0.5");
            return Err(ElasticError::Constant { what, value: poisson, bound });
        }
        let shear = young / (2.0 * (1.0 + poisson));
        let lambda = 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
        let (mut stiffness, mut compliance) = ([[0.0; 6]; 6], [[0.0; 6]; 6]);
        for i in 0..3 {
            stiffness[i][..3].fill(lambda);
            stiffness[i][i] += 2.0 * shear;
            stiffness[i + 3][i + 3] = shear;
            compliance[i][..3].fill(-poisson / young);
            compliance[i][i] = 1.0 / young;
            compliance[i + 3][i + 3] = 1.0 / shear;
        }
        Ok(Self { stiffness, compliance, isotropic: true })
    }

    /// Moduli with three planes of symmetry.
    ///
    /// # Errors
    /// [`ElasticError::Constant`]; [`ElasticError::Indefinite`] where some strain would have no energy.
    pub fn orthotropic(of: &Orthotropic) -> Result<Self, ElasticError> {
        for (value, what) in of.young.into_iter().zip(["E1", "E2", "E3"]) {
            positive(what, value)?;
        }
        for (value, what) in of.shear.into_iter().zip(["G12", "G23", "G13"]) {
            positive(what, value)?;
        }
        for (value, what) in of.poisson.into_iter().zip(["nu12", "nu23", "nu13"]) {
            if !value.is_finite() {
                return Err(ElasticError::Constant { what, value, bound: "finite" });
            }
        }
        let [e1, e2, e3] = of.young;
        let [p12, p23, p13] = of.poisson;
        // Each pivot of the compliance of normal stresses, in units of 1/E.
        let [a, b, c] = [-p12 / e1, -p13 / e1, -p23 / e2];
        let second = 1.0 - p12 * p12 * e2 / e1;
        let compliance = Tensor::new(1.0 / e1, a, b, a, 1.0 / e2, c, b, c, 1.0 / e3);
        let third = compliance.determinant() * e1 * e2 * e3;
        let pivot = if second <= 0.0 { second } else { third };
        let inverse = compliance.try_inverse().filter(|_| pivot > 0.0);
        let Some(inverse) = inverse else {
            return Err(ElasticError::Indefinite { pivot });
        };
        let mut out = Self { stiffness: [[0.0; 6]; 6], compliance: [[0.0; 6]; 6], isotropic: false };
        for i in 0..3 {
            for j in 0..3 {
                out.stiffness[i][j] = inverse[(i, j)];
                out.compliance[i][j] = compliance[(i, j)];
            }
            out.stiffness[i + 3][i + 3] = of.shear[i];
            out.compliance[i + 3][i + 3] = 1.0 / of.shear[i];
        }
        Ok(out)
    }

    /// Stresses of strains in material axes \[F/L²\].
    pub fn stress(&self, strain: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|i| (0..6).map(|j| self.stiffness[i][j] * strain[j]).sum())
    }

    /// Energy of strains per volume \[F/L²\].
    pub fn energy(&self, strain: &[f64; 6]) -> f64 {
        0.5 * self.stress(strain).iter().zip(strain).map(|(s, e)| s * e).sum::<f64>()
    }

    /// Energy per volume that stresses would release \[F/L²\].
    pub fn complementary(&self, stress: &[f64; 6]) -> f64 {
        let strain = |i: usize| (0..6).map(|j| self.compliance[i][j] * stress[j]).sum::<f64>();
        0.5 * (0..6).map(|i| stress[i] * strain(i)).sum::<f64>()
    }

    /// How much stiffer against a change of volume the Poisson's ratios make the solid: the bulk modulus over what it is without
    /// them, `1/(1 − 2ν)` of an isotropic one.
    pub fn coupling(&self) -> f64 {
        let normal = |i: usize| self.compliance[i][..3].iter().sum::<f64>();
        let alone: f64 = (0..3).map(|i| self.compliance[i][i]).sum();
        alone / (0..3).map(normal).sum::<f64>()
    }

    /// Shear modulus \[F/L²\], if there are no preferred directions.
    pub fn shear(&self) -> Option<f64> {
        self.isotropic.then_some(self.stiffness[3][3])
    }

    /// Moduli in space, the material axes being the columns of `axes`.
    pub fn turned(&self, axes: &Tensor) -> [[f64; 6]; 6] {
        if self.isotropic {
            return self.stiffness;
        }
        let mut turn = [[0.0; 6]; 6];
        for (row, &(i, j)) in PAIRS.iter().enumerate() {
            for (column, &(m, n)) in PAIRS.iter().enumerate() {
                let once = axes[(i, m)] * axes[(j, n)];
                turn[row][column] = if m == n { once } else { once + axes[(i, n)] * axes[(j, m)] };
            }
        }
        let half: [[f64; 6]; 6] = std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..6).map(|k| turn[i][k] * self.stiffness[k][j]).sum())
        });
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| half[i][k] * turn[j][k]).sum()))
    }
}

fn positive(what: &'static str, value: f64) -> Result<(), ElasticError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(ElasticError::Constant { what, value, bound: "positive and finite" })
}
