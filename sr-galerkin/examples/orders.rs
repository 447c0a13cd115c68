#[path = "../tests/bodies/mod.rs"]
mod bodies;
use bodies::*;
use implicit_statics::{Equilibrium, SymmetricSolver};
use sph_core::{Basis, Support};
fn show(name: &str, b: &Galerkin2) {
    let p = b.pattern();
    let t = std::time::Instant::now();
    let s = SymmetricSolver::placed(b.unknowns(), &p, b.places().as_deref()).unwrap();
    println!("{name}: {} unknowns {} pattern; placed {} entries {:.3e} mult {:?}", b.unknowns(), p.len(), s.factor_entries(), s.multiplications(), t.elapsed());
    if b.unknowns() < 20000 {
        let t = std::time::Instant::now();
        let s = SymmetricSolver::new(b.unknowns(), &p).unwrap();
        println!("   amd {} entries {:.3e} mult {:?}", s.factor_entries(), s.multiplications(), t.elapsed());
    }
}
type Galerkin2 = sr_galerkin::Galerkin;
fn main() {
    show("cantilever", &body(cantilever(21, 10.0, On::Top)));
    for (n, basis, r) in [([41, 8, 8], Basis::Linear, 1.8), ([14, 14, 14], Basis::Linear, 1.8), ([41, 8, 8], Basis::Quadratic, 2.5), ([81, 16, 16], Basis::Linear, 1.8)] {
        let t = std::time::Instant::now();
        let mut parts = block(n.map(|n| n as f64 - 1.0), n, 0.0);
        parts.basis = basis; parts.support = Support::sphere(r); parts.rule = 2;
        parts.conditions.extend(sr_galerkin::Condition::fixed(&nodes(&parts, |x| x.x == 0.0)));
        let b = body(parts);
        println!("built {:?}", t.elapsed());
        show(&format!("{n:?} {basis:?}"), &b);
    }
}
