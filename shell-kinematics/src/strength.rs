//! Strengths of plies: failure criteria of plane stress, their index and the reserve factor.
//!
//! A criterion says `f(σ) = 1` where a ply fails. Each is a sum of a linear and a quadratic part of the stresses σ₁ along the fibre, σ₂ across it and τ,
//!
//! ```text
//! f(λσ) = λ b + λ² a        index f(σ) = a + b        reserve factor λ > 0 of f(λσ) = 1:  λ = 2/(b + √(b² + 4a))
//! ```
//!
//! The index says only whether a ply holds; the reserve factor by what its stresses may grow together. With X, Y, S the strengths along and across the fibre and in
//! shear, t in tension and c in compression:
//!
//! ```text
//! Tsai–Wu [tsai1971]   b = F₁σ₁ + F₂σ₂          F₁ = 1/X_t − 1/X_c    F₂ = 1/Y_t − 1/Y_c
//!                      a = F₁₁σ₁² + F₂₂σ₂² + F₆₆τ² + 2F₁₂σ₁σ₂        F₁₁ = 1/X_tX_c   F₂₂ = 1/Y_tY_c   F₆₆ = 1/S²   F₁₂ = f √(F₁₁F₂₂)
//! Hashin [hashin1980]  fibre, σ₁ ≥ 0   a = (σ₁/X_t)² + (τ/S)²                            σ₁ < 0   a = (σ₁/X_c)²
//!                      matrix, σ₂ ≥ 0  a = (σ₂/Y_t)² + (τ/S)²
//!                      matrix, σ₂ < 0  a = (σ₂/2S_t)² + (τ/S)²    b = [(Y_c/2S_t)² − 1] σ₂/Y_c
//! von Mises            a = (σ₁² + σ₂² − σ₁σ₂ + 3τ²)/σ_Y²
//! ```
//!
//! f lies strictly between −1 and 1, where `f(σ) = 1` is a closed surface; −½ makes the criterion of equal strengths that of von Mises. S_t is the shear
//! strength in the plane across the fibre. Of Hashin's modes the one that fails first counts.

use crate::section::MaterialError;

/// Strengths of a ply along and across its fibre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FibreStrength {
    along: [f64; 2],
    across: [f64; 2],
    shear: f64,
    shear_across: f64,
    interaction: f64,
}

/// What a ply bears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Strength {
    /// One with a fibre.
    Fibre(FibreStrength),
    /// One that is alike in all directions, by von Mises: its yield strength \[F/L²\].
    Yield(f64),
}

/// A criterion for plies with a fibre; others are judged by von Mises.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criterion {
    /// One surface through all strengths.
    TsaiWu,
    /// Fibre and matrix apart, of which the one that fails first counts.
    Hashin,
}

/// How near a stress is to failure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// `f(σ)`, one at failure \[–\].
    pub index: f64,
    /// Factor on the stress at which the index is one \[–\]; infinite where it never is.
    pub reserve: f64,
}

impl Margin {
    /// That of no stress.
    pub const NONE: Self = Self { index: 0.0, reserve: f64::INFINITY };

    /// Of the quadratic and the linear part of a criterion.
    fn of(quadratic: f64, linear: f64) -> Self {
        let below = linear + (linear * linear + 4.0 * quadratic).sqrt();
        Self { index: quadratic + linear, reserve: if below > 0.0 { 2.0 / below } else { f64::INFINITY } }
    }

    /// The greater index and the smaller reserve of both.
    pub fn worse(self, other: Self) -> Self {
        Self { index: self.index.max(other.index), reserve: self.reserve.min(other.reserve) }
    }
}

/// A strength, if it is positive.
fn positive(what: &'static str, value: f64) -> Result<f64, MaterialError> {
    let bound = "positive and finite";
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(MaterialError::Constant { what, value, bound })
    }
}

impl FibreStrength {
    /// Strengths in tension and compression along the fibre and across it, and in shear between the two, all positive \[F/L²\]. The interaction is −½, the
    /// shear strength across the fibre half of the compressive strength there: a fracture at 45°.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless all are positive and finite.
    pub fn new(along: [f64; 2], across: [f64; 2], shear: f64) -> Result<Self, MaterialError> {
        let along = [
            positive("the tensile strength along the fibre", along[0])?,
            positive("the compressive strength along the fibre", along[1])?,
        ];
        let across = [
            positive("the tensile strength across the fibre", across[0])?,
            positive("the compressive strength across the fibre", across[1])?,
        ];
        let shear = positive("the shear strength", shear)?;
        Ok(Self { along, across, shear, shear_across: 0.5 * across[1], interaction: -0.5 })
    }

    /// The same with another interaction f of Tsai and Wu \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless it lies strictly between −1 and 1.
    pub fn interacting(self, interaction: f64) -> Result<Self, MaterialError> {
        if interaction.abs() < 1.0 {
            return Ok(Self { interaction, ..self });
        }
        let (what, bound) = ("the interaction of Tsai and Wu", "strictly between -1 and 1");
        Err(MaterialError::Constant { what, value: interaction, bound })
    }

    /// The same with another shear strength in the plane across the fibre \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless it is positive and finite.
    pub fn sheared_across(self, strength: f64) -> Result<Self, MaterialError> {
        Ok(Self { shear_across: positive("the shear strength across the fibre", strength)?, ..self })
    }

    /// The margin of stresses `σ₁, σ₂, τ` in the axes of the fibre \[F/L²\].
    pub fn margin(&self, criterion: Criterion, stress: [f64; 3]) -> Margin {
        match criterion {
            Criterion::TsaiWu => self.tsai_wu(stress),
            Criterion::Hashin => self.hashin(stress),
        }
    }

    fn tsai_wu(&self, [s1, s2, s6]: [f64; 3]) -> Margin {
        let ([xt, xc], [yt, yc]) = (self.along, self.across);
        // Roots of the quadratic parts: √F₁₁σ₁ and √F₂₂σ₂.
        let [a1, a2, a6] = [s1 / (xt * xc).sqrt(), s2 / (yt * yc).sqrt(), s6 / self.shear];
        let linear = s1 * (1.0 / xt - 1.0 / xc) + s2 * (1.0 / yt - 1.0 / yc);
        Margin::of(a1 * a1 + a2 * a2 + a6 * a6 + 2.0 * self.interaction * a1 * a2, linear)
    }

    fn hashin(&self, [s1, s2, s6]: [f64; 3]) -> Margin {
        let square = |x: f64| x * x;
        let sheared = square(s6 / self.shear);
        let fibre = match s1 >= 0.0 {
            true => square(s1 / self.along[0]) + sheared,
            false => square(s1 / self.along[1]),
        };
        let [yt, yc] = self.across;
        let matrix = match s2 >= 0.0 {
            true => Margin::of(square(s2 / yt) + sheared, 0.0),
            false => {
                let twice = 2.0 * self.shear_across;
                Margin::of(square(s2 / twice) + sheared, (square(yc / twice) - 1.0) * s2 / yc)
            }
        };
        Margin::of(fibre, 0.0).worse(matrix)
    }
}

impl Strength {
    /// One that is alike in all directions \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless it is positive and finite.
    pub fn of_yield(strength: f64) -> Result<Self, MaterialError> {
        positive("the yield strength", strength).map(Self::Yield)
    }

    /// The margin of stresses `σ₁, σ₂, τ` in the axes of the ply \[F/L²\].
    pub fn margin(&self, criterion: Criterion, stress: [f64; 3]) -> Margin {
        match self {
            Self::Fibre(strength) => strength.margin(criterion, stress),
            Self::Yield(strength) => {
                let [a, b, c] = stress.map(|value| value / strength);
                Margin::of(a * a + b * b - a * b + 3.0 * c * c, 0.0)
            }
        }
    }
}
