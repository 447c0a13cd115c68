//! The command `coque`: its words, and what each of them does.

// A print that fails panics; `say` does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod accuracy;
mod accurate;
mod ask;
mod bar;
mod check;
mod company;
mod errors;
mod examples;
mod launcher;
mod mesh;
mod plot;
mod refine;
mod resume;
mod run;
mod starter;
mod stderr;
mod stop;
mod sweep;
mod templates;
mod view;
mod words;

use std::ffi::OsString;
use std::sync::Arc;

use clap::{CommandFactory, Parser, Subcommand};
use company::Company;
pub use company::ProcessGroup;
pub use launcher::{Launched, launched};
use stderr::Refused;
use stop::{Stop, outlive_file_limits};

const DONE: u8 = 0;
const BAD_INPUT: u8 = 2;
const DIVERGED: u8 = 3;
const NOT_SETTLED: u8 = 4;
const INTERRUPTED: u8 = 130;

/// Simulates thin shells, solids that break, fluids that load both, and Galerkin solids, all by particles.
#[derive(Parser)]
#[command(name = "coque", version, after_help = START)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scene and write its curve.
    #[command(after_help = run::HELP)]
    Run(run::Run),
    /// Read a surface and print what was found: sizes, boundary, sets, quality.
    #[command(after_help = mesh::HELP)]
    Mesh(mesh::Mesh),
    /// Show a run in the browser: shapes that turn, fields, frames, the curve, in one file.
    #[command(after_help = view::HELP)]
    View(view::View),
    /// Draw frames of a run with [output.fields], or its curve, as SVG.
    #[command(after_help = plot::HELP)]
    Plot(plot::Plot),
    /// Go on with a run that was interrupted or killed, to the same bits.
    #[command(after_help = resume::HELP)]
    Resume(resume::Resume),
    /// Run a scene for a list of values, or for every combination of several; one table out.
    #[command(after_help = sweep::HELP)]
    Sweep(sweep::Sweep),
    /// Write a scene on a finer mesh: all over, or where the estimated error is.
    #[command(after_help = refine::HELP)]
    Refine(refine::Refine),
    /// Write a commented scene to start from: by three questions, or an example.
    #[command(after_help = templates::NEW_HELP)]
    New(templates::New),
    /// List the scenes within the program, or write one of them.
    #[command(after_help = examples::HELP)]
    Examples(examples::Examples),
    /// Validate a scene; print the model, what it leaves out and what a run will cost.
    #[command(after_help = check::HELP)]
    Check(check::Check),
    /// Print what a scene may name: analyses, formulations, supports, loads, …, a line each.
    #[command(after_help = templates::LIST_HELP)]
    List(templates::List),
    /// Print the JSON schema of scenes, for editors.
    #[command(after_help = templates::SCHEMA_HELP)]
    Schema(templates::Schema),
    /// Print what completes the words of this command in a shell.
    #[command(after_help = words::COMPLETION_HELP)]
    Completion(words::Completion),
    /// Print the manual page.
    #[command(after_help = words::MAN_HELP)]
    Man,
}

const START: &str = "\
Start here:
  coque new                         three questions, then a commented scene to run and to change
  coque examples ring               writes ring.toml, one of the scenes within the program
  coque run ring.toml --view        results in out/ring, shown in the browser
  coque view out/gate               the same of a run that is there, if its scene has [output.fields]
  coque plot out/gate               its last frame as a picture for a paper
  coque check ring.toml             what it models, what it leaves out, what a run will cost
  coque check ring.toml --accuracy 0.5%     which lattice and analysis that takes
  coque run ring.toml --error       every number with its error, from runs on coarser lattices
  coque refine ring.toml --by 50%   a finer mesh where the error is
  coque list                        what a scene may name
  coque run --help                  options, examples, where results are
  coque mesh panel.msh              what a mesh holds, and what is wrong with it

Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged, 4 done but short of what was asked, 130 interrupted.";

/// Obeys the arguments of a command line, the first of which is the name of the program; what the command `coque` is. Returns the exit code.
///
/// Words for people go to the standard error, tables and texts that were asked for to the standard output.
pub fn command_line(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    command_line_in(None, arguments)
}

/// The same in one of several processes that a launcher started: all of them run a scene, or go on with a run, together; any other command is
/// obeyed by the first alone.
pub fn command_line_in(
    group: Option<&dyn ProcessGroup>,
    arguments: impl IntoIterator<Item = OsString>,
) -> u8 {
    // First of all: a signal for which nobody watches ends the program as it stands.
    let stop = Stop::watch();
    outlive_file_limits();
    let company = match Company::new(group) {
        Ok(company) => company,
        Err(refused) => {
            refused.say();
            return BAD_INPUT;
        }
    };
    let command = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli.command,
        Err(said) => {
            if company.is_first() {
                let _ = said.print();
            }
            return if said.use_stderr() { BAD_INPUT } else { DONE };
        }
    };
    match stop.map_err(Refused::from).and_then(|stop| obey(command, &stop, &company)) {
        Ok(code) => code,
        Err(refused) => {
            refused.say();
            BAD_INPUT
        }
    }
}

fn obey(command: Command, stop: &Arc<Stop>, company: &Company) -> Result<u8, Refused> {
    match command {
        Command::Run(run) => run::carry_out(&run, stop, company),
        Command::Resume(resume) => resume::carry_out(&resume, stop, company),
        _ if !company.is_first() => Ok(DONE),
        Command::Mesh(mesh) => mesh::carry_out(&mesh).map(|()| DONE),
        Command::View(view) => view::carry_out(&view, stop).map(|()| DONE),
        Command::Plot(plot) => plot::carry_out(&plot).map(|()| DONE),
        Command::Sweep(sweep) => sweep::carry_out(&sweep, stop),
        Command::Refine(refine) => refine::carry_out(&refine, stop).map(|()| DONE),
        Command::New(new) => templates::new(&new, stop, company),
        Command::Examples(examples) => examples::carry_out(&examples).map(|()| DONE),
        Command::Check(check) => check::carry_out(&check).map(|()| DONE),
        Command::List(list) => templates::list(&list).map(|()| DONE),
        Command::Schema(schema) => templates::schema(&schema).map(|()| DONE),
        Command::Completion(completion) => words::completion(&completion, Cli::command()).map(|()| DONE),
        Command::Man => words::man(&Cli::command()).map(|()| DONE),
    }
}
