//! Friction between two particles: the artificial viscosity of \[monaghan1992\] and, of its form, laminar flow \[monaghan2005\].
//!
//! ```text
//! a_a = −Σ m_b Π_ab F r_ab
//! Π_ab = −α c̄ h min(v_ab·r_ab, 0)/[ρ̄ (r² + η²)] − 4(d + 2) ν v_ab·r_ab/[(ρ_a + ρ_b)(r² + η²)]
//! ```
//!
//! The second is ν∇²v + 2ν∇(∇·v) in the limit of fine kernels: to second order `v_ab = (r·∇)v − ½(r·∇)²v`, the first term
//! sums to zero by symmetry, and `∫ F r_i r_j r_k r_l/r² dV = −(δ_ij δ_kl + δ_ik δ_jl + δ_il δ_jk)/(d + 2)` because
//! `∫ F r² dV = −d`. In a flow that hardly changes its volume that is the friction of a Newtonian fluid. Forces along v_ab
//! would do for the momentum, but not for its moment: a fluid in rigid rotation would be braked at the walls.

use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;

/// What both need beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viscosity {
    /// `α h c₀/ρ₀³`: with it `Π = −artificial (ρ_a³ + ρ_b³) min(v·r, 0)/[(ρ_a + ρ_b)(r² + η²)]`, as c ∝ ρ³.
    pub artificial: f64,
    /// 4(d + 2)ν \[L²/T\].
    pub laminar: f64,
}

impl Viscosity {
    /// Those of a formulation, in so many dimensions.
    pub fn new(dimensions: usize, formulation: &Formulation, liquid: &Liquid, kernel: &Wendland) -> Self {
        let cube = liquid.density * liquid.density * liquid.density;
        Self {
            artificial: formulation.viscosity * kernel.h * liquid.sound_speed / cube,
            laminar: 4.0 * (dimensions as f64 + 2.0) * formulation.kinematic_viscosity,
        }
    }
}
