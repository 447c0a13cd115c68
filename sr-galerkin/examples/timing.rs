//! timing
#[path = "../tests/bodies/mod.rs"]
mod bodies;
use implicit_statics::{Equilibrium, SymmetricSolver};
use std::time::Instant;
fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    s.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
#[allow(clippy::unwrap_used, unused_variables)]
fn main() {
    let threads: usize = std::env::args().nth(1).map_or(1, |s| s.parse().unwrap());
    let mut parts = bodies::cantilever(21, 10.0, bodies::On::Top);
    parts.threads = threads;
    let t = Instant::now();
    let mut b = bodies::body(parts);
    println!("build {:?}", t.elapsed());
    let pattern = b.pattern();
    let mut values = vec![0.0; pattern.len()];
    let n = b.unknowns();
    println!("unknowns {n} entries {}", pattern.len());
    let mut solver = SymmetricSolver::new(n, &pattern).unwrap();
    let mut out = vec![0.0; n];
    let reps = 20;
    let best = |name: &str, f: &mut dyn FnMut()| {
        let mut best = f64::INFINITY;
        for _ in 0..reps {
            let t = Instant::now();
            f();
            best = best.min(t.elapsed().as_secs_f64());
        }
        println!("{name}: {:.3} ms", best * 1e3);
    };
    let zero = vec![0.0; n];
    best("internal", &mut || {
        b.update(&zero);
        b.internal(0.0, &mut out);
    });
    best("external", &mut || {
        b.external(1.0, &mut out);
    });
    best("tangent", &mut || {
        b.tangent(0.0, &mut values);
    });
    best("factor", &mut || {
        solver.factor(&values).unwrap();
    });
    b.external(1.0, &mut out);
    best("solve", &mut || {
        let mut x = out.clone();
        solver.solve(&mut x).unwrap();
    });
    best("save", &mut || {
        let s = b.save();
        b.restore(&s);
    });
    let c = cpu();
    if std::env::args().nth(2).is_some() {
        let t = Instant::now();
        let mut parts = bodies::cantilever(21, 10.0, bodies::On::Top);
        parts.threads = threads;
        let mut b = bodies::body(parts);
        let (v, st) =
            bodies::curve(&mut b, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0], bodies::tip);
        println!(
            "curve {:?} {} {:?}",
            t.elapsed(),
            v[9],
            st.iter().map(|s| s.converged.iterations).collect::<Vec<_>>()
        );
    }
}
