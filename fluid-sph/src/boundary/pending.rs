//! Where a structure is to be at the end of a step.

use explicit_dynamics::BoundaryState;

/// The next place of a structure, as settling.rs puts it there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pending {
    /// Whether it is still to be put there.
    pub due: bool,
    /// The place.
    pub end: BoundaryState,
    /// Mean velocities of its points on the way \[L/T\].
    pub velocities: Vec<[f64; 3]>,
}
