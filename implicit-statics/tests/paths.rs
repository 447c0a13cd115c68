//! Paths with closed forms: snap-through, snap-back, softening; every control and what it can pass.

mod common;

use std::ops::ControlFlow;

use common::{Arch, ArchWithSpring, Flat, Potential, Softening};
use implicit_statics::{
    Control, CriticalKind, CriticalOptions, End, Equilibrium, EquilibriumError, NewtonOptions, OutOfBounds,
    Passage, Passed, Path, PathOptions, Start, follow,
};

const TIGHT: f64 = 1e-13; // Newton's last step squares the error: what is asked for is below 1e-10

fn options(control: Control) -> PathOptions {
    let newton = NewtonOptions { tolerance: TIGHT, ..Default::default() };
    PathOptions { newton, ..PathOptions::new(control) }
}

fn trace<P: Potential>(system: &mut Flat<P>, options: &PathOptions) -> (Path, Vec<(f64, Vec<f64>)>) {
    let mut curve = Vec::new();
    let path = follow(system, &Start::default(), options, |point, system| {
        curve.push((point.level(), system.q.clone()));
        ControlFlow::Continue(())
    });
    (path, curve)
}

fn shallow() -> Arch {
    Arch { half: 10.0, height: 1.0, sideways: false }
}

#[test]
fn load_control_follows_the_arch_up_to_its_limit() {
    let mut system = Flat::new(shallow());
    let limit = system.potential.limit();
    let (path, curve) =
        trace(&mut system, &options(Control::Load { step: 0.1 * limit, until: 0.999 * limit }));
    assert_eq!(path.end, Ok(End::Reached));
    let last = path.points.last().unwrap();
    assert_eq!(last.level(), 0.999 * limit);
    assert_eq!(last.inertia().negative, 0);
    for (level, q) in curve {
        assert!(q[0] < 1.0 - 1.0 / 3.0_f64.sqrt());
        assert!((level - system.potential.level(q[0])).abs() < 1e-10 * limit);
    }
}

#[test]
fn displacement_control_goes_through_both_limit_points() {
    let mut system = Flat::new(shallow());
    let limit = system.potential.limit();
    let control = Control::Displacement { functional: vec![(0, 1.0)], step: 0.05, until: 2.4 };
    let (path, curve) = trace(&mut system, &PathOptions { largest: 1.0, ..options(control) });
    assert_eq!(path.end, Ok(End::Reached));
    assert!((system.q[0] - 2.4).abs() < 1e-14);
    assert_eq!(path.points.len(), 49);
    for (level, q) in &curve {
        assert!((level - system.potential.level(q[0])).abs() < 1e-10 * limit, "{level} at {}", q[0]);
    }
    let unstable = path.points.iter().filter(|p| p.inertia().negative == 1).count();
    let between = curve.iter().filter(|(_, q)| (1.0 - q[0]).abs() < 1.0 / 3.0_f64.sqrt()).count();
    assert_eq!(unstable, between);
}

#[test]
fn arc_length_goes_through_both_limit_points_and_ends_at_the_bound() {
    let mut system = Flat::new(shallow());
    let limit = system.potential.limit();
    let control = Control::ArcLength { first: 0.05 * limit, range: (-2.0 * limit, 1.5 * limit) };
    let (path, curve) = trace(&mut system, &options(control));
    assert_eq!(path.end, Ok(End::Reached));
    assert_eq!(path.points.last().unwrap().level(), 1.5 * limit);
    assert!(system.q[0] > 2.0, "beyond the snapped state");
    for (level, q) in &curve {
        assert!((level - system.potential.level(q[0])).abs() < 1e-10 * limit);
    }
    assert!(curve.iter().any(|(level, _)| *level < -0.9 * limit));
}

/// u(w) = w + λ(w)/k turns where λ'(w) = −k.
fn snap_back() -> ArchWithSpring {
    let arch = shallow();
    let spring = 0.4 * arch.height.powi(2) / arch.bar().powi(3);
    ArchWithSpring { arch, spring }
}

#[test]
fn arc_length_passes_both_turning_points_of_the_displacement() {
    let mut system = Flat::new(snap_back());
    let limit = system.potential.arch.limit();
    let control = Control::ArcLength { first: 0.05 * limit, range: (-2.0 * limit, 1.5 * limit) };
    let (path, curve) = trace(&mut system, &PathOptions { largest: 3.0, ..options(control) });
    assert_eq!(path.end, Ok(End::Reached));
    for (level, q) in &curve {
        let exact = system.potential.arch.level(q[0]);
        assert!((level - exact).abs() < 1e-10 * limit);
        assert!((q[1] - q[0] - exact / system.potential.spring).abs() < 1e-10);
    }
    let turns = curve.windows(3).filter(|t| (t[1].1[1] - t[0].1[1]) * (t[2].1[1] - t[1].1[1]) < 0.0);
    assert_eq!(turns.count(), 2);
}

#[test]
fn displacement_control_stops_at_a_turning_point_and_keeps_the_curve() {
    let mut system = Flat::new(snap_back());
    let control = Control::Displacement { functional: vec![(1, 1.0)], step: 0.05, until: 4.0 };
    let small = PathOptions { largest: 1.0, ..options(control) };
    let (path, curve) = trace(&mut system, &small);
    // at the turning point the displacement has the value u(w) with λ'(w) = −k
    let z = ((1.0 - 0.4) / 3.0_f64).sqrt();
    let arch = shallow();
    let highest = 1.0 - z + arch.level(1.0 - z) / system.potential.spring;
    for (point, (level, q)) in path.points.iter().zip(&curve) {
        assert_eq!(point.level(), *level);
        if q[0] < 1.0 {
            assert!(q[1] < highest + 1e-9);
        }
    }
    assert!(curve.iter().filter(|(_, q)| q[0] < 1.0).any(|(_, q)| q[1] > highest - 0.051));
}

#[test]
fn a_failed_path_keeps_its_points_its_state_and_a_restart() {
    let mut system = Flat::new(Softening);
    let control = Control::Load { step: 0.05, until: 0.5 };
    let (path, curve) = trace(&mut system, &options(control));
    let limit = libm::exp(-1.0_f64);
    let Err(EquilibriumError::StepTooSmall { level, size, smallest, .. }) = &path.end else {
        panic!("{:?}", path.end)
    };
    assert!(size < smallest);
    let last = path.points.last().unwrap();
    assert_eq!((last.level(), *level), (path.restart.level, path.restart.level));
    assert_eq!(system.q, curve.last().unwrap().1, "the system stands at the last converged state");
    assert!(*level < limit && *level > limit - 1e-5, "{level} {limit}");
    assert!(path.points.iter().any(|p| p.restarts > 0));

    let range = (0.2, 1.0);
    let on = options(Control::ArcLength { first: 0.01, range });
    let path = follow(&mut system, &path.restart, &on, |_, _| ControlFlow::Continue(()));
    assert_eq!(path.end, Ok(End::Reached));
    let w = system.q[0];
    assert!(w > 1.0 && (w * libm::exp(-w) - 0.2).abs() < 1e-12);
}

/// λ = cos 0.3 − cos(q + 0.3) stiffens before it turns at q = π − 0.3: a step of 1 leaps over the limit point.
struct Swing;

impl Potential for Swing {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        q[0] * libm::cos(0.3_f64) - libm::sin(q[0] + 0.3) + libm::sin(0.3_f64)
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = libm::cos(0.3_f64) - libm::cos(q[0] + 0.3);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, libm::sin(q[0] + 0.3));
    }
    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
}

#[test]
fn a_load_step_that_leaps_over_a_limit_point_is_refused() {
    let mut system = Flat::new(Swing);
    let mut load = options(Control::Load { step: 1.0, until: 1.5 });
    load.newton.line_search = false;
    let (path, curve) = trace(&mut system, &load);
    assert_eq!(path.end, Ok(End::Reached));
    assert!(path.points[1].restarts > 0, "the first trial leaps");
    assert!(curve.iter().all(|(_, q)| q[0] < std::f64::consts::PI - 0.3));
    // with no smaller step allowed the reason is reported
    let mut system = Flat::new(Swing);
    let (path, _) = trace(&mut system, &PathOptions { smallest: 1.0, ..load });
    let Err(EquilibriumError::StepTooSmall { cause, .. }) = path.end else { panic!("{:?}", path.end) };
    assert!(
        matches!(*cause, EquilibriumError::Fold { step: 1, level: 1.0, cosine } if cosine == -1.0),
        "{cause}"
    );
}

/// As an application follows paths: full steps of Newton, watched for what is critical.
fn watched(control: Control) -> PathOptions {
    let mut watched = options(control);
    (watched.newton.line_search, watched.newton.iterations) = (false, 50);
    PathOptions { critical: Some(CriticalOptions::default()), ..watched }
}

#[test]
fn a_load_step_to_the_far_side_of_the_arch_names_the_limit_it_leapt_over() {
    for line_search in [false, true] {
        let mut system = Flat::new(shallow());
        let limit = system.potential.limit();
        let mut load = watched(Control::Load { step: 0.3 * limit, until: 1.5 * limit });
        (load.newton.line_search, load.largest) = (line_search, 1.0);
        let (path, _) = trace(&mut system, &load);
        assert_eq!(path.end, Ok(End::Reached));
        assert!(system.q[0] > 2.0, "the far side, with no negative pivot at either end");
        assert!(path.points.iter().all(|point| point.inertia().negative == 0));
        let [passage] = &path.passages[..] else { panic!("{:?}", path.passages) };
        assert!(passage.levels.0 < limit && limit < passage.levels.1 && passage.negative == (0, 0));
        let Passed::Turn(level) = passage.what else { panic!("{:?}", passage.what) };
        assert!((level - limit).abs() < 1e-9 * limit, "{level} {limit}");
        let [point] = &path.critical[..] else { panic!("{:?}", path.critical) };
        assert_eq!((point.kind, point.level, point.step), (CriticalKind::Limit, level, passage.step));
        assert_eq!(path.restart.level, 1.5 * limit, "the state found is kept");
    }
}

#[test]
fn a_displacement_step_over_a_turning_point_says_so() {
    let mut system = Flat::new(snap_back());
    let control = Control::Displacement { functional: vec![(1, 1.0)], step: 0.5, until: 4.0 };
    let (path, curve) = trace(&mut system, &PathOptions { largest: 1.0, ..watched(control) });
    assert_eq!(path.end, Ok(End::Reached));
    let leap = curve.windows(2).position(|two| two[0].1[0] < 1.0 && two[1].1[0] > 1.0).unwrap() + 1;
    let steps: Vec<_> = path.passages.iter().map(|passage| passage.step).collect();
    assert_eq!(steps, [leap]);
    assert!(matches!(path.passages[0].what, Passed::Turn(_)), "{:?}", path.passages);
}

/// λ = q + a sin q has limit points at cos q = −1/a, none if a < 1.
struct Ripple(f64);

impl Potential for Ripple {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        0.5 * q[0] * q[0] - self.0 * libm::cos(q[0])
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0] + self.0 * libm::sin(q[0]);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 1.0 + self.0 * libm::cos(q[0]));
    }
    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
}

#[test]
fn a_leap_over_many_limit_points_names_the_first() {
    let q = libm::acos(-1.0_f64 / 1.5);
    let limit = q + 1.5 * libm::sin(q);
    for until in [6.0, 9.0, 14.0, 30.0] {
        let mut system = Flat::new(Ripple(1.5));
        let (path, _) = trace(&mut system, &watched(Control::Load { step: until, until }));
        assert_eq!(path.end, Ok(End::Reached));
        let Some(&Passage { what: Passed::Turn(level), .. }) = path.passages.first() else {
            panic!("{until}: {:?}", path.passages)
        };
        assert!((level - limit).abs() < 1e-6 * limit, "{until}: {level} {limit}");
    }
}

#[test]
fn steps_that_stay_on_their_branch_are_proved_to() {
    // One step over three ripples without a limit point: far from its tangents, and on its branch all the same.
    let mut system = Flat::new(Ripple(0.9));
    let (path, curve) = trace(&mut system, &watched(Control::Load { step: 17.0, until: 17.0 }));
    assert_eq!(path.end, Ok(End::Reached));
    assert!((path.critical.is_empty(), path.passages.is_empty()) == (true, true), "{:?}", path.passages);
    let (level, q) = curve.last().unwrap();
    assert!((q[0] + 0.9 * libm::sin(q[0]) - level).abs() < 1e-8);
}

/// A spring whose model ends at q = 1.
struct Bounded;

impl Potential for Bounded {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        0.5 * q[0] * q[0]
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0];
    }
    fn hessian(&self, _q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 1.0);
    }
    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
    fn within_bounds(&self, q: &[f64]) -> Result<(), OutOfBounds> {
        let found =
            OutOfBounds { place: "the spring".into(), what: "stretch", value: q[0], bound: "below 1" };
        if q[0] < 1.0 { Ok(()) } else { Err(found) }
    }
}

#[test]
fn a_balance_beyond_the_bounds_of_the_model_is_refused() {
    let mut system = Flat::new(Bounded);
    let load = watched(Control::Load { step: 0.4, until: 3.0 });
    let path = follow(&mut system, &Start::default(), &load, |_, _| ControlFlow::Continue(()));
    let Err(EquilibriumError::StepTooSmall { cause, .. }) = &path.end else { panic!("{:?}", path.end) };
    assert!(cause.to_string().contains("stretch of the spring is 1.0"), "{cause}");
    assert!(system.q[0] < 1.0 && system.q[0] > 1.0 - 1e-5, "the last state within: {}", system.q[0]);
}

#[test]
fn the_masses_in_the_norm_of_the_arc_change_the_points_not_the_curve() {
    for masses in [vec![0.0, 0.0], vec![0.0, 3.0], vec![1.0, 2.0]] {
        let mut system = Flat::new(snap_back());
        system.masses = masses;
        let limit = system.potential.arch.limit();
        let control = Control::ArcLength { first: 0.05 * limit, range: (-2.0 * limit, 1.5 * limit) };
        let (path, curve) = trace(&mut system, &PathOptions { largest: 2.0, ..options(control) });
        assert_eq!(path.end, Ok(End::Reached));
        for (level, q) in &curve {
            assert!((level - system.potential.arch.level(q[0])).abs() < 1e-10 * limit);
        }
    }
    let empty = options(Control::ArcLength { first: 0.1, range: (1.0, 1.0) });
    assert!(matches!(trace(&mut Flat::new(snap_back()), &empty).0.end, Err(EquilibriumError::Option { .. })));
}

#[test]
fn the_observer_may_stop_and_bad_options_are_refused() {
    let mut system = Flat::new(shallow());
    let control = Control::Displacement { functional: vec![(0, 1.0)], step: 0.1, until: 2.0 };
    let path = follow(&mut system, &Start::default(), &options(control), |point, system| {
        assert_eq!(point.step > 0, system.energy() > 0.0);
        if point.step == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((path.end, path.points.len()), (Ok(End::Stopped), 4));

    let outside = Control::Displacement { functional: vec![(7, 1.0)], step: 0.1, until: 2.0 };
    let path = follow(&mut system, &Start::default(), &options(outside), |_, _| ControlFlow::Continue(()));
    assert_eq!(
        path.end.unwrap_err().to_string(),
        "controlled unknown is 7, must be below the number of unknowns"
    );
}
