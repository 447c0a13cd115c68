//! The water that benches march.

#![allow(dead_code, clippy::unwrap_used)] // each bench uses some of it, and may stop where it stands

#[path = "../../tests/common/mod.rs"]
mod common;

use std::fs;

use common::{disorder, pool};
use explicit_dynamics::Clock;
use fluid_sph::{Fluid, Formulation, Parts, Scheme};

/// A square or cube of so many particles a side in disorder, without walls: what is measured are the fluid's own sweeps.
#[derive(Clone, Copy)]
pub struct Water {
    pub name: &'static str,
    pub dimensions: usize,
    pub side: usize,
    pub scheme: Scheme,
}

impl Water {
    pub const fn new(name: &'static str, dimensions: usize, side: usize, scheme: Scheme) -> Self {
        Self { name, dimensions, side, scheme }
    }

    /// The fluid and a clock that has made its first step.
    pub fn fluid(&self, threads: usize) -> (Fluid, Clock) {
        let Self { dimensions, side, scheme, .. } = *self;
        let size = if dimensions == 2 { [1.0, 1.0, 0.0] } else { [1.0; 3] };
        let mut parts = pool(dimensions, size, size, 1.0 / side as f64);
        parts.walls.clear();
        disorder(&mut parts, 0.4, 0.5);
        let formulation = Formulation { scheme, ..Formulation::default() };
        let mut fluid = Fluid::new(Parts { formulation, threads, ..parts }).unwrap();
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
        steps(&mut fluid, &mut clock, 1);
        (fluid, clock)
    }
}

/// A column that falls and runs along the bottom of a basin between walls.
pub fn dam(dimensions: usize, spacing: f64) -> Parts {
    let (water, basin) =
        if dimensions == 2 { ([1.0, 1.0, 0.0], [3.0, 1.0, 0.0]) } else { ([0.5, 0.5, 0.5], [1.5, 0.5, 0.5]) };
    let mut parts = pool(dimensions, water, basin, spacing);
    disorder(&mut parts, 0.2, 1.0);
    parts
}

/// Marches so many steps.
pub fn steps(fluid: &mut Fluid, clock: &mut Clock, count: usize) {
    for _ in 0..count {
        clock.step(fluid, f64::INFINITY, |_| 1.0).unwrap();
    }
}

/// Time of the processor on this thread \[s\].
pub fn thread_seconds() -> f64 {
    let reported =
        fs::read_to_string("/proc/thread-self/schedstat").expect("a system that tells the time of a thread");
    1e-9 * reported.split(' ').next().and_then(|time| time.parse::<f64>().ok()).expect("a time")
}
