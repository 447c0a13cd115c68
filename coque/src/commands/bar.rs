//! What a terminal shows of a run; its curve so far goes to the disk on the way.

use std::io::{self, IsTerminal};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::{Curve, GrowingCurve, Progress, ProgressReport};
use indicatif::{ProgressBar, ProgressStyle};

use super::stderr::say;
use super::stop::Stop;

/// Time between two looks of the bar at its run.
const REFRESH: Duration = Duration::from_millis(100);

/// Progress on a terminal, hidden elsewhere; ends the run when that is asked for.
pub struct Bar {
    bar: ProgressBar,
    stop: Arc<Stop>,
    curve: GrowingCurve,
    /// Whether a row of the curve found no room.
    reported: bool,
    particles: usize,
    begun: Instant,
    /// When the bar was drawn last.
    drawn: Option<Instant>,
    /// Part done and steps where this sitting began.
    first: Option<(f64, u64)>,
}

impl Bar {
    /// A bar for a run of so many particles.
    pub fn new(particles: usize, stop: Arc<Stop>, curve: GrowingCurve) -> Self {
        let bar = if io::stderr().is_terminal() { ProgressBar::new(1000) } else { ProgressBar::hidden() };
        if let Ok(style) = ProgressStyle::with_template("{bar:20} {percent:>3} %  {wide_msg}") {
            bar.set_style(style);
        }
        Self { bar, stop, curve, reported: false, particles, begun: Instant::now(), drawn: None, first: None }
    }

    /// Takes the bar off the terminal.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    fn draw(&mut self, news: &ProgressReport) {
        let (from, steps) = *self.first.get_or_insert((news.done, news.steps));
        let spent = self.begun.elapsed().as_secs_f64();
        self.bar.set_position((1000.0 * news.done) as u64);
        self.bar.set_message(message(news, news.steps - steps, self.particles, spent, news.done - from));
    }
}

impl Progress for Bar {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        if !self.bar.is_hidden() && self.drawn.is_none_or(|drawn| drawn.elapsed() >= REFRESH) {
            self.draw(news);
            self.drawn = Some(Instant::now());
        }
        if self.stop.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn companion(&mut self, number: usize, of: usize, lattice: &str) {
        self.bar.suspend(|| say(&format!("for the errors: {number} of {of}, {lattice}")));
        (self.begun, self.first) = (Instant::now(), None);
    }

    fn recorded(&mut self, curve: &Curve) {
        if let Err(error) = self.curve.take(curve)
            && !self.reported
        {
            self.reported = true;
            self.warn(&format!("the curve so far cannot be written: {error}"));
        }
    }

    fn warn(&mut self, message: &str) {
        self.bar.suspend(|| say(&format!("warning: {message}; the run goes on")));
    }
}

/// Level, speed, energy ratio and time left, from the steps and the part done in so many seconds.
fn message(news: &ProgressReport, steps: u64, particles: usize, spent: f64, gained: f64) -> String {
    let mut parts = Vec::new();
    // First: a narrow terminal cuts the line off.
    if gained > 0.0 {
        parts.push(format!("{} left", clock(spent * (1.0 - news.done) / gained)));
    }
    parts.push(format!("level {:.4}, step {}", news.level, news.steps));
    // Without time there are points, not steps, and nothing moves.
    if news.time > 0.0 {
        let rate = steps as f64 * particles as f64 / spent.max(1e-3);
        parts.push(format!("{:.1} M particle-steps/s", 1e-6 * rate));
        if news.internal > 0.0 {
            parts.push(format!("kinetic/internal {:.0e}", news.kinetic / news.internal));
        }
    }
    parts.join(", ")
}

/// Seconds as `4.2 s`, `3 min 20 s` or `2 h 5 min`.
pub fn clock(seconds: f64) -> String {
    if seconds < 10.0 {
        return format!("{seconds:.1} s");
    }
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{whole} s"),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole % 3600 / 60),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_tells_rate_ratio_and_time_left() {
        let news =
            ProgressReport { done: 0.6, time: 2.0, level: 0.5, steps: 3000, kinetic: 1e-6, internal: 0.5 };
        // 2000 steps of 1000 particles in 4 s; a half gained, four tenths to go.
        assert_eq!(
            message(&news, 2000, 1000, 4.0, 0.5),
            "3.2 s left, level 0.5000, step 3000, 0.5 M particle-steps/s, kinetic/internal 2e-6"
        );
        let point = ProgressReport { time: 0.0, ..news };
        assert_eq!(message(&point, 3, 1000, 4.0, 0.0), "level 0.5000, step 3000");
    }

    #[test]
    fn durations_read_as_people_say_them() {
        assert_eq!([4.21, 42.0, 200.0, 7530.0].map(clock), ["4.2 s", "42 s", "3 min 20 s", "2 h 5 min"]);
    }
}
