//! How a run is ended from outside: Ctrl-C, and the signals by which systems end what they run.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};

use super::INTERRUPTED;
use super::stderr::say;

/// Whether the end was asked for.
///
/// Before a run begins there is nothing to keep, and the program ends at once; after that the first signal asks for an
/// end in good order, the second ends at once.
#[derive(Debug, Default)]
pub struct Stop {
    asked: AtomicBool,
    stage: AtomicU8,
}

/// Nothing is written yet; the stage that a [`Stop`] begins with.
const BEFORE: u8 = 0;
/// There are results to keep.
const RUNNING: u8 = 1;
/// A signal came before the run began, and the program is about to end.
const ENDING: u8 = 2;

impl Stop {
    /// Watches from here on: Ctrl-C and, on Unix, SIGTERM, SIGHUP (unless `nohup` had it ignored) and SIGXCPU.
    ///
    /// # Errors
    /// What the system says if it lets no signal be caught.
    pub fn watch() -> Result<Arc<Self>, String> {
        let stop = Arc::new(Self::default());
        watch(stop.clone()).map_err(|error| format!("cannot watch for Ctrl-C: {error}\n"))?;
        Ok(stop)
    }

    /// From here on there are results to keep.
    pub fn begin(&self) {
        if self.stage.compare_exchange(BEFORE, RUNNING, Ordering::SeqCst, Ordering::SeqCst) == Err(ENDING) {
            // The program ends from the thread of the signal; a file begun now would be left half written.
            loop {
                std::thread::park();
            }
        }
    }

    /// Whether the run is to end.
    pub fn asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }

    fn signal(&self) {
        if self.asked.swap(true, Ordering::SeqCst) {
            std::process::exit(INTERRUPTED.into());
        }
        if self.stage.compare_exchange(BEFORE, ENDING, Ordering::SeqCst, Ordering::SeqCst).is_ok() {
            say("\ninterrupted before the run began; nothing was written");
            std::process::exit(INTERRUPTED.into());
        }
        say("\nending in good order; Ctrl-C once more ends at once");
    }
}

/// A file that may not grow further (`ulimit -f`) is an error of its write, not the end of the program.
pub fn outlive_file_limits() {
    // Where the signal cannot be caught, the program ends by it.
    #[cfg(unix)]
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

#[cfg(unix)]
fn watch(stop: Arc<Stop>) -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXCPU};
    let mut ends = vec![SIGINT, SIGTERM, SIGXCPU];
    if !hangup_ignored() {
        ends.push(SIGHUP);
    }
    let mut signals = signal_hook::iterator::Signals::new(ends)?;
    std::thread::Builder::new().name("signals".into()).spawn(move || {
        for _ in signals.forever() {
            stop.signal();
        }
    })?;
    Ok(())
}

/// Whether whoever started the program had SIGHUP ignored, as `nohup` does; known on Linux alone.
#[cfg(unix)]
fn hangup_ignored() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 1)
}

#[cfg(not(unix))]
fn watch(stop: Arc<Stop>) -> Result<(), ctrlc::Error> {
    ctrlc::set_handler(move || stop.signal())
}
