//! The processes of an MPI run: how one joins them, and how all end at once.

use std::sync::Arc;

use coque::{Launched, ProcessGroup, launched};
use ferrompi::{Communicator, Mpi, ThreadLevel};
use peers::Peers;

use crate::ending::Ending;
use crate::messages::Messages;

/// Processes that a launcher started together. As it is dropped they part (`MPI_Finalize`), each waiting for the others; all peers of it must have
/// been dropped by then.
pub struct World {
    /// The communicator that has all of them.
    all: Arc<Communicator>,
    /// MPI begins and ends with it, on one thread.
    _mpi: Mpi,
}

impl World {
    /// Joins those with whom a launcher started this process; none where it was started by itself, and MPI is not begun then.
    ///
    /// # Errors
    /// [`JoinError`]: the launcher is that of another MPI library; the library does not begin or takes calls from one thread alone.
    pub fn join() -> Result<Option<Self>, JoinError> {
        let Some(Launched { count, variable, .. }) = launched().filter(|launched| launched.count > 1) else {
            return Ok(None);
        };
        let refused = |error: ferrompi::Error| JoinError::Init(error.to_string());
        let mpi = Mpi::init_thread(ThreadLevel::Serialized).map_err(refused)?;
        let level = mpi.thread_level();
        if level < ThreadLevel::Serialized {
            return Err(JoinError::Threads(format!("{level:?}")));
        }
        let all = Arc::new(mpi.world());
        let found = all.size() as usize;
        if found != count {
            let library = Mpi::library_version().unwrap_or_default();
            let library = library.lines().next().unwrap_or_default().trim().to_owned();
            return Err(JoinError::OtherMpi { launched: count, variable, library, found });
        }
        Ok(Some(Self { all, _mpi: mpi }))
    }

    /// From here on a panic of one ends all, with its message: unwinding would wait for the others, which wait for it.
    pub fn end_on_panic(&self) {
        let ending = self.ending();
        std::panic::set_hook(Box::new(move |panic| ending.end(&panic.to_string())));
    }

    /// Messages between them, over a communicator of its own; all of them call it together.
    pub fn messages(&self) -> Messages {
        let own = self.all.duplicate();
        let own = own.unwrap_or_else(|error| self.end(&error.to_string()));
        Messages::new(own, self.ending())
    }

    /// What ends them all.
    pub fn ending(&self) -> Ending {
        Ending::of(self.all.clone())
    }
}

impl ProcessGroup for World {
    /// Ends them all if MPI has no room for one more communicator.
    fn peers(&self) -> Box<dyn Peers> {
        Box::new(self.messages())
    }

    fn end(&self, message: &str) -> ! {
        self.ending().end(message)
    }
}

/// Why a process cannot join those with whom it was started.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum JoinError {
    /// The launcher is that of another library.
    #[error(
        "the launcher started {launched} processes ({variable}), but the MPI library of this program, {library}, finds {found}: they belong to \
         different installations; start it by the launcher of that library, or build it anew with the mpicc of this launcher first in PATH"
    )]
    OtherMpi {
        /// Processes that the launcher started.
        launched: usize,
        /// The variable that says it.
        variable: &'static str,
        /// The library, in its own words.
        library: String,
        /// Processes that the library finds.
        found: usize,
    },
    /// The library does not let threads other than the first call it.
    #[error(
        "the MPI library gives the thread level {0}, but calls come from one thread at a time that need not be the first \
         (MPI_THREAD_SERIALIZED): take a library built with support for threads"
    )]
    Threads(String),
    /// The library does not begin.
    #[error("MPI cannot begin: {0}")]
    Init(String),
}
