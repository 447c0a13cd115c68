//! Points through the thickness: what each was committed as, and what a step makes of it.

use super::hardening::{not_negative, positive};
use crate::section::MaterialError;

/// Numbers of a history that each slice has: three plastic strains in the coordinates of [`super::modes`], then α; behind them three of each back stress that recovers, and
/// the overstress where rates count.
pub(super) const OF_SLICE: usize = 4;

/// The most back stresses that recover.
pub const MOST_BACK_STRESSES: usize = 3;
/// A back stress that recovers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BackStress {
    pub(super) modulus: f64,
    pub(super) recovery: f64,
}

impl BackStress {
    /// One that grows by H \[F/L²\] a plastic strain at first, in uniaxial tension, and nears H/g with the rate g \[–\].
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless `H > 0` and `g ≥ 0`, both finite.
    pub fn new(modulus: f64, recovery: f64) -> Result<Self, MaterialError> {
        Ok(Self {
            modulus: positive("the modulus of a back stress", modulus)?,
            recovery: not_negative("the recovery of a back stress", recovery)?,
        })
    }

    /// ⅔H \[F/L²\].
    pub(super) fn own(&self) -> f64 {
        self.modulus * 2.0 / 3.0
    }
}

/// Back stresses of a point, in the coordinates of its modes; those beyond the number of the law are zero.
pub(super) type Backs<P> = [[P; 3]; MOST_BACK_STRESSES];

/// How fast a step goes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pace<P> {
    /// So slowly that rates do nothing.
    Slow,
    /// Outside of time, with an overstress that stays what it is \[–\].
    Held(P),
    /// In so much time \[T\].
    Lasting(f64),
}

/// What a point was committed as.
#[derive(Clone, Copy, Debug)]
pub(super) struct Committed<P> {
    /// e_p.
    pub plastic: [P; 3],
    /// Equivalent plastic strain.
    pub alpha: P,
    /// Back stresses that recover.
    pub backs: Backs<P>,
}

/// What a step makes of a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<P> {
    /// Elastic strain, or stress: x.
    pub stress: [P; 3],
    /// e_p.
    pub plastic: [P; 3],
    /// Equivalent plastic strain.
    pub alpha: P,
    /// γ, zero where nothing flows \[L²/F\].
    pub gamma: P,
    /// ξ.
    pub over: [P; 3],
    /// One where the tangent is that of flow: on the surface at least.
    pub on_surface: P,
    /// s, by which the yield stress exceeds that of slow flow \[–\].
    pub overstress: P,
}
