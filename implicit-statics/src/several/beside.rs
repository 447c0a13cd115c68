//! What each system has beside its pattern, among the unknowns of all.

use super::interaction::Joinable;
use super::system::Several;
use crate::rank_one::RankOne;

impl<S: Joinable + ?Sized> Several<S> {
    /// The terms of all systems.
    pub(super) fn beside(&mut self, level: f64) -> Vec<RankOne> {
        let unknowns = self.first.last().copied().unwrap_or(0);
        let mut terms = Vec::new();
        for (system, range) in self.parts(|own| &own.first) {
            for own in system.beside_pattern(level) {
                let mut along = vec![0.0; unknowns];
                along[range.clone()].copy_from_slice(&own.along);
                terms.push(RankOne { along, ..own });
            }
        }
        terms
    }
}
