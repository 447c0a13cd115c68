//! What a ply bears, as a scene says it.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::scene::bounded::Positive;

/// Strengths of a ply along and across its fibre, all positive.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FibreStrength {
    /// X_t, in tension along the fibre \[F/L²\].
    pub along_tension: Positive,
    /// X_c, in compression along the fibre \[F/L²\].
    pub along_compression: Positive,
    /// Y_t, in tension across the fibre \[F/L²\].
    pub across_tension: Positive,
    /// Y_c, in compression across the fibre \[F/L²\].
    pub across_compression: Positive,
    /// S, in shear between the two \[F/L²\].
    pub shear: Positive,
    /// S_t of Hashin, in shear in the plane across the fibre \[F/L²\]; half of Y_c without, which is a fracture at 45°.
    pub shear_across: Option<Positive>,
    /// Interaction f of Tsai and Wu, F₁₂ = f √(F₁₁F₂₂), between −1 and 1 \[–\]; −½ without.
    pub interaction: Option<f64>,
}
