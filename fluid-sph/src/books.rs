//! What is booked between two kicks: the clock asks for work and losses at kicks only.

/// What was booked so far, and what the next kick hands over.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Books {
    pub viscous: f64,
    pub diffusion: f64,
    /// Work of boundaries and, of a predictor and corrector, of gravity since the last kick.
    pub external: f64,
    /// Losses since the last kick.
    pub dissipated: f64,
    /// Greatest |ρ/ρ₀ − 1| so far.
    pub density_error: f64,
}
