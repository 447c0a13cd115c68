//! A march taken up where it stood ends in the same bits as one that never stopped.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use explicit_dynamics::{
    Bounds, Damping, Dynamics, Event, Instant, LinearisedDynamics, March, MarchError, MarchState, MassScaled,
    OutOfBounds, Plan, QuasiStatic, StableStep, Step, Transient, Work, lanczos_step,
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

/// Where a march stood: how many events there had been, the place, and the system there.
type Place = (usize, MarchState, Oscillator);

/// All events of a march to its end, and every place where it stood.
fn events(mut march: March, system: &mut Oscillator) -> Result<(Vec<Event>, Vec<Place>), MarchError> {
    let (mut events, mut places, mut last) = (Vec::new(), Vec::new(), 0.0);
    loop {
        events.push(march.advance(system)?);
        assert_eq!(march.state().is_some(), events.ends_with(&[Event::Step]));
        if let Some(at) = march.state() {
            let done = march.done();
            assert!((last..=1.0).contains(&done), "{done} after {last}");
            last = done;
            places.push((events.len(), at.clone(), system.clone()));
        }
        if events.ends_with(&[Event::End]) {
            return Ok((events, places));
        }
    }
}

fn quasi_static(damping: Damping, period: Option<f64>) -> QuasiStatic {
    let levels = vec![0.25, 0.6, 1.0];
    QuasiStatic {
        levels,
        period,
        ramp: 0.7,
        hold: 4.0,
        damping,
        tolerance: 1e-6,
        accuracy: 5e-3,
        safety: 0.2,
    }
}

/// Marches through, then goes on from many a place; all must have the same events and end in the same bits.
fn goes_on(plan: impl Into<Plan>) {
    let (plan, mut whole) = (plan.into(), Oscillator::new());
    let march = March::start(plan.clone(), &mut whole).unwrap();
    let (all, places) = events(march, &mut whole).unwrap();
    assert!(places.len() > 100);
    for (seen, place, system) in places.iter().step_by(17) {
        let mut system = system.clone();
        let (rest, _) = events(March::resume(plan.clone(), place.clone()), &mut system).unwrap();
        assert_eq!(rest, all[*seen..]);
        assert_eq!([system.x, system.v].map(f64::to_bits), [whole.x, whole.v].map(f64::to_bits));
    }
}

#[test]
fn quasi_static_marches_go_on_to_the_same_bits() {
    let given = [Some(3.1), None];
    for (damping, period) in
        [Damping::Ratio(0.5), Damping::Kinetic].into_iter().flat_map(|d| given.map(|p| (d, p)))
    {
        goes_on(quasi_static(damping, period));
    }
}

/// Long enough for a new estimate of the step, every 5000 steps.
const TRANSIENT: Transient = Transient { duration: 700.0, record_every: 70.0, damping: 0.01, safety: 0.1 };

#[test]
fn transient_marches_go_on_to_the_same_bits() {
    goes_on(TRANSIENT);
}

#[test]
fn an_event_is_a_step_a_level_or_a_record_of_it() {
    let mut system = Oscillator::new();
    let path = quasi_static(Damping::Ratio(0.5), Some(3.1));
    let march = March::start(path.clone(), &mut system).unwrap();
    let (events, places) = events(march, &mut system).unwrap();
    let level = |event: &Event| if let Event::Level(reached) = event { Some(reached.level) } else { None };
    assert_eq!(events.iter().filter_map(level).collect::<Vec<_>>(), path.levels);
    let records = events.iter().filter(|event| matches!(event, Event::Record(_))).count();
    assert_eq!(records, 1 + path.levels.len());
    // Each level is followed by its record, and each record by the rest of its step.
    for pair in events.windows(2) {
        match (pair[0], pair[1]) {
            (Event::Level(reached), Event::Record(record)) => {
                assert_eq!((reached.level, reached.settled), (record.at.level, record.settled));
            }
            (Event::Level(_), next) => panic!("{next:?} behind a level"),
            (Event::Record(_), next) => assert!(matches!(next, Event::Step | Event::End)),
            _ => {}
        }
    }
    // Behind every step the march may be kept, but for the one that ended a level: what comes next is its record.
    let (_, last, _) = places.last().unwrap();
    assert_eq!(last.clock.steps as usize, places.len() + path.levels.len() - 1);
    assert_eq!(last.clock.now.level, 1.0);
}

#[test]
fn behind_its_end_and_behind_an_error_a_march_stays_over() {
    let mut system = Oscillator::new();
    let mut march = March::start(Transient { duration: 7.0, ..TRANSIENT }, &mut system).unwrap();
    while march.next_record(&mut system).unwrap().is_some() {}
    let (x, steps) = (system.x.to_bits(), march.clock().steps);
    assert_eq!(march.advance(&mut system), Ok(Event::End));
    assert_eq!((system.x.to_bits(), march.clock().steps), (x, steps));
    let mut march = March::start(Transient { safety: 1.2, ..TRANSIENT }, &mut system).unwrap();
    while march.next_record(&mut system).is_ok_and(|record| record.is_some()) {}
    assert_eq!((march.advance(&mut system), march.state()), (Ok(Event::End), None));
}

/// Two marches of two systems, a step of each in turn, and one of them kept in the middle and taken up by another march.
#[test]
fn marches_led_in_turns_do_not_know_of_each_other() {
    let plans = [Plan::from(quasi_static(Damping::Kinetic, None)), TRANSIENT.into()];
    let alone = plans.clone().map(|plan| {
        let mut system = Oscillator::new();
        let march = March::start(plan, &mut system).unwrap();
        let clock = march.finish(&mut system).unwrap();
        ([system.x, system.v].map(f64::to_bits), clock)
    });
    let mut systems = [(); 2].map(|()| Oscillator::new());
    let [mut one, mut two] = [0, 1].map(|i| March::start(plans[i].clone(), &mut systems[i]).unwrap());
    let (mut ended, mut turns) = ([false; 2], 0);
    while ended != [true; 2] {
        ended[0] = one.advance(&mut systems[0]).unwrap() == Event::End;
        ended[1] = two.advance(&mut systems[1]).unwrap() == Event::End;
        turns += 1;
        if turns > 150
            && turns < 200
            && let Some(at) = one.state().cloned()
        {
            (one, systems[0]) = (March::resume(plans[0].clone(), at), systems[0].clone());
        }
    }
    let together = [(&one, &systems[0]), (&two, &systems[1])]
        .map(|(march, system)| ([system.x, system.v].map(f64::to_bits), march.clock().clone()));
    assert!(turns > 200 && together == alone);
}

#[test]
fn the_place_of_another_march_is_refused() {
    let mut system = Oscillator::new();
    let run = quasi_static(Damping::Ratio(0.5), Some(3.1));
    let mut march = March::start(run.clone(), &mut system).unwrap();
    for _ in 0..5 {
        march.advance(&mut system).unwrap();
    }
    let at = march.state().unwrap().clone();
    let transient = Transient { duration: 7.0, record_every: 1.0, damping: 0.0, safety: 0.1 };
    let error = March::resume(transient, at.clone()).advance(&mut Oscillator::new()).unwrap_err();
    assert!(error.to_string().contains("level number 0 of a quasi-static march"), "{error}");
    let shorter = QuasiStatic { levels: Vec::new(), ..run };
    assert!(March::resume(shorter, at).advance(&mut Oscillator::new()).is_err());
}
