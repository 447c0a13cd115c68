//! How all processes end at once.

use std::io::{Write, stderr};
use std::sync::Arc;

use ferrompi::Communicator;

/// The code with which processes end that cannot go on, as that of a panic.
pub const CANNOT_GO_ON: i32 = 101;

/// Ends all processes at once, whatever they are doing; any thread may call it.
#[derive(Clone)]
pub struct Ending {
    /// What is said before a message: which process it is.
    name: String,
    all: Arc<Communicator>,
}

impl Ending {
    /// Of those who share a communicator.
    pub(crate) fn of(all: Arc<Communicator>) -> Self {
        Self { name: format!("rank {} of {}", all.rank(), all.size()), all }
    }

    /// Prints the message, with the number of the process before it, and ends all of them with [`CANNOT_GO_ON`].
    pub fn end(&self, message: &str) -> ! {
        let _ = stderr().write_all(format!("{}: {message}\n", self.name).as_bytes());
        self.all.abort(CANNOT_GO_ON)
    }
}
