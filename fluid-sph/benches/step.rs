//! A whole step of kick and drift on one core, in disordered water: time and memory a particle.

#![allow(missing_docs, clippy::unwrap_used)] // a bench may stop where it stands

#[path = "../tests/common/mod.rs"]
mod common;

use common::{disorder, pool};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use explicit_dynamics::Clock;
use fluid_sph::Fluid;

/// A square or cube of so many particles a side in disorder, without walls: what is measured are the fluid's own sweeps.
fn water(dimensions: usize, side: usize) -> Fluid {
    let size = if dimensions == 2 { [1.0, 1.0, 0.0] } else { [1.0; 3] };
    let mut parts = pool(dimensions, size, size, 1.0 / side as f64);
    parts.walls.clear();
    disorder(&mut parts, 0.4, 0.5);
    Fluid::new(parts).unwrap()
}

fn step(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step");
    group.sample_size(10);
    for (name, dimensions, side) in
        [("plane 1e4", 2, 100), ("plane 1e5", 2, 316), ("plane 1e6", 2, 1000), ("space 1e5", 3, 46)]
    {
        let mut fluid = water(dimensions, side);
        let mut clock = Clock::start(&mut fluid, 1.0, 1.0, 0.0).unwrap();
        clock.step(&mut fluid, f64::INFINITY, |_| 1.0).unwrap();
        println!("{name}: {} bytes a particle", fluid.bytes_per_particle());
        group.throughput(Throughput::Elements(fluid.len() as u64));
        group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
            bencher.iter(|| clock.step(&mut fluid, f64::INFINITY, |_| 1.0).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, step);
criterion_main!(benches);
