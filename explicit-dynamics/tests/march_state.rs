//! A march taken up where it stood ends in the same bits as one that never stopped.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use std::ops::ControlFlow;

use explicit_dynamics::{
    Bounds, Damping, Dynamics, Instant, LinearisedDynamics, MarchError, MarchState, MassScaled, Observer,
    OutOfBounds, QuasiStatic, Record, StableStep, Step, Transient, Work, lanczos_step,
};

/// `m ẍ + k x + c x³ = level · load`: the stable step changes on the way.
#[derive(Clone)]
struct Oscillator {
    x: f64,
    v: f64,
    f: f64,
    external: f64,
}

const MASS: f64 = 2.0;
const STIFFNESS: f64 = 8.0;
const CUBIC: f64 = 0.5;

impl Oscillator {
    fn new() -> Self {
        Self { x: 0.3, v: 0.1, f: 0.0, external: 0.0 }
    }
}

impl Dynamics for Oscillator {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.external = 4.0 * at.level;
        self.f = self.external - STIFFNESS * self.x - CUBIC * self.x.powi(3);
        0.5 * STIFFNESS * self.x * self.x + 0.25 * CUBIC * self.x.powi(4)
    }
    fn kick(&mut self, step: &Step) -> Work {
        let half = 0.5 * step.damping * step.kick;
        let old = self.v;
        self.v = (old * (1.0 - half) + step.kick * self.f / MASS) / (1.0 + half);
        let mean = 0.5 * (old + self.v);
        Work {
            kinetic: 0.5 * MASS * mean * mean,
            external: step.kick * self.external * mean,
            dissipated: step.kick * step.damping * MASS * mean * mean,
            ..Work::default()
        }
    }
    fn drift(&mut self, step: &Step) {
        self.x += step.drift() * self.v;
    }
    fn stop(&mut self) {
        self.v = 0.0;
    }
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        lanczos_step(self, safety)
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let (particle, speed, bound) = (0, self.v.abs(), 1e3);
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle, speed, bound }) }
    }
    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        Some(self)
    }
}

impl LinearisedDynamics for Oscillator {
    fn unknowns(&self) -> usize {
        1
    }
    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        out[0] = (STIFFNESS + 3.0 * CUBIC * self.x * self.x) / MASS * v[0];
    }
}

impl MassScaled for Oscillator {
    fn out_of_balance(&self, out: &mut [f64]) {
        out[0] = self.f / MASS.sqrt();
    }
    fn rates(&self, out: &mut [f64]) {
        out[0] = MASS.sqrt() * self.v;
    }
    fn displaced(&self) -> f64 {
        MASS.sqrt() * self.x.abs()
    }
}

/// Notes every record, and every place with the state beside it; ends the march where it is asked to.
#[derive(Default)]
struct Notes {
    records: Vec<Record>,
    places: Vec<(usize, MarchState, Oscillator)>,
    last_done: f64,
    stop_at: Option<usize>,
}

impl Observer<Oscillator> for Notes {
    fn record(&mut self, _: &mut Oscillator, record: &Record) -> ControlFlow<()> {
        self.records.push(*record);
        ControlFlow::Continue(())
    }
    fn between(&mut self, system: &mut Oscillator, at: &MarchState, done: f64) -> ControlFlow<()> {
        assert!((self.last_done..=1.0).contains(&done), "{done} after {}", self.last_done);
        self.last_done = done;
        self.places.push((self.records.len(), at.clone(), system.clone()));
        if self.stop_at == Some(self.places.len()) {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

fn quasi_static(damping: Damping, period: Option<f64>) -> QuasiStatic {
    let levels = vec![0.25, 0.6, 1.0];
    QuasiStatic {
        levels,
        period,
        ramp: 0.7,
        dwell: 4.0,
        damping,
        tolerance: 1e-6,
        accuracy: 5e-3,
        safety: 0.2,
    }
}

/// Marches through, then goes on from many a place; all must end in the same bits.
fn goes_on(
    march: impl Fn(&mut Oscillator, &mut Notes) -> Result<(), MarchError>,
    go_on: impl Fn(MarchState, &mut Oscillator, &mut Notes) -> Result<(), MarchError>,
) {
    let (mut whole, mut notes) = (Oscillator::new(), Notes::default());
    march(&mut whole, &mut notes).unwrap();
    assert!(notes.places.len() > 100);
    for (seen, place, system) in notes.places.iter().step_by(17) {
        let mut system = system.clone();
        let mut rest = Notes::default();
        go_on(place.clone(), &mut system, &mut rest).unwrap();
        assert_eq!(rest.records, notes.records[*seen..]);
        assert_eq!([system.x, system.v].map(f64::to_bits), [whole.x, whole.v].map(f64::to_bits));
    }
}

#[test]
fn quasi_static_marches_go_on_to_the_same_bits() {
    let given = [Some(3.1), None];
    for (damping, period) in
        [Damping::Ratio(0.5), Damping::Kinetic].into_iter().flat_map(|d| given.map(|p| (d, p)))
    {
        let run = quasi_static(damping, period);
        goes_on(
            |system, notes| run.march(system, notes).map(drop),
            |at, system, notes| run.go_on(at, system, notes).map(drop),
        );
    }
}

#[test]
fn transient_marches_go_on_to_the_same_bits() {
    // Long enough for a new estimate of the step, every 5000 steps.
    let run = Transient { duration: 700.0, record_every: 70.0, damping: 0.01, safety: 0.1 };
    goes_on(
        |system, notes| run.march(system, notes).map(drop),
        |at, system, notes| run.go_on(at, system, notes).map(drop),
    );
}

#[test]
fn an_observer_ends_a_march_between_steps() {
    for stop_at in [1, 7, 20] {
        let mut notes = Notes { stop_at: Some(stop_at), ..Notes::default() };
        let clock =
            quasi_static(Damping::Ratio(0.5), Some(3.1)).march(&mut Oscillator::new(), &mut notes).unwrap();
        assert_eq!(notes.places.len(), stop_at);
        // One step with the first record, one more between each two places of the first level.
        assert_eq!(clock.steps as usize, stop_at);
    }
}

#[test]
fn the_place_of_another_march_is_refused() {
    let mut notes = Notes { stop_at: Some(5), ..Notes::default() };
    let run = quasi_static(Damping::Ratio(0.5), Some(3.1));
    run.march(&mut Oscillator::new(), &mut notes).unwrap();
    let at = notes.places.pop().unwrap().1;
    let transient = Transient { duration: 7.0, record_every: 1.0, damping: 0.0, safety: 0.1 };
    let error = transient.go_on(at.clone(), &mut Oscillator::new(), &mut Notes::default()).unwrap_err();
    assert!(error.to_string().contains("level number 0 of a quasi-static march"), "{error}");
    let shorter = QuasiStatic { levels: Vec::new(), ..run };
    assert!(shorter.go_on(at, &mut Oscillator::new(), &mut Notes::default()).is_err());
}
