//! Nanoseconds a number: a plain sum, in chunks and then exact, each exact; taking the value, merging, a sum of peers.
//!
//! `cargo bench -p peers` prints the least of many windows, measured in turn: a machine that others use too only ever adds to them.

use std::hint::black_box;
use std::time::Instant;

use peers::{Exact, Peers, together};

/// Numbers of a window: 80 kB, in the cache.
const COUNT: usize = 10_000;
const WINDOWS: usize = 400;

/// Something to measure: how many things a window does, and the window.
type Measured<'a> = (&'a str, usize, Box<dyn FnMut() + 'a>);

/// How long one thing takes \[ns\].
fn time(many: usize, window: &mut dyn FnMut()) -> f64 {
    let start = Instant::now();
    window();
    start.elapsed().as_secs_f64() * 1e9 / many as f64
}

fn line(what: &str, time: f64) {
    println!("{what:<40} {time:>9.2} ns");
}

/// SplitMix64 of \[steele2014\], in [−1, 1).
fn numbers() -> Vec<f64> {
    let mut state = 0_u64;
    let mut next = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 * 2_f64.powi(-52) - 1.0
    };
    (0..COUNT).map(|_| next()).collect()
}

fn main() {
    let values = numbers();
    // Of many sizes, so that digits change from one to the next.
    let spread: Vec<f64> = (0..).zip(&values).map(|(i, x)| x * 2_f64.powi(37 * i % 1800 - 900)).collect();
    let each = |sum: &mut Exact, values: &[f64]| black_box(values).iter().for_each(|&x| sum.add(x));
    let mut filled = Exact::new();
    each(&mut filled, &spread);
    let [mut chunks, mut alike, mut any, mut merged, mut settled] = [(); 5].map(|()| filled.clone());
    let mut measured: Vec<Measured> = vec![
        ("plain sum, a number", COUNT, Box::new(|| _ = black_box(black_box(&values).iter().sum::<f64>()))),
        (
            "chunks, then exact, a number",
            COUNT,
            Box::new(|| chunks.add_in_chunks(black_box(&values).iter().copied())),
        ),
        ("exact, a number, all of one size", COUNT, Box::new(|| each(&mut alike, &values))),
        ("exact, a number, of all sizes", COUNT, Box::new(|| each(&mut any, &spread))),
        ("value", 100, Box::new(|| (0..100).for_each(|_| _ = black_box(black_box(&filled).value())))),
        ("merge", 100, Box::new(|| (0..100).for_each(|_| black_box(&mut merged).merge(black_box(&filled))))),
        (
            "words, carries passed on",
            100,
            Box::new(|| {
                (0..100).for_each(|_| _ = black_box(black_box(&mut settled).words_mut()[0]));
            }),
        ),
    ];
    // In turn, so that all meet the same disturbances.
    let mut least = vec![f64::INFINITY; measured.len()];
    for _ in 0..WINDOWS {
        for (least, (_, many, window)) in least.iter_mut().zip(&mut measured) {
            *least = least.min(time(*many, window));
        }
    }
    measured.iter().zip(least).for_each(|((what, ..), least)| line(what, least));
    let step = |mut peers: Box<dyn Peers>| {
        let mut sums = [Exact::new(), Exact::new()];
        let mut window = || (0..100).for_each(|_| peers.add(&mut sums, &mut []));
        (0..WINDOWS).map(|_| time(100, &mut window)).fold(f64::INFINITY, f64::min)
    };
    if let Ok(times) = together(2, step) {
        line("add two sums, two threads as peers", times[0]);
    }
}
