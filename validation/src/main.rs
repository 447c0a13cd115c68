//! The command `validate`: runs the cases, prints the table, writes records and report.

use std::alloc::System;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use validation::cases::{self, option_cost};
use validation::{Case, Effort, JudgeError, Record, Selection, claimed, exit_code, judge, report, tables};

/// Counts what is allocated, for the memory that each option costs.
#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Judge coque: scenes against references.
///
/// Every case runs one or more scenes of scenes/, compares them with a published curve or a closed form, and holds the
/// difference against a tolerance that has a reason. The table shows all of it; the report draws it.
#[derive(Parser)]
#[command(name = "validate", version, after_help = HELP)]
struct Cli {
    /// Only the runs that are fast enough for every commit
    #[arg(long)]
    quick: bool,
    /// All runs but the heavy ones: those that take up to ten minutes as well
    #[arg(long, conflicts_with_all = ["quick", "heavy"])]
    full: bool,
    /// Only the runs that take more than ten minutes each; no other set has them
    #[arg(long, conflicts_with = "quick")]
    heavy: bool,
    /// The hard cases in place of the usual ones: where shells and particles break
    #[arg(long)]
    hard: bool,
    /// Hold the error bars of `coque run --error` against the references in place of the numbers
    #[arg(long, conflicts_with = "hard")]
    errors: bool,
    /// With --errors: every scene and study from so many lattices coarser on, as if that were its own
    #[arg(long, requires = "errors", value_name = "N", default_value_t = 0)]
    coarser: usize,
    /// Only this case; may be given several times
    #[arg(long = "case", value_name = "NAME")]
    cases: Vec<String>,
    /// Write one record per run: particles, steps, time, metrics with tolerances, curve
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Folder for report.html and the pages beside it
    #[arg(long, value_name = "DIR", default_value = "target/validation")]
    report: PathBuf,
    /// Beside the report a page for each pictured case, to be turned and played in a browser
    #[arg(long)]
    pages: bool,
    /// Scenes that run at the same time, one thread each [default: one for each core]
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
    /// List the cases and leave
    #[arg(long)]
    list: bool,
}

const HELP: &str = "\
Examples:
  validate --list                      what there is, and what it is compared with
  validate --quick                     what every commit has to pass
  validate --full                      with the runs that take from ten seconds to ten minutes
  validate --hard                      the survival table
  validate --heavy --case baffle       the runs that take more than ten minutes
  validate --case ring --case panel    the two cases of Lin et al. 2013
  validate --case option-cost          what each option of a scene costs
  validate --errors                    claimed against true error: the bars of `coque run --error`
  validate --json records.json         for further analysis
  validate --pages --case panel        its shape to be turned and played: target/validation/shapes/panel.html
  validate --jobs 1                    wall times without a neighbour on the other core

Reading the table: errors are in the unit that follows them; `pass` means that every metric with a tolerance keeps
to it, `shown` that nothing is asked of the run, `MISSED` that a tolerance is exceeded; the lines below the table then
say which, and where the tolerance comes from. Report and JSON say of every number whether it is judged or only shown,
and why.

Exit codes: 0 every tolerance kept, 1 a tolerance missed, 2 not judged (unknown case, scene refused, no file).";

fn main() -> ExitCode {
    let cli = Cli::parse();
    if cli.list {
        print!("{}", tables::list(&cli.all()));
        return ExitCode::SUCCESS;
    }
    match carry_out(&cli) {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

impl Cli {
    /// The usual cases, or the hard ones.
    fn all(&self) -> Vec<Case> {
        if self.hard { cases::hard() } else { cases::usual() }
    }
}

fn carry_out(cli: &Cli) -> Result<u8, JudgeError> {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    let selection = Selection {
        set: match (cli.quick, cli.full, cli.heavy) {
            (true, ..) => Effort::Quick,
            (_, true, _) => Effort::Full,
            (.., true) => Effort::Heavy,
            _ => Effort::Usual,
        },
        hard: cli.hard,
        names: cli.cases.clone(),
        jobs: cli.jobs.unwrap_or_else(cores),
        pages: cli.pages,
    };
    if cli.errors {
        return held(cli, &selection);
    }
    let results = judge(cli.all(), &selection, &|line| eprintln!("{line}"))?;
    print!("{}", tables::table(&results));
    if let Some(result) = results.iter().find(|result| result.case.name == option_cost::NAME) {
        println!("\n{}", tables::numbers(&option_cost::table(&result.runs)?));
    }
    println!("\n{}", tables::trust(&results));
    if let Some(file) = &cli.json {
        let records: Vec<&Record> = results.iter().flat_map(|result| &result.records).collect();
        let text = serde_json::to_string_pretty(&records).map_err(|error| write_error(file, &error))?;
        fs::write(file, text).map_err(|error| write_error(file, &error))?;
    }
    for page in report::pages(&results, &selection)? {
        write(&cli.report.join(page.file), &page.html)?;
    }
    for (file, html) in report::shapes(&results)? {
        write(&cli.report.join(file), &html)?;
    }
    println!("report: {}", cli.report.join(report::FIRST).display());
    Ok(exit_code(&results))
}

fn write(file: &Path, text: &str) -> Result<(), JudgeError> {
    let made = file.parent().map_or(Ok(()), fs::create_dir_all);
    made.and_then(|()| fs::write(file, text)).map_err(|error| write_error(file, &error))
}

/// Runs the scenes on the lattices beside their own and holds claimed against true errors.
fn held(cli: &Cli, selection: &Selection) -> Result<u8, JudgeError> {
    let dots = claimed::claimed(cli.all(), selection, cli.coarser, &|line| eprintln!("{line}"))?;
    print!("{}", claimed::table(&dots));
    let metrics = claimed::judged(&dots);
    let page = claimed::page(&dots)?;
    let file = cli.report.join(page.file);
    write(&file, &page.html)?;
    if let Some(file) = &cli.json {
        let text = serde_json::to_string_pretty(&dots).map_err(|error| write_error(file, &error))?;
        fs::write(file, text).map_err(|error| write_error(file, &error))?;
    }
    println!("report: {}", file.display());
    Ok(u8::from(metrics.iter().any(|metric| !metric.pass)))
}

fn write_error(path: &Path, error: &impl ToString) -> JudgeError {
    JudgeError::Write { path: path.display().to_string(), reason: error.to_string() }
}
