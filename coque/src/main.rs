//! The command `coque`: runs a scene and writes its results.

mod commands {
    pub mod bar;
    pub mod check;
    pub mod mesh;
    pub mod plot;
    pub mod resume;
    pub mod sweep;
    pub mod teach;
}

use std::fs;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use commands::bar::{Bar, stop_on_interrupt};
use commands::{check, mesh, plot, resume, sweep, teach};
use coque::{
    CHECKPOINT, Checkpoint, Checkpoints, Ended, Failure, FieldError, FieldFiles, FieldSink, Model, Origin,
    Outcome, Rendering, RunOptions, SCENE_COPY, Scene, render,
};

const DONE: u8 = 0;
const BAD_INPUT: u8 = 2;
const DIVERGED: u8 = 3;
const INTERRUPTED: u8 = 130;

/// Simulates thin shells with one layer of SPH particles.
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
    /// Draw the last frame of a run with [output.fields] as SVG.
    Plot(plot::Plot),
    /// Go on with a run that was interrupted or killed, to the same bits.
    #[command(after_help = resume::HELP)]
    Resume(resume::Resume),
    /// Run a scene for a list of values, or for every combination of several; one table out.
    #[command(after_help = sweep::HELP)]
    Sweep(sweep::Sweep),
    /// Write a commented scene to start from.
    #[command(after_help = teach::NEW_HELP)]
    New(teach::New),
    /// Validate a scene; print the model, what it leaves out and what a run will cost.
    #[command(after_help = check::HELP)]
    Check(check::Check),
    /// Print what a scene may name: analyses, formulations, supports, loads, …, a line each.
    #[command(after_help = teach::LIST_HELP)]
    List(teach::List),
    /// Print the JSON schema of scenes, for editors.
    #[command(after_help = teach::SCHEMA_HELP)]
    Schema,
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
}

const START: &str = "\
Start here:
  coque run scenes/ring.toml        results in out/ring
  coque plot out/ring               the deformed shape, if the scene has [output.fields]
  coque new plate                   a commented scene to start from: plate.toml
  coque check plate.toml            what it models, what it leaves out, what a run will cost
  coque list                        what a scene may name
  coque run --help                  options, examples, where results are
  coque mesh panel.msh              what a mesh holds, and what is wrong with it

Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged, 130 interrupted.";

const RUN_HELP: &str = "\
Examples:
  coque run scenes/ring.toml
  coque run scenes/ring.toml --out out/coarse --set 'geometry.plate.particles=[25, 3]'
  coque run scenes/ring.toml --set formulation.nodal.order=2
  coque run scenes/ring.toml --set loads.0.couple.moment=31.4 --threads 2
  coque run scenes/ring.toml --set analysis.static.levels=8          the same without time
  coque run scenes/plate.toml --set analysis.modal.modes=6           frequencies
  coque run scenes/panel.toml --set 'output.fields={ stresses = true }'     then open out/panel/fields/shell.pvd
  coque run scenes/ring.toml --set output.checkpoint_every=60        then `coque resume out/ring` if it was stopped
  coque run scenes/panel.toml --set 'analysis.arc-length.stop={ column = \"w_crown\", above = 30 }'

Results, in DIR:
  curve.csv      one row per load level or record; the first row names columns with units
  curve.svg      the plot that [output] asks for
  fields/        with [output.fields]: shell.pvd and, extruded, solid.pvd for ParaView; written on the way
  summary.json   method, particles, steps, speed, energies, how each level ended, critical points
  scene.toml     a copy of the scene; what --set replaced stands at its end
  checkpoint.bin while the run is under way, if [output] checkpoint_every asks for it

Ctrl-C ends the run in good order, with the results so far; a second one at once.
Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged, 130 interrupted (the curve so far is kept).";

fn replacement(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() => Ok((path.trim().into(), value.trim().into())),
        _ => Err("write path.to.key=value, such as material.elastic.young=2.1e11".into()),
    }
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Run(run) => carry_out(&run),
        Command::Mesh(mesh) => mesh::carry_out(&mesh).map(|()| DONE),
        Command::Plot(plot) => plot::carry_out(&plot).map(|()| DONE),
        Command::Resume(resume) => resume::carry_out(&resume),
        Command::Sweep(sweep) => sweep::carry_out(&sweep),
        Command::New(new) => teach::new(&new).map(|()| DONE),
        Command::Check(check) => check::carry_out(&check).map(|()| DONE),
        Command::List(list) => teach::list(&list).map(|()| DONE),
        Command::Schema => teach::schema().map(|()| DONE),
    };
    match done {
        Ok(code) => ExitCode::from(code),
        Err(message) => {
            eprint!("{message}");
            ExitCode::from(BAD_INPUT)
        }
    }
}

/// Reads, builds, runs, writes; the error is ready to print.
fn carry_out(run: &Run) -> Result<u8, String> {
    let (scene, text) = read_scene(&run.scene, &run.replaced)?;
    let model = build(&scene, run.threads.into())?;
    let out = run.out.clone().unwrap_or_else(|| default_out(&run.scene));
    let text = make_folder(&out, &run.scene, text, &run.replaced)?;
    // Another folder may be the present one when the run goes on.
    let file = std::path::absolute(&run.scene).unwrap_or_else(|_| run.scene.clone());
    let file = file.display().to_string();
    launch(model, &out, Origin::new(&text, file, run.replaced.clone(), run.threads.into()), None)
}

/// Reads a scene, and its text; errors underline it.
fn read_scene(path: &Path, replaced: &[(String, String)]) -> Result<(Scene, String), String> {
    let file = path.display().to_string();
    let text = fs::read_to_string(path).map_err(|e| format!("cannot read {file}: {e}\n"))?;
    let scene = Scene::with_overrides(&text, &file, replaced).map_err(|e| render(&e, rendering()))?;
    Ok((scene, text))
}

fn build(scene: &Scene, threads: usize) -> Result<Model, String> {
    scene.build(threads).map_err(|e| render(&e, rendering()))
}

fn rendering() -> Rendering {
    Rendering { width: 100, colour: io::stderr().is_terminal() }
}

/// Makes the folder and copies the scene into it; gives the text of the copy, which names what was replaced at its end.
///
/// What an earlier run left there and might be taken for this one's is taken out.
fn make_folder(
    out: &Path,
    scene: &Path,
    mut text: String,
    replaced: &[(String, String)],
) -> Result<String, String> {
    fs::create_dir_all(out).map_err(|e| format!("cannot create {}: {e}\n", out.display()))?;
    let copy = out.join(SCENE_COPY);
    let same = |a: &Path, b: &Path| a.canonicalize().is_ok_and(|a| b.canonicalize().is_ok_and(|b| a == b));
    if !same(&copy, scene) {
        for (path, value) in replaced {
            let shown = format!("{path}={value}").replace(char::is_control, " ");
            text.push_str(&format!("\n# --set '{shown}'\n"));
        }
        fs::write(&copy, &text).map_err(|e| format!("cannot write {}: {e}\n", copy.display()))?;
    }
    for stale in [CHECKPOINT, "summary.json"].map(|name| out.join(name)).iter().filter(|file| file.exists()) {
        fs::remove_file(stale).map_err(|e| format!("cannot remove {}: {e}\n", stale.display()))?;
    }
    Ok(text)
}

/// Runs from the start or from a checkpoint, writes the results, and gives the exit code.
fn launch(model: Model, out: &Path, origin: Origin, from: Option<Checkpoint>) -> Result<u8, String> {
    let scene = model.scene.clone();
    let described = model.describe();
    eprintln!("{}: {} particles, {} freedoms", scene.title, described.particles, described.freedoms);
    let replaced = origin.replaced.clone();
    let mut checkpoints = scene.output.checkpoint_every.map(|every| Checkpoints::new(out, origin, every));
    let mut files = fields(&scene, out, from.as_ref()).map_err(|e| format!("{e}\n"))?;
    let mut bar = Bar::new(described.particles, stop_on_interrupt()?);
    let options = RunOptions {
        progress: &mut bar,
        checkpoints: checkpoints.as_mut(),
        fields: files.as_mut().map(|files| files as &mut dyn FieldSink),
        from,
    };
    let mut outcome = model.run_with(options).map_err(|e| format!("{e}\n"))?;
    bar.finish();
    outcome.summary.replaced = replaced.into_iter().map(|(path, value)| format!("{path}={value}")).collect();
    write_results(&scene, &outcome, out)?;
    // With more room on the disk a run can go on as well.
    let stopped = matches!(outcome.ended, Ended::Interrupted { .. } | Ended::Diverged(Failure::Fields(_)));
    let resumable = stopped && checkpoints.is_some();
    if !resumable && let Some(checkpoints) = checkpoints {
        checkpoints.finish().map_err(|e| format!("{e}\n"))?;
    }
    Ok(report(&outcome, out, resumable))
}

/// The files of the frames, if the scene asks for any: none yet, or those up to the checkpoint.
fn fields(scene: &Scene, out: &Path, from: Option<&Checkpoint>) -> Result<Option<FieldFiles>, FieldError> {
    let Some(wanted) = &scene.output.fields else { return Ok(None) };
    let folder = out.join("fields");
    let files = match from {
        None => FieldFiles::create(&folder, wanted),
        Some(checkpoint) => FieldFiles::go_on(&folder, wanted, checkpoint.frames()),
    };
    files.map(Some)
}

fn default_out(scene: &Path) -> PathBuf {
    Path::new("out").join(scene.file_stem().unwrap_or("scene".as_ref()))
}

fn write_results(scene: &Scene, outcome: &Outcome, out: &Path) -> Result<(), String> {
    let save = |name: &str, write: &dyn Fn(&mut BufWriter<fs::File>) -> io::Result<()>| {
        let path = out.join(name);
        fs::File::create(&path)
            .and_then(|file| {
                let mut to = BufWriter::new(file);
                write(&mut to)?;
                to.flush()
            })
            .map_err(|e| format!("cannot write {}: {e}\n", path.display()))
    };
    save("curve.csv", &|to| outcome.curve.write_csv(to))?;
    save("summary.json", &|to| Ok(serde_json::to_writer_pretty(to, &outcome.summary)?))?;
    // A plot of what probes measure has no place among modes.
    if let Some(plot) = scene.output.plot.as_ref().filter(|_| !scene.analysis.gives_modes()) {
        coque::plot_svg(&outcome.curve, &plot.x, &plot.y, &scene.title, &out.join("curve.svg"))
            .map_err(|e| format!("{e}\n"))?;
    }
    Ok(())
}

/// Tells what came out and gives the exit code.
fn report(outcome: &Outcome, out: &Path, resumable: bool) -> u8 {
    let summary = &outcome.summary;
    for warning in &summary.warnings {
        eprintln!("warning: {}", warning.message);
    }
    for critical in &summary.critical {
        eprintln!("{} at {}", critical.kind, critical.place());
    }
    let effort = match summary.analysis.as_str() {
        "explicit" => format!(", {:.2e} particle-steps/s", summary.particle_steps_per_second),
        "static" | "arc-length" => format!(", {} Newton iterations", summary.newton_iterations),
        _ => String::new(),
    };
    eprintln!(
        "{} steps in {:.2} s{effort}; results in {}",
        summary.steps,
        summary.wall_seconds,
        out.display()
    );
    match &outcome.ended {
        Ended::Done => DONE,
        Ended::Diverged(error) => {
            eprintln!("{error}\nthe curve so far is in {}", out.join("curve.csv").display());
            if resumable {
                eprintln!("go on with: coque resume {}", out.display());
            }
            if matches!(error, Failure::Fields(_)) { BAD_INPUT } else { DIVERGED }
        }
        ended @ Ended::Interrupted { .. } => {
            eprintln!("{ended}; the curve so far is in {}", out.join("curve.csv").display());
            if resumable {
                eprintln!("go on with: coque resume {}", out.display());
            }
            INTERRUPTED
        }
    }
}
