//! When the records of a run are due, and which runs are taken for a mistake, to the last bit of their bounds.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use explicit_dynamics::{
    Bounds, Clock, Dynamics, Instant, March, MarchError, OutOfBounds, StableStep, Step, Transient, Work,
};

/// A body that stands still, with a stable step of the safety asked for.
struct Still;

impl Dynamics for Still {
    fn evaluate(&mut self, _: Instant) -> f64 {
        0.0
    }
    fn kick(&mut self, _: &Step) -> Work {
        Work::default()
    }
    fn drift(&mut self, _: &Step) {}
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        Ok(StableStep { dt: safety, holds: u64::MAX })
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        Ok(())
    }
    fn stop(&mut self) {}
}

/// Times of the records, at most so many.
fn run(duration: f64, record_every: f64, safety: f64, most: usize) -> Result<(Vec<f64>, Clock), MarchError> {
    let plan = Transient { duration, record_every, damping: 0.0, safety };
    let (mut times, mut march) = (Vec::new(), March::start(plan, &mut Still)?);
    while times.len() < most
        && let Some(record) = march.next_record(&mut Still)?
    {
        times.push(record.at.time);
    }
    Ok((times, march.clock().clone()))
}

/// The last record of a run that is not a whole number of intervals is due at the end, of one that is but for rounding of a millionth of an
/// interval where its interval ends.
#[test]
fn the_last_record_is_due_at_the_end() {
    for (duration, every, last) in [
        (2.5, 1.0, 2.5),
        (2.5e-3, 1e-3, 2.5e-3),
        (2.5e3, 1e3, 2.5e3),
        (3.0 - 0.5e-6, 1.0, 3.0),
        (3.0 + 0.5e-6, 1.0, 3.0),
        (3e-3 + 0.5e-9, 1e-3, 3e-3),
        (3e3 - 0.5e-3, 1e3, 3e3),
        (3.0 - 2e-6, 1.0, 3.0 - 2e-6),
        (0.25, 1.0, 0.25),
    ] {
        let (times, clock) = run(duration, every, 0.125 * every.min(1.0), 100).unwrap();
        let found = *times.last().unwrap();
        assert!((found - last).abs() < 1e-9 * every, "{duration} {every}: {found}");
        let count = (last / every - 1e-9).ceil() as usize;
        assert_eq!(times.len(), count + 1, "{times:?}");
        for (record, time) in times[..count].iter().enumerate().map(|(i, time)| (i as f64, time)) {
            assert!((time - record * every).abs() < 1e-9 * every, "{times:?}");
        }
        // The step that its record is taken in goes on towards the next record, which never comes.
        assert!(clock.now.time - found > 0.1 * every.min(1.0), "{} {found}", clock.now.time);
    }
    // At the bound itself the interval is whole.
    let duration = 3.0 - 1e-6;
    assert_eq!(duration + 1e-6, 3.0);
    assert!((run(duration, 1.0, 0.125, 100).unwrap().0[3] - 3.0).abs() < 1e-9);
}

/// Ten thousand million steps or ten million records are run, one step or record more is refused, whichever of the two it is.
#[test]
fn runs_beyond_all_bounds_are_refused() {
    let refused = |duration: f64, every: f64, safety: f64| match run(duration, every, safety, 1) {
        Ok(_) => false,
        Err(MarchError::Option { key: "duration", .. }) => true,
        Err(other) => panic!("{other}"),
    };
    for dt in [0.5, 0.0625] {
        assert!(!refused(1e10 * dt, 1e10 * dt, dt));
        assert!(refused(1.5e10 * dt, 1.5e10 * dt, dt));
        assert!(refused(1e10 * dt + 4.0 * dt, 1e10 * dt + 4.0 * dt, dt));
        // The first record counts as well, however short the run.
        assert!(refused(dt, 2e10 * dt, dt));
    }
    for every in [0.25, 4.0] {
        assert!(!refused(1e7 * every, every, 0.125));
        assert!(refused(1e7 * every + every, every, 0.125));
        assert!(refused(1.5e7 * every, every, 0.125));
    }
}
