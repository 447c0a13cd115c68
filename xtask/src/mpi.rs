//! The tests of several processes: what they take, and how they are asked for.

use crate::cargo;

/// Builds what MPI is asked for.
pub const FEATURE: [&str; 2] = ["--features", "coque-mpi/mpi"];

/// What is not there of an MPI library; none where all is.
pub fn missing() -> Option<String> {
    let lacks = ["mpicc", "mpirun"].into_iter().find(|program| !cargo::has_program(program))?;
    Some(format!(
        "there is no {lacks}, and no run of several processes is tested; install an MPI library, as by apt-get install openmpi-bin libopenmpi-dev"
    ))
}

/// Words after `cargo` for these tests alone.
pub fn tests() -> Vec<String> {
    let of = ["test", "--workspace", FEATURE[0], FEATURE[1]];
    cargo::words(
        &[&of[..], &["--test", "messages", "--test", "runs", "--test", "ranks"], &["--", "--test-threads=1"]]
            .concat(),
    )
}
