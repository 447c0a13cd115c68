//! Forces and full steps of both laws, in a plane and in space, on one and two threads.
//!
//! `cargo xtask bench` runs it; throughput is printed in directed bonds per second.

mod lattices;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use explicit_dynamics::Clock;
use lattices::{body, name};
use peridynamics::Law;

fn laws(c: &mut Criterion) {
    for counts in [[100, 100, 1], [316, 316, 1], [22, 22, 22], [46, 46, 46]] {
        for law in [Law::BondBased, Law::StateBased] {
            case(c, counts, law, &[1, 2]);
        }
    }
}

/// What a million nodes need.
fn million(c: &mut Criterion) {
    case(c, [100, 100, 100], Law::BondBased, &[2]);
}

fn case(c: &mut Criterion, counts: [usize; 3], law: Law, threads: &[usize]) {
    let mut group = c.benchmark_group(format!("{} {counts:?}", name(law)));
    for &threads in threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let mut solid = body(counts, law, threads);
        let bonds = solid.bonds() as u64;
        println!(
            "{} nodes, {bonds} bonds, {:.1} MB that a step touches, {:.0} bytes a node",
            solid.len(),
            solid.bytes_per_particle() * solid.len() as f64 / 1e6,
            solid.bytes_per_particle(),
        );
        let mut clock = Clock::start(&mut solid, 1.0, 0.5, 0.0).expect("a stable step");
        group.throughput(Throughput::Elements(bonds)).sample_size(10);
        group.bench_function(format!("forces, {threads} threads"), |b| {
            pool.install(|| b.iter(|| solid.evaluate_internal(false)));
        });
        group.bench_function(format!("full step, {threads} threads"), |b| {
            pool.install(|| {
                b.iter(|| clock.step(&mut solid, f64::INFINITY, |_| 1.0).expect("a sound step"));
            });
        });
    }
}

criterion_group!(benches, laws, million);
criterion_main!(benches);
