//! What boundaries owe between two ends of a step; the work that comes of it is in points.rs.

/// What is known by particle of the boundary between two ends of a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ledger {
    /// P/ρ² at the last end \[L⁵/(M T²)\].
    pub shares: Vec<f64>,
    /// Half of what the density would have changed by since then \[M/L³\].
    pub owed: Vec<f64>,
    /// Half of the step since then \[T\].
    pub time: f64,
}

impl Ledger {
    /// Of so many particles, before the first step.
    pub fn new(count: usize) -> Self {
        Self { shares: vec![0.0; count], owed: vec![0.0; count], time: 0.0 }
    }
}
