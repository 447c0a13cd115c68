//! How many eigenvalues of a symmetric matrix lie on either side of zero.

/// Signs of the eigenvalues of a symmetric matrix (Sylvester's law: of the pivots of any factor).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Inertia {
    /// Eigenvalues above zero.
    pub positive: usize,
    /// Eigenvalues below zero.
    pub negative: usize,
    /// Eigenvalues that vanish within rounding of the scaled matrix.
    pub zero: usize,
}
