//! Names of metrics that more than one place knows.

/// How far an answer is off; the survival table shows it.
pub const ERROR: &str = "error";
/// What is left between the explicit and the static run.
pub const DYNAMICS: &str = "explicit − static";
/// Levels at which the motion had not died.
pub const REST: &str = "unsettled levels";
/// Asserts a failure as it is, with its cause.
pub const KNOWN: &str = "known failure";
/// Fails an answer that is far off and says nothing.
pub const SILENT: &str = "off without a warning";
