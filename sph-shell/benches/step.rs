//! One acceleration and one full step of the default formulation, at 22 500 and 100 489 particles, on one and two threads.
//!
//! `cargo xtask bench` runs it; throughput is printed in particle-steps per second.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use explicit_dynamics::Clock;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{CubicSpline, EndWeights, Plate, Vec3, lattice};
use sph_shell::{Divergence, Formulation, Parts, Reach, Shell};

/// A free square plate, L/t = 100, in slow motion: rates of some tenths per cent of the speed of sound.
fn plate(side: usize, formulation: Formulation, threads: usize) -> Shell {
    let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [side, side], EndWeights::Trapezoid)
        .expect("a sound lattice");
    let material = Isotropic::new(1e6, 0.3).expect("a sound material");
    let mut shell = Shell::builder(Parts {
        cloud,
        section: Box::new(IsotropicSection::new(material, 0.01).expect("a sound section")),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation,
        supports: Vec::new(),
        loads: Vec::new(),
        threads,
    })
    .build()
    .expect("a sound shell");
    for a in 0..shell.len() {
        let x = shell.position(a);
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y), Vec3::zeros());
    }
    shell
}

fn default_formulation(c: &mut Criterion) {
    for side in [150, 317] {
        let particles = (side * side) as u64;
        let mut group = c.benchmark_group(format!("{particles} particles"));
        group.throughput(Throughput::Elements(particles)).sample_size(20);
        for threads in [1, 2] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            let mut shell = plate(side, Formulation::StressPoint(Reach::Cell), threads);
            println!("{} bytes per particle", shell.bytes_per_particle());
            let mut clock = Clock::start(&mut shell, 1.0, 0.5, 0.0).expect("a stable step");
            group.bench_function(format!("acceleration, {threads} threads"), |b| {
                pool.install(|| b.iter(|| shell.evaluate_internal(false)));
            });
            group.bench_function(format!("full step, {threads} threads"), |b| {
                pool.install(|| {
                    b.iter(|| clock.step(&mut shell, f64::INFINITY, |_| 1.0).expect("a sound step"))
                });
            });
        }
    }
}

fn formulations(c: &mut Criterion) {
    let nodal =
        |order, smoothing| Formulation::Nodal { order, smoothing, consistent: false, kernel: &CubicSpline };
    let mut group = c.benchmark_group("2500 particles, one thread");
    group.throughput(Throughput::Elements(2500)).sample_size(20);
    for formulation in [
        Formulation::StressPoint(Reach::Cell),
        Formulation::StressPoint(Reach::Kernel(&CubicSpline, 2.9)),
        nodal(1, 1.2),
        nodal(2, 1.3),
        nodal(3, 1.5),
        Formulation::StrongForm {
            smoothing: 1.2,
            viscosity: 1.0,
            divergence: Divergence::Sum,
            kernel: &CubicSpline,
        },
    ] {
        let mut shell = plate(50, formulation, 1);
        let mut clock = Clock::start(&mut shell, 1.0, 0.2, 0.0).expect("a stable step");
        group.bench_function(format!("full step, {formulation:?}"), |b| {
            b.iter(|| clock.step(&mut shell, f64::INFINITY, |_| 1.0).expect("a sound step"));
        });
    }
}

criterion_group!(benches, default_formulation, formulations);
criterion_main!(benches);
