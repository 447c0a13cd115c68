//! What pages of a hundred thousand particles take: `cargo test -p viewer --test marks -- --ignored --nocapture`.
//!
//! Ignored, for it takes seconds and a gigabyte: it prints how fast a page is made, and holds how large it gets. The pages
//! stay in the folder of the tests, to be opened.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::Path;
use std::time::Instant;

use mesh_io::{Array, Sheet};
use viewer::{Body, Show};

const FRAMES: usize = 40;
/// Points along x and y: a hundred thousand in all.
const ALONG: usize = 400;
const ACROSS: usize = 250;

fn array(width: usize, numbers: Vec<f64>) -> Array {
    Array { components: Vec::new(), unit: Some("m".into()), width, numbers }
}

fn places() -> impl Iterator<Item = (f64, f64)> {
    (0..ALONG * ACROSS).map(|i| ((i % ALONG) as f64 / ALONG as f64, (i / ALONG) as f64 / ACROSS as f64))
}

fn sheet(
    motion: impl Fn(f64, f64) -> [f64; 3],
    field: impl Fn(usize, f64, f64) -> f64,
    cells: Vec<Vec<usize>>,
) -> Sheet {
    let moved: Vec<[f64; 3]> = places().map(|(x, y)| motion(x, y)).collect();
    let points = places().zip(&moved).map(|((x, y), u)| [x + u[0], y + u[1], u[2]]).collect();
    let values = places().enumerate().map(|(i, (x, y))| f64::from(field(i, x, y) as f32)).collect();
    let data = [
        ("displacement".to_string(), array(3, moved.into_iter().flatten().collect())),
        ("pressure".into(), array(1, values)),
        ("thickness".into(), array(1, vec![1e-3; ALONG * ACROSS])),
    ];
    Sheet { points, cells, point_data: data.into(), ..Sheet::default() }
}

/// A plate in ever larger waves.
fn shell(frame: usize) -> Sheet {
    let t = frame as f64 / FRAMES as f64;
    let at = |i: usize, j: usize| i + ALONG * j;
    let cells = (0..ACROSS - 1).flat_map(|j| {
        (0..ALONG - 1).map(move |i| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    });
    let wave = move |x: f64, y: f64| t * 0.2 * (9.0 * x + 3.0 * t).sin() * (5.0 * y).cos();
    sheet(
        move |x, y| [-0.1 * t * x, 0.0, wave(x, y)],
        move |_, x, y| 1e6 * wave(x, y).powi(2),
        cells.collect(),
    )
}

/// A swirl with the noise of particles that push each other.
fn fluid(frame: usize) -> Sheet {
    let t = 3.0 * frame as f64 / FRAMES as f64;
    let noise = move |i: usize, k: u32| {
        let mut h = (i as u32 ^ (frame as u32) << 20)
            .wrapping_mul(2_654_435_761)
            .wrapping_add(k.wrapping_mul(40_503));
        h = (h ^ (h >> 15)).wrapping_mul(2_246_822_519);
        f64::from(h ^ (h >> 13)) / f64::from(u32::MAX) - 0.5
    };
    let motion = move |x: f64, y: f64| {
        let i = (x * ALONG as f64) as usize + ALONG * (y * ACROSS as f64) as usize;
        let r = ((x - 0.5).powi(2) + (y - 0.5).powi(2)).sqrt();
        let (s, c) = (t * (1.0 - r)).sin_cos();
        let (u, v) = (x - 0.5, y - 0.5);
        [c * u - s * v - u + 1e-3 * noise(i, 1), s * u + c * v - v + 1e-3 * noise(i, 2), 0.0]
    };
    let pressure = move |i: usize, _: f64, y: f64| 1e4 * (1.0 - y) * (1.0 + 0.02 * noise(i, 3));
    let mut sheet = sheet(motion, pressure, (0..ALONG * ACROSS).map(|i| vec![i]).collect());
    sheet.point_data.remove("thickness");
    sheet.point_data.insert("area".into(), array(1, vec![1e-5; ALONG * ACROSS]));
    sheet
}

#[test]
#[ignore = "takes a gigabyte"]
fn a_hundred_thousand_particles_in_forty_frames_take_thirty_megabytes() {
    for (name, make) in [("shell", shell as fn(usize) -> Sheet), ("fluid", fluid)] {
        let mut body = Body::new(name, &make(0));
        (0..FRAMES).for_each(|frame| body.add(&make(frame)).unwrap());
        let frames = vec![Default::default(); FRAMES];
        let show = Show {
            title: name.into(),
            frames,
            bodies: vec![body],
            wanted: vec!["pressure".into()],
            ..Show::default()
        };
        for threads in [1, 2] {
            let (show, start) = (show.clone(), Instant::now());
            let page = show.page(1 << 30, threads).unwrap();
            let (spent, size) = (start.elapsed().as_secs_f64(), page.html.len() as f64 / 1e6);
            // Displacement, field, thickness or area in single precision.
            let raw = (ALONG * ACROSS * FRAMES * 5 * 4) as f64 / 1e6;
            println!(
                "{name}, {threads} threads: {size:.1} MB, {raw:.0} MB of numbers in {spent:.2} s: {:.0} MB/s",
                raw / spent
            );
            let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.html"));
            fs::write(path, &page.html).unwrap();
            assert!(size <= 30.0, "{size} MB");
        }
    }
}
