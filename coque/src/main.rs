//! The command `coque`: runs a scene and writes its results.

// A print that fails panics; `commands::say` does not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

mod commands {
    pub mod accuracy;
    pub mod bar;
    pub mod check;
    pub mod folder;
    pub mod frames;
    pub mod mesh;
    pub mod plot;
    pub mod resume;
    pub mod stderr;
    pub mod stop;
    pub mod sweep;
    pub mod templates;
    pub mod view;
}

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::{Args, Parser, Subcommand};
use commands::bar::Bar;
use commands::stderr::{Refused, say};
use commands::stop::{Stop, outlive_file_limits};
use commands::view::Follower;
use commands::{check, mesh, plot, resume, sweep, templates, view};
use coque::{
    Checked, Checkpoint, Ended, GrowingCurve, Model, Origin, Outcome, ResultFolder, Scene, Warning, read_text,
};

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
    #[command(after_help = RUN_HELP)]
    Run(Run),
    /// Read a surface and print what was found: sizes, boundary, sets, quality.
    #[command(after_help = mesh::HELP)]
    Mesh(mesh::Mesh),
    /// Show a run in the browser: shapes that turn, fields, frames, the curve, in one file.
    #[command(after_help = view::HELP)]
    View(view::View),
    /// Draw the last frame of a run with [output.fields] as SVG.
    Plot(plot::Plot),
    /// Go on with a run that was interrupted or killed, to the same bits.
    #[command(after_help = resume::HELP)]
    Resume(resume::Resume),
    /// Run a scene for a list of values, or for every combination of several; one table out.
    #[command(after_help = sweep::HELP)]
    Sweep(sweep::Sweep),
    /// Write a commented scene to start from.
    #[command(after_help = templates::NEW_HELP)]
    New(templates::New),
    /// Validate a scene; print the model, what it leaves out and what a run will cost.
    #[command(after_help = check::HELP)]
    Check(check::Check),
    /// Print what a scene may name: analyses, formulations, supports, loads, …, a line each.
    #[command(after_help = templates::LIST_HELP)]
    List(templates::List),
    /// Print the JSON schema of scenes, for editors.
    #[command(after_help = templates::SCHEMA_HELP)]
    Schema(templates::Schema),
}

#[derive(Args)]
struct Run {
    /// The scene, a TOML file; scenes/ has examples to start from.
    scene: PathBuf,
    /// Folder for the results [default: out/<name of the scene>].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Threads; results are the same for any number.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: u16,
    /// Replace a value of the scene; may be given several times.
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = replacement)]
    replaced: Vec<(String, String)>,
    /// Show the run in the browser, on the way and at its end; a scene without [output.fields] gets them, with stresses.
    #[arg(long)]
    view: bool,
}

const START: &str = "\
Start here:
  coque run scenes/ring.toml --view     results in out/ring, shown in the browser
  coque view out/gate               the same of a run that is there, if its scene has [output.fields]
  coque plot out/gate               its last frame as a picture for a paper
  coque new plate                   a commented scene to start from: plate.toml
  coque check plate.toml            what it models, what it leaves out, what a run will cost
  coque check plate.toml --accuracy 0.5%    which lattice and analysis that takes
  coque list                        what a scene may name
  coque run --help                  options, examples, where results are
  coque mesh panel.msh              what a mesh holds, and what is wrong with it

Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged, 4 done but a level did not settle, 130 interrupted.";

const RUN_HELP: &str = "\
Examples:
  coque run scenes/ring.toml
  coque run scenes/ring.toml --out out/coarse --set 'geometry.plate.particles=[25, 3]'
  coque run scenes/ring.toml --set formulation.nodal.order=2
  coque run scenes/ring.toml --set loads.0.couple.moment=31.4 --threads 2
  coque run scenes/ring.toml --set 'loads[+]={ on = \"u1\", force = { total = [0, 0, 1] } }'     one load more
  coque run scenes/ring.toml --set analysis.static.levels=8          the same without time
  coque run scenes/plate.toml --set analysis.modal.modes=6           frequencies
  coque run scenes/panel.toml --set 'output.fields={ stresses = true }'     then open out/panel/fields/shell.pvd
  coque run scenes/ring.toml --set output.checkpoint_every=60        then `coque resume out/ring` if it was stopped
  coque run scenes/panel.toml --set 'analysis.arc-length.stop={ column = \"w_crown\", above = 30 }'

Results, in DIR:
  curve.csv      one row per load level or record; the first row names columns with units
  curve.svg      the plot that [output] asks for
  fields/        with [output.fields]: shell.pvd and, extruded, solid.pvd for ParaView; of a solid solid.pvd; written on the way;
                 sets.json has particles by the name of their set
  summary.json   method, particles, steps, speed, energies, how each level ended, critical points
  view.html      the run in the browser, with --view or by `coque view DIR`
  scene.toml     a copy of the scene; what --set replaced stands at its end
  checkpoint.bin while the run is under way, if [output] checkpoint_every asks for it

Rows of curve.csv are on the disk as they come, the other files once the run has ended; each replaces the old one whole.
What an earlier run left in DIR under these names is taken out as a run begins; one run at a time holds DIR (coque.lock).
Ctrl-C, SIGTERM or a terminal that goes (not under nohup) end the run in good order, with the results so far; a second
one at once.
A level that was left before the motion had died is no equilibrium: all is written, a warning tells what was missing, and
the last line on stderr is `not settled: ` with the levels. Other warnings are printed as `warning: `; summary.json has
each with a word for scripts.

Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged (the curve so far is kept), 4 done but a level did
not settle, 130 interrupted (the curve so far is kept).";

fn replacement(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() => Ok((path.trim().into(), value.trim().into())),
        _ => Err("write path.to.key=value, such as material.elastic.young=2.1e11".into()),
    }
}

fn main() -> ExitCode {
    // First of all: a signal for which nobody watches ends the program as it stands.
    let stop = Stop::watch();
    outlive_file_limits();
    let command = Cli::parse().command;
    match stop.map_err(Refused::from).and_then(|stop| obey(command, &stop)) {
        Ok(code) => ExitCode::from(code),
        Err(refused) => {
            refused.say();
            ExitCode::from(BAD_INPUT)
        }
    }
}

fn obey(command: Command, stop: &Arc<Stop>) -> Result<u8, Refused> {
    match command {
        Command::Run(run) => carry_out(&run, stop),
        Command::Mesh(mesh) => mesh::carry_out(&mesh).map(|()| DONE),
        Command::View(view) => view::carry_out(&view, stop).map(|()| DONE),
        Command::Plot(plot) => plot::carry_out(&plot).map(|()| DONE),
        Command::Resume(resume) => resume::carry_out(&resume, stop),
        Command::Sweep(sweep) => sweep::carry_out(&sweep, stop),
        Command::New(new) => templates::new(&new).map(|()| DONE),
        Command::Check(check) => check::carry_out(&check).map(|()| DONE),
        Command::List(list) => templates::list(&list).map(|()| DONE),
        Command::Schema(schema) => templates::schema(&schema).map(|()| DONE),
    }
}

/// Reads, builds, runs, writes; the error is ready to print.
fn carry_out(run: &Run, stop: &Arc<Stop>) -> Result<u8, Refused> {
    let mut replaced = run.replaced.clone();
    let (mut scene, text) = read_scene(&run.scene, &replaced)?;
    if run.view && scene.output.fields.is_none() {
        replaced.push(("output.fields".into(), "{ stresses = true }".into()));
        (scene, _) = read_scene(&run.scene, &replaced)?;
    }
    let model = build(&scene, run.threads.into())?;
    let out = run.out.clone().unwrap_or_else(|| default_out(&run.scene));
    let folder = take(&out)?;
    stop.begin();
    let text = folder.begin(&run.scene, text, &replaced)?;
    // Another folder may be the present one when the run goes on.
    let file = std::path::absolute(&run.scene).unwrap_or_else(|_| run.scene.clone());
    let file = file.display().to_string();
    let origin = Origin::new(&text, file, replaced, run.threads.into());
    let follower = run.view.then(|| Follower::begin(&out));
    let code = launch(model, &folder, origin, None, stop);
    let shown = follower.map_or(Ok(()), Follower::end);
    let code = code?;
    shown?;
    Ok(code)
}

/// Reads a scene, and its text; errors underline it.
fn read_scene(path: &Path, replaced: &[(String, String)]) -> Result<(Checked, String), Refused> {
    let file = path.display().to_string();
    let text = read_text(path).map_err(|e| format!("cannot read {file}: {e}\n"))?;
    let scene = Scene::with_overrides(&text, &file, replaced).map_err(|e| Refused::scene(&e))?;
    Ok((scene, text))
}

fn build(scene: &Checked, threads: usize) -> Result<Model, Refused> {
    let model = scene.build(threads).map_err(|e| Refused::scene(&e))?;
    if let Some(warning) = model.memory.warning() {
        say(&format!("warning: {warning}"));
    }
    Ok(model)
}

/// Runs from the start or from a checkpoint, writes the results, and gives the exit code.
fn launch(
    model: Model,
    folder: &ResultFolder,
    origin: Origin,
    from: Option<Checkpoint>,
    stop: &Arc<Stop>,
) -> Result<u8, Refused> {
    let out = folder.path();
    let described = model.describe();
    say(&format!(
        "{}: {} particles, {} degrees of freedom",
        model.task.title, described.particles, described.dof
    ));
    let early = model.warnings().to_vec();
    early.iter().for_each(|warning| say(&format!("warning: {}", warning.message)));
    let curve = GrowingCurve::new(&out.join(ResultFolder::CURVE));
    let mut bar = Bar::new(described.particles, stop.clone(), curve);
    let kept = model.run_into(folder, origin, from, &mut bar, None)?;
    bar.finish();
    let code = report(&kept.outcome, &early, out, kept.resumable);
    kept.written?;
    Ok(code)
}

/// Takes the folder of a run for this program.
fn take(path: &Path) -> Result<ResultFolder, String> {
    let folder = ResultFolder::take(path)?;
    if let Some(warning) = folder.warning() {
        say(&format!("warning: {warning}"));
    }
    Ok(folder)
}

fn default_out(scene: &Path) -> PathBuf {
    Path::new("out").join(scene.file_stem().unwrap_or("scene".as_ref()))
}

/// Tells what came out and gives the exit code; warnings printed early are not repeated.
fn report(outcome: &Outcome, early: &[Warning], out: &Path, resumable: bool) -> u8 {
    let summary = &outcome.summary;
    for warning in summary.record.warnings.iter().filter(|warning| !early.contains(warning)) {
        say(&format!("warning: {}", warning.message));
    }
    if let Some(counted) = summary.record.counted {
        let from = counted.from.map_or("below zero".into(), |from| format!("{from:.4e}"));
        say(&format!(
            "{} modes from {from} to {:.4e} by inertia, all found; {} factorisations, {} solves",
            counted.number, counted.to, counted.factorisations, counted.solves
        ));
    }
    for critical in &summary.record.critical {
        say(&format!("{} at {}", critical.kind, critical.place()));
    }
    let effort = match summary.analysis.as_str() {
        "explicit" => format!(", {:.2e} particle-steps/s", summary.particle_steps_per_second),
        "static" | "arc-length" => format!(", {} Newton iterations", summary.record.newton_iterations),
        _ => summary.record.conjugate_gradients.as_ref().map_or_else(String::new, |took| {
            format!(", {} iterations of conjugate gradients", took.iterations)
        }),
    };
    say(&format!(
        "{} steps in {:.2} s{effort}; results in {}",
        summary.record.steps,
        summary.record.wall_seconds,
        out.display()
    ));
    match &outcome.ended {
        Ended::Done => {
            if resumable {
                say(&format!("with more room: coque resume {}", out.display()));
            }
            let Some(short) = summary.record.falls_short() else { return DONE };
            say(&short);
            NOT_SETTLED
        }
        Ended::Diverged(error) => {
            say(&format!("{error}\nthe curve so far is in {}", out.join("curve.csv").display()));
            if resumable {
                say(&format!("go on with: coque resume {}", out.display()));
            }
            if error.is_input() { BAD_INPUT } else { DIVERGED }
        }
        ended @ Ended::Interrupted { .. } => {
            say(&format!("{ended}; the curve so far is in {}", out.join("curve.csv").display()));
            if resumable {
                say(&format!("go on with: coque resume {}", out.display()));
            }
            INTERRUPTED
        }
    }
}
