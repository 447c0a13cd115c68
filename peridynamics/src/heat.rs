//! By how much a body is warmed.

/// By how much, and at which level.
#[derive(Clone, Debug)]
pub(crate) struct Heat {
    /// αΔT of each node at level one \[–\].
    pub strains: Vec<f64>,
    /// The level that its bonds have.
    pub level: f64,
    /// Norm of what bonds would pull with at level one were all nodes held \[F\].
    pub exerts: f64,
}
