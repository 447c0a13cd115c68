//! Bonds of bodies that are warmer: their extensions count from the lengths that they have were the body free.
//!
//! ```text
//! r(λ) = r (1 + λ ½(αΔTᵢ + αΔTⱼ))
//! ```
//!
//! [madenci2014, ch. 4]. A body of one temperature that nothing holds, and by the mean of both ends one whose temperature is linear in space, is free
//! of stress whatever its law and its weights; extensions, dilatations and limits of bonds are those of what is left.

use lanes::Pack;

/// Lengths of bonds by the level of heat.
#[derive(Clone, Debug)]
pub(crate) struct BondHeat {
    /// Lengths at rest, as cold as the body was built \[L\].
    pub cold: Vec<Pack>,
    /// By how much each bond would grow were the body free, at level one \[L\].
    pub growth: Vec<Pack>,
}

impl BondHeat {
    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.cold[..]) + size_of_val(&self.growth[..])
    }
}
