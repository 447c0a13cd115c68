//! What one Newton iteration and a whole curve of the cantilever (21×3×3 nodes, quadratic) cost; with `large` the time and the memory of a
//! linear answer of 20 736 nodes: `cargo bench -p sr-galerkin --bench newton -- [threads] [large]`. Times are of the processor; with
//! several threads those of the first. Linux alone tells them.

#[path = "../tests/bodies/mod.rs"]
mod bodies;

use bodies::{On, body, cantilever, curve, tip};
use implicit_statics::{Equilibrium, SymmetricSolver};
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
    let mut solver = SymmetricSolver::placed(n, &pattern, body.coordinates().as_deref()).expect("a pattern");
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

/// A clamped block of 81×16×16 nodes, linear basis on balls of 1.8 spacings, under its weight: one linear answer.
fn large(threads: usize) {
    let begin = processor();
    let lap = |name: &str, since: f64| println!("{name:12} {:8.2} s", processor() - since);
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
    lap("body", begin);
    let (n, start) = (body.unknowns(), processor());
    let pattern = body.pattern();
    let mut solver = SymmetricSolver::placed(n, &pattern, body.coordinates().as_deref()).expect("a pattern");
    lap("analysis", start);
    let (mut values, start) = (vec![0.0; pattern.len()], processor());
    drop(pattern);
    body.tangent(0.0, &mut values);
    lap("stiffness", start);
    let start = processor();
    solver.factor(&values).expect("finite");
    lap("factor", start);
    let (mut answer, start) = (vec![0.0; n], processor());
    body.load_rate(0.0, &mut answer);
    solver.solve(&mut answer).expect("regular");
    lap("solve", start);
    lap("all", begin);
    body.update(&answer);
    body.internal(0.0, &mut answer); // held parameters follow
    let end = body.nodes() - 1;
    // Bernoulli's cantilever: q L⁴/(8 E I)
    let beam = 1e-9 * 225.0 * 80.0_f64.powi(4) / (8.0 * 15.0_f64.powi(4) / 12.0);
    println!(
        "{} nodes, {n} unknowns, {} entries, {} of the factor, {:.2e} multiplications",
        body.nodes(),
        values.len(),
        solver.factor_entries(),
        solver.multiplications()
    );
    println!("end over Bernoulli's {:.4}", -body.displacement(end).z / beam);
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux");
    println!("peak memory: {}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default());
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
