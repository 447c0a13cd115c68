//! Temperatures in balance, one row of the curve; temperatures in time, a row at once.

use std::ops::ControlFlow;

use explicit_dynamics::Instant;
use heat_conduction::HeatCourse;

use crate::bodies::ConductingBody;
use crate::run::Run;
use crate::run::outcome::{Ended, Failure};
use crate::run::progress::ProgressReport;
use crate::scene::HeatInTime;
use crate::warning::WarningKind;

use super::linear::INTERRUPTED;

/// Part of an interval between rows by which the last may be longer, so that rounding makes no row of its own.
const ROUNDING: f64 = 1e-9;

/// Finds the temperatures and reads the curve's one row: the heat that enters by each way, then the columns of the scene.
pub(super) fn steady(body: &mut dyn ConductingBody, run: &mut Run<'_>) -> Ended {
    if run.tell(0.0, 0, 0.0, 0.0).is_break() {
        return INTERRUPTED;
    }
    let mut row = match body.settle() {
        Err(cause) => return Ended::Diverged(Failure::Heat(cause)),
        Ok((heat, iterations)) => {
            run.record.newton_iterations = iterations as u64;
            vec![iterations as f64, heat.supplied, heat.held, heat.film, heat.radiated]
        }
    };
    run.record.steps = 1;
    run.read_probes(&mut row, body);
    run.push(row);
    // A frame that cannot be written has its own failure.
    let _ = run.keep_shape(body, 0.0, 1.0);
    Ended::Done
}

/// A course of temperatures under way.
pub(super) struct HeatingInTime {
    wanted: HeatInTime,
    /// Rows after the first.
    rows: u64,
    /// The row that comes next; the first is that of the start.
    next: u64,
    time: f64,
}

impl HeatingInTime {
    /// From the start.
    pub fn new(wanted: HeatInTime) -> Self {
        let rows = (wanted.duration.get() / wanted.record_every.get() - ROUNDING).ceil().max(1.0) as u64;
        Self { wanted, rows, next: 0, time: 0.0 }
    }

    /// Goes on to the next row and reads it; `Break` at the end, or where no step is short enough.
    pub fn advance(&mut self, body: &mut dyn ConductingBody, run: &mut Run<'_>) -> ControlFlow<Ended> {
        let (done, steps) = (self.next as f64 / (self.rows + 1) as f64, run.record.steps);
        let news = ProgressReport { done, time: self.time, steps, ..ProgressReport::default() };
        if run.update(&news).is_break() {
            return ControlFlow::Break(Ended::Interrupted { time: self.time, level: 0.0 });
        }
        let HeatInTime { start, duration, record_every, tolerance } = self.wanted;
        let found = match self.next {
            0 => body.start(start),
            last if last == self.rows => body.advance(duration.get(), tolerance.get()),
            row => body.advance(row as f64 * record_every.get(), tolerance.get()),
        };
        let row = match found {
            Err(cause) => return ControlFlow::Break(Ended::Diverged(Failure::Heat(cause))),
            Ok(course) => {
                run.record.steps = course.steps();
                run.record.newton_iterations = course.temperatures().iterations as u64;
                self.time = course.time();
                if self.next == 0 && course.overshoot() > tolerance.get() {
                    let message = format!(
                        "what is held jumps at the start, and temperatures beside it swing over by {:.3e} for as long as heat takes through two spacings; let an `amplitude` \
                         bring it there, or read later times",
                        course.overshoot()
                    );
                    run.record.warn(WarningKind::HeatOvershoot, message);
                }
                columns(course)
            }
        };
        run.row(row, body);
        let kept = match self.next {
            0 => run.keep_shape(body, 0.0, 0.0),
            _ => run.keep_latest(body, self.time, 0.0),
        };
        self.next += 1;
        if kept.is_break() || self.next > self.rows {
            return ControlFlow::Break(Ended::Done);
        }
        ControlFlow::Continue(())
    }

    /// Time \[T\].
    pub fn stands_at(&self) -> Instant {
        Instant { time: self.time, level: 0.0 }
    }
}

/// Time, heat that has entered by each way, what is stored, the sum of the estimates of steps.
fn columns(course: &HeatCourse) -> Vec<f64> {
    let came = course.came();
    vec![course.time(), came.supplied, came.held, came.film, came.radiated, course.stored(), course.error()]
}
