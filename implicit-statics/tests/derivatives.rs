//! What holds a system against differences finds what is wrong in it, and nothing where all is right.

mod common;

use common::{Flat, Potential};
use implicit_statics::{force_error, load_rate_error, stiffness_error, tangent_error};

/// `U = ¼ q₀⁴ + ½ q₁² (1 + q₀)`, with a part of its gradient and of its stiffness left out; the load follows, `λ (1, q₀)`.
struct Spoilt {
    gradient: f64,
    stiffness: f64,
}

impl Potential for Spoilt {
    fn unknowns(&self) -> usize {
        2
    }

    fn energy(&self, q: &[f64]) -> f64 {
        0.25 * q[0].powi(4) + 0.5 * q[1] * q[1] * (1.0 + q[0])
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0].powi(3) + 0.5 * q[1] * q[1] * (1.0 - self.gradient);
        out[1] = q[1] * (1.0 + q[0]);
    }

    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 3.0 * q[0] * q[0] * (1.0 - self.stiffness));
        add(1, 0, q[1]);
        add(1, 1, 1.0 + q[0]);
    }

    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[1.0, 0.5]);
    }
}

/// Errors of force, stiffness, tangent and load rate.
fn errors(gradient: f64, stiffness: f64, at: [f64; 2]) -> [f64; 4] {
    let mut system = Flat::new(Spoilt { gradient, stiffness });
    system.q = at.to_vec();
    let way = [0.7, -0.4];
    let found = [
        force_error(&mut system, 0.3, &way, 1e-3),
        stiffness_error(&mut system, 0.3, &way, 1e-3),
        tangent_error(&mut system, 0.3, &way, 1e-3),
        load_rate_error(&mut system, 0.3, 1e-3),
    ];
    assert_eq!(system.q, at, "the state is what it was");
    found
}

#[test]
fn a_sound_system_shows_rounding_and_a_spoilt_one_its_fault() {
    let sound = errors(0.0, 0.0, [0.8, 0.5]);
    println!("{sound:.1?}");
    // The potential is of fourth degree, so that differences of fourth order are exact but for 1e-16 over the step.
    assert!(sound.iter().all(|error| *error < 1e-12), "{sound:?}");
    let wrong_force = errors(0.1, 0.0, [0.8, 0.5]);
    assert!(wrong_force[0] > 1e-2 && wrong_force[1] > 1e-3 && wrong_force[2] > 1e-3, "{wrong_force:?}");
    let wrong_tangent = errors(0.0, 0.1, [0.8, 0.5]);
    assert!(
        wrong_tangent[0] < 1e-12 && wrong_tangent[1] > 1e-2 && wrong_tangent[2] > 1e-2,
        "{wrong_tangent:?}"
    );
}

#[test]
fn what_is_no_number_is_no_agreement() {
    let found = errors(f64::NAN, 0.0, [0.8, 0.5]);
    assert_eq!(found[..3], [f64::INFINITY; 3], "{found:?}");
}
