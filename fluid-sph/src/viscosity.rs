//! Friction between two particles: the artificial viscosity of \[monaghan1992\] and laminar flow as in \[lo2002\].
//!
//! ```text
//! Π_ab = −α c̄ μ/ρ̄,  μ = h min(v_ab·r_ab, 0)/(r² + η²)          a_a = − Σ m_b Π_ab F r_ab
//! a_a = Σ m_b 4ν F r² v_ab/[(ρ_a + ρ_b)(r² + η²)]
//! ```

use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;

/// What both need beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viscosity {
    /// `α h c₀/ρ₀³`: with it `Π = −artificial (ρ_a³ + ρ_b³) min(v·r, 0)/[(ρ_a + ρ_b)(r² + η²)]`, as c ∝ ρ³.
    pub artificial: f64,
    /// 4ν \[L²/T\].
    pub laminar: f64,
}

impl Viscosity {
    /// Those of a formulation.
    pub fn new(formulation: &Formulation, liquid: &Liquid, kernel: &Wendland) -> Self {
        let cube = liquid.density * liquid.density * liquid.density;
        Self {
            artificial: formulation.viscosity * kernel.h * liquid.sound_speed / cube,
            laminar: 4.0 * formulation.kinematic_viscosity,
        }
    }
}
