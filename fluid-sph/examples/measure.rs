//! Scratch.
#![allow(clippy::unwrap_used)]
#[path = "../tests/common/mod.rs"]
mod common;
use common::{GRAVITY, march, pool};
use explicit_dynamics::{Clock, Dynamics};
use fluid_sph::*;
use sph_core::Vec3;

fn still(n: usize, aspect: f64, form: Formulation, c: f64) {
    let dx = 1.0 / n as f64;
    let mut parts = pool(2, [aspect, 1.0, 0.0], [aspect, 1.2, 0.0], dx);
    parts.formulation = form;
    parts.liquid.sound_speed = c * (GRAVITY).sqrt();
    let mut f = Fluid::new(parts).unwrap();
    let until = 10.0 / GRAVITY.sqrt();
    let e0 = f.energies();
    let (mut kin_max, mut kin_sum, mut k) = (0.0f64, 0.0, 0.0);
    let mut w0 = 0.0;
    let (mut sq, mut mx, mut cnt, mut bias, mut nb) = (0.0, 0.0f64, 0.0, 0.0, 0.0);
    let mut s = 0;
    let mut win = [(0.0f64, 0.0f64, 0.0f64, 0.0f64); 10];
    let clock = march(&mut f, until, |c, f| {
        s += 1;
        if c.now.time > 0.1 * until {
            kin_max = kin_max.max(c.kinetic);
            kin_sum += c.kinetic;
            k += 1.0;
            if s % 97 == 0 {
                for (p, q) in f.positions().iter().zip(f.pressures()) {
                    if p.y < 0.9 {
                        let e = (q / (1000.0 * GRAVITY) - (1.0 - p.y)).abs();
                        sq += e * e;
                        if e > mx {
                            println!(
                                "   max {e:.4} at t {:.3} of {until:.3} ({:.3} {:.3})",
                                c.now.time, p.x, p.y
                            );
                        }
                        mx = mx.max(e);
                        cnt += 1.0;
                        if (p.y - 0.3).abs() < 0.05 {
                            bias += q / (1000.0 * GRAVITY) - (1.0 - p.y);
                            nb += 1.0;
                        }
                    }
                }
            }
        }
        w0 = 0.0;
    });
    let _ = w0;
    for w in win {
        println!(
            "   window rms {:.4} max {:.4} kin {:.2e}",
            (w.0 / w.1).sqrt(),
            w.2,
            w.3 / (1000.0 * GRAVITY * aspect / 2.0)
        );
    }
    let scale = 1000.0 * GRAVITY * aspect / 2.0;
    let e1 = f.energies();
    println!(
        "still n {n} {:?} rms {:.4} max {:.4} bias/dx {:.3} kin mean {:.2e} max {:.2e} steps {} err {:.4}",
        form.walls,
        (sq / cnt).sqrt(),
        mx,
        bias / nb * n as f64,
        kin_sum / k / scale,
        kin_max / scale,
        clock.steps,
        f.greatest_density_error()
    );
    let tot = |e: &Energies| e.kinetic + e.compression + e.potential + e.viscous + e.diffusion;
    println!(
        "   energy residual / scale {:.2e} {:?} {:?}  floor force {:?} (exact {})",
        (tot(&e1) - tot(&e0)) / scale,
        e0,
        e1,
        f.wall_force(0),
        -1000.0 * GRAVITY * aspect
    );
    let gauge = f.pressure_at(Vec3::new(0.5 * aspect, 0.0, 0.0)).unwrap();
    println!(
        "   floor gauge {:.4} level {:.4} surface particles {}",
        gauge / 1000.0 / GRAVITY,
        f.level_at(Vec3::new(0.5 * aspect, 0.0, 0.0)),
        f.free_surface().iter().filter(|x| **x).count()
    );
}

fn dam(n: usize, form: Formulation) {
    // L = 1, H = 2, dx = 1/n; basin 5 long.
    let dx = 1.0 / n as f64;
    let mut parts = pool(2, [1.0, 2.0, 0.0], [6.0, 4.0, 0.0], dx);
    parts.formulation = form;
    parts.start = Start::Hydrostatic;
    let mut f = Fluid::new(parts).unwrap();
    let mut clock = Clock::start(&mut f, 1.0, 1.0, 0.0).unwrap();
    let e0 = f.energies();
    let tot = |e: &Energies| e.kinetic + e.compression + e.potential + e.viscous + e.diffusion;
    for t in [1.0, 1.5, 2.0, 2.5, 3.0, 3.2] {
        // T = t sqrt(2 g / L)... n² = H/L = 2: T = n t sqrt(g / L)
        let until = t / (2.0 * GRAVITY).sqrt();
        while clock.now.time < until - 1e-9 {
            let left = until - clock.now.time;
            clock.step(&mut f, left, |_| 1.0).unwrap();
        }
        let z = f.positions().iter().map(|p| p.x).fold(0.0, f64::max) + 0.5 * dx;
        let e = f.energies();
        println!(
            "dam {:?} {:?} T {t} Z {z:.3} steps {} err {:.4} visc {:.3} diff {:.4} residual/released {:.4} of E0 {:.4}",
            form.scheme,
            form.walls,
            clock.steps,
            f.greatest_density_error(),
            e.viscous / e0.potential,
            e.diffusion / e0.potential,
            (tot(&e) - tot(&e0)) / (e0.potential - e.potential),
            (tot(&e) - tot(&e0)) / e0.potential
        );
    }
    f.within_bounds(explicit_dynamics::Bounds::Motion).unwrap();
}

fn main() {
    let what = std::env::args().nth(1).unwrap_or_default();
    let t = std::time::Instant::now();
    match what.as_str() {
        "still" => still(50, 0.4, Formulation::default(), 20.0),
        "still1" => still(50, 1.0, Formulation::default(), 20.0),
        "still10" => still(50, 0.4, Formulation::default(), 10.0),
        "still-dyn" => {
            still(50, 0.4, Formulation { walls: WallRule::Dynamic, ..Formulation::default() }, 20.0)
        }
        "still-pc" => {
            still(50, 0.4, Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() }, 20.0)
        }
        "dam" => dam(25, Formulation::default()),
        "dam50" => dam(50, Formulation::default()),
        "dam-pub" => dam(25, Formulation::published()),
        "dam-pc" => dam(25, Formulation { scheme: Scheme::PredictorCorrector, ..Formulation::default() }),
        _ => {}
    }
    println!("{:?}", t.elapsed());
}
