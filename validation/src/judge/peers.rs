//! Answers of other programs to a case, with what they cost there in units of a run of ours on the same machine.

use super::{CaseResult, Run};
use crate::JudgeError;

/// What other programs found, and the run of ours that their costs are counted in.
#[derive(Clone, Debug)]
pub struct Peers {
    /// Method of the run whose time is one.
    pub method: &'static str,
    /// Its lattice.
    pub grid: &'static str,
    /// One of each program and mesh.
    pub answers: Vec<Peer>,
}

/// An answer of another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Peer {
    /// Program and element.
    pub method: String,
    /// How far it is off, in the unit of the case's headline.
    pub error: f64,
    /// Its time over that of our run, both taken in turn on one thread of one machine \[–\].
    pub cost: f64,
}

/// The answers of other programs to a case as `(method, (time here \[s\], error))`: as long as our run took here, times their
/// cost. None where that run was not made.
///
/// # Errors
/// [`JudgeError`] from the stored answers.
pub fn peers_here(result: &CaseResult) -> Result<Vec<(String, (f64, f64))>, JudgeError> {
    let Some(peers) = (result.case.peers)()? else { return Ok(Vec::new()) };
    let here = |run: &&Run| run.variant.method == peers.method && run.variant.grid == peers.grid;
    let Some(unit) = result.runs.iter().find(here).map(|run| run.outcome.seconds_per_point()) else {
        return Ok(Vec::new());
    };
    Ok(peers.answers.into_iter().map(|peer| (peer.method, (peer.cost * unit, peer.error))).collect())
}
