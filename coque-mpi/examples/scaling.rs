//! What two processes gain over two threads, and both over one thread: scenes of the repository marched in turn, medians of the ratios.
//! `target/release/examples/scaling [rounds]`, from the root of the repository, with `mpirun` there and nothing else running.
//!
//! `cargo build --release --workspace --bin coque-mpi --example scaling --features coque-mpi/mpi` builds it and what it runs.

#![allow(clippy::unwrap_used)] // an example may stop where it stands

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A scene with values replaced.
type Problem = (&'static str, &'static [&'static str]);

/// A square plate of so many particles in so many steps about.
macro_rules! plate {
    ($side:literal, $duration:literal) => {
        (
            "scenes/plate.toml",
            &[
                concat!("geometry.plate.particles=[", $side, ", ", $side, "]"),
                concat!(
                    "analysis={ explicit = { transient = { duration = ",
                    $duration,
                    ", record_every = ",
                    $duration,
                    " } } }"
                ),
            ],
        )
    };
}

/// Twice as many particles as in the first of the problems.
const TWICE: Problem = plate!("141", "0.028");
const PROBLEMS: [(&str, Problem); 4] = [
    ("plate, 1e4", plate!("100", "0.04")),
    ("plate, 1e5", plate!("317", "0.003")),
    (
        "tube under a tool, 1.1e4",
        (
            "scenes/tube-crushed.toml",
            &[
                "geometry.cylinder.particles=[1001, 11]",
                "tools.0.amplitude={ ramp = 2e-4 }",
                "tools.0.moved=[0.0, 0.0, -3.0]",
                "curve.4.name=taken",
                "analysis={ explicit = { transient = { duration = 4e-5, record_every = 4e-5 } } }",
            ],
        ),
    ),
    (
        "ring on itself, 1.1e4",
        (
            "scenes/ring-in-itself.toml",
            &[
                "geometry.cylinder.particles=[1001, 11]",
                "analysis={ explicit = { transient = { duration = 0.02, record_every = 0.02 } } }",
            ],
        ),
    ),
];

fn main() {
    let rounds: usize = std::env::args().nth(1).map_or(5, |given| given.parse().unwrap());
    println!("{rounds} rounds, medians of the ratios of one round; steps a second\n");
    println!("{:<26}{:>12}{:>12}{:>12}{:>12}", "", "one thread", "2 threads", "2 processes", "2 over 2");
    for (name, problem) in PROBLEMS {
        let round = |_| [(1, 1), (1, 2), (2, 1)].map(|(processes, threads)| run(problem, processes, threads));
        let found: Vec<[f64; 3]> = (0..rounds).map(round).collect();
        let ratio = |of: usize, over: usize| median(found.iter().map(|row| row[of] / row[over]));
        let one = median(found.iter().map(|row| row[0]));
        println!("{name:<26}{one:>12.1}{:>12.2}{:>12.2}{:>12.2}", ratio(1, 0), ratio(2, 0), ratio(2, 1));
    }
    let (_, alone) = PROBLEMS[0];
    let weak = median((0..rounds).map(|_| run(TWICE, 2, 1) / run(alone, 1, 1)));
    println!("\n2e4 particles on two processes over 1e4 on one: {weak:.2}");
}

/// Steps a second of a run by so many processes with so many threads each.
fn run((scene, replaced): Problem, processes: usize, threads: usize) -> f64 {
    let beside = std::env::current_exe().unwrap();
    let program = beside.parent().and_then(Path::parent).unwrap().join("coque-mpi");
    let out: PathBuf = std::env::temp_dir().join(format!("coque-scaling-{}", std::process::id()));
    let mut command = if processes == 1 {
        Command::new(program)
    } else {
        let mut command = Command::new("mpirun");
        command.args(["-n", &processes.to_string(), "--bind-to", "core"]).arg(program);
        command
    };
    command.args(["run", scene, "--threads", &threads.to_string(), "--out"]).arg(&out);
    replaced.iter().for_each(|value| _ = command.args(["--set", value]));
    let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    assert!(status.success(), "{scene} by {processes} processes: {status}");
    let summary = std::fs::read_to_string(out.join("summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    std::fs::remove_dir_all(out).unwrap();
    summary["steps"].as_f64().unwrap() / summary["wall_seconds"].as_f64().unwrap()
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
