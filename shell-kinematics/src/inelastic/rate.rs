//! Rate: by how much the yield stress of a point that flows fast exceeds that of one that flows slowly.
//!
//! Where the equivalent plastic strain grows at the rate ε̇ the yield stress is `(1 + s) K(α)`, with the overstress
//!
//! ```text
//! s = (ε̇/D)^(1/p)                   [cowper1957]
//! s = C ln max(1, ε̇/ε̇₀)             [johnson1983], without heat
//! ```
//!
//! A step that takes the time Δt has `ε̇ = Δα/Δt`. Solved for s, with `Δα = Δt ε̇(s)`, its equation is convex and has no infinite slope where the flow begins
//! (inelastic/flow_step.rs).

use super::functions::{exp, ln};
use super::hardening::positive;
use crate::pack::Number;
use crate::section::MaterialError;

/// The least number whose logarithm is taken.
const LEAST: f64 = 1e-300;

/// How the yield stress grows with the rate of plastic strain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate(Law);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Law {
    CowperSymonds { reference: f64, exponent: f64 },
    JohnsonCook { reference: f64, factor: f64 },
}

impl Rate {
    /// Cowper and Symonds: at the rate D \[1/T\] the yield stress is twice that of slow flow, `s = (ε̇/D)^(1/p)`.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `D > 0` and `p ≥ 1`, both finite.
    pub fn cowper_symonds(reference: f64, exponent: f64) -> Result<Self, MaterialError> {
        let reference = positive("the reference rate of Cowper and Symonds", reference)?;
        let what = "the exponent of Cowper and Symonds";
        if positive(what, exponent)? < 1.0 {
            return Err(MaterialError::Constant { what, value: exponent, bound: "at least 1" });
        }
        Ok(Self(Law::CowperSymonds { reference, exponent }))
    }

    /// Johnson and Cook, without heat: no change up to the rate ε̇₀ \[1/T\], beyond it `s = C ln(ε̇/ε̇₀)`.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `ε̇₀ > 0` and `C > 0`, both finite.
    pub fn johnson_cook(reference: f64, factor: f64) -> Result<Self, MaterialError> {
        Ok(Self(Law::JohnsonCook {
            reference: positive("the reference rate of Johnson and Cook", reference)?,
            factor: positive("the factor of Johnson and Cook", factor)?,
        }))
    }

    /// The overstress s of a rate \[–\]; zero or less where it changes nothing.
    #[inline(always)]
    pub(super) fn overstress<P: Number>(&self, rate: P) -> P {
        let log = |reference: f64| ln((rate * (1.0 / reference)).max(rate.all(LEAST)));
        match self.0 {
            Law::CowperSymonds { reference, exponent } => exp(log(reference) * (1.0 / exponent)),
            Law::JohnsonCook { reference, factor } => log(reference) * factor,
        }
    }

    /// The flow Δα of a step of a duration \[T\] at an overstress, and by how much it grows with that.
    #[inline(always)]
    pub(super) fn flow<P: Number>(&self, overstress: P, duration: f64) -> [P; 2] {
        match self.0 {
            Law::CowperSymonds { reference, exponent } => {
                let s = overstress.max(overstress.all(LEAST));
                let flow = exp(ln(s) * exponent) * (reference * duration);
                [flow, flow * exponent / s]
            }
            Law::JohnsonCook { reference, factor } => {
                let flow = exp(overstress * (1.0 / factor)) * (reference * duration);
                [flow, flow * (1.0 / factor)]
            }
        }
    }
}
