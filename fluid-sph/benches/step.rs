//! Whole steps in disordered water, sorting included: time of one core and memory a particle, and what two cores gain.
//!
//! `cargo bench -p fluid-sph --bench step -- [NAME | two]`. Times of one thread are those of the processor, so that other
//! work on the machine counts little; those of two threads are of the wall and hold on a quiet machine only. Beside them stands how long a
//! line of memory takes from one core to the other and back: virtual cores that share a cache have it there in tens of nanoseconds, others in
//! hundreds, and a host may move them from one minute to the next.

mod waters;

use std::sync::atomic::{AtomicU64, Ordering::Acquire, Ordering::Release};
use std::time::Instant;

use explicit_dynamics::Clock;
use fluid_sph::{Fluid, Scheme};
use waters::{Water, steps, thread_seconds};

const KICK: Scheme = Scheme::KickDriftKick;
const WATERS: [Water; 5] = [
    Water::new("plane-1e4", 2, 100, KICK),
    Water::new("plane-1e5", 2, 316, KICK),
    Water::new("plane-1e6", 2, 1000, KICK),
    Water::new("space-1e5", 3, 46, KICK),
    Water::new("plane-1e4-predicted", 2, 100, Scheme::PredictorCorrector),
];
/// Particle-steps of one measurement, about.
const WORK: usize = 1_000_000;
/// Ways there and back of a line of memory.
const TRIPS: u64 = 500_000;
/// Measurements, of which the median counts.
const ROUNDS: usize = 5;

fn main() {
    let wanted = std::env::args().skip(1).find(|argument| !argument.starts_with("--")).unwrap_or_default();
    for water in WATERS.iter().filter(|water| water.name.contains(&wanted)) {
        let (mut fluid, mut clock) = water.fluid(1);
        let one = 1e-6 / median(&mut fluid, &mut clock, thread_seconds);
        let bytes = fluid.bytes_per_particle();
        println!(
            "{}: {one:.2} million particle-steps a second of one core, {bytes} bytes a particle",
            water.name
        );
    }
    for water in WATERS.iter().filter(|_| wanted == "two") {
        let (one, before) = (wall(water, 1), round_trip());
        let two = wall(water, 2);
        println!(
            "{}: two threads are {:.2} times as fast as one; a line of memory there and back: {before:.0} ns, {:.0} ns after",
            water.name,
            one / two,
            round_trip()
        );
    }
}

/// Time that a line of memory takes from one thread to another and back \[ns\].
fn round_trip() -> f64 {
    static LINE: AtomicU64 = AtomicU64::new(0);
    LINE.store(0, Release);
    let turn = |mine: u64| {
        for k in 0..TRIPS {
            while LINE.load(Acquire) != 2 * k + mine {
                std::hint::spin_loop();
            }
            LINE.store(2 * k + mine + 1, Release);
        }
    };
    let start = Instant::now();
    std::thread::scope(|threads| {
        threads.spawn(|| turn(1));
        turn(0);
    });
    1e9 * start.elapsed().as_secs_f64() / TRIPS as f64
}

/// Time of the wall for a particle-step \[s\].
fn wall(water: &Water, threads: usize) -> f64 {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
    pool.install(|| {
        let (mut fluid, mut clock) = water.fluid(threads);
        let start = Instant::now();
        median(&mut fluid, &mut clock, || start.elapsed().as_secs_f64())
    })
}

/// Median time of a particle-step \[s\] by a clock.
fn median(fluid: &mut Fluid, clock: &mut Clock, seconds: impl Fn() -> f64) -> f64 {
    let count = (WORK / fluid.len()).max(2);
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let before = seconds();
            steps(fluid, clock, count);
            (seconds() - before) / (count * fluid.len()) as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}
