//! Pages of a hundred thousand particles in forty frames, a shell and a fluid: `cargo run --release -p viewer --example large_page`.
//!
//! Prints how large each page is and how fast it is made, and leaves it in the present folder, to be opened.

use std::error::Error;
use std::fs;
use std::time::Instant;

use mesh_io::{Array, Sheet};
use viewer::{Body, Show, page};

const FRAMES: usize = 40;

fn array(width: usize, numbers: Vec<f64>) -> Array {
    Array { components: Vec::new(), unit: Some("m".into()), width, numbers }
}

fn places([along, across]: [usize; 2]) -> impl Iterator<Item = (f64, f64)> {
    (0..along * across).map(move |i| ((i % along) as f64 / along as f64, (i / along) as f64 / across as f64))
}

fn sheet(
    size: [usize; 2],
    motion: impl Fn(f64, f64) -> [f64; 3],
    field: impl Fn(usize, f64, f64) -> f64,
    cells: Vec<Vec<usize>>,
) -> Sheet {
    let moved: Vec<[f64; 3]> = places(size).map(|(x, y)| motion(x, y)).collect();
    let points = places(size).zip(&moved).map(|((x, y), u)| [x + u[0], y + u[1], u[2]]).collect();
    let values = places(size).enumerate().map(|(i, (x, y))| f64::from(field(i, x, y) as f32)).collect();
    let data = [
        ("displacement".to_string(), array(3, moved.into_iter().flatten().collect())),
        ("pressure".into(), array(1, values)),
        ("thickness".into(), array(1, vec![1e-3; size[0] * size[1]])),
    ];
    Sheet { points, cells, point_data: data.into(), ..Sheet::default() }
}

/// A plate in ever larger waves.
fn shell(size: [usize; 2], frame: usize) -> Sheet {
    let [along, across] = size;
    let t = frame as f64 / FRAMES as f64;
    let at = |i: usize, j: usize| i + along * j;
    let cells = (0..across - 1).flat_map(move |j| {
        (0..along - 1).map(move |i| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    });
    let wave = move |x: f64, y: f64| t * 0.2 * libm::sin(9.0 * x + 3.0 * t) * libm::cos(5.0 * y);
    sheet(
        size,
        move |x, y| [-0.1 * t * x, 0.0, wave(x, y)],
        move |_, x, y| 1e6 * wave(x, y).powi(2),
        cells.collect(),
    )
}

/// A swirl with the noise of particles that push each other.
fn fluid(size: [usize; 2], frame: usize) -> Sheet {
    let [along, across] = size;
    let t = 3.0 * frame as f64 / FRAMES as f64;
    let noise = move |i: usize, k: u32| {
        let mut h = (i as u32 ^ (frame as u32) << 20)
            .wrapping_mul(2_654_435_761)
            .wrapping_add(k.wrapping_mul(40_503));
        h = (h ^ (h >> 15)).wrapping_mul(2_246_822_519);
        f64::from(h ^ (h >> 13)) / f64::from(u32::MAX) - 0.5
    };
    let motion = move |x: f64, y: f64| {
        let i = (x * along as f64) as usize + along * (y * across as f64) as usize;
        let r = ((x - 0.5).powi(2) + (y - 0.5).powi(2)).sqrt();
        let (s, c) = libm::sincos(t * (1.0 - r));
        let (u, v) = (x - 0.5, y - 0.5);
        [c * u - s * v - u + 1e-3 * noise(i, 1), s * u + c * v - v + 1e-3 * noise(i, 2), 0.0]
    };
    let pressure = move |i: usize, _: f64, y: f64| 1e4 * (1.0 - y) * (1.0 + 0.02 * noise(i, 3));
    let mut sheet = sheet(size, motion, pressure, (0..along * across).map(move |i| vec![i]).collect());
    sheet.point_data.remove("thickness");
    sheet.point_data.insert("area".into(), array(1, vec![1e-5; along * across]));
    sheet
}

/// What is shown of a shell or a fluid of so many particles along x and y.
pub fn shown(name: &str, size: [usize; 2]) -> Result<Show, Box<dyn Error>> {
    let make = |frame: usize| if name == "shell" { shell(size, frame) } else { fluid(size, frame) };
    let mut body = Body::new(name, &make(0));
    for frame in 0..FRAMES {
        body.add(&make(frame))?;
    }
    let frames = vec![Default::default(); FRAMES];
    Ok(Show {
        title: name.into(),
        frames,
        bodies: vec![body],
        wanted: vec!["pressure".into()],
        ..Show::default()
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    for name in ["shell", "fluid"] {
        for threads in [1, 2] {
            let (show, start) = (shown(name, [400, 250])?, Instant::now());
            let html = page(show, 1 << 30, threads)?.html;
            let (spent, size) = (start.elapsed().as_secs_f64(), html.len() as f64 / 1e6);
            // Displacement, field, thickness or area in single precision.
            let raw = (400 * 250 * FRAMES * 5 * 4) as f64 / 1e6;
            println!("{name}, {threads} threads: {size:.1} MB, {raw:.0} MB of numbers in {spent:.2} s");
            fs::write(format!("{name}.html"), &html)?;
        }
    }
    Ok(())
}
