//! How long operators take to build: `cargo run --release -p sph-core --example build_times [ROW]` (ROW² particles).

use std::time::Instant;

use sph_core::*;

fn main() -> Result<(), SpaceError> {
    let row = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(317);
    let dome = Sphere { radius: 10.0, polar: [0.4, 1.5], azimuth: [0.0, 1.5] };
    let cloud = timed("jittered lattice", || jittered_lattice(&dome, [row, row], 0.25, 1))?;
    println!("{} particles", cloud.len());
    timed("cell operator", || cell_operator(&cloud))?;
    timed("kernel operator, reach 1.8", || kernel_operator(&cloud, &CubicSpline, 1.8))?;
    for order in 1..=3 {
        timed(&format!("nodal operator, order {order}"), || {
            nodal_operator(&cloud, &CubicSpline, order, 1.3)
        })?;
    }
    for n in [11, 21, 41] {
        let flat = jittered_lattice(&Plate { lengths: [1.0, 1.0] }, [n, n], 0.25, 1)?;
        let mut operator = kernel_operator(&flat, &CubicSpline, 1.8)?;
        let report =
            timed(&format!("consistency, {n}²"), || make_divergence_consistent(&mut operator, &flat, &[1]))?;
        println!("    {report:?}");
    }
    Ok(())
}

/// Runs `build` and prints its wall time.
fn timed<T>(what: &str, build: impl FnOnce() -> Result<T, SpaceError>) -> Result<T, SpaceError> {
    let start = Instant::now();
    let built = build()?;
    println!("{what}: {:.3} s", start.elapsed().as_secs_f64());
    Ok(built)
}
