//! `coque check`: validates a scene and prints the model and what its run will cost.

use std::path::PathBuf;

use crate::{Estimate, LoadResultants, Model, Quantity, Units, Warning};
use clap::Args;

use super::accuracy;
use super::bar::clock;
use super::run::{build, read_scene, replacement};
use super::stderr::{Refused, print};

#[derive(Args)]
pub struct Check {
    /// The scene, a TOML file.
    scene: PathBuf,
    /// Threads that a run would use.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: u16,
    /// Replace a value of the scene; may be given several times.
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = replacement)]
    replaced: Vec<(String, String)>,
    /// Predict which particles, method and analysis reach this accuracy, such as 0.5%, from runs on coarse lattices.
    #[arg(long, value_name = "SHARE", value_parser = accuracy::share)]
    accuracy: Option<f64>,
    /// Time for those runs of each method, in seconds.
    #[arg(long, value_name = "SECONDS", default_value_t = 30.0, value_parser = accuracy::seconds, requires = "accuracy")]
    within: f64,
    /// Draw the errors of those runs over their times into this file, SVG.
    #[arg(long, value_name = "FILE", requires = "accuracy")]
    chart: Option<PathBuf>,
}

pub const HELP: &str = "\
Reads and builds a scene as `coque run` would, times a few steps, and prints what is modelled, what is left out, and
what a run will cost; numbers that are known to come out wrong are warned of, with the reason. How long levels hold is not known beforehand: the shortest and the longest are reported.

With --accuracy the scene is run on lattices from coarse to fine until its own answers differ by less than that, or the
time given is over; order and error of the answers then tell the lattice that is needed, and its time and memory. Errors
are shares of the greatest value of a column. What a shell leaves out of a solid does not show in them.

Examples:
  coque check scenes/ring.toml
  coque check scenes/panel.toml --set 'geometry.cylinder.particles=[101, 101]' --threads 2
  coque check scenes/scordelis-lo.toml --accuracy 0.5%
  coque check scenes/panel.toml --accuracy 1% --within 60
  coque check scenes/ring.toml --accuracy 0.5% --chart ring.svg       error against time of each method

Exit codes: 0 sound, 2 refused.";

/// Builds the model and prints it.
pub fn carry_out(check: &Check) -> Result<(), Refused> {
    let (scene, _) = read_scene(&check.scene, &check.replaced)?;
    let model = build(&scene, check.threads.into())?;
    let mut text = format!("{}\n{}", scene.title, described(&model));
    let loads = model.description.resultants.as_ref();
    text.push_str(&loads.map_or(String::new(), |loads| resultants(loads, &scene.units)));
    let particles = model.describe().particles;
    let memory = model.memory;
    let free =
        memory.available.map_or(String::new(), |free| format!(", of {:.0} MB that are free", 1e-6 * free));
    let time = scene.units.symbol(Quantity::Time);
    text.push_str(&warned(model.warnings()));
    text.push_str(&cost(&model.estimate(), particles, &time));
    text.push_str(&format!("  {:<24} about {:.0} MB{free}\n", "memory of a run", 1e-6 * memory.needed));
    print(&text)?;
    match check.accuracy {
        Some(wanted) => {
            accuracy::carry_out(&scene, wanted, check.within, check.threads.into(), check.chart.as_deref())
        }
        None => Ok(()),
    }
}

fn described(model: &Model) -> String {
    let about = model.describe();
    let mut text = format!(
        "\n  particles                {}\n  points                   {}\n  degrees of freedom       {}\n",
        about.particles, about.points, about.dof
    );
    for (heading, lines) in [("modelled", &about.modelled), ("left out", &about.left_out)] {
        text.push_str(&format!("\n{heading}\n"));
        lines.iter().for_each(|line| text.push_str(&format!("  {line}\n")));
    }
    text
}

/// What the loads amount to at level one, and the side of the normals.
fn resultants(loads: &LoadResultants, units: &Units) -> String {
    let vector = |v: [f64; 3]| format!("[{}]", v.map(number).join(", "));
    let unit = |quantity| units.symbol(quantity);
    let [length, force, moment] = [Quantity::Length, Quantity::Force, Quantity::Energy].map(unit);
    let mut text = format!(
        "\nloads at level one, moments about the centroid {} {length}\n  normals: {}\n",
        vector(loads.about),
        loads.normals
    );
    for (name, found) in &loads.loads {
        let [f, m] = [found.force, found.moment].map(vector);
        text.push_str(&format!("  {name}: force {f} {force}, moment {m} {moment}\n"));
    }
    text
}

/// A number to five digits; round-off of what cancels is reported as it is.
fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        1e-3..1e6 => {
            let digits = (4 - libm::log10(x.abs()).floor() as i32).max(0) as usize;
            let text = format!("{x:.digits$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
        }
        _ => format!("{x:.4e}"),
    }
}

/// What is doubtful, under a heading of its own; nothing if nothing is.
fn warned(warnings: &[Warning]) -> String {
    if warnings.is_empty() {
        return String::new();
    }
    let line = |warning: &Warning| format!("  {}: {}\n", warning.kind.word(), warning.message);
    format!("\nwarnings\n{}", warnings.iter().map(line).collect::<String>())
}

fn cost(estimate: &Estimate, particles: usize, time: &str) -> String {
    let mut text = String::from("\nwhat a run will cost\n");
    let mut line = |word: &str, value: String| text.push_str(&format!("  {word:<24} {value}\n"));
    let marched = estimate.stable_step > 0.0;
    if marched {
        line("stable step", format!("{:.3e} {time}", estimate.stable_step));
        let rate = particles as f64 / estimate.seconds_a_step;
        line("speed", format!("{:.1} million particle-steps/s, timed just now at rest", 1e-6 * rate));
    } else {
        line("one factorisation", format!("{:.2e} s, timed just now", estimate.seconds_a_step));
    }
    let word = if marched { "steps" } else { "factorisations" };
    match estimate.steps {
        Some([least, most]) => {
            line(word, range(format!("{least:.0}"), format!("{most:.0}")));
        }
        None => line(word, "as the path will have it".into()),
    }
    if let Some([least, most]) = estimate.solves {
        line("solves", range(format!("{least:.0}"), format!("{most:.0}")));
    }
    if let Some([least, most]) = estimate.seconds.map(|seconds| seconds.map(clock)) {
        line("wall time", range(least, most));
    }
    line("memory of a step", format!("{:.1} MB", 1e-6 * estimate.bytes));
    text
}

fn range(least: String, most: String) -> String {
    if least == most { format!("about {least}") } else { format!("{least} to {most}") }
}
