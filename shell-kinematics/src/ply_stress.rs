//! What plies bear: their stresses from the strains of a section, and how near these are to failure.
//!
//! The strain of a layered section runs linearly through its thickness, `e + ζκ`, the stress of ply k linearly through the ply: in the axes of its fibre
//!
//! ```text
//! σ = Q (R_k (e + ζκ) − ᾱ θ(ζ))        θ(ζ) = θ₀ + ζ θ₁
//! ```
//!
//! with R_k the strains turned to the fibre, ᾱ = (α_L, α_T, 0) and Q of layered_section.rs \[jones1999\]. On a linear course an index of degree two of one sign of its
//! quadratic part is greatest at an end, a reserve factor least there: the ends are the faces of the ply, and for criteria that ask for signs the places where
//! σ₁ or σ₂ changes its own.
//!
//! θ is read back from what the resultants lack of those of the strains, N_θ = Ae + Bκ − N and M_θ = Be + Dκ − M: they are linear in θ₀ and θ₁
//! (expansion.rs), in a linear answer too.

use std::any::Any;

use crate::integrated_section::IntegratedSection;
use crate::layered_section::{LayeredSection, Orthotropic, Ply};
use crate::section::{IsotropicSection, Section};
use crate::strength::{Criterion, Margin};

/// The plies of a section whose stresses follow from its strains; one of a homogeneous section; none of sections that yield, and of rubber.
pub fn laminate_of(section: &dyn Section) -> Option<LayeredSection> {
    let any = section as &dyn Any;
    if let Some(layered) = any.downcast_ref::<LayeredSection>() {
        return Some(layered.clone());
    }
    let homogeneous = any.downcast_ref::<IsotropicSection>().map(IsotropicSection::material);
    let material = homogeneous.or_else(|| any.downcast_ref::<IntegratedSection>().map(|own| own.material))?;
    let thickness = section.scales().thickness;
    LayeredSection::new(&[Ply { material: Orthotropic::isotropic(&material), thickness, angle: 0.0 }]).ok()
}

/// Strains of a section about its middle, and its change of temperature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Through {
    /// `e11, e22, 2e12` of the middle \[–\].
    pub membrane: [f64; 3],
    /// `κ11, κ22, 2κ12` \[1/L\].
    pub curvature: [f64; 3],
    /// θ₀ in the middle \[Θ\] and θ₁ by height \[Θ/L\].
    pub heat: [f64; 2],
}

impl LayeredSection {
    /// Its plies, from the lowest to the highest.
    pub fn plies(&self) -> &[Ply] {
        &self.plies
    }

    /// What goes through its thickness at strains `e11, e22, 2e12, κ11, κ22, 2κ12` about a surface that lies by a height under its middle \[L\]. Where it is
    /// heated, resultants `N11, N22, N12, M11, M22, M12` about the same surface say by how much.
    pub fn through(&self, strains: [f64; 6], height: f64, resultants: Option<[f64; 6]>) -> Through {
        let [e11, e22, e12, k11, k22, k12] = strains;
        let curvature = [k11, k22, k12];
        let membrane = [e11 + height * k11, e22 + height * k22, e12 + height * k12];
        let mut through = Through { membrane, curvature, heat: [0.0; 2] };
        if let Some((resultants, expansion)) = resultants.zip(self.expansion()) {
            let row = |m: &[[f64; 3]; 3], s: &[f64; 3], i: usize| (0..3).map(|j| m[i][j] * s[j]).sum::<f64>();
            let lacking = std::array::from_fn(|i| match i {
                0..3 => {
                    row(&self.stiffness.membrane, &membrane, i) + row(&self.stiffness.coupling, &curvature, i)
                        - resultants[i]
                }
                _ => {
                    let k = i - 3;
                    let own = row(&self.stiffness.coupling, &membrane, k)
                        + row(&self.stiffness.bending, &curvature, k);
                    own - (resultants[i] - height * resultants[k])
                }
            });
            through.heat = expansion.temperatures(&lacking);
        }
        through
    }

    /// Heights of the lower and the upper face of a ply over the middle \[L\].
    fn faces(&self, ply: usize) -> [f64; 2] {
        let below: f64 = self.plies[..ply].iter().map(|own| own.thickness).sum();
        let bottom = below - 0.5 * self.scales().thickness;
        [bottom, bottom + self.plies[ply].thickness]
    }

    /// Stress of a ply in the axes of its fibre, `σ₁, σ₂, τ` \[F/L²\], at a share of its thickness: zero its lower face, one its upper.
    ///
    /// # Panics
    /// If there is no such ply.
    pub fn ply_stress(&self, ply: usize, through: &Through, share: f64) -> [f64; 3] {
        let [bottom, top] = self.faces(ply);
        let height = bottom + share * (top - bottom);
        let Ply { material, angle, .. } = &self.plies[ply];
        let [e11, e22, e12]: [f64; 3] =
            std::array::from_fn(|i| through.membrane[i] + height * through.curvature[i]);
        let (s, c) = libm::sincos(*angle);
        let warmer = through.heat[0] + height * through.heat[1];
        let [along, across] = material.expansion().unwrap_or_default().map(|own| own * warmer);
        let e1 = c * c * e11 + s * s * e22 + s * c * e12 - along;
        let e2 = s * s * e11 + c * c * e22 - s * c * e12 - across;
        let shear = 2.0 * s * c * (e22 - e11) + (c * c - s * s) * e12;
        let [q11, q22, q12, q66] = material.plane_stress();
        [q11 * e1 + q12 * e2, q12 * e1 + q22 * e2, q66 * shear]
    }

    /// The margin of a ply, the worst through its thickness; none of a ply whose material says no strength.
    ///
    /// # Panics
    /// If there is no such ply.
    pub fn ply_margin(&self, ply: usize, criterion: Criterion, through: &Through) -> Option<Margin> {
        let strength = self.plies[ply].material.strength()?;
        let [low, high] = [0.0, 1.0].map(|share| self.ply_stress(ply, through, share));
        let mut worst = strength.margin(criterion, low).worse(strength.margin(criterion, high));
        for k in 0..2 {
            if low[k] * high[k] < 0.0 {
                let share = low[k] / (low[k] - high[k]);
                let mut stress = std::array::from_fn(|i| low[i] + share * (high[i] - low[i]));
                stress[k] = 0.0;
                worst = worst.worse(strength.margin(criterion, stress));
            }
        }
        Some(worst)
    }

    /// The ply of least reserve with its margin; none where no ply has a strength.
    pub fn worst_ply(&self, criterion: Criterion, through: &Through) -> Option<(usize, Margin)> {
        let all =
            (0..self.plies.len()).filter_map(|ply| Some((ply, self.ply_margin(ply, criterion, through)?)));
        all.reduce(|worst, own| if own.1.reserve < worst.1.reserve { own } else { worst })
    }
}
