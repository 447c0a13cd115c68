//! Work on a thread of its own while the thread that asked for it waits without the interpreter, serves signals and tells how it goes.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use coque::{Curve, Exert, GrowingCurve, Progress, ProgressReport};
use pyo3::prelude::*;

use crate::errors::failed;
use crate::leaving::{UnderWay, leaving};
use crate::push::exerted;

/// Time between two looks at signals.
pub const INTERVAL: Duration = Duration::from_millis(50);
/// What a program has for its first thread \[bytes\].
const STACK: usize = 8 << 20;

/// What the two threads share.
#[derive(Default)]
struct Shared {
    stop: AtomicBool,
    news: Mutex<Option<ProgressReport>>,
    /// What a function that the run calls raised.
    raised: Mutex<Option<PyErr>>,
}

impl Shared {
    fn asked(&self) -> bool {
        self.stop.load(Ordering::Relaxed) || leaving()
    }
}

/// Follows a run: leaves news for the thread that waits, ends the run when that is asked for.
pub struct Watch {
    shared: Arc<Shared>,
    left: Instant,
    /// Where the rows of the curve go on the way.
    pub curve: Option<GrowingCurve>,
    /// What the run went on without.
    pub said: Vec<String>,
}

impl Watch {
    /// A function of Python, of times or of load levels, as one that exerts forces; what it raises ends the work.
    pub fn exert(&self, function: Py<PyAny>, by_level: bool) -> Exert {
        let shared = self.shared.clone();
        exerted(function, by_level, move |error| {
            *shared.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
            shared.stop.store(true, Ordering::Relaxed);
        })
    }

    /// Whether the work goes on.
    pub fn goes_on(&self) -> ControlFlow<()> {
        if self.shared.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Progress for Watch {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        if self.left.elapsed() >= INTERVAL {
            self.left = Instant::now();
            *self.shared.news.lock().unwrap_or_else(PoisonError::into_inner) = Some(*news);
        }
        self.goes_on()
    }

    fn recorded(&mut self, curve: &Curve) {
        // Rows that find no room now may do so at the end, whose fault is reported.
        let _ = self.curve.as_mut().map(|file| file.take(curve));
    }

    fn warn(&mut self, message: &str) {
        self.said.push(message.into());
    }
}

/// What the work gave, and what a signal, `listener` or a function that the work calls raised on the way, which ended it in good order.
///
/// `listener` is called with `(done, time, level, steps, kinetic, internal)`; it ends the work by `False`.
///
/// # Errors
/// `coque.CoqueError` where there is no thread to be had, where the interpreter is about to end, and for a panic of the work.
pub fn watched<T: Send + 'static>(
    py: Python<'_>,
    listener: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&mut Watch) -> T + Send + 'static,
) -> PyResult<(T, Option<PyErr>)> {
    let _under_way = UnderWay::begin(py)?;
    let shared = Arc::new(Shared::default());
    let mut watch = Watch { shared: shared.clone(), left: Instant::now(), curve: None, said: Vec::new() };
    let (sender, receiver) = mpsc::channel();
    // Whoever waits may not be moved between threads, but may be looked at by one at a time.
    let receiver = Mutex::new(receiver);
    let thread = std::thread::Builder::new().name("coque".into()).stack_size(STACK);
    thread
        .spawn(move || sender.send(work(&mut watch)))
        .map_err(|error| failed(py, &format!("no thread for the run: {error}")))?;
    let mut raised = None;
    loop {
        let wait = || receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(INTERVAL);
        match py.detach(wait) {
            Ok(found) => {
                let of_work = shared.raised.lock().unwrap_or_else(PoisonError::into_inner).take();
                return Ok((found, of_work.or(raised)));
            }
            Err(RecvTimeoutError::Disconnected) => {
                return Err(failed(py, "the run ended by a fault of the program; please report it"));
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        let asked = py.check_signals().and_then(|()| tell(listener, &shared));
        match asked {
            Ok(ControlFlow::Continue(())) => {}
            Ok(ControlFlow::Break(())) => shared.stop.store(true, Ordering::Relaxed),
            Err(error) => {
                shared.stop.store(true, Ordering::Relaxed);
                raised = raised.or(Some(error));
            }
        }
    }
}

/// Hands news on.
fn tell(listener: Option<&Bound<'_, PyAny>>, shared: &Shared) -> PyResult<ControlFlow<()>> {
    let news = shared.news.lock().unwrap_or_else(PoisonError::into_inner).take();
    let (Some(listener), Some(news)) = (listener, news) else { return Ok(ControlFlow::Continue(())) };
    let ProgressReport { done, time, level, steps, kinetic, internal } = news;
    let answer = listener.call1((done, time, level, steps, kinetic, internal))?;
    let ends = answer.extract::<bool>().is_ok_and(|goes_on| !goes_on);
    Ok(if ends { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
}
