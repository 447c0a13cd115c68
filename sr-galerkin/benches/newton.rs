//! What one Newton iteration and a whole curve of the cantilever (21×3×3 nodes, quadratic) cost; with `large` a linear answer of 20 000
//! nodes: `cargo bench -p sr-galerkin --bench newton -- [threads] [large]`.

#[path = "../tests/bodies/mod.rs"]
mod bodies;

use std::time::Instant;

use bodies::{On, body, cantilever, curve, tip};
use implicit_statics::{Equilibrium, SymmetricSolver, linear_response};
use solid_kinematics::Moduli;
use sph_core::{Basis, Support, Vec3};
use sr_galerkin::{Condition, Galerkin, Load};

/// Trials of each.
const TRIALS: usize = 100;

/// Seconds that the processor has given this thread, as Linux tells: others on the machine hardly count.
fn processor() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux");
    let first = text.split(' ').next().and_then(|nanoseconds| nanoseconds.parse::<f64>().ok());
    1e-9 * first.expect("nanoseconds")
}

/// Mean of many trials: the system counts in steps of some milliseconds.
fn mean(name: &str, mut work: impl FnMut()) {
    let start = processor();
    (0..TRIALS).for_each(|_| work());
    println!("{name:12} {:8.3} ms", 1e3 * (processor() - start) / TRIALS as f64);
}

fn iteration(body: &mut Galerkin) {
    let (n, pattern) = (body.unknowns(), body.pattern());
    println!("{} nodes, {} points, {n} unknowns, {} entries", body.nodes(), body.points(), pattern.len());
    let (mut values, mut forces, zero) = (vec![0.0; pattern.len()], vec![0.0; n], vec![0.0; n]);
    let mut solver = SymmetricSolver::placed(n, &pattern, body.places().as_deref()).expect("a pattern");
    mean("forces", || {
        body.update(&zero); // points are evaluated anew
        body.internal(0.0, &mut forces);
    });
    mean("stiffness", || body.tangent(0.0, &mut values));
    mean("factor", || {
        solver.factor(&values).expect("finite");
    });
    body.external(1.0, &mut forces);
    mean("solve", || solver.solve(&mut forces.clone()).expect("regular"));
}

/// A clamped block of 81×16×16 nodes, linear basis on balls of 1.8 spacings, under its weight.
fn large(threads: usize) {
    let start = Instant::now();
    let lengths = [80.0, 15.0, 15.0];
    let mut parts = bodies::block(lengths, [81, 16, 16], 0.0);
    parts.basis = Basis::Linear;
    parts.support = Support::sphere(1.8);
    parts.rule = 2;
    parts.threads = threads;
    parts.material.moduli = Moduli::isotropic(1.0, 0.2).expect("moduli");
    parts.conditions.extend(Condition::fixed(&bodies::nodes(&parts, |x| x.x == 0.0)));
    parts.loads.push(Load::Body(Vec3::new(0.0, 0.0, -1e-9)));
    let mut body = body(parts);
    println!("built in {:?}: {} nodes, {} entries", start.elapsed(), body.nodes(), body.pattern().len());
    let start = Instant::now();
    let solver = SymmetricSolver::placed(body.unknowns(), &body.pattern(), body.places().as_deref()).expect("a pattern");
    println!("analysis {:?}: {} entries, {:.2e} mult", start.elapsed(), solver.factor_entries(), solver.multiplications());
    drop(solver);
    let start = Instant::now();
    let answer = linear_response(&mut body, 0.0).expect("an answer");
    body.update(&answer);
    let mut forces = vec![0.0; answer.len()];
    body.internal(0.0, &mut forces);
    let end = body.nodes() - 1;
    // a cantilever of Bernoulli's: q L⁴/(8 E I), with shear 2 (1 + ν) (h/L)² more or less
    let beam = 1e-9 * 225.0 * 80.0_f64.powi(4) / (8.0 * 15.0_f64.powi(4) / 12.0);
    println!(
        "{} unknowns in {:?}; end over a beam's {:.4}",
        answer.len(),
        start.elapsed(),
        -body.displacement(end).z / beam
    );
    println!("{}", std::fs::read_to_string("/proc/self/status").unwrap().lines().find(|l| l.starts_with("VmHWM")).unwrap());
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let threads = arguments.iter().find_map(|text| text.parse().ok()).unwrap_or(1);
    if arguments.iter().any(|text| text == "large") {
        return large(threads);
    }
    let with = || {
        let mut parts = cantilever(21, 10.0, On::Top);
        parts.threads = threads;
        body(parts)
    };
    iteration(&mut with());
    let start = processor();
    let levels: Vec<f64> = (1..=10).map(f64::from).collect();
    let (values, steps) = curve(&mut with(), &levels, tip);
    let iterations: usize = steps.iter().map(|step| step.converged.iterations).sum();
    let time = processor() - start;
    println!("curve in {time:.3} s, {iterations} iterations, K = 10: {:.5}", values[9]);
}
