//! Stresses that are in a shell before anything is strained, as a scene says them.

use schemars::JsonSchema;
use serde::Deserialize;

/// A stress of the unloaded shell, of welding or forming, or of a sheet that was stretched into its frame: `membrane`, `bending` or both.
///
/// Stresses of one cell add up. They are tensors σ11, σ22, σ12 whose first direction is the projection of `axis` on the surface, the second at
/// right angles to it about the normal. An analysis without time brings them into balance before anything else, a run in real time
/// sets out from the shell as it is drawn.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InitialStress {
    /// Set of cells: a group of faces of the mesh, a declared set, `all`.
    pub on: String,
    /// Direction whose projection on the surface is the first, in the un-turned frame; left out where the stress is the same in all directions.
    pub axis: Option<[f64; 3]>,
    /// Mean through the thickness, `[σ11, σ22, σ12]` \[F/L²\].
    pub membrane: Option<[f64; 3]>,
    /// Linear part at the upper face, to which the normals point, `[σ11, σ22, σ12]`; the lower face has the opposite \[F/L²\].
    pub bending: Option<[f64; 3]>,
}

impl InitialStress {
    /// Whether it is the same in all directions.
    pub(crate) fn isotropic(&self) -> bool {
        let same = |[s11, s22, s12]: [f64; 3]| s11 == s22 && s12 == 0.0;
        [self.membrane, self.bending].into_iter().flatten().all(same)
    }
}
