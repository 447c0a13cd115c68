//! `coque sweep`: runs a scene for every combination of values, several at a time, one table out.

mod combinations;
mod parts;
mod table;

use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;

use combinations::combinations;
use parts::{Only, Part};
use table::{Row, write_table};

use crate::{
    Curve, Ended, FieldFiles, FieldSink, GrowingCurve, Model, Outcome, Progress, ProgressReport,
    ResultFolder, RunOptions, Scene, read_text, write_whole,
};
use clap::Args;

use super::run::{replacement, take};
use super::stderr::{Refused, say};
use super::stop::Stop;
use super::{BAD_INPUT, DIVERGED, DONE, INTERRUPTED, NOT_SETTLED};

#[derive(Args)]
pub struct Sweep {
    /// The scene, a TOML file.
    #[arg(required_unless_present = "collect")]
    scene: Option<PathBuf>,
    /// A value of the scene and what to replace it by in turn; given several times, every combination is run.
    #[arg(long, value_name = "PATH=V1,V2,…", value_parser = replacement, required_unless_present = "collect")]
    over: Vec<(String, String)>,
    /// Replace a value in all runs.
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = replacement)]
    replaced: Vec<(String, String)>,
    /// Runs at a time, one thread each.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: u16,
    /// Folder for the results [default: out/<name of the scene>-sweep].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Run one part of N alone: the runs whose numbers leave K over N, for one of N jobs of a cluster into one folder.
    #[arg(long, value_name = "K/N")]
    only: Option<Only>,
    /// Make sweep.csv of the parts in a folder, and run nothing.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["scene", "over", "replaced", "out", "only", "jobs"])]
    collect: Option<PathBuf>,
}

pub const HELP: &str = "\
Examples:
  coque sweep scenes/ring.toml --over section.homogeneous.thickness=0.5,1,2 --jobs 2
  coque sweep scenes/panel.toml --over 'geometry.cylinder.particles=[11, 11],[21, 21]' --over formulation.nodal.order=1,2

  coque sweep scenes/ring.toml --over section.homogeneous.thickness=0.5,1,2 --out out/all --only 2/3     on one machine of three
  coque sweep --collect out/all                                                                         then, on any of them

Values are TOML; commas within brackets and quotes belong to the value.

Results, in DIR:
  sweep.csv      a row per run: its number, the values, how it ended, words of its warnings (such as not-settled),
                 wall time, and the last row of its curve; of modes, load cases and combinations a row each
  001/curve.csv  the curve of each run, by number
  001/fields/    with [output.fields]: the frames of each run, shell.pvd for ParaView
  part-2-of-3.json   with --only, in place of sweep.csv: the rows of its runs

A run that is refused or diverges does not stop the others. Ctrl-C ends all of them in good order.
Exit codes: 0 all done, 2 bad input, 3 one refused or diverged, 4 all done but one did not settle, 130 interrupted.";

/// Column of a curve whose rows are modes.
const MODE: &str = "mode";

/// Runs all combinations, or a part of them; the table is written whatever becomes of them.
pub fn carry_out(sweep: &Sweep, stop: &Arc<Stop>) -> Result<u8, Refused> {
    if let Some(folder) = &sweep.collect {
        let (over, runs, rows) = parts::collect(folder)?;
        return report(folder, &over, &runs, &rows, false);
    }
    let Some(path) = &sweep.scene else { return Ok(BAD_INPUT) };
    let file = path.display().to_string();
    let text = read_text(path).map_err(|e| format!("cannot read {file}: {e}\n"))?;
    let runs = combinations(&sweep.over)?;
    let all: Vec<_> = runs.iter().map(|values| [&sweep.replaced[..], values].concat()).collect();
    let text = Scene::whole_text_of(&text, &file, &all).map_err(|e| Refused::scene(&e))?;
    let stem = path.file_stem().unwrap_or("scene".as_ref()).to_string_lossy();
    let out = sweep.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{stem}-sweep")));
    let scene = Scene::with_overrides(&text, &file, &sweep.replaced);
    if scene.is_ok_and(|scene| scene.error.is_some()) {
        say(
            "warning: a sweep finds no errors, and [error] is left out; run what counts by `coque run --error`",
        );
    }
    let own: Vec<usize> =
        (0..runs.len()).filter(|&number| sweep.only.is_none_or(|only| only.has(number))).collect();
    // Parts share a folder, and each run has its own.
    let folder = if sweep.only.is_none() { Some(take(&out)?) } else { None };
    stop.begin();
    if let Some(folder) = &folder {
        folder.clear()?;
        clear_runs(&out)?;
        parts::clear(&out)?;
    }
    let next = AtomicUsize::new(0);
    let rows: Mutex<Vec<Option<Row>>> = Mutex::new(runs.iter().map(|_| None).collect());
    let work = || {
        loop {
            if stop.asked() {
                return;
            }
            let Some(&number) = own.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
            let values = &runs[number];
            let row = one(&text, &file, &all[number], &out.join(format!("{:03}", number + 1)), stop);
            let named: Vec<String> = values.iter().map(|(path, value)| format!("{path}={value}")).collect();
            let (count, named) = (runs.len(), named.join(" "));
            for warning in &row.warnings {
                say(&format!("[{}/{count}] warning: {}", number + 1, warning.message));
            }
            let warnings =
                if row.warnings.is_empty() { String::new() } else { format!(", {}", row.warnings()) };
            say(&format!("[{}/{count}] {named}: {}{warnings} ({:.1} s)", number + 1, row.ended, row.seconds));
            // A poisoned lock means that another run panicked; what it left is whole rows.
            rows.lock().unwrap_or_else(|poisoned| poisoned.into_inner())[number] = Some(row);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..usize::from(sweep.jobs).min(own.len()) {
            scope.spawn(work);
        }
    });
    let rows = rows.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    let Some(only) = sweep.only else { return report(&out, &sweep.over, &runs, &rows, stop.asked()) };
    let rows = rows.into_iter().enumerate().filter_map(|(number, row)| Some((number, row?))).collect();
    let part = Part { only, text, over: sweep.over.clone(), replaced: sweep.replaced.clone(), rows };
    let file = part.write(&out)?;
    let done: Vec<u8> = part.rows.iter().map(|(_, row)| row.code).collect();
    let finished = done.iter().filter(|code| [DONE, NOT_SETTLED].contains(code)).count();
    say(&format!("{finished} of {} runs done; they are in {}", own.len(), file.display()));
    Ok(code_of(own.len(), &done, stop.asked()))
}

/// Writes the table and tells what became of all runs.
fn report(
    out: &Path,
    over: &[(String, String)],
    runs: &[combinations::Values],
    rows: &[Option<Row>],
    interrupted: bool,
) -> Result<u8, Refused> {
    let table = out.join(ResultFolder::TABLE);
    write_whole(&table, |to| write_table(to, over, runs, rows))
        .map_err(|e| format!("cannot write {}: {e}\n", table.display()))?;
    let codes: Vec<u8> = rows.iter().flatten().map(|row| row.code).collect();
    let unsettled = codes.iter().filter(|&&code| code == NOT_SETTLED).count();
    let done = codes.iter().filter(|&&code| code == DONE).count() + unsettled;
    say(&format!("{done} of {} runs done; the table is {}", runs.len(), table.display()));
    if unsettled > 0 {
        say(&format!("not settled: {unsettled} of them"));
    }
    Ok(code_of(runs.len(), &codes, interrupted))
}

/// The exit code of so many runs, by those of the runs that were made.
fn code_of(runs: usize, codes: &[u8], interrupted: bool) -> u8 {
    let unsettled = codes.contains(&NOT_SETTLED);
    let done = codes.iter().filter(|&code| [DONE, NOT_SETTLED].contains(code)).count();
    match () {
        () if interrupted => INTERRUPTED,
        () if done < runs => DIVERGED,
        () if unsettled => NOT_SETTLED,
        () => DONE,
    }
}

/// One run; whatever happens becomes a row.
fn one(text: &str, file: &str, replaced: &[(String, String)], out: &Path, stop: &Stop) -> Row {
    let begun = Instant::now();
    let model = Scene::with_overrides(text, file, replaced).and_then(|scene| scene.build(1));
    let refused = |ended: String| Row {
        ended,
        code: BAD_INPUT,
        seconds: 0.0,
        columns: vec![],
        found: vec![],
        warnings: vec![],
    };
    let outcome = match model {
        Ok(model) => run(model, out, stop),
        Err(error) => return refused(format!("refused: {error}")),
    };
    let outcome = match outcome {
        Ok(outcome) => outcome,
        Err(error) => return refused(error),
    };
    let code = match outcome.ended {
        Ended::Done if outcome.summary.record.falls_short().is_some() => NOT_SETTLED,
        Ended::Done => DONE,
        Ended::Diverged(ref failure) if failure.is_input() => BAD_INPUT,
        Ended::Diverged(_) => DIVERGED,
        Ended::Interrupted { .. } => INTERRUPTED,
    };
    let Curve { columns, rows } = outcome.curve;
    let each = outcome.summary.cases.is_some() || columns.iter().any(|column| column.name == MODE);
    let first = if each { 0 } else { rows.len().saturating_sub(1) };
    let shown = |row: &Vec<f64>| row.iter().map(|value| format!("{value:?}")).collect();
    let found = rows[first..].iter().map(shown).collect();
    let seconds = begun.elapsed().as_secs_f64();
    let (ended, warnings) = (outcome.ended.to_string(), outcome.summary.record.warnings);
    Row { ended, code, seconds, columns, found, warnings }
}

/// Takes out what an earlier sweep left in its numbered folders, of which it may have had more.
fn clear_runs(out: &Path) -> Result<(), String> {
    let entries = fs::read_dir(out).map_err(|e| format!("cannot read {}: {e}\n", out.display()))?;
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.len() < 3 || !name.bytes().all(|c| c.is_ascii_digit()) {
            continue;
        }
        if entry.path().is_symlink() {
            let shown = entry.path().display().to_string();
            return Err(format!(
                "{shown} is a link, and nothing is written outside the folder of the sweep; \
                 remove it, or name another folder with --out\n"
            ));
        }
        if entry.path().is_dir() {
            take(&entry.path())?.clear()?;
            // What else is there keeps it.
            let _ = fs::remove_dir(entry.path());
        }
    }
    Ok(())
}

/// Runs a model; its curve and its frames go into its folder.
fn run(model: Model, out: &Path, stop: &Stop) -> Result<Outcome, String> {
    let folder = take(out)?;
    let mut files = FieldFiles::of_run(&model, out, 0).map_err(|error| error.to_string())?;
    let options = RunOptions {
        progress: &mut Watch { stop, curve: GrowingCurve::new(&out.join(ResultFolder::CURVE)) },
        checkpoints: None,
        fields: files.as_mut().map(|files| files as &mut dyn FieldSink),
        from: None,
    };
    let outcome = model.run_with(options).map_err(|error| error.to_string())?;
    let file = folder.path().join(ResultFolder::CURVE);
    write_whole(&file, |to| outcome.curve.write_csv(to))
        .map_err(|error| format!("cannot write {}: {error}", file.display()))?;
    Ok(outcome)
}

/// Ends a run when that is asked for, and puts its curve on the disk row by row.
struct Watch<'a> {
    stop: &'a Stop,
    curve: GrowingCurve,
}

impl Progress for Watch<'_> {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        if self.stop.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    fn recorded(&mut self, curve: &Curve) {
        // Rows that find no room now may do so at the end, whose fault is reported.
        let _ = self.curve.take(curve);
    }
}
