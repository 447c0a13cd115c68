//! `cargo xtask peers`: this program beside other codes, on the same problems, on this machine, in turn.
//!
//! A comparison is one file here: its problem, what ours and the other one run, how their answers are read. Decks and scripts of
//! the others are in xtask/peers/. A code that is not installed is named with what installs it; its rows say so, and nothing fails.

mod calculix;
mod lammps;
mod opensees;
mod pardiso;
mod place;
mod program;
mod pysph;
mod reading;
mod report;
mod row;
mod shell_mesh;

use clap::Args;
use std::fs;

use place::Place;
use report::Report;
use row::{Comparison, Outcome};

/// What is compared.
#[derive(Args)]
pub struct Options {
    /// Runs of each, in turn
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..))]
    times: u32,
    /// Threads for either; a code that knows one alone takes one, and the report says so
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    threads: u32,
    /// Only comparisons whose problem or other code contains this text
    #[arg(value_name = "FILTER")]
    filter: Option<String>,
}

/// Every comparison, in the order of the report.
fn comparisons() -> Vec<Comparison> {
    let all = [
        calculix::comparisons(),
        lammps::comparisons(),
        pysph::comparisons(),
        opensees::comparisons(),
        pardiso::comparisons(),
    ];
    all.into_iter().flatten().collect()
}

/// Runs what is installed and writes target/peers/report.md.
pub fn run(options: &Options) -> Result<(), String> {
    let wanted: Vec<Comparison> =
        comparisons().into_iter().filter(|of| of.is_named(options.filter.as_deref())).collect();
    if wanted.is_empty() {
        return Err("no comparison has this text in its name; without a filter all are run".to_owned());
    }
    let place = Place::prepare(options.threads)?;
    if wanted.iter().any(|of| (of.peer.find)(&place).is_some()) {
        place.build()?;
    }
    let mut report = Report::new(&place, options.times);
    for comparison in wanted {
        println!("\n── {}: {}", comparison.peer.name, comparison.problem);
        let outcome = comparison.run(&place, options.times);
        match &outcome {
            Outcome::NotInstalled => println!("not installed: {}", comparison.peer.install),
            Outcome::Failed(why) => println!("failed: {why}"),
            Outcome::Apart { .. } => println!("answers differ: nothing was timed"),
            Outcome::Timed { .. } => {}
        }
        report.add(&place, &comparison, outcome);
        println!("{}", report.last_line());
    }
    let file = place.folder.join("report.md");
    fs::write(&file, report.page()).map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    println!("\nthe report: {}", file.display());
    Ok(())
}
