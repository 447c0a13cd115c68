#[path = "../tests/bodies/mod.rs"]
mod bodies;
use bodies::*;
use implicit_statics::{Newton, NewtonOptions};
use sr_galerkin::lead;
fn main() {
    let search = std::env::args().any(|a| a == "search");
    let consistent = std::env::args().any(|a| a == "consistent");
    let mut parts = cantilever(21, 10.0, On::Top);
    if consistent { parts.tangent = solid_kinematics::Tangent::Consistent; }
    let mut b = body(parts);
    let options = NewtonOptions { tolerance: 1e-8, iterations: 30, line_search: search };
    let mut newton = Newton::new(&b, &options).unwrap();
    let mut sum = 0;
    let order: usize = std::env::var("ORDER").map_or(0, |k| k.parse().unwrap());
    let fresh = std::env::var("FRESH").is_ok();
    let n3 = 3 * b.nodes();
    let mut past: Vec<Vec<f64>> = vec![vec![0.0; n3]];
    for k in 0..10 {
        use implicit_statics::Equilibrium;
        let c: &[f64] = match order.min(past.len() - 1) { 0 => &[1.0], 1 => &[2.0, -1.0], 2 => &[3.0, -3.0, 1.0], _ => &[4.0, -6.0, 4.0, -1.0] };
        let mut s = b.save();
        for i in 0..n3 { s[i] = c.iter().enumerate().map(|(j, c)| c * past[past.len() - 1 - j][i]).sum(); }
        b.restore(&s);
        if fresh && c.len() > 1 { newton = Newton::new(&b, &options).unwrap(); }
        lead(&mut b, &mut newton, (k as f64, k as f64 + 1.0), |s, _| {
            sum += s.converged.iterations;
            println!("{} its {} bound {:.1e}: {:?}", s.converged.level, s.converged.iterations, s.converged.bound, s.converged.residuals.iter().map(|r| format!("{r:.1e}")).collect::<Vec<_>>());
        }).unwrap();
        past.push(b.save()[..n3].to_vec());
    }
    println!("{sum} iterations, tip {:.6}", tip(&b));
}
