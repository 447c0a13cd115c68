//! What a section does as it is heated: the resultants that keep it as it was.
//!
//! At the height ζ over the middle of its thickness t a section is warmer by θ(ζ) = θ₀ + ζ θ₁, θ₀ the change in its middle and t θ₁ that of the upper
//! face less that of the lower. Free, a ply would take the strain ᾱθ, ᾱ its coefficients in the axes of the point; what it resists is what its strain
//! has beyond that:
//!
//! ```text
//! σ = Q̄ (e + ζκ − ᾱθ)        ψ = ½ Σ∫ (e + ζκ − ᾱθ)·Q̄ (e + ζκ − ᾱθ) dζ = ½ ε·Cε − N_θ·e − M_θ·κ + ψ_θ
//! N_θ = θ₀ a₀ + θ₁ a₁        M_θ = θ₀ a₁ + θ₁ a₂                      a_k = Σ∫ Q̄ᾱ ζ^k dζ
//! ψ_θ = ½ (θ₀² q₀ + 2 θ₀θ₁ q₁ + θ₁² q₂)                               q_k = Σ∫ ᾱ·Q̄ᾱ ζ^k dζ
//! ```
//!
//! with ε the strains of the section and C its stiffness \[jones1999\]. To the strains, heat is thus a stress that is there before anything is strained, of
//! the resultants −N_θ and −M_θ: forces stay the derivative of ψ, and the tangent is that of the section. ψ is all that is stored, zero where every ply is
//! as long as it would be alone. Strains are those of the shell's measure, e = ½(C − 1) or ln U: lengths grow by αθ to the first order.

/// Resultants and energy of a section that is heated and kept from straining, by degrees of temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expansion {
    /// a₀ \[F/(L Θ)\], a₁ \[F/Θ\], a₂ \[F L/Θ\], `11, 22, 12` of each.
    forces: [[f64; 3]; 3],
    /// q₀ \[F/(L Θ²)\], q₁ \[F/Θ²\], q₂ \[F L/Θ²\].
    works: [f64; 3],
    /// t \[L\].
    thickness: f64,
}

/// What keeps a heated section as it was.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Blocked {
    /// N_θ \[F/L\], then M_θ about the surface of the particles \[F\], `11, 22, 12` of each: the section presses with them.
    pub resultants: [f64; 6],
    /// ψ_θ, stored by a reference area \[F/L\].
    pub energy: f64,
}

impl Expansion {
    /// That of a section of a thickness without plies.
    pub(crate) fn none(thickness: f64) -> Self {
        Self { forces: [[0.0; 3]; 3], works: [0.0; 3], thickness }
    }

    /// That of one isotropic material with the stiffness `E/(1 − ν)` \[F/L²\] against strains that are alike in all directions.
    pub(crate) fn isotropic(stiffness: f64, expansion: f64, thickness: f64) -> Self {
        let force = |moment: f64| [stiffness * expansion * moment, stiffness * expansion * moment, 0.0];
        let work = |moment: f64| 2.0 * stiffness * expansion * expansion * moment;
        let cube = thickness.powi(3) / 12.0;
        Self {
            forces: [force(thickness), [0.0; 3], force(cube)],
            works: [work(thickness), 0.0, work(cube)],
            thickness,
        }
    }

    /// The same with one more ply: its plane stiffness Q̄ \[F/L²\], its free strain `11, 22, 2·12` \[1/Θ\], ∫1, ∫ζ and ∫ζ² over it.
    pub(crate) fn with_ply(mut self, plane: &[[f64; 3]; 3], free: [f64; 3], moments: [f64; 3]) -> Self {
        let stress = plane.map(|row| (0..3).map(|j| row[j] * free[j]).sum::<f64>());
        let work: f64 = (0..3).map(|i| stress[i] * free[i]).sum();
        for (k, moment) in moments.into_iter().enumerate() {
            (0..3).for_each(|i| self.forces[k][i] += stress[i] * moment);
            self.works[k] += work * moment;
        }
        self
    }

    /// What keeps the section as it was while its middle, at a height over the particles \[L\], warms by the first and its upper face by the second
    /// more than its lower \[Θ\].
    pub fn blocked(&self, [change, difference]: [f64; 2], height: f64) -> Blocked {
        let slope = difference / self.thickness;
        let [a0, a1, a2] = &self.forces;
        let [q0, q1, q2] = self.works;
        let mut resultants = [0.0; 6];
        for i in 0..3 {
            let force = change * a0[i] + slope * a1[i];
            resultants[i] = force;
            resultants[3 + i] = change * a1[i] + slope * a2[i] + height * force;
        }
        let energy = 0.5 * (change * change * q0 + 2.0 * change * slope * q1 + slope * slope * q2);
        Blocked { resultants, energy }
    }

    /// θ₀ in the middle \[Θ\] and θ₁ by height \[Θ/L\] of which resultants about the middle keep the section as it was, by least squares: `N_θ = θ₀ a₀ + θ₁ a₁`,
    /// `M_θ = θ₀ a₁ + θ₁ a₂`, moments and θ₁ in units of the thickness. Zero where heat does nothing to the section.
    pub(crate) fn temperatures(&self, resultants: &[f64; 6]) -> [f64; 2] {
        let t = self.thickness;
        let [a0, a1, a2] = &self.forces;
        let column = |of: [&[f64; 3]; 2], by: f64| -> [f64; 6] {
            std::array::from_fn(|i| if i < 3 { of[0][i] / by } else { of[1][i - 3] / (t * by) })
        };
        let [first, second] = [column([a0, a1], 1.0), column([a1, a2], t)];
        let right: [f64; 6] = std::array::from_fn(|i| if i < 3 { resultants[i] } else { resultants[i] / t });
        let dot = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let [p, q, r] = [dot(&first, &first), dot(&first, &second), dot(&second, &second)];
        let [x, y] = [dot(&first, &right), dot(&second, &right)];
        let whole = p * r - q * q;
        // Columns that are zero or along each other: what is left of them says one number.
        if whole <= 1e-12 * p * r {
            return if p > 0.0 { [x / p, 0.0] } else { [0.0; 2] };
        }
        [(x * r - y * q) / whole, (y * p - x * q) / whole / t]
    }
}
