//! `coque run`: a scene, its run, its results; what building, running and reporting have in common for all commands.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;

use super::accurate::{Wanted, forecast, refine};
use super::bar::Bar;
use super::company::Company;
use super::errors;
use super::stderr::{Refused, say};
use super::stop::Stop;
use super::view::Follower;
use super::{BAD_INPUT, DIVERGED, DONE, INTERRUPTED, NOT_SETTLED};
use crate::{
    Checked, Checkpoint, Ended, GrowingCurve, Model, OneProcess, Origin, Outcome, Progress, ProgressReport,
    ResultFolder, RunOptions, Scene, Warning, read_text,
};

#[derive(Args)]
pub struct Run {
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
    /// Give every number its error: the run is followed by runs on coarser lattices, which take about half as long, or finer ones.
    #[arg(long)]
    error: bool,
    /// Run on the lattice that brings every measured number within this share of the greatest of its column, such as 0.5%: it is forecast from
    /// coarse lattices, its price is said, and it is refined once more if the bars are wider.
    #[arg(long, value_name = "SHARE", value_parser = super::accuracy::share)]
    accuracy: Option<f64>,
    /// Draw the errors of the measured numbers over the time that each lattice took into this file, SVG; asks for errors.
    #[arg(long, value_name = "FILE")]
    chart: Option<PathBuf>,
    /// Show the run in the browser, on the way and at its end; a scene without [output.fields] gets them, with stresses.
    #[arg(long)]
    view: bool,
}

impl Run {
    /// A run with nothing replaced, shown in the browser.
    pub fn shown(scene: PathBuf) -> Self {
        Self {
            scene,
            out: None,
            threads: 1,
            replaced: Vec::new(),
            error: false,
            accuracy: None,
            chart: None,
            view: true,
        }
    }
}

pub const HELP: &str = "\
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
  coque run scenes/ring.toml --set analysis.static.levels=8 --error  each number with its error
  coque run scenes/scordelis-lo.toml --error --chart roof.svg        the error of each number over the time that it takes
  coque run scenes/scordelis-lo.toml --accuracy 0.5%                 on the lattice that takes, price first
  coque run scenes/panel.toml --set 'analysis.arc-length.stop={ column = \"w_crown\", above = 30 }'

Results, in DIR:
  curve.csv      one row per load level or record; the first row names columns with units; with --error or [error] a column `NAME ±` beside each
  curve.svg      the plot that [output] asks for
  fields/        with [output.fields]: shell.pvd and, extruded, solid.pvd for ParaView; of a solid solid.pvd; written on the way;
                 sets.json has particles by the name of their set
  cases.csv      with load cases: their rows by name, with the least and greatest of each column and where it is met
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

pub fn replacement(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((path, value)) if !path.trim().is_empty() => Ok((path.trim().into(), value.trim().into())),
        _ => Err("write path.to.key=value, such as material.elastic.young=2.1e11".into()),
    }
}

/// Reads, builds, runs, writes; the error is ready to print. Of several processes each does all of it but write.
pub fn carry_out(run: &Run, stop: &Arc<Stop>, company: &Company) -> Result<u8, Refused> {
    let out = run.out.clone().unwrap_or_else(|| default_out(&run.scene));
    let read = scene_of(run);
    let Some(accuracy) = run.accuracy else {
        let prepared = read.and_then(|(scene, text, replaced)| {
            let model = build(&scene, run.threads.into())?;
            let folder = company.is_first().then(|| take(&out)).transpose()?;
            Ok((model, folder, text, replaced))
        });
        let (mut model, folder, text, replaced) = company.all(prepared)?;
        let scene = format!("{text}{replaced:?}");
        company.same(crc32fast::hash(scene.as_bytes()), "scene")?;
        company.share(&mut model)?;
        stop.begin();
        let measured = model.measured();
        let (code, outcome) = begin(run, model, folder.as_ref(), (text, replaced), stop, company)?;
        return draw(run, &outcome, &measured).map(|()| code);
    };
    if let Some(ranks) = company.ranks() {
        return Err(format!("{}\n", OneProcess::Errors { started: ranks.number() }).into());
    }
    let (scene, _, replaced) = read?;
    let mut wanted = forecast(&scene, accuracy, run.threads.into())?;
    let folder = take(&out)?;
    stop.begin();
    loop {
        let Wanted { lattice, again } = wanted;
        let mut replaced = replaced.clone();
        replaced.extend(lattice);
        let (scene, text) = read_scene(&run.scene, &replaced)?;
        let model = build(&scene, run.threads.into())?;
        let measured = model.measured();
        let (code, outcome) = begin(run, model, Some(&folder), (text, replaced), stop, company)?;
        let next = again.then(|| refine(&scene, &outcome, &measured, accuracy, folder.path())).flatten();
        match next.filter(|_| code == DONE && !stop.asked()) {
            Some(next) => wanted = next,
            None => return draw(run, &outcome, &measured).map(|()| code),
        }
    }
}

/// Paths and the values put there.
type Replaced = Vec<(String, String)>;

/// The scene with what the options replace, its text, and that.
fn scene_of(run: &Run) -> Result<(Checked, String, Replaced), Refused> {
    let mut replaced = run.replaced.clone();
    let (mut scene, text) = read_scene(&run.scene, &replaced)?;
    if run.view && scene.output.fields.is_none() {
        replaced.push(("output.fields".into(), "{ stresses = true }".into()));
        (scene, _) = read_scene(&run.scene, &replaced)?;
    }
    if (run.error || run.accuracy.is_some() || run.chart.is_some()) && scene.error.is_none() {
        replaced.push(("error".into(), "{}".into()));
        (scene, _) = read_scene(&run.scene, &replaced)?;
    }
    Ok((scene, text, replaced))
}

/// Draws the errors over the times of the lattices, if that is asked for.
fn draw(run: &Run, outcome: &Outcome, measured: &[String]) -> Result<(), Refused> {
    let (Some(file), Some(errors)) = (&run.chart, &outcome.summary.errors) else { return Ok(()) };
    errors::chart(errors, measured, &outcome.summary.title, file)
}

/// Runs a model that was built of a scene with values replaced, into its folder, if this process has one.
fn begin(
    run: &Run,
    model: Model,
    folder: Option<&ResultFolder>,
    (text, replaced): (String, Replaced),
    stop: &Arc<Stop>,
    company: &Company<'_>,
) -> Result<(u8, Outcome), Refused> {
    let begun = folder.map_or(Ok(text.clone()), |folder| folder.begin(&run.scene, text, &replaced));
    let text = company.all(begun.map_err(Refused::from))?;
    // Another folder may be the present one when the run goes on.
    let file = std::path::absolute(&run.scene).unwrap_or_else(|_| run.scene.clone());
    let file = file.display().to_string();
    let origin = Origin::new(&text, file, replaced, run.threads.into());
    let follower = folder.filter(|_| run.view).map(|folder| Follower::begin(folder.path()));
    let ended = launch(model, folder, origin, None, stop, company);
    let shown = follower.map_or(Ok(()), Follower::end);
    let ended = ended?;
    shown?;
    Ok(ended)
}

/// Reads a scene, and its text with what it includes; errors underline it.
pub fn read_scene(path: &Path, replaced: &[(String, String)]) -> Result<(Checked, String), Refused> {
    let file = path.display().to_string();
    let repair = || super::examples::suggestion(path).map_or_else(String::new, |words| format!("; {words}"));
    let text = read_text(path).map_err(|e| format!("cannot read {file}: {e}{}\n", repair()))?;
    let scene = Scene::with_overrides(&text, &file, replaced).map_err(|e| Refused::scene(&e))?;
    let text = Scene::whole_text(&text, &file, replaced).map_err(|e| Refused::scene(&e))?;
    Ok((scene, text))
}

pub fn build(scene: &Checked, threads: usize) -> Result<Model, Refused> {
    let model = scene.build(threads).map_err(|e| Refused::scene(&e))?;
    if let Some(warning) = model.memory.warning() {
        say(&format!("warning: {warning}"));
    }
    Ok(model)
}

/// Runs from the start or from a checkpoint, writes the results, and gives the exit code with what was found. Those who run it together
/// write nothing but the first.
pub fn launch(
    model: Model,
    folder: Option<&ResultFolder>,
    origin: Origin,
    from: Option<Checkpoint>,
    stop: &Arc<Stop>,
    company: &Company<'_>,
) -> Result<(u8, Outcome), Refused> {
    let Some(folder) = folder else { return follow(model, from, stop) };
    let out = folder.path();
    let described = model.describe();
    let together =
        company.ranks().map_or_else(String::new, |ranks| format!(", {} processes", ranks.number()));
    say(&format!(
        "{}: {} particles, {} degrees of freedom{together}",
        model.task.title, described.particles, described.dof
    ));
    let early = model.warnings().to_vec();
    let measured = model.measured();
    early.iter().for_each(|warning| say(&format!("warning: {}", warning.message)));
    let curve = GrowingCurve::new(&out.join(ResultFolder::CURVE));
    let mut bar = Bar::new(described.particles, stop.clone(), curve);
    let kept = company.sure(model.run_into(folder, origin, from, &mut bar, None))?;
    bar.finish();
    let code = report(&kept.outcome, &early, out, kept.resumable);
    errors::report(&kept.outcome, &measured);
    kept.written?;
    Ok((code, kept.outcome))
}

/// Runs it with the process that speaks and writes.
fn follow(model: Model, from: Option<Checkpoint>, stop: &Arc<Stop>) -> Result<(u8, Outcome), Refused> {
    let mut progress = Follow(stop.clone());
    let options = RunOptions { progress: &mut progress, checkpoints: None, fields: None, from };
    let outcome = model.run_with(options).map_err(|error| format!("{error}\n"))?;
    Ok((DONE, outcome))
}

/// Ends the run when that is asked of this process.
struct Follow(Arc<Stop>);

impl Progress for Follow {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        if self.0.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// Takes the folder of a run for this program.
pub fn take(path: &Path) -> Result<ResultFolder, String> {
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
    for line in summary.vibration.iter().flat_map(|found| found.lines()) {
        say(&line);
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
