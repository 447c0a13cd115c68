//! PARDISO of MKL: the factor of a tangent of ours.

use std::path::Path;
use std::process::Command;

use super::place::{Place, python};
use super::program;
use super::reading::{Found, Reading, answers, line_of_json};
use super::row::{Comparison, Peer, Side};

const PARDISO: Peer = Peer {
    name: "PARDISO",
    install: "python3 -m venv target/peers/pardiso && target/peers/pardiso/bin/pip install scipy pypardiso",
    threaded: true,
    find: |place| {
        let version = "from importlib.metadata import version; import pypardiso, scipy.io; print('of MKL', version('mkl'))";
        python(place, "pardiso", version)
    },
};

/// Particles a side of the panel.
const SIDE: &str = "101";

/// Parts of a solution whose times are added.
type Stages = &'static [&'static str];

/// All comparisons with PARDISO.
pub fn comparisons() -> Vec<Comparison> {
    vec![
        stages("factor and solve, tangent of a panel of 101² particles", &["factor", "solve"]),
        stages("analysis, factor and solve of the same", &["analysis", "factor", "solve"]),
    ]
}

fn stages(problem: &'static str, stages: Stages) -> Comparison {
    Comparison {
        problem,
        peer: PARDISO,
        unit: "ms",
        answers: "norm of the solution",
        // Rounding, times the condition of the matrix: 10⁻¹¹ %.
        share: 1e-8,
        ours: Side { by: "LDLᵀ".to_owned(), run: Box::new(move |place, _| ours(place, stages)) },
        theirs: Side {
            by: "Cholesky".to_owned(),
            run: Box::new(move |place, found| theirs(place, found, stages)),
        },
    }
}

/// Ours writes the matrix as well; the other one reads it.
fn ours(place: &Place, stages: Stages) -> Result<Reading, String> {
    let folder = place.at("matrix")?;
    let mut command = Command::new(place.ours("examples/tangent_matrix"));
    command.args([SIDE, &place.threads.to_string()]).arg(&folder);
    staged(&mut command, &folder, place.threads, stages)
}

fn theirs(place: &Place, found: &Found, stages: Stages) -> Result<Reading, String> {
    let folder = place.at("matrix")?;
    let mut command = Command::new(&found.program);
    command.arg(place.deck("pardiso_matrix.py")).arg(&folder);
    staged(&mut command, &folder, place.threads, stages)
}

/// Runs a program that prints times of stages \[ms\] in a line of JSON. Its memory holds the matrix as text and is not compared.
fn staged(command: &mut Command, folder: &Path, threads: u32, stages: Stages) -> Result<Reading, String> {
    let said = line_of_json(&program::run(command, folder, threads)?.output)?;
    let cost: Option<f64> = stages.iter().map(|stage| said[*stage].as_f64()).sum();
    Ok(Reading {
        answers: answers(&said)?,
        cost: cost.ok_or_else(|| format!("no times of {} in {said}", stages.join(", ")))?,
        ..Reading::default()
    })
}
