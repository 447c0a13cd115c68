//! The end of the interpreter, which waits for the work that other threads have under way: a thread that comes back to an interpreter
//! that has ended is ended in the middle of whatever it does.

use std::sync::atomic::{AtomicBool, AtomicU32, AtomicUsize, Ordering};
use std::thread::sleep;
use std::time::Duration;

use pyo3::prelude::*;

use crate::errors::failed;

/// Whether the interpreter is about to end.
static LEAVING: AtomicBool = AtomicBool::new(false);
/// Pieces of work under way.
static UNDER_WAY: AtomicUsize = AtomicUsize::new(0);
/// The process that counts them: a fork takes the count along, and none of the threads.
static PROCESS: AtomicU32 = AtomicU32::new(0);

/// A piece of work that the end of the interpreter waits for.
pub struct UnderWay(());

impl UnderWay {
    /// Begins it, while the interpreter is held.
    ///
    /// # Errors
    /// `coque.CoqueError` where the interpreter is about to end.
    pub fn begin(py: Python<'_>) -> PyResult<Self> {
        if leaving() {
            return Err(failed(py, "the interpreter is about to end"));
        }
        if PROCESS.swap(std::process::id(), Ordering::SeqCst) != std::process::id() {
            UNDER_WAY.store(0, Ordering::SeqCst);
        }
        UNDER_WAY.fetch_add(1, Ordering::SeqCst);
        Ok(Self(()))
    }
}

impl Drop for UnderWay {
    fn drop(&mut self) {
        UNDER_WAY.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Whether work is to end, for the interpreter does.
pub fn leaving() -> bool {
    LEAVING.load(Ordering::Relaxed)
}

/// Ends all work and waits until it has.
#[pyfunction]
pub fn leave(py: Python<'_>) {
    LEAVING.store(true, Ordering::SeqCst);
    if PROCESS.load(Ordering::SeqCst) == std::process::id() {
        py.detach(|| {
            while UNDER_WAY.load(Ordering::SeqCst) > 0 {
                sleep(Duration::from_millis(5));
            }
        });
    }
}
