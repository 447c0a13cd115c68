//! What a shell of given make answers to its strains: resultants per length, for one material or for plies.

use nalgebra::{Matrix2, Matrix3, SMatrix};

/// The stiffness of a section: resultants (n₁₁ n₂₂ n₁₂ m₁₁ m₂₂ m₁₂ q₁ q₂) against strains
/// (ε₁₁ ε₂₂ 2ε₁₂ κ₁₁ κ₂₂ 2κ₁₂ γ₁ γ₂), in \[F/L\], \[F\], \[F L\].
pub type Stiffness = SMatrix<f64, 8, 8>;

/// Share of the uniform shear stiffness that a parabola of shear stresses through the thickness leaves.
pub const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// A section: stiffness and inertia of one unit of reference area.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Resultants against strains.
    pub stiffness: Stiffness,
    /// Mass per area \[M/L²\].
    pub mass: f64,
    /// Moment of inertia of the mass about the mid-surface, per area \[M\].
    pub rotary: f64,
}

/// One ply: orthotropic, in plane stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ply {
    /// Thickness \[L\].
    pub thickness: f64,
    /// Angle from the first axis of the section to the fibres \[rad\].
    pub angle: f64,
}

/// Constants of an orthotropic ply along (L) and across (T) its fibres \[F/L²\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orthotropic {
    /// Young's modulus along the fibres.
    pub along: f64,
    /// Young's modulus across the fibres.
    pub across: f64,
    /// Contraction across per extension along; no unit.
    pub poisson: f64,
    /// Shear modulus in the planes that hold the fibres.
    pub shear: f64,
    /// Shear modulus in the plane across the fibres.
    pub shear_across: f64,
    /// Density \[M/L³\].
    pub density: f64,
}

impl Section {
    /// One isotropic material in plane stress: Young's modulus \[F/L²\], Poisson's ratio, thickness \[L\], density \[M/L³\].
    pub fn isotropic(young: f64, poisson: f64, thickness: f64, density: f64) -> Self {
        let shear = 0.5 * young / (1.0 + poisson);
        let material =
            Orthotropic { along: young, across: young, poisson, shear, shear_across: shear, density };
        Self::layered(&material, &[Ply { thickness, angle: 0.0 }])
    }

    /// Plies of one material, from the lowest (against the director) to the highest; the nodes lie in the middle.
    ///
    /// Classical lamination of the in-plane part, A = ΣQ̄t, B = ΣQ̄tz, D = ΣQ̄(tz² + t³/12), and the sum of the
    /// transverse shear stiffnesses times [`SHEAR_FACTOR`].
    pub fn layered(material: &Orthotropic, plies: &[Ply]) -> Self {
        let thickness: f64 = plies.iter().map(|ply| ply.thickness).sum();
        let mut stiffness = Stiffness::zeros();
        let mut bottom = -0.5 * thickness;
        for ply in plies {
            let (t, z) = (ply.thickness, bottom + 0.5 * ply.thickness);
            let (in_plane, shear) = turned(material, ply.angle);
            for (row, column, factor) in
                [(0, 0, t), (0, 3, t * z), (3, 0, t * z), (3, 3, t * z * z + t * t * t / 12.0)]
            {
                let mut block = stiffness.fixed_view_mut::<3, 3>(row, column);
                block += in_plane * factor;
            }
            let mut block = stiffness.fixed_view_mut::<2, 2>(6, 6);
            block += shear * (SHEAR_FACTOR * t);
            bottom += t;
        }
        let rotary = material.density * thickness.powi(3) / 12.0;
        Self { stiffness, mass: material.density * thickness, rotary }
    }

    /// The membrane part A \[F/L\].
    pub fn membrane(&self) -> Matrix3<f64> {
        self.stiffness.fixed_view::<3, 3>(0, 0).into_owned()
    }
}

/// Plane-stress and transverse-shear moduli \[F/L²\] of a ply in axes from which its fibres are turned by `angle`.
fn turned(material: &Orthotropic, angle: f64) -> (Matrix3<f64>, Matrix2<f64>) {
    let minor = material.poisson * material.across / material.along;
    let scale = 1.0 / (1.0 - material.poisson * minor);
    let coupled = scale * material.poisson * material.across;
    let own = Matrix3::new(
        scale * material.along,
        coupled,
        0.0, //
        coupled,
        scale * material.across,
        0.0, //
        0.0,
        0.0,
        material.shear,
    );
    let (c, s) = (libm::cos(angle), libm::sin(angle));
    // strains along the fibres from strains along the axes
    let strain = Matrix3::new(
        c * c,
        s * s,
        c * s, //
        s * s,
        c * c,
        -c * s, //
        -2.0 * c * s,
        2.0 * c * s,
        c * c - s * s,
    );
    let rotation = Matrix2::new(c, s, -s, c);
    let shear = Matrix2::new(material.shear, 0.0, 0.0, material.shear_across);
    (strain.transpose() * own * strain, rotation.transpose() * shear * rotation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

    const MATERIAL: Orthotropic = Orthotropic {
        along: 3300.0,
        across: 1100.0,
        poisson: 0.25,
        shear: 660.0,
        shear_across: 440.0,
        density: 2.0,
    };

    #[test]
    fn an_isotropic_section_has_the_textbook_rigidities() {
        let section = Section::isotropic(12.0, 0.5, 2.0, 3.0);
        assert_relative_eq!(section.stiffness[(0, 0)], 32.0);
        assert_relative_eq!(section.stiffness[(0, 1)], 16.0);
        assert_relative_eq!(section.stiffness[(2, 2)], 8.0);
        assert_relative_eq!(section.stiffness[(3, 3)], 32.0 / 3.0);
        assert_relative_eq!(section.stiffness[(6, 6)], 20.0 / 3.0, max_relative = 1e-14);
        assert_relative_eq!(section.rotary, 2.0);
    }

    #[test]
    fn a_quarter_turn_swaps_the_axes_and_isotropy_does_not_see_angles() {
        let ply = |angle| [Ply { thickness: 1.0, angle }];
        let (along, across) =
            (Section::layered(&MATERIAL, &ply(0.0)), Section::layered(&MATERIAL, &ply(FRAC_PI_2)));
        assert_relative_eq!(along.stiffness[(0, 0)], across.stiffness[(1, 1)], max_relative = 1e-12);
        assert_relative_eq!(along.stiffness[(6, 6)], across.stiffness[(7, 7)], max_relative = 1e-12);
        let shear = 12.0 / 2.6;
        let steel =
            Orthotropic { along: 12.0, across: 12.0, poisson: 0.3, shear, shear_across: shear, density: 1.0 };
        let (straight, oblique) =
            (Section::layered(&steel, &ply(0.0)), Section::layered(&steel, &ply(FRAC_PI_3)));
        assert_relative_eq!(straight.stiffness, oblique.stiffness, epsilon = 1e-12);
    }

    #[test]
    fn equal_plies_act_as_one_and_only_unsymmetric_ones_couple() {
        let plies = |angles: &[f64]| {
            let stack: Vec<_> = angles.iter().map(|&angle| Ply { thickness: 1.0, angle }).collect();
            Section::layered(&MATERIAL, &stack).stiffness
        };
        let thick = Section::layered(&MATERIAL, &[Ply { thickness: 3.0, angle: 0.0 }]).stiffness;
        assert_relative_eq!(plies(&[0.0, 0.0, 0.0]), thick, max_relative = 1e-12, epsilon = 1e-9);
        assert_relative_eq!(
            plies(&[0.0, FRAC_PI_2, 0.0]).fixed_view::<3, 3>(0, 3).norm(),
            0.0,
            epsilon = 1e-9
        );
        assert!(plies(&[0.0, FRAC_PI_2]).fixed_view::<3, 3>(0, 3).norm() > 100.0);
    }
}
