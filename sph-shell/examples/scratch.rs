//! scratch
use explicit_dynamics::*;
use shell_kinematics::*;
use sph_core::*;
use sph_shell::*;
use std::ops::ControlFlow;
struct Tip(usize, f64, f64);
impl Observer<Shell> for Tip {
    fn record(&mut self, s: &mut Shell, r: &Record) -> ControlFlow<()> {
        let u = s.displacement(self.0);
        let th = std::f64::consts::TAU * r.at.level;
        let (ex, ez) = if th > 0.0 { (self.1 * (th.sin() / th - 1.0), self.1 * (1.0 - th.cos()) / th) } else { (0.0, 0.0) };
        println!("level {:.3} u {:.4} {:.4} {:.4} exact {:.4} {:.4} err {:.3} % steps {} settled {} bal {:.2e} U {:.4} W {:.4}", r.at.level, u.x, u.y, u.z, ex, ez,
            100.0 * ((u.x - ex).powi(2) + (u.z - ez).powi(2)).sqrt() / self.1, r.step, r.settled, r.balance_error, r.energy.internal, r.energy.external);
        let _ = self.2;
        ControlFlow::Continue(())
    }
}
fn main() {
    let arg: Vec<String> = std::env::args().collect();
    let (n1, n2): (usize, usize) = (arg[2].parse().unwrap(), arg[3].parse().unwrap());
    let form = match arg[1].as_str() {
        "cell" => Formulation::StressPoint(Reach::Cell),
        "n1" => Formulation::Nodal { order: 1, smoothing: 1.2, consistent: false, kernel: &CubicSpline },
        "n2" => Formulation::Nodal { order: 2, smoothing: 1.3, consistent: true, kernel: &CubicSpline },
        "n2p" => Formulation::Nodal { order: 2, smoothing: 1.3, consistent: false, kernel: &CubicSpline },
        "n3" => Formulation::Nodal { order: 3, smoothing: 1.5, consistent: true, kernel: &CubicSpline },
        "n3p" => Formulation::Nodal { order: 3, smoothing: 1.5, consistent: false, kernel: &CubicSpline },
        "sf" => Formulation::StrongForm { smoothing: std::env::var("SM").unwrap().parse().unwrap(), viscosity: std::env::var("VI").unwrap().parse().unwrap(), kernel: &CubicSpline },
        x => Formulation::StressPoint(Reach::Kernel(&CubicSpline, x.parse().unwrap())),
    };
    let weights = if arg[1].starts_with("n3") { EndWeights::Gregory } else { EndWeights::Trapezoid };
    if n1 > 90 && n1 == n2 {
        // speed
        let threads: usize = arg[4].parse().unwrap();
        let cloud = lattice(&Plate { lengths: [1.0, 1.0] }, [n1, n2], weights).unwrap();
        let section = IsotropicSection::new(Isotropic::new(1e6, 0.3).unwrap(), 0.01).unwrap();
        let mut s = Shell::new(Parts { cloud, section: Box::new(section), strain: &StretchCorrected, density: 1.0, formulation: form, supports: vec![], loads: vec![], threads }).unwrap();
        println!("bytes {}", s.bytes_per_particle());
        let mut dice = 1u64;
        for a in 0..s.len() { dice = dice.wrapping_mul(6364136223846793005).wrapping_add(1); s.set_rate(a, Vec3::new((dice >> 40) as f64 * 1e-6, 0.0, 0.1), Vec3::zeros()); }
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut clock = Clock::start(&mut s, 1.0, 0.5, 0.0).unwrap();
        let steps = 4_000_000 / (n1 * n2);
        let mut go = || { for _ in 0..steps { clock.step(&mut s, f64::INFINITY, |_| 1.0).unwrap(); } };
        for _ in 0..5 {
            let t = std::time::Instant::now();
            if threads > 1 { pool.install(&mut go) } else { go() }
            let ns = t.elapsed().as_nanos() as f64 / (steps * n1 * n2) as f64;
            println!("{ns:.1} ns per particle-step, {:.2} M/s", 1e3 / ns);
        }
        return;
    }
    let cloud = lattice(&Plate { lengths: [10.0, 1.0] }, [n1, n2], weights).unwrap();
    let l = cloud.lattice.unwrap();
    let tip = l.index(n1 - 1, n2 / 2);
    let section = IsotropicSection::new(Isotropic::new(1200.0, 0.0).unwrap(), 1.0).unwrap();
    let m = std::f64::consts::TAU * 100.0 / 10.0;
    let edge: Vec<(u32, f64)> = l.edge(Side::U1).iter().enumerate().map(|(j, &a)| (a, if j == 0 || j == n2 - 1 { 0.5 } else { 1.0 })).collect();
    let supports = vec![
        Supported { particles: l.edge(Side::U0), support: Box::new(Clamped) },
        Supported { particles: l.row(n2 / 2), support: Box::new(SymmetryPlane { normal: Vec3::y() }) },
    ];
    let loads = vec![AppliedLoad { load: Box::new(EdgeCouple { edge, moment: m, axis: CoupleAxis::Fixed(-Vec3::y()) }), amplitude: Amplitude::Constant }];
    let t = std::time::Instant::now();
    let mut s = Shell::new(Parts { cloud, section: Box::new(section), strain: &StretchCorrected, density: 1.0, formulation: form, supports, loads, threads: 1 }).unwrap();
    println!("built {:?} bytes {}", t.elapsed(), s.bytes_per_particle());
    {
        let o = &s.reference().operator;
        let sp = s.reference().cloud.spacing();
        let mut w: Vec<(f64, usize, u8, usize)> = (0..o.points.len()).map(|p| { let st = o.stencil(p); let m = st.g1.iter().map(|x| x.abs()).sum::<f64>().max(st.g2.iter().map(|x| x.abs()).sum()); (m * sp, p, o.orders[p], st.particles.len()) }).collect();
        w.sort_by(|a, b| b.0.partial_cmp(&a.0).unwrap());
        println!("worst stencils {:?}", &w[..6]);
        println!("best stencils {:?}", &w[w.len() - 3..]);
    }
    let safety = arg.get(4).map_or(0.8, |s| s.parse().unwrap());
    let q = QuasiStatic { levels: std::env::var("LV").map_or(vec![0.25, 0.5, 0.75, 1.0], |v| v.split(",").map(|x| x.parse().unwrap()).collect()), period: 17.9, ramp: arg.get(5).map_or(1.5, |s| s.parse().unwrap()), hold: 8.0, damping: Damping::Ratio(1.0), tolerance: arg.get(6).map_or(1e-8, |s| s.parse().unwrap()), safety };
    match q.march(&mut s, &mut Tip(tip, 10.0, 0.0)) {
        Ok((c, l)) => println!("{} steps dt {:.4} {:?}", c.steps, c.dt, l.iter().map(|l| l.kinetic_over_internal).collect::<Vec<_>>()),
        Err(e) => println!("{e}"),
    }
    println!("{:?}", t.elapsed());
}
