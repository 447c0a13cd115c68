//! Heat that runs along the bonds of a solid: by the weights that carry it.
//!
//! ```text
//! U = Σᵢ Vᵢ ½ Σⱼ κᵢⱼ (Tⱼ − Tᵢ)²        κᵢⱼ = k Cᵢⱼ/((d + 2) μ)        g = Vᵢ κᵢⱼ + Vⱼ κⱼᵢ        qᵢ = Σⱼ g (Tⱼ − Tᵢ)
//! ```
//!
//! after \[bobaru2010\], its micro-conductivity taken from the weights C of the crate (`correction`): with `Σⱼ C r² n_a² n_b²` that of the solid on any axes, `Σⱼ κ r² n_a²` is k at each node,
//! also at faces where weights are even. Balanced weights give more: what their stiffness pulls on a node under a uniform strain is what the face pulls, and contracted, `Σⱼ g r n = −k aᵢ`:
//! a temperature that is linear in space is in balance with the heat through its faces, node by node, to rounding. No conductance is negative, so that nothing is warmer than what
//! warms it. Bonds that are cut conduct nothing: a crack is a slit through which no heat runs.

use heat_conduction::Network;

use crate::error::SolidError;
use crate::solid::Solid;

impl Solid {
    /// The bonds as pairs of nodes that conduct heat, by a conductivity \[F/(T Θ)\].
    ///
    /// # Errors
    /// [`SolidError::Conduction`] for a plate of two sheets.
    pub fn conduction(&self, conductivity: f64) -> Result<Network, SolidError> {
        let Some(stiffness) = self.mechanics.pairs() else { return Err(SolidError::Conduction) };
        let d = self.block.dimensions as f64;
        let by = conductivity / ((d + 2.0) * self.shear_modulus);
        Ok(Network::new(self.len(), stiffness.into_iter().map(|(a, b, own)| (a, b, by * own)).collect()))
    }
}
