//! A command that a launcher of MPI started several times: the processes do it together, and the first of them speaks.

use peers::Peers;

use super::launcher::{Launched, launched};
use super::stderr::{Refused, be_silent, speak};
use crate::{Model, Ranks};

/// Processes that a launcher started together, this one among them.
pub trait ProcessGroup {
    /// They as those who march one model; all of them call it together.
    fn peers(&self) -> Box<dyn Peers>;

    /// Ends all of them at once, whatever they are doing, with one message.
    fn end(&self, message: &str) -> !;
}

/// The process of a command, and those who were started with it.
pub struct Company<'a> {
    ranks: Option<Ranks>,
    group: Option<&'a dyn ProcessGroup>,
}

impl<'a> Company<'a> {
    /// Of those who were started together; all but the first are silent from here on.
    ///
    /// # Errors
    /// A launcher started several, but nothing joined them.
    pub fn new(group: Option<&'a dyn ProcessGroup>) -> Result<Self, Refused> {
        let ranks = group.map(|group| Ranks::new(group.peers()));
        if ranks.as_ref().is_some_and(|ranks| !ranks.is_first()) {
            be_silent();
        }
        match launched() {
            Some(Launched { count, rank, variable }) if count > 1 && group.is_none() => {
                if rank.is_some_and(|rank| rank > 0) {
                    be_silent();
                }
                Err(Refused::from(format!(
                    "a launcher started {count} processes ({variable}), and each of them would do the whole run: start coque-mpi in place of \
                     coque (cargo install --path coque-mpi --features mpi), or, for runs of their own, `env -u {variable} coque …`\n"
                )))
            }
            _ => Ok(Self { ranks, group }),
        }
    }

    /// Those who do it together; none where one process does.
    pub fn ranks(&self) -> Option<&Ranks> {
        self.ranks.as_ref()
    }

    /// Whether this one speaks and writes.
    pub fn is_first(&self) -> bool {
        self.ranks.as_ref().is_none_or(Ranks::is_first)
    }

    /// What each of them did: where one failed all do, and the least of those that failed says why.
    pub fn all<T>(&self, own: Result<T, Refused>) -> Result<T, Refused> {
        let Some(ranks) = &self.ranks else { return own };
        let Some(failed) = ranks.failed(own.is_err()) else { return own };
        if failed != ranks.rank() {
            return Err(Refused::unsaid());
        }
        speak();
        own.map_err(|refused| if failed == 0 { refused } else { refused.by(&format!("rank {failed}: ")) })
    }

    /// Refuses what is not the same for all of them, by its checksum.
    pub fn same(&self, checksum: u32, what: &str) -> Result<(), Refused> {
        match &self.ranks {
            Some(ranks) if !ranks.same(checksum) => Err(Refused::from(format!(
                "the processes do not have the same {what}: give all of them the same files and options, in a folder that every machine sees\n"
            ))),
            _ => Ok(()),
        }
    }

    /// Makes a model one that all of them run, if they have the same.
    pub fn share(&self, model: &mut Model) -> Result<(), Refused> {
        let Some(ranks) = &self.ranks else { return Ok(()) };
        self.same(model.checksum(), "mesh")?;
        model.share(ranks).map_err(|refused| Refused::from(format!("{refused}\n")))
    }

    /// What came out of a part that one process does while the others are in the run; a failure there ends all of them.
    pub fn sure<T>(&self, result: Result<T, String>) -> Result<T, String> {
        match (self.group, result) {
            (Some(group), Err(error)) => group.end(error.trim_end()),
            (_, result) => result,
        }
    }
}
