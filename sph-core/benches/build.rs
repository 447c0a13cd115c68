//! Set-up: neighbours and sampling operators at 10 000 and 100 489 particles.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use sph_core::{
    CellList, CubicSpline, EndWeights, Plate, cell_operator, kernel_operator, lattice, nodal_operator,
};

fn set_up(c: &mut Criterion) {
    for side in [100, 317] {
        let particles = (side * side) as u64;
        let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [side, side], EndWeights::Trapezoid)
            .expect("a sound lattice");
        let radius = 2.5 / side as f64;
        let mut group = c.benchmark_group(format!("{particles} particles"));
        group.throughput(Throughput::Elements(particles)).sample_size(10);
        group.bench_function("neighbours within 2.5 spacings", |b| {
            b.iter(|| {
                let list = CellList::new(&cloud.positions, radius);
                let (mut found, mut total) = (Vec::new(), 0);
                for x in &cloud.positions {
                    list.within(x, radius, &mut found);
                    total += found.len();
                }
                total
            });
        });
        group.bench_function("cell operator", |b| b.iter(|| cell_operator(&cloud).expect("sound cells")));
        group.bench_function("kernel operator, reach 1.4", |b| {
            b.iter(|| kernel_operator(&cloud, &CubicSpline, 1.4).expect("sound stencils"));
        });
        group.bench_function("nodal operator, order 2", |b| {
            b.iter(|| nodal_operator(&cloud, &CubicSpline, 2, 1.3).expect("sound stencils"));
        });
    }
}

criterion_group!(benches, set_up);
criterion_main!(benches);
