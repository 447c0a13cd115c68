//! Newton's method: quadratic convergence, manifolds, line search, rounding, and what it refuses.

mod common;

use std::ops::ControlFlow;

use common::bars::Bars;
use common::pendulum::Pendulum;
use common::{Arch, Flat, Hencky, Potential};
use implicit_statics::{
    Control, Equilibrium, EquilibriumError, Newton, NewtonOptions, PathOptions, Start, follow,
    linear_response, tangent_error,
};

fn tight() -> NewtonOptions {
    NewtonOptions { tolerance: 1e-13, ..Default::default() }
}

/// r_{k+1}/r_k² over the iterates that are near the solution and above rounding.
fn ratios(residuals: &[f64], scale: f64) -> Vec<f64> {
    let near = |r: &&[f64]| r[0] < 0.1 * scale && r[1] > 1e-13 * scale;
    residuals.windows(2).filter(near).map(|r| r[1] / (r[0] * r[0])).collect()
}

#[test]
fn residuals_fall_quadratically() {
    let mut arch = Flat::new(Arch { half: 10.0, height: 1.0, sideways: false });
    let limit = arch.potential.limit();
    let converged = Newton::new(&arch, &tight()).unwrap().at_level(&mut arch, 0.7 * limit).unwrap();
    let seen = ratios(&converged.residuals, limit);
    assert!(seen.len() >= 2, "{:?}", converged.residuals);
    assert!(seen.iter().all(|r| r * limit < 1.5), "{seen:?}");

    let mut pendulum = Pendulum::new(12);
    let converged = Newton::new(&pendulum, &tight()).unwrap().at_level(&mut pendulum, 0.02).unwrap();
    let scale = converged.residuals[0];
    let seen = ratios(&converged.residuals, scale);
    assert!(seen.len() >= 2, "{:?}", converged.residuals);
    assert!(seen.iter().all(|r| r * scale < 1.0), "{seen:?}");
}

#[test]
fn bordered_steps_converge_quadratically_too() {
    for control in [
        Control::ArcLength { first: 0.002, range: (-1.0, 0.02) },
        Control::Displacement { functional: vec![(22, 1.0), (23, 0.5)], step: 0.2, until: 1.0 },
    ] {
        let mut pendulum = Pendulum::new(12);
        let options = PathOptions { newton: tight(), ..PathOptions::new(control) };
        let softest = (std::f64::consts::PI / 24.0).powi(2); // eigenvalue of the straight chain
        let mut count = 0;
        let path = follow(&mut pendulum, &Start::default(), &options, |point, _| {
            let seen = ratios(&point.converged.residuals, point.level() * Pendulum::load());
            assert!(seen.iter().all(|r| r * softest * softest < 5.0), "{:?}", point.converged.residuals);
            count += seen.len();
            ControlFlow::Continue(())
        });
        assert!(path.end.is_ok());
        assert!(count >= 3, "{count}");
    }
}

/// Every director turns in the plane of e_z and the load; the last balance of moments is
/// sin(φᵢ − φᵢ₋₁) − sin(φᵢ₊₁ − φᵢ) = λ f cos φᵢ.
#[test]
fn directors_turn_far_on_their_spheres() {
    let mut pendulum = Pendulum::new(10);
    let options =
        PathOptions { newton: tight(), ..PathOptions::new(Control::Load { step: 0.02, until: 2.0 }) };
    let path = follow(&mut pendulum, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert!(path.end.is_ok(), "{:?}", path.end);
    let force = 2.0 * Pendulum::load();
    let angle = |i: usize| pendulum.angle(i);
    for i in 0..10 {
        let below = angle(i) - if i == 0 { 0.0 } else { angle(i - 1) };
        let above = if i == 9 { 0.0 } else { angle(i + 1) - angle(i) };
        assert!((libm::sin(below) - libm::sin(above) - force * libm::cos(angle(i))).abs() < 1e-12);
        assert!((pendulum.director(i).norm() - 1.0).abs() < 1e-13);
    }
    assert!(angle(9) > 1.5, "{}", angle(9));
    assert!(path.points.iter().all(|p| p.inertia().negative == 0));

    // one director alone: tan φ = λ f
    let mut single = Pendulum::new(1);
    Newton::new(&single, &tight()).unwrap().at_level(&mut single, 3.0).unwrap();
    assert!((libm::tan(single.angle(0)) - 3.0 * Pendulum::load()).abs() < 1e-11);
}

#[test]
fn tangents_of_the_test_systems_are_derivatives() {
    let mut chain = Flat::new(Hencky { links: 6 });
    chain.q = vec![0.02, 0.05, 0.04, -0.01, 0.03];
    check_tangent(&mut chain, 3.0);
    let mut arch = Flat::new(Arch { half: 1.0, height: 2.0, sideways: true });
    arch.q = vec![0.3, 0.2];
    check_tangent(&mut arch, 0.1);
    let mut pendulum = Pendulum::new(3);
    pendulum.update(&[0.3, 0.2, -0.4, 0.9, 0.1, 1.1]);
    let balanced = Newton::new(&pendulum, &tight()).unwrap().at_level(&mut pendulum, 0.5).unwrap();
    check_tangent(&mut pendulum, balanced.level);
}

fn check_tangent<E: Equilibrium>(system: &mut E, level: f64) {
    let ways = 0..system.unknowns();
    let worst = ways.map(|j| {
        let mut way = vec![0.0; system.unknowns()];
        way[j] = 1.0;
        tangent_error(system, level, &way, 2e-4)
    });
    let worst = worst.fold(0.0, f64::max);
    println!("tangent {worst:.1e}");
    assert!(worst < 1e-9, "{worst:.1e}");
}

#[test]
fn a_linear_answer_is_the_slope_of_the_path() {
    let mut arch = Flat::new(Arch { half: 10.0, height: 1.0, sideways: false });
    let slope = linear_response(&mut arch, 0.0).unwrap()[0];
    let stiffness = 2.0 * arch.potential.height.powi(2) / arch.potential.bar().powi(3); // λ'(0)
    assert!((slope * stiffness - 1.0).abs() < 1e-12);
    assert_eq!(arch.q, vec![0.0]);
}

#[test]
fn a_line_search_shortens_what_overshoots() {
    let solve = |line_search| {
        let mut stiff = Flat::new(Stiffening);
        let options = NewtonOptions { line_search, iterations: 40, ..tight() };
        let converged = Newton::new(&stiff, &options).unwrap().at_level(&mut stiff, 100.0);
        (converged, stiff.q[0])
    };
    let (with, q) = solve(true);
    let (without, _) = solve(false);
    assert!((libm::sinh(q) - 100.0).abs() < 1e-10);
    let (with, without) = (with.unwrap().iterations, without.map_or(usize::MAX, |c| c.iterations));
    assert!(with < without, "{with} {without}");
}

/// λ = sinh q: the tangent at rest is far too soft for a large load.
struct Stiffening;

impl Potential for Stiffening {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        libm::cosh(q[0]) - 1.0
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = libm::sinh(q[0]);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, libm::cosh(q[0]));
    }
    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
}

/// Two points on a stiff link, far from the origin, held by soft springs: the force of the link is a difference
/// of positions, and its rounding is larger than the tolerance asks for.
struct StiffLink;

const AWAY: f64 = 1000.0;

impl Potential for StiffLink {
    fn unknowns(&self) -> usize {
        2
    }
    fn energy(&self, q: &[f64]) -> f64 {
        0.5e8 * (q[1] - q[0]).powi(2) + 0.5 * (q[0] * q[0] + q[1] * q[1])
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        let force = 1e8 * ((q[1] + AWAY) - (q[0] + AWAY));
        out.copy_from_slice(&[q[0] - force, q[1] + force]);
    }
    fn hessian(&self, _q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 1e8 + 1.0);
        add(1, 0, -1e8);
        add(1, 1, 1e8 + 1.0);
    }
    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[1.0, 0.3]);
    }
}

#[test]
fn rounding_of_the_forces_ends_the_iteration() {
    let mut link = Flat::new(StiffLink);
    let converged = Newton::new(&link, &tight()).unwrap().at_level(&mut link, 1.0).unwrap();
    assert!(converged.bound > 1e-12 && converged.bound < 1e-4, "{converged:?}");
    assert!(converged.iterations <= 5, "{converged:?}");
    assert!((link.q[0] - 0.65).abs() < 1e-6 && (link.q[1] - 0.65).abs() < 1e-6, "{:?}", link.q);
}

#[test]
fn a_mechanism_is_named() {
    // two bars in a line: nothing holds their joint downwards
    let mut flat = Flat::new(Arch { half: 1.0, height: 0.0, sideways: true });
    let error = Newton::new(&flat, &tight()).unwrap().at_level(&mut flat, 0.1).unwrap_err();
    let EquilibriumError::Mechanism { zero: 1, unknown: 0, ref name, .. } = error else { panic!("{error}") };
    assert_eq!(name, "apex, down");
    let message = error.to_string();
    assert!(message.starts_with("step 0, load level 1.0"), "{message}");
    assert!(message.contains("the structure moves freely, mostly in apex, down"), "{message}");

    let control = Control::ArcLength { first: 0.1, range: (0.0, 1.0) };
    let path =
        follow(&mut flat, &Start::default(), &PathOptions::new(control), |_, _| ControlFlow::Continue(()));
    assert!(matches!(path.end, Err(EquilibriumError::Mechanism { step: 0, .. })), "{:?}", path.end);
}

#[test]
fn failures_say_where_and_leave_the_state() {
    let mut arch = Flat::new(Arch { half: 10.0, height: 1.0, sideways: false });
    let options = NewtonOptions { iterations: 2, ..tight() };
    let limit = arch.potential.limit();
    let error = Newton::new(&arch, &options).unwrap().at_level(&mut arch, 0.9 * limit).unwrap_err();
    let EquilibriumError::NotConverged { iterations: 2, ref residuals, residual, bound, .. } = error else {
        panic!("{error}")
    };
    assert_eq!((residuals.len(), residuals[2]), (3, residual));
    assert!(residual > bound);
    assert_eq!(arch.q, vec![0.0]);
    assert!(error.to_string().contains("above the bound"), "{error}");

    let mut arch = Flat::new(Arch { half: 10.0, height: 1.0, sideways: false });
    let error = Newton::new(&arch, &tight()).unwrap().at_level(&mut arch, f64::NAN).unwrap_err();
    assert!(matches!(error, EquilibriumError::Force { ref name, .. } if name == "apex, down"), "{error}");
}

/// A row of bars whose end is moved: every joint goes along in proportion, in one step predicted by the load rate.
#[test]
fn held_values_go_with_the_level_and_kept_states_are_announced() {
    let mut bars = Bars::new(20);
    let options = PathOptions::new(Control::Load { step: 0.25, until: 1.0 });
    let path = follow(&mut bars, &Start::default(), &options, |_, _| ControlFlow::Continue(()));
    assert!(path.end.is_ok());
    for (i, q) in bars.q.iter().enumerate() {
        assert!((q - (i + 1) as f64 / 20.0).abs() < 1e-9, "{q}");
    }
    assert!(path.points.iter().skip(1).all(|point| point.converged.iterations == 1), "{:?}", path.points);
    // The start and every point.
    assert_eq!(bars.accepted, 1 + path.points.len() - 1);

    let mut bars = Bars::new(5);
    let mut rate = vec![0.0; 4];
    bars.q = vec![0.1, 0.15, 0.3, 0.4];
    bars.load_rate(0.7, &mut rate);
    let mut difference = |level: f64| {
        let mut out = vec![0.0; 4];
        bars.internal(level, &mut out);
        out
    };
    let (plus, minus) = (difference(0.7 + 1e-5), difference(0.7 - 1e-5));
    for i in 0..4 {
        assert!(((minus[i] - plus[i]) / 2e-5 - rate[i]).abs() < 1e-6 * rate[3], "{i}");
    }
}

/// A spring that stiffens, `f = q + q³`, and counts its tangents.
struct CountedSpring {
    q: f64,
    keeps: bool,
    tangents: usize,
}

impl Equilibrium for CountedSpring {
    fn unknowns(&self) -> usize {
        1
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        vec![(0, 0)]
    }

    fn internal(&mut self, _level: f64, out: &mut [f64]) {
        out[0] = self.q + self.q.powi(3);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        out[0] = level;
    }

    fn load_rate(&mut self, _level: f64, out: &mut [f64]) {
        out[0] = 1.0;
    }

    fn tangent(&mut self, _level: f64, values: &mut [f64]) {
        self.tangents += 1;
        values[0] = 1.0 + 3.0 * self.q * self.q;
    }

    fn keeps_factor(&self) -> bool {
        self.keeps
    }

    fn update(&mut self, increment: &[f64]) {
        self.q += increment[0];
    }

    fn save(&self) -> Vec<f64> {
        vec![self.q]
    }

    fn restore(&mut self, saved: &[f64]) {
        self.q = saved[0];
    }

    fn energy(&mut self) -> f64 {
        0.5 * self.q.powi(2) + 0.25 * self.q.powi(4)
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0]
    }

    fn name_unknown(&self, _unknown: usize) -> String {
        "the end of the spring".into()
    }
}

#[test]
fn a_factor_that_still_serves_is_kept_where_the_system_asks_for_it() {
    let run = |keeps: bool| {
        let mut spring = CountedSpring { q: 0.0, keeps, tangents: 0 };
        let mut newton = Newton::new(&spring, &tight()).unwrap();
        for level in [1.0, 2.0, 3.0] {
            let converged = newton.at_level(&mut spring, level).unwrap();
            assert_eq!(converged.inertia.positive, 1);
        }
        assert!((spring.q + spring.q.powi(3) - 3.0).abs() < 1e-12);
        spring.tangents
    };
    let (kept, always) = (run(true), run(false));
    assert!(kept < always, "{kept} tangents for {always}");
}

#[test]
fn without_the_inertia_of_a_balance_a_factor_less_is_made_and_its_state_is_the_same() {
    let run = |inertia: bool| {
        let mut spring = CountedSpring { q: 0.0, keeps: false, tangents: 0 };
        let mut newton = Newton::new(&spring, &NewtonOptions { inertia, ..tight() }).unwrap();
        let mut iterations = 0;
        for level in [0.0, 1.0, 2.0, 3.0] {
            // Whoever moves the state leaves no factor to begin with.
            newton.has_moved();
            let converged = newton.at_level(&mut spring, level).unwrap();
            assert_eq!(converged.inertia.positive, usize::from(inertia || level > 0.0));
            iterations += converged.iterations;
        }
        (spring.q.to_bits(), iterations, spring.tangents)
    };
    let ((state, iterations, with), (other, same, without)) = (run(true), run(false));
    assert_eq!((state, iterations), (other, same));
    // One for each of the four levels.
    assert_eq!(with, without + 4);
}
