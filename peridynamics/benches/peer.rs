//! Full steps against the package PERI of LAMMPS, on the same lattices, one thread each.
//!
//! Both march a free block of m = 3.015 with whole volumes and no bond that breaks. Times are those of the processor, so
//! that other work on the machine counts little: ours from the thread's own clock, LAMMPS's loop times its share of the
//! processor. LAMMPS also walks a list of contacts. Without the program `lmp` it says so and ends.

mod lattices;

use std::fs;
use std::process::Command;
use std::time::Instant;

use explicit_dynamics::Clock;
use lattices::{SPACING, body, name};
use peridynamics::Law;

/// Directed bonds that each measurement works through, at least.
const WORK: usize = 60_000_000;

fn main() {
    if Command::new("lmp").arg("-h").output().is_err() {
        println!("comparison with LAMMPS skipped: the program lmp is not here");
        return;
    }
    for counts in [[22, 22, 22], [46, 46, 46]] {
        for law in [Law::BondBased, Law::StateBased] {
            let mut solid = body(counts, law, 1);
            let (bonds, steps) = (solid.bonds(), WORK.div_ceil(solid.bonds()));
            let mut clock = Clock::start(&mut solid, 1.0, 0.2, 0.0).expect("a stable step");
            let mut march = || {
                for _ in 0..steps {
                    clock.step(&mut solid, f64::INFINITY, |_| 1.0).expect("a sound step");
                }
            };
            march();
            let start = Stopwatch::start();
            march();
            let rate = |seconds: f64| (steps * bonds) as f64 / seconds / 1e6;
            let ours = rate(start.seconds());
            match lammps(counts[0], law, steps) {
                Some(seconds) => println!(
                    "{} {counts:?}, {bonds} bonds: {ours:.0} million bonds a second, LAMMPS {:.1}, ratio {:.1}",
                    name(law),
                    rate(seconds),
                    ours / rate(seconds),
                ),
                None => println!("{} {counts:?}: LAMMPS did not report a time", name(law)),
            }
        }
    }
}

/// Time of the processor on this thread, where the system tells it; else that of the wall.
struct Stopwatch {
    wall: Instant,
    thread: Option<f64>,
}

impl Stopwatch {
    fn start() -> Self {
        Self { wall: Instant::now(), thread: thread_seconds() }
    }

    fn seconds(&self) -> f64 {
        match (self.thread, thread_seconds()) {
            (Some(before), Some(now)) => now - before,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

fn thread_seconds() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(1e-9 * text.split(' ').next()?.parse::<f64>().ok()?)
}

/// Seconds of the processor that LAMMPS needs for the steps.
fn lammps(side: usize, law: Law, steps: usize) -> Option<f64> {
    let folder = std::env::temp_dir().join(format!("peer-{}", std::process::id()));
    fs::create_dir_all(&folder).ok()?;
    fs::write(folder.join("input"), script(side, law, steps)).ok()?;
    let output = Command::new("lmp")
        .args(["-in", "input", "-log", "none"])
        .env("OMP_NUM_THREADS", "1")
        .current_dir(&folder)
        .output();
    fs::remove_dir_all(&folder).ok()?;
    let text = String::from_utf8_lossy(&output.ok()?.stdout).into_owned();
    let number =
        |line: &str, place: usize| line.split_whitespace().nth(place)?.trim_end_matches('%').parse().ok();
    // The last run's lines `Loop time of T on …` and `P% CPU use …`.
    let time: f64 = number(text.lines().rfind(|line| line.starts_with("Loop time of"))?, 3)?;
    let share: f64 = number(text.lines().rfind(|line| line.contains("CPU use"))?, 0)?;
    Some(time * share / 100.0)
}

/// LAMMPS's input: elastic constants of the same solid, a step far below the stable one. It stays at rest, which costs as
/// much: in motion the LPS of LAMMPS 2022 gives nodes a damage of .79 in the first step, for critical stretches from 0.5 to 1e9.
fn script(side: usize, law: Law, steps: usize) -> String {
    let (horizon, volume) = (3.015 * SPACING, SPACING.powi(3));
    let (bulk, shear) = (1e6 / 1.2, 1e6 / 2.6);
    let micro = 18.0 * (1e6 / 1.5) / (std::f64::consts::PI * horizon.powi(4));
    let pair = match law {
        Law::BondBased => format!("pair_style peri/pmb\npair_coeff 1 1 {micro:e} {horizon} 1e9 0.0"),
        Law::StateBased => format!("pair_style peri/lps\npair_coeff 1 1 {bulk} {shear} {horizon} 1e9 0.0"),
    };
    let end = (side as f64 - 0.5) * SPACING;
    format!(
        "units si\nboundary s s s\natom_style peri\natom_modify map array\nneighbor {skin} bin\n\
         lattice sc {SPACING}\nregion body block 0 {end} 0 {end} 0 {end} units box\ncreate_box 1 body\n\
         create_atoms 1 region body\n{pair}\nset group all density 1.0\nset group all volume {volume:e}\n\
         fix march all nve\ntimestep 1e-7\nthermo 1000000\n\
         run {steps}\nrun {steps}\n",
        skin = 0.1 * SPACING,
    )
}
