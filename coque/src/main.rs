//! The command `coque`: runs a scene and writes its results.

mod commands {
    pub mod plot;
}

use std::fs;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Parser, Subcommand};
use coque::{Ended, Failure, FieldFiles, Outcome, Progress, Rendering, Scene, render};
use indicatif::{ProgressBar, ProgressStyle};

const DONE: u8 = 0;
const BAD_INPUT: u8 = 2;
const DIVERGED: u8 = 3;

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
    #[command(after_help = MESH_HELP)]
    Mesh(Mesh),
    /// Draw the last frame of a run with [output.fields] as SVG.
    Plot(commands::plot::Plot),
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

#[derive(Args)]
struct Mesh {
    /// The file: .msh (Gmsh 2.2, 4.1 ASCII), .inp (Abaqus), .stl, .obj, .vtu, or .csv (points).
    file: PathBuf,
}

const START: &str = "\
Start here:
  coque run scenes/ring.toml        results in out/ring
  coque plot out/ring               the deformed shape, if the scene has [output.fields]
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
  coque run scenes/panel.toml --set 'analysis.arc-length.stop={ column = \"w_crown\", above = 30 }'

Results, in DIR:
  curve.csv      one row per load level or record; the first row names columns with units
  curve.svg      the plot that [output] asks for
  fields/        with [output.fields]: shell.pvd and, extruded, solid.pvd for ParaView; written on the way
  summary.json   method, particles, steps, speed, energies, how each level ended, critical points

Exit codes: 0 done, 2 bad input or no room on the disk, 3 diverged (the curve so far is kept), 130 interrupted.";

const MESH_HELP: &str = "\
Examples:
  coque mesh panel.msh
  coque mesh hull.inp

In a scene, beside it:
  [geometry.mesh]
  file = \"panel.msh\"     # relative to the scene
  scale = 0.001           # lengths of the file times this; 1 without
  flip = true             # normals to the other side; false without

Sets for supports, loads and curves: `all`, the groups of the file by their names, the boundary loops
`boundary0`, `boundary1`, ... (the longest first), and what the scene declares:
  [sets]
  crown = { nearest = [0.0, 0.0, 2540.0] }
  end = { plane = { point = [254.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] } }
  foot = { box = { min = [0.0, 0.0, 0.0], max = [1.0, 9.0, 0.1] } }
A force on a set along the boundary is shared by length, a couple wants one such line.

Where sets and normals come from:
  .msh  physical groups; a view of three components called normals
  .inp  *Nset and *Elset; direction cosines after the coordinates of a *Node
  .stl  solids, if there are several; vertices that coincide are merged
  .obj  groups and objects; vn
  .vtu  point data of whole numbers 0 and 1; point data Normals
  .csv  points with columns x,y,z,nx,ny,nz,area[,thickness], for formulation.nodal alone
Other formats: `meshio convert FILE surface.vtu --ascii`.

Exit codes: 0 sound, 2 refused.";

fn replacement(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() => Ok((path.trim().into(), value.trim().into())),
        _ => Err("write path.to.key=value, such as material.elastic.young=2.1e11".into()),
    }
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Run(run) => carry_out(&run),
        Command::Mesh(mesh) => look(&mesh.file),
        Command::Plot(plot) => commands::plot::carry_out(&plot).map(|()| DONE),
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
    let file = run.scene.display().to_string();
    let text = fs::read_to_string(&run.scene).map_err(|e| format!("cannot read {file}: {e}\n"))?;
    let how = Rendering { width: 100, colour: io::stderr().is_terminal() };
    let scene = Scene::with_overrides(&text, &file, &run.replaced).map_err(|e| render(&e, how))?;
    let model = scene.build(run.threads.into()).map_err(|e| render(&e, how))?;
    let out = run.out.clone().unwrap_or_else(|| default_out(&run.scene));
    fs::create_dir_all(&out).map_err(|e| format!("cannot create {}: {e}\n", out.display()))?;
    let described = model.describe();
    eprintln!("{}: {} particles, {} freedoms", scene.title, described.particles, described.freedoms);
    let mut bar = Bar::new();
    let outcome = match &scene.output.fields {
        None => model.run(&mut bar),
        Some(wanted) => {
            let mut files = FieldFiles::create(&out.join("fields"), wanted).map_err(|e| format!("{e}\n"))?;
            model.run_with_fields(&mut bar, &mut files)
        }
    };
    bar.0.finish_and_clear();
    write_results(&scene, &outcome, &out)?;
    Ok(report(&outcome, &out))
}

/// Reads a surface and prints what was found.
fn look(file: &Path) -> Result<u8, String> {
    let text = coque::mesh::read(file).and_then(|surface| coque::mesh::report(&surface));
    let text = text.map_err(|error| format!("{error}\n"))?;
    io::stdout().write_all(text.as_bytes()).map_err(|error| format!("cannot print: {error}\n"))?;
    Ok(DONE)
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
fn report(outcome: &Outcome, out: &Path) -> u8 {
    let summary = &outcome.summary;
    for level in summary.levels.iter().filter(|level| !level.settled) {
        eprintln!(
            "warning: level {} did not settle (kinetic/internal energy {:.1e}); lengthen `hold` or shorten the step between levels",
            level.level, level.kinetic_over_internal
        );
    }
    for critical in &summary.critical {
        eprintln!("{} at load level {}", critical.kind, critical.level);
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
            if matches!(error, Failure::Fields(_)) { BAD_INPUT } else { DIVERGED }
        }
    }
}

/// Progress on a terminal; hidden elsewhere.
struct Bar(ProgressBar);

impl Bar {
    fn new() -> Self {
        let bar = if io::stderr().is_terminal() { ProgressBar::new(1000) } else { ProgressBar::hidden() };
        if let Ok(style) =
            ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {elapsed} of {duration}")
        {
            bar.set_style(style);
        }
        Self(bar)
    }
}

impl Progress for Bar {
    fn update(&mut self, done: f64, record: &explicit_dynamics::Record) {
        self.0.set_position((1000.0 * done) as u64);
        self.0.set_message(format!("level {:.4}, step {}", record.at.level, record.step));
    }
}
