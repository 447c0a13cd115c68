//! Friction between two particles: the artificial viscosity of \[monaghan1992\], and laminar flow.
//!
//! ```text
//! a_a = −Σ m_b Π_ab F r_ab
//! Π_ab = −α c̄ h min(v_ab·r_ab, 0)/[ρ̄ (r² + η²)] − 4(d + 2) ν v_ab·r_ab/[(ρ_a + ρ_b) κh²],   κ = 10/9 in a plane, 4/3 in space
//! ```
//!
//! The second acts along the line of centres, as that of \[monaghan2005\] does, so that it exerts no moment and does not
//! resist a rigid rotation. To second order `v_ab = (r·∇)v − ½(r·∇)²v`. The first term sums to zero by symmetry; with
//! `∫F r² dV = −d` and `κh² = ∫F r⁴ dV/∫F r² dV`
//!
//! ```text
//! ∫ F r_i r_j r_k r_l/(κh²) dV = −(δ_ij δ_kl + δ_ik δ_jl + δ_il δ_jk)/(d + 2)
//! ```
//!
//! leaves ν∇²v + 2ν∇(∇·v): the friction of a Newtonian fluid where the volume hardly changes. The published weight
//! F/(r² + η²) has the same integral but gives the nearest so much that a square lattice of h = 1.3 Δx is 20 % too soft in
//! shear along its rows and 12 % too stiff across; F/(κh²) is within 5 % for any direction (h/Δx from 1.3 to 2). Forces
//! along v_ab \[lo2002\] stand for the stress ν∇v, which resists rotation: torques on curved walls are wrong by ν v/r.

use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;

/// What both need beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viscosity {
    /// `α h c₀/ρ₀³`: with it `Π = −artificial (ρ_a³ + ρ_b³) min(v·r, 0)/[(ρ_a + ρ_b)(r² + η²)]`, as c ∝ ρ³.
    pub artificial: f64,
    /// `4(d + 2)ν/(κh²)` \[1/T\].
    pub laminar: f64,
}

impl Viscosity {
    /// Those of a formulation, in so many dimensions.
    pub fn new(dimensions: usize, formulation: &Formulation, liquid: &Liquid, kernel: &Wendland) -> Self {
        let (d, ratio) = if dimensions == 2 { (2.0, 10.0 / 9.0) } else { (3.0, 4.0 / 3.0) };
        let cube = liquid.density * liquid.density * liquid.density;
        Self {
            artificial: formulation.viscosity * kernel.h * liquid.sound_speed / cube,
            laminar: 4.0 * (d + 2.0) * formulation.kinematic_viscosity / (ratio * kernel.h * kernel.h),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shear along the rows of a lattice and across, from the sums over the lattice themselves: measured −4.0 to +4.4 % of ν.
    #[test]
    fn friction_of_a_lattice_hardly_depends_on_the_direction() {
        let liquid = Liquid { density: 1.0, sound_speed: 1.0 };
        for dimensions in [2, 3] {
            for smoothing in [1.3, 1.55, 2.0] {
                let kernel = Wendland::new(dimensions, smoothing);
                let formulation = Formulation { kinematic_viscosity: 1.0, ..Formulation::default() };
                let laminar = Viscosity::new(dimensions, &formulation, &liquid, &kernel).laminar;
                let (mut rows, mut along) = (0.0, 0.0);
                let depth = if dimensions == 2 { 0 } else { 4 };
                for (i, j) in (-4_i32..=4).flat_map(|i| (-4_i32..=4).map(move |j| (i, j))) {
                    for k in -depth..=depth {
                        let [x, y] = [i, j].map(f64::from);
                        // Of v_y = ½x² the sum is −¼ Σ 4(d + 2)ν/(κh²) F x²y², masses and densities one.
                        let weight = -0.25 * laminar * kernel.factor(f64::from(i * i + j * j + k * k).sqrt());
                        rows += weight * x * x * y * y;
                        along += weight * x * x * x * x;
                    }
                }
                // Turned by 45°, x²y² becomes ¼(x² − y²)².
                for found in [rows, 0.5 * (along - rows)] {
                    assert!((found - 1.0).abs() < 0.06, "{dimensions} {smoothing}: {found}");
                }
            }
        }
    }
}
