//! The workspace's own commands, as code: `cargo xtask validate · test · bench · peers · ci · tidy · python · package · wheel · deb · new-case · soak · gallery ·
//! book · aarch64`.

mod aarch64;
mod bench;
mod book;
mod cargo;
mod deb;
mod gallery;
mod mpi;
mod new_case;
mod package;
mod pages;
mod peers;
mod python;
mod soak;
mod test_all;
mod tidy;
mod validate;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// What a developer runs in this workspace.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Judge scenes against references: print the table, exit 1 if a case misses its tolerance
    ///
    /// Every case is a scene of scenes/, a reference of benchmarks-ref, a metric and a tolerance with its reason.
    /// Runs the program `validate` of the crate `validation` in release mode and returns its exit code.
    Validate(validate::Options),

    /// Everything that CI runs, from a bare checkout; stops at the first failure
    ///
    /// Steps: format, lints, tidy, Python, tests (the quick sets of cases, usual and hard, among them), the package for Python,
    /// documentation tests.
    /// Each is timed; a failure prints the command that repeats it. A missing rustfmt or clippy is skipped, loudly; so is the environment in
    /// target/python with which the package for Python is tested and fields are read back, where there is no Python 3.10 or no network. The last
    /// line counts what passed, failed and was skipped; where the environment variable CI is set, a skip fails the run. Runs of several processes are
    /// tested where there is an MPI library; --mpi tests them alone.
    Test {
        /// The tests of several processes alone.
        #[arg(long)]
        mpi: bool,
    },

    /// Run the benches, all or those whose name contains FILTER
    ///
    /// Finds every `[[bench]]` target of the workspace. Targets named "…instructions…" count instructions under
    /// valgrind, which does not drift with the load of the machine; without valgrind they are skipped, and said so.
    Bench(bench::Options),

    /// This program beside CalculiX, LAMMPS, … on the same problems, in turn: the report is target/peers/report.md
    ///
    /// Compares answers first, then times whichever of them are installed; of the others it says how they are installed, and their rows
    /// read "not installed". Their decks and scripts are in xtask/peers. One thread unless --threads says otherwise.
    Peers(peers::Options),

    /// `test`, then the full validation with its report in target/ci-report
    Ci,

    /// Check what the compiler cannot: layers between crates, circles of modules, conventions in sources, citations
    ///
    /// Layers: leaves use no crate of ours, a model uses no model, only `validation` reads benchmarks-ref.
    /// Circles: in every folder of a crate the modules use each other without one.
    /// Sources: a `//!` line on top, at most 400 lines, no tabs, trailing blanks, ignored tests, numbers of issues or
    /// paths of one machine; files and streams only in mesh-io, coque, coque-python, validation and xtask.
    /// Citations: every key in square brackets has its entry in references.bib.
    /// Links: those of Markdown pages lead to files and headings that are there; docs/SUMMARY.md lists every page of docs.
    /// Words: none that only those know who wrote the project.
    Tidy,

    /// The environment in target/python with which the package is tested and fields are read back, locked by hashes
    ///
    /// Made anew when coque/tests/python/requirements.txt has changed; with uv if there is one, else with venv and pip.
    /// Without it the tests pass and say what they left out. `test` makes it too.
    Python,

    /// Build the package for Python for development, run its tests, check its types; needs the environment of `python`
    ///
    /// The package lies in target/python/package: with it in PYTHONPATH the changed sources can be tried.
    Package,

    /// Build the wheel of the package for Python in release mode, into target/wheels, and say how large it is
    ///
    /// One wheel serves every Python from 3.9 on.
    Wheel,

    /// The program as a package of Debian in target/deb, with its manual page and completions; needs cargo-deb
    ///
    /// Built for distribution; page and completions are what the program prints of itself.
    Deb,

    /// Lay out a new benchmark: a scene, a case file, and the line that lists it
    ///
    /// Writes scenes/NAME.toml and validation/src/cases/shell/NAME.rs (with underscores) from templates that explain
    /// each entry, and prints what is left to do by hand.
    /// NAME is kebab-case, such as pinched-cylinder; an existing name is refused.
    NewCase(new_case::Options),

    /// Kill runs of every analysis at random moments (kill -9, SIGTERM), go on with them, compare their ends byte by byte
    ///
    /// Runs with checkpoints are resumed, the others run anew. An error where a file is torn, a run does not end when it
    /// is asked to, or an end differs from that of a run left in peace. Needs the program `kill`; files in target/soak.
    Soak(soak::Options),

    /// Run every scene of scenes/ and draw it: a page of pictures in target/gallery
    ///
    /// A scene that takes longer than the limit is drawn as it stands then. An error where a scene has no picture.
    Gallery(gallery::Options),

    /// The Markdown pages as one site in target/book/html, in the order of docs/SUMMARY.md; needs mdbook
    ///
    /// Pictures of the gallery go along where `cargo xtask gallery` has made them.
    Book,

    /// Tests of the base crates and seven scenes on aarch64, under an emulator: marches in time agree with those here to the bit
    ///
    /// Needs the target's standard library, a linker and qemu; says how to get what is missing. `test` runs it last where all
    /// is there, and says that it was not run where something is not.
    Aarch64,
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Validate(options) => return validate::run(&options),
        Task::Test { mpi: true } => test_all::of_processes(),
        Task::Test { mpi: false } => test_all::run(test_all::Depth::Quick),
        Task::Bench(options) => bench::run(&options),
        Task::Peers(options) => peers::run(&options),
        Task::Ci => test_all::run(test_all::Depth::Full),
        Task::Tidy => tidy::run(),
        Task::Python => python::make(),
        Task::Package => {
            package::test().and_then(|passed| if passed { Ok(()) } else { Err("the package fails".into()) })
        }
        Task::Wheel => package::wheel(),
        Task::Deb => deb::run(),
        Task::NewCase(options) => new_case::run(&options),
        Task::Soak(options) => soak::run(&options),
        Task::Gallery(options) => gallery::run(&options),
        Task::Book => book::run(),
        Task::Aarch64 => aarch64::Tools::find().and_then(|tools| tools.check()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_sound_and_every_task_explains_itself() {
        let mut command = Arguments::command();
        command.build();
        command.clone().debug_assert();
        for task in command.get_subcommands().filter(|task| task.get_name() != "help") {
            assert!(task.get_about().is_some(), "{} has no help", task.get_name());
        }
    }
}
