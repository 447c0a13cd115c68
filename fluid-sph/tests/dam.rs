//! A column that falls: its front against measured ones, and the ledger of its energy.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{GRAVITY, pool};
use explicit_dynamics::{Clock, Dynamics};
use fluid_sph::{Fluid, Formulation, Scheme};

/// Fronts x/L of a column of height 2L at `T = t √(2g/L)` = 1, 1.5, 2, 2.5, 3, and the greatest error of the energy over the
/// potential energy released.
fn fronts(formulation: Formulation) -> ([f64; 5], f64) {
    let spacing = 0.04;
    let mut parts = pool(2, [1.0, 2.0, 0.0], [4.6, 2.4, 0.0], spacing);
    parts.formulation = formulation;
    let mut fluid = Fluid::new(parts).unwrap();
    let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
    let start = fluid.energies();
    let total = |e: &fluid_sph::Energies| e.kinetic + e.compression + e.potential + e.viscous + e.diffusion;
    let mut worst: f64 = 0.0;
    let fronts = [1.0, 1.5, 2.0, 2.5, 3.0].map(|scaled| {
        let until = scaled / (2.0 * GRAVITY).sqrt();
        while clock.now.time < until * (1.0 - 1e-9) {
            clock.step(&mut fluid, until - clock.now.time, |_| 1.0).unwrap();
        }
        let now = fluid.energies();
        worst = worst.max((total(&now) - total(&start)).abs() / (start.potential - now.potential));
        fluid.positions().iter().map(|p| p.x).fold(0.0, f64::max) + 0.5 * spacing
    });
    fluid.within_bounds(explicit_dynamics::Bounds::Configuration).unwrap();
    (fronts, worst)
}

/// Upper edge of three measured fronts \[martin1952, koshizuka1996\]; a column without a gate and hardly any friction runs ahead.
const MEASURED: [f64; 5] = [1.40, 1.85, 2.39, 3.03, 3.75];
const LEAST: [f64; 5] = [1.33, 1.77, 2.30, 2.79, 3.47];

fn check(formulation: Formulation) {
    let (fronts, worst) = fronts(formulation);
    for (number, front) in fronts.iter().enumerate() {
        // Ahead of the measured band by 8 % at most where it is compared.
        let (low, high) = (LEAST[number], 1.10 * MEASURED[number]);
        assert!(*front > low && *front < high, "{fronts:?}");
    }
    assert!(worst < 0.01, "{worst}");
}

/// Measured 1.50, 1.99, 2.56, 3.19, 3.89: 4 to 8 % ahead; the energy closes to 0.5 % of what was released, later to 0.2 %.
#[test]
fn by_kicks_and_drifts() {
    check(Formulation::default());
}

/// The same flow by the other scheme.
#[test]
fn by_predictor_and_corrector() {
    check(Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() });
}

/// Measured 1.45, 1.94, 2.53, 3.18, 3.87.
#[test]
fn by_the_published_set() {
    check(Formulation::published());
}
