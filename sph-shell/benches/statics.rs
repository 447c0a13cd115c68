//! What statics of the shell cost: `cargo bench -p sph-shell --bench statics -- WHAT SIDE [LEVELS]`, all of them on small bodies
//! without a WHAT. Times are of the processor (Linux alone tells them), on one thread; `THREADS=2 cargo bench …` takes so many, and times of the clock.
//!
//! | what | on SIDE² particles |
//! |---|---|
//! | `iteration` | one Newton iteration of a hinged panel: forces, tangent, factor, solve |
//! | `panel` | the panel pushed in through its limit point in LEVELS levels |
//! | `linear` | a linear answer of a clamped plate, with the peak of memory |
//! | `iterated` | the same by conjugate gradients |
//! | `modes`, `buckling` | ten modes, ten buckling loads of that plate |

use std::ops::ControlFlow;
use std::sync::LazyLock;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use implicit_statics::{
    BucklingOptions, ConjugateOptions, Control, CriticalOptions, Equilibrium, Newton, NewtonOptions,
    PathOptions, Start, SymmetricSolver, conjugate_response, linear_buckling, linear_response, natural_modes,
    unwatched,
};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cloud, Cylinder, EndWeights, Plate, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Hinged, Load, Parts, Reach, Shell, StaticShell, Supported,
    SymmetryPlane,
};

/// Trials of each part of an iteration.
const TRIALS: usize = 50;

static BEGIN: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Seconds that the processor has given this thread, as Linux tells: others on the machine hardly count. Of several threads those of the clock.
fn processor() -> f64 {
    if rayon::current_num_threads() > 1 {
        return BEGIN.elapsed().as_secs_f64();
    }
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").expect("Linux");
    let first = text.split(' ').next().and_then(|nanoseconds| nanoseconds.parse::<f64>().ok());
    1e-9 * first.expect("nanoseconds")
}

fn timed<T>(name: &str, work: impl FnOnce() -> T) -> T {
    let start = processor();
    let out = work();
    println!("{name:12} {:9.3} s", processor() - start);
    out
}

/// Mean of many trials: the system counts in steps of some milliseconds.
fn mean(name: &str, mut work: impl FnMut()) {
    let start = processor();
    (0..TRIALS).for_each(|_| work());
    println!("{name:12} {:9.3} ms", 1e3 * (processor() - start) / TRIALS as f64);
}

fn shell(
    cloud: Cloud,
    young: f64,
    thickness: f64,
    supports: Vec<Supported>,
    load: Box<dyn Load>,
) -> StaticShell {
    let section = IsotropicSection::new(Isotropic::new(young, 0.3).expect("moduli"), thickness);
    let shell = Shell::builder(Parts {
        cloud,
        section: Box::new(section.expect("a section")),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports,
        loads: vec![AppliedLoad { load, amplitude: Amplitude::Constant }],
        threads: rayon::current_num_threads(),
    })
    .build();
    StaticShell::new(shell.expect("a shell"))
}

/// A quarter of a hinged cylindrical panel (R = 2540, t = 12.7) under a force of 1 at its crown; and the crown.
fn panel(side: usize) -> (StaticShell, u32) {
    let patch = Cylinder { radius: 2540.0, angles: [0.0, 0.1], length: 254.0 };
    let cloud = lattice(&patch, [side, side], EndWeights::Trapezoid).expect("a lattice");
    let sides = cloud.sides.clone().expect("sides");
    let edge = |side: Side| sides.edge(side).to_vec();
    let plane =
        |side, normal| Supported { particles: edge(side), support: Box::new(SymmetryPlane { normal }) };
    let supports = vec![
        Supported { particles: edge(Side::U1), support: Box::new(Hinged) },
        plane(Side::U0, Vec3::x()),
        plane(Side::V0, Vec3::y()),
    ];
    let crown = edge(Side::U0).into_iter().find(|a| edge(Side::V0).contains(a)).expect("a corner");
    let force = Force { shares: vec![(crown, 1.0)], total: -Vec3::z() };
    (shell(cloud, 3102.75, 12.7, supports, Box::new(force)), crown)
}

/// A square plate, L/t = 100, clamped along one edge and pressed in its plane on the other.
fn plate(side: usize) -> StaticShell {
    let cloud =
        lattice(&Plate { lengths: [1.0, 1.0] }, [side, side], EndWeights::Trapezoid).expect("a lattice");
    let sides = cloud.sides.clone().expect("sides");
    let clamp = Supported { particles: sides.edge(Side::U0).to_vec(), support: Box::new(Clamped) };
    let end = sides.edge(Side::U1);
    let shares = end.iter().map(|&a| (a, 1.0 / end.len() as f64)).collect();
    let force = Force { shares, total: Vec3::new(-1.0, 0.0, 1e-9) };
    shell(cloud, 1e6, 0.01, vec![clamp], Box::new(force))
}

fn iteration(side: usize) {
    let (mut body, _) = panel(side);
    let (n, pattern) = (body.unknowns(), body.pattern());
    let (mut values, mut forces) = (vec![0.0; pattern.len()], vec![0.0; n]);
    let mut solver = SymmetricSolver::placed(n, &pattern, body.coordinates().as_deref()).expect("a pattern");
    println!(
        "{n} unknowns, {} entries, {} of the factor, {:.2e} multiplications",
        pattern.len(),
        solver.factor_entries(),
        solver.multiplications()
    );
    mean("analysis", || {
        let pattern = body.pattern();
        SymmetricSolver::placed(n, &pattern, body.coordinates().as_deref()).expect("a pattern");
    });
    mean("forces", || body.internal(0.0, &mut forces));
    mean("tangent", || body.tangent(0.0, &mut values));
    mean("factor", || {
        solver.factor(&values).expect("finite");
    });
    body.external(1.0, &mut forces);
    mean("solve", || solver.solve(&mut forces.clone()).expect("regular"));
    mean("… of two", || {
        let [mut a, mut b] = [forces.clone(), forces.clone()];
        solver.solve_all([&mut a, &mut b]).expect("regular");
    });
    mean("… of four", || {
        let [mut a, mut b, mut c, mut d] = std::array::from_fn(|_| forces.clone());
        solver.solve_all([&mut a, &mut b, &mut c, &mut d]).expect("regular");
    });
}

/// Pushes the crown in by 30, one level after the other as an analysis of levels does.
fn through(side: usize, levels: usize) {
    let (mut body, crown) = panel(side);
    let weights = body.functional(&[crown], -Vec3::z());
    let functional: Vec<_> = weights.into_iter().enumerate().filter(|&(_, weight)| weight != 0.0).collect();
    let mut start = Start::default();
    let mut newton = Newton::new(&body, &NewtonOptions::default()).expect("a pattern");
    let (mut iterations, mut loads) = (0, Vec::new());
    timed("panel", || {
        for level in 1..=levels {
            let done = -body.shell().displacement(crown as usize).z;
            let step = 30.0 * level as f64 / levels as f64 - done;
            let control = Control::Displacement { functional: functional.clone(), step, until: step };
            let mut options = PathOptions::new(control);
            options.newton.line_search = false;
            options.critical = Some(CriticalOptions { tolerance: 1e-3, ..CriticalOptions::default() });
            let path = newton.follow(&mut body, &start, &options, |point, _| {
                iterations += if point.step > 0 { point.converged.iterations } else { 0 };
                ControlFlow::Continue(())
            });
            path.end.expect("a level");
            loads.push(4.0 * path.restart.level);
            start = path.restart;
        }
    });
    let largest = loads.iter().copied().fold(0.0, f64::max);
    println!("{iterations} iterations, largest force {largest:.12e}, last {:.12e}", loads[levels - 1]);
}

fn linear(side: usize, iterated: bool) {
    let mut body = timed("body", || plate(side));
    let answer = timed("answer", || {
        if !iterated {
            return linear_response(&mut body, 0.0).expect("regular");
        }
        let found = conjugate_response(&mut body, 0.0, &ConjugateOptions::default()).expect("convergence");
        println!("{} iterations, unknowns of the levels {:?}", found.iterations, found.levels);
        found.response
    });
    let largest = answer.iter().copied().fold(0.0, f64::max);
    println!("{} unknowns, largest {largest:.12e}", answer.len());
    let status = std::fs::read_to_string("/proc/self/status").expect("Linux");
    println!("peak memory: {}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default());
}

fn modes(side: usize) {
    let mut body = plate(side);
    let watch = &mut unwatched;
    let found = timed("modes", || natural_modes(&mut body, 0.0, 10, 0.0, watch).expect("modes"));
    let values: Vec<f64> = found.modes.iter().map(|mode| mode.circular_frequency()).collect();
    println!("{:?}\n{values:.9?}", found.effort);
}

fn buckling(side: usize) {
    let mut body = plate(side);
    let options = BucklingOptions::new(10);
    let watch = &mut unwatched;
    let found = timed("buckling", || linear_buckling(&mut body, 0.0, &options, watch).expect("levels"));
    let values: Vec<f64> = found.modes.iter().map(|mode| mode.level).collect();
    println!("{:?}\n{values:.9?}", found.effort);
}

fn main() {
    let threads = std::env::var("THREADS").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(measured);
}

fn measured() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|text| text != "--bench").collect();
    let number =
        |place: usize, default| arguments.get(place).and_then(|text| text.parse().ok()).unwrap_or(default);
    match arguments.first().map(String::as_str) {
        Some("iteration") => iteration(number(1, 21)),
        Some("panel") => through(number(1, 21), number(2, 60)),
        Some("linear") => linear(number(1, 100), false),
        Some("iterated") => linear(number(1, 100), true),
        Some("modes") => modes(number(1, 50)),
        Some("buckling") => buckling(number(1, 50)),
        _ => {
            iteration(21);
            through(21, 60);
            linear(50, false);
            linear(50, true);
            modes(30);
            buckling(30);
        }
    }
}
