//! The stopwatch of a measurement: looks at clock and heap after some steps and again after more, then ends the march.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use coque::{Progress, ProgressReport};
use stats_alloc::INSTRUMENTED_SYSTEM;

/// What a look sees.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Processor time of the whole process so far.
    pub processor: Duration,
    /// Wall clock.
    pub wall: Instant,
    /// The heap; none unless the program counts its allocations.
    pub heap: Option<Heap>,
}

/// What has been allocated.
#[derive(Clone, Copy, Debug)]
pub struct Heap {
    /// Bytes that are held.
    pub held: f64,
    /// Allocations so far.
    pub allocations: usize,
}

impl Look {
    /// Looks.
    pub fn now() -> Self {
        let stats = INSTRUMENTED_SYSTEM.stats();
        // A program that counts has allocated long before it comes here.
        let heap = (stats.allocations > 0).then(|| Heap {
            held: stats.bytes_allocated as f64 - stats.bytes_deallocated as f64,
            allocations: stats.allocations + stats.reallocations,
        });
        Self { processor: processor_time(), wall: Instant::now(), heap }
    }
}

/// Processor time of all threads of the process.
#[cfg(unix)]
fn processor_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), time.tv_nsec.unsigned_abs() as u32)
}

/// Without a clock for it, wall time since the first look: the same on a quiet machine, one thread.
#[cfg(not(unix))]
fn processor_time() -> Duration {
    static FIRST: std::sync::OnceLock<Instant> = std::sync::OnceLock::new();
    FIRST.get_or_init(Instant::now).elapsed()
}

/// Times the steps from number `from` to number `to`; between any others it compares two numbers.
pub struct Stopwatch {
    from: u64,
    to: u64,
    start: Option<Look>,
    end: Option<Look>,
}

impl Stopwatch {
    /// Times `steps` steps, after `warm` others.
    pub fn new(warm: u64, steps: u64) -> Self {
        Self { from: warm, to: warm + steps, start: None, end: None }
    }

    /// Both looks; none if the march ended before.
    pub fn looks(&self) -> Option<[Look; 2]> {
        Some([self.start?, self.end?])
    }

    /// Looks, if it is time to, after so many steps; `Break` once both looks are taken.
    pub fn between(&mut self, steps: u64) -> ControlFlow<()> {
        if steps == self.from {
            self.start = Some(Look::now());
        }
        if steps < self.to {
            return ControlFlow::Continue(());
        }
        self.end = Some(Look::now());
        ControlFlow::Break(())
    }
}

/// Through coque: with the calls of a progress bar.
impl Progress for Stopwatch {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        self.between(news.steps)
    }
}
