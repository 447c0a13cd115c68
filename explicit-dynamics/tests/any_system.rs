//! Systems behind `dyn Dynamics`: the same bits, a step as long as they say, and a refusal where they cannot tell rest.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use explicit_dynamics::{
    Bounds, Clock, Damping, Dynamics, Instant, LinearisedDynamics, March, MarchError, MassScaled,
    OutOfBounds, OutOfRange, Plan, QuasiStatic, Record, StableStep, Step, Transient, Work, lanczos_step,
};

/// A unit mass on a spring of stiffness 4 under `level · load`; it may not leave |x| < 100.
#[derive(Clone, Default)]
struct Spring {
    load: f64,
    x: f64,
    v: f64,
    f: f64,
    external: f64,
    /// Steps for which its own stable step holds; zero for that of Lanczos.
    holds: u64,
    estimates: u64,
    /// Whether it tells how far from rest it is.
    rests: bool,
}

impl Dynamics for Spring {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.external = at.level * self.load;
        self.f = self.external - 4.0 * self.x;
        2.0 * self.x * self.x
    }
    fn kick(&mut self, step: &Step) -> Work {
        let old = self.v;
        self.v = step.decay().kicked(old, step.kick * self.f);
        let mean = 0.5 * (old + self.v);
        Work {
            kinetic: 0.5 * mean * mean,
            external: step.kick * self.external * mean,
            dissipated: step.kick * step.damping * mean * mean,
            ..Work::default()
        }
    }
    fn drift(&mut self, step: &Step) {
        self.x += step.drift() * self.v;
    }
    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.estimates += 1;
        let holds = self.holds;
        if holds > 0 { Ok(StableStep { dt: safety, holds }) } else { lanczos_step(self, safety) }
    }
    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        if bounds == Bounds::Motion || self.x.abs() < 100.0 {
            return Ok(());
        }
        Err(OutOfRange { place: "the mass".into(), what: "x", value: self.x, bound: "below 100" }.into())
    }
    fn stop(&mut self) {
        self.v = 0.0;
    }
    fn linearised(&mut self) -> Option<&mut dyn MassScaled> {
        if self.rests { Some(self) } else { None }
    }
}

impl LinearisedDynamics for Spring {
    fn unknowns(&self) -> usize {
        1
    }
    fn apply(&mut self, v: &[f64], out: &mut [f64]) {
        out[0] = 4.0 * v[0];
    }
}

impl MassScaled for Spring {
    fn out_of_balance(&self, out: &mut [f64]) {
        out[0] = self.f;
    }
    fn rates(&self, out: &mut [f64]) {
        out[0] = self.v;
    }
    fn displaced(&self) -> f64 {
        self.x.abs()
    }
}

/// The records of any system, and the clock at the end.
fn records<S: Dynamics + ?Sized>(
    plan: impl Into<Plan>,
    system: &mut S,
) -> Result<(Vec<Record>, Clock), MarchError> {
    let (mut records, mut march) = (Vec::new(), March::start(plan, system)?);
    while let Some(record) = march.next_record(system)? {
        records.push(record);
    }
    Ok((records, march.clock().clone()))
}

fn quasi_static() -> QuasiStatic {
    QuasiStatic {
        levels: vec![0.5, 1.0],
        period: Some(3.0),
        ramp: 1.0,
        hold: 20.0,
        damping: Damping::Ratio(0.7),
        tolerance: 1e-8,
        accuracy: 5e-3,
        safety: 0.1,
    }
}

const TRANSIENT: Transient = Transient { duration: 9.0, record_every: 1.0, damping: 0.1, safety: 0.1 };

#[test]
fn a_system_without_a_type_marches_to_the_same_bits() {
    let start = Spring { load: 3.0, x: 0.4, rests: true, ..Spring::default() };
    let (mut typed, mut by_reference) = (start.clone(), start.clone());
    let mut boxed: Box<dyn Dynamics> = Box::new(start);
    for plan in [Plan::from(quasi_static()), TRANSIENT.into()] {
        let one = records(plan.clone(), &mut typed).unwrap();
        let two = records(plan.clone(), &mut by_reference as &mut dyn Dynamics).unwrap();
        let three = records(plan, &mut *boxed).unwrap();
        assert!([3, 10].contains(&one.0.len()) && one == two && one == three);
    }
    assert_eq!([typed.x, typed.v].map(f64::to_bits), [by_reference.x, by_reference.v].map(f64::to_bits));
}

#[test]
fn a_system_that_does_not_say_when_it_rests_is_refused() {
    let mut spring = Spring { load: 3.0, ..Spring::default() };
    assert_eq!(records(quasi_static(), &mut spring), Err(MarchError::NotLinearised));
    records(TRANSIENT, &mut spring).unwrap();
}

#[test]
fn a_step_is_found_anew_as_often_as_the_system_says() {
    // Eleven records on their times, and ten steps of .1 between two of them.
    for (holds, estimates) in [(1, 102), (50, 3), (1000, 1)] {
        let mut spring = Spring { x: 0.4, holds, ..Spring::default() };
        let run = Transient { duration: 10.0, ..TRANSIENT };
        let (records, clock) = records(run, &mut spring).unwrap();
        assert_eq!((records.len(), clock.steps), (11, 101));
        assert_eq!(spring.estimates, estimates, "holds for {holds}");
    }
}

#[test]
fn a_configuration_out_of_range_ends_the_march() {
    let mut spring = Spring { load: 1e4, ..Spring::default() };
    match records(TRANSIENT, &mut spring) {
        Err(MarchError::OutOfBounds { found, .. }) => {
            assert!(found.to_string().starts_with("x of the mass is ") && found.value >= 100.0, "{found}");
        }
        other => panic!("{other:?}"),
    }
}
