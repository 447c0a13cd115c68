//! What glue between two bodies does now.

/// Glue, for the forces last evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct GlueNow {
    /// The set and the body that it joins.
    pub between: String,
    /// Number of particles that are glued.
    pub particles: usize,
    /// Their stiffnesses, summed \[F/L\].
    pub stiffness: f64,
    /// Greatest distance of a particle from where it is held \[L\].
    pub gap: f64,
    /// Spacing of the bodies \[L\].
    pub spacing: f64,
    /// Energy stored \[F L\].
    pub energy: f64,
}
