//! Load steps of one solve each: their order, what they tell of their error, held values that move.

mod common;

use common::bars::Bars;
use implicit_statics::{Equilibrium, EquilibriumError, Newton, NewtonOptions, OneSolve};

/// A spring that stiffens, `q + q³ = λ`.
struct Spring(f64);

impl Equilibrium for Spring {
    fn unknowns(&self) -> usize {
        1
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        vec![(0, 0)]
    }

    fn internal(&mut self, _: f64, out: &mut [f64]) {
        out[0] = self.0 + self.0.powi(3);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        out[0] = level;
    }

    fn load_rate(&mut self, _: f64, out: &mut [f64]) {
        out[0] = 1.0;
    }

    fn tangent(&mut self, _: f64, values: &mut [f64]) {
        values[0] = 1.0 + 3.0 * self.0.powi(2);
    }

    fn update(&mut self, increment: &[f64]) {
        self.0 += increment[0];
    }

    fn save(&self) -> Vec<f64> {
        vec![self.0]
    }

    fn restore(&mut self, saved: &[f64]) {
        self.0 = saved[0];
    }

    fn energy(&mut self) -> f64 {
        0.5 * self.0.powi(2) + 0.25 * self.0.powi(4)
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0]
    }

    fn name_unknown(&self, _: usize) -> String {
        "the spring".into()
    }
}

/// To λ = 2, where q = 1: half the step leaves a quarter of the error, and `K⁻¹ r` is the error but for its own square.
#[test]
fn errors_are_of_the_second_order_and_reported() {
    let run = |steps: usize| {
        let mut spring = Spring(0.0);
        let mut scheme = OneSolve::new(&spring).unwrap();
        let level = |step: usize| 2.0 * step as f64 / steps as f64;
        for step in 1..=steps {
            let left = scheme.step(&mut spring, (level(step - 1), level(step))).unwrap();
            let exact = (spring.0 + spring.0.powi(3) - level(step)).abs() / level(step);
            assert!((left - exact).abs() < 1e-14, "rounding: {left} for {exact}");
        }
        let reported = scheme.remaining_displacement(&mut spring, 2.0).unwrap()[0];
        assert_eq!(scheme.inertia().negative, 0);
        (spring.0 - 1.0, reported)
    };
    let found = [20, 40, 80].map(run);
    for pair in found.windows(2) {
        let ratio = pair[0].0 / pair[1].0;
        assert!((3.8..4.3).contains(&ratio), "{ratio}: {found:?}");
    }
    for (error, reported) in found {
        // f = q + q³: the correction leaves ½ f″/f′ e² = ¾ e² at q = 1
        assert!((reported + error).abs() < 0.8 * error * error, "{error} reported as {reported}");
    }
}

/// The end of a row of bars goes with the level: all joints in proportion, in balance after every step.
#[test]
fn held_values_go_with_the_level() {
    let mut bars = Bars::new(8);
    let mut scheme = OneSolve::new(&bars).unwrap();
    for step in 0..4 {
        let left = scheme.step(&mut bars, (0.25 * f64::from(step), 0.25 * f64::from(step + 1))).unwrap();
        assert!(left < 1e-14, "{left} of the force at the end");
    }
    for (i, q) in bars.q.iter().enumerate() {
        assert!((q - (i + 1) as f64 / 8.0).abs() < 1e-14, "{q}");
    }
    let way = scheme.remaining_displacement(&mut bars, 1.0).unwrap();
    assert!(way.iter().all(|way| way.abs() < 1e-14));
    let mut balanced = Bars::new(8);
    Newton::new(&balanced, &NewtonOptions::default()).unwrap().at_level(&mut balanced, 1.0).unwrap();
    assert!(bars.q.iter().zip(&balanced.q).all(|(a, b)| (a - b).abs() < 1e-9));
}

#[test]
fn what_is_no_number_is_named() {
    let mut spring = Spring(0.0);
    let mut scheme = OneSolve::new(&spring).unwrap();
    let error = scheme.step(&mut spring, (0.0, 1e200)).unwrap_err(); // its cube is beyond numbers
    assert!(matches!(error, EquilibriumError::Force { ref name, .. } if name == "the spring"), "{error}");
}
