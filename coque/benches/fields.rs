//! What a frame of fields costs beside the 200 steps it shows, at 100 489 particles: all in one run, so that ratios hold.

use std::path::Path;

use coque::scene::Fields;
use coque::{FieldFiles, FieldRequest, FieldSink, Force, Frame, Length, Scene, State, Time, Units};
use criterion::{Criterion, criterion_group, criterion_main};
use explicit_dynamics::Clock;

const SCENE: &str = r#"
title = "A plate under a sudden pressure"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [3.17, 3.17], particles = [317, 317] }
material.elastic = { young = 2.1e11, poisson = 0.3, density = 7800.0 }
section.homogeneous = { thickness = 0.01 }
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "all", pressure = { value = 1e4, follower = false } }]
analysis.explicit.transient = { duration = 1.0, record_every = 1.0 }
"#;

fn frames(c: &mut Criterion) {
    let mut group = c.benchmark_group("100489 particles");
    group.sample_size(10);
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let shell = Scene::parse(SCENE, "plate").and_then(|scene| scene.build_shell(threads));
        let mut shell = shell.expect("a sound scene");
        let mut clock = Clock::start(&mut shell, 1.0, 0.8, 0.0).expect("a stable step");
        group.bench_function(format!("200 steps, {threads} threads"), |b| {
            let mut steps = || {
                for _ in 0..200 {
                    clock.step(&mut shell, f64::INFINITY, |_| 1.0).expect("a sound step");
                }
            };
            pool.install(|| b.iter(&mut steps));
        });
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fields-bench");
        for (name, stresses, extruded) in
            [("motion", false, false), ("stresses", true, false), ("stresses, extruded", true, true)]
        {
            let units = Units { length: Length::None, force: Force::None, time: Time::None, by_depth: false };
            let shown = FieldRequest {
                state: State::Moving,
                units,
                stresses,
                indicator: false,
                contact: false,
                of_stresses: coque::StressFields::default(),
                driven: None,
                forces: None,
            };
            let wanted = Fields { stresses, extruded, ..Fields::MOTION };
            group.bench_function(format!("frame of {name}, {threads} threads"), |b| {
                pool.install(|| {
                    b.iter(|| {
                        // Always frame zero: the disk is not filled.
                        let (case, envelope) = (None, None);
                        let frame =
                            Frame { body: &shell, shown, along: 0.0, level: 1.0, time: 0.0, case, envelope };
                        let files = FieldFiles::create(&folder, FieldFiles::LONE, &wanted);
                        files.and_then(|mut files| files.frame(&frame)).expect("room on the disk");
                    });
                });
            });
        }
    }
}

criterion_group!(benches, frames);
criterion_main!(benches);
