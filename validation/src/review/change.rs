//! A case beside what was reviewed of it.

use super::reviewed::Reviewed;
use crate::judge::CaseResult;

/// A case whose results are not as they were reviewed.
pub struct Change<'a> {
    /// The case as it is now.
    pub result: &'a CaseResult,
    /// Its runs as they were reviewed; empty where the case is new.
    pub stored: Vec<Reviewed>,
}

impl Change<'_> {
    /// A run as it was reviewed; none if it is new.
    pub fn reviewed(&self, method: &str, grid: &str) -> Option<&Reviewed> {
        self.stored.iter().find(|run| run.method == method && run.grid == grid)
    }
}
