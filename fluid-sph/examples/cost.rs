//! Scratch: steps of a jittered pool.
#![allow(clippy::unwrap_used)]
#[path = "../tests/common/mod.rs"]
mod common;
use common::pool;
use explicit_dynamics::Clock;
use fluid_sph::*;
fn main() {
    let n: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let steps: usize = std::env::args().nth(2).unwrap().parse().unwrap();
    let dims: usize = std::env::args().nth(3).unwrap().parse().unwrap();
    let dx = 1.0 / n as f64;
    let size = if dims == 2 { [1.0, 1.0, 0.0] } else { [1.0; 3] };
    let mut parts = pool(dims, size, size, dx);
    parts.walls.clear();
    for (i, p) in parts.positions.iter_mut().enumerate() {
        for k in 0..dims {
            p[k] += 0.2 * dx * ((i * (k + 3)) as f64 * 0.618).fract();
        }
    }
    let mut f = Fluid::new(parts).unwrap();
    let mut clock = Clock::start(&mut f, 1.0, 1.0, 0.0).unwrap();
    let t = std::time::Instant::now();
    for _ in 0..steps {
        clock.step(&mut f, f64::INFINITY, |_| 1.0).unwrap();
    }
    println!(
        "{} particles {:.1} ns a particle-step, {} bytes",
        f.len(),
        t.elapsed().as_nanos() as f64 / (steps * f.len()) as f64,
        f.bytes_per_particle()
    );
}
