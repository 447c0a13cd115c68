//! How the numbers of a point where a shell is strained lie in a row.

/// Numbers of a point that grow with a small motion: strains `e11 e22 2e12 κ11 κ22 2κ12 γ1 γ2`, then the resultants
/// `N11 N22 N12 M11 M22 M12 Q1 Q2`.
pub const POINT_NUMBERS: usize = 16;
