//! Names of columns that stand beside those of a scene.

/// The name of the column that has the mean of one.
pub(crate) fn mean_of(column: &str) -> String {
    format!("{column}_mean")
}

/// The name of the column that has the phase of one.
pub(crate) fn phase_of(column: &str) -> String {
    format!("{column}_phase")
}
