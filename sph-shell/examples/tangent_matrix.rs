//! The tangent of a clamped cylindrical panel under its weight: written as Matrix Market, factored and solved here, each timed.
//!
//! ```text
//! cargo run --release -p sph-shell --example tangent_matrix -- SIDE THREADS [FOLDER]
//! ```
//!
//! Writes matrix.mtx (lower triangle) and right.txt into the folder, if one is given, for another solver to take: so does
//! `cargo xtask peers`. Prints one line of JSON: unknowns, the norm of the solution, ms of analysis, factor and solve by the clock, medians
//! of five.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::time::Instant;

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, SymmetricSolver};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{AppliedLoad, Clamped, Formulation, Gravity, Parts, Reach, Shell, StaticShell, Supported};

const TRIALS: usize = 5;

/// A panel of .5 rad of a cylinder, radius 1 and length .5, t = R/100, clamped along both straight edges.
fn panel(side: usize, threads: usize) -> Result<StaticShell, Box<dyn Error>> {
    let patch = Cylinder { radius: 1.0, angles: [0.0, 0.5], length: 0.5 };
    let cloud = lattice(&patch, [side, side], EndWeights::Trapezoid)?;
    let sides = cloud.sides.clone().ok_or("a lattice has sides")?;
    let clamp = |side| Supported { particles: sides.edge(side).to_vec(), support: Box::new(Clamped) };
    let shell = Shell::builder(Parts {
        cloud,
        section: Box::new(IsotropicSection::new(Isotropic::new(1e6, 0.3)?, 0.01)?),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: vec![clamp(Side::U0), clamp(Side::U1)],
        loads: vec![AppliedLoad {
            load: Box::new(Gravity { acceleration: -Vec3::z() }),
            amplitude: Amplitude::Constant,
        }],
        threads,
    });
    Ok(StaticShell::new(shell.build()?))
}

fn write(
    folder: &Path,
    unknowns: usize,
    pattern: &[(usize, usize)],
    values: &[f64],
    right: &[f64],
) -> Result<(), Box<dyn Error>> {
    let mut text =
        format!("%%MatrixMarket matrix coordinate real symmetric\n{unknowns} {unknowns} {}\n", pattern.len());
    for ((row, column), value) in pattern.iter().zip(values) {
        writeln!(text, "{} {} {value:e}", row + 1, column + 1)?;
    }
    fs::write(folder.join("matrix.mtx"), text)?;
    let lines: Vec<String> = right.iter().map(|value| format!("{value:e}\n")).collect();
    fs::write(folder.join("right.txt"), lines.concat())?;
    Ok(())
}

/// The median time of some trials \[ms\], and what the last one gave.
fn timed<T>(
    mut work: impl FnMut() -> Result<T, Box<dyn Error + Send + Sync>>,
) -> Result<(f64, T), Box<dyn Error + Send + Sync>> {
    let mut times = Vec::new();
    let mut last = None;
    for _ in 0..TRIALS {
        let start = Instant::now();
        last = Some(work()?);
        times.push(1e3 * start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    Ok((times[TRIALS / 2], last.ok_or("no trial")?))
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [side, threads, folder @ ..] = words.as_slice() else { return Err("SIDE THREADS [FOLDER]".into()) };
    let (side, threads): (usize, usize) = (side.parse()?, threads.parse()?);
    let mut body = panel(side, threads)?;
    let (n, pattern, places) = (body.unknowns(), body.pattern(), body.coordinates());
    let (mut values, mut right) = (vec![0.0; pattern.len()], vec![0.0; n]);
    body.tangent(0.0, &mut values);
    body.external(1.0, &mut right);
    if let Some(folder) = folder.first() {
        write(Path::new(folder), n, &pattern, &values, &right)?;
    }
    let measured = || -> Result<_, Box<dyn Error + Send + Sync>> {
        let (analysis, mut solver) = timed(|| Ok(SymmetricSolver::placed(n, &pattern, places.as_deref())?))?;
        let (factor, _) = timed(|| Ok(solver.factor(&values)?))?;
        let (solve, solution) = timed(|| {
            let mut solution = right.clone();
            solver.solve(&mut solution)?;
            Ok(solution)
        })?;
        Ok((analysis, factor, solve, solution.iter().map(|x| x * x).sum::<f64>().sqrt()))
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (analysis, factor, solve, norm) = pool.install(measured).map_err(|error| error.to_string())?;
    println!(
        r#"{{ "answers": [{norm:e}], "unknowns": {n}, "analysis": {analysis:e}, "factor": {factor:e}, "solve": {solve:e} }}"#
    );
    Ok(())
}
