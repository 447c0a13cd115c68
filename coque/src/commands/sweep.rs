//! `coque sweep`: runs a scene for every combination of values, several at a time, one table out.

use std::fs;
use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Instant;

use crate::{
    Column, Curve, Ended, FieldFiles, FieldSink, GrowingCurve, Model, Outcome, Progress, ProgressReport,
    ResultFolder, RunOptions, Scene, Warning, read_text, write_whole,
};
use clap::Args;

use super::run::{replacement, take};
use super::stderr::{Refused, say};
use super::stop::Stop;
use super::{BAD_INPUT, DIVERGED, DONE, INTERRUPTED, NOT_SETTLED};

#[derive(Args)]
pub struct Sweep {
    /// The scene, a TOML file.
    scene: PathBuf,
    /// A value of the scene and what to replace it by in turn; given several times, every combination is run.
    #[arg(long, value_name = "PATH=V1,V2,…", value_parser = replacement, required = true)]
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
}

pub const HELP: &str = "\
Examples:
  coque sweep scenes/ring.toml --over section.homogeneous.thickness=0.5,1,2 --jobs 2
  coque sweep scenes/panel.toml --over 'geometry.cylinder.particles=[11, 11],[21, 21]' --over formulation.nodal.order=1,2

Values are TOML; commas within brackets and quotes belong to the value.

Results, in DIR:
  sweep.csv      a row per run: its number, the values, how it ended, words of its warnings (such as not-settled),
                 wall time, and the last row of its curve; of modes a row each
  001/curve.csv  the curve of each run, by number
  001/fields/    with [output.fields]: the frames of each run, shell.pvd for ParaView

A run that is refused or diverges does not stop the others. Ctrl-C ends all of them in good order.
Exit codes: 0 all done, 2 bad input, 3 one refused or diverged, 4 all done but one did not settle, 130 interrupted.";

/// Column of a curve whose rows are modes.
const MODE: &str = "mode";

/// Combinations beyond which a list of values is taken for a mistake.
const MOST_RUNS: usize = 100_000;

/// What became of one run.
struct Row {
    ended: String,
    /// Exit code of such a run.
    code: u8,
    seconds: f64,
    columns: Vec<Column>,
    /// The last row of its curve; all rows where they are modes.
    found: Vec<Vec<f64>>,
    warnings: Vec<Warning>,
}

impl Row {
    /// Words of its warnings, each once.
    fn warnings(&self) -> String {
        let mut words: Vec<&str> = self.warnings.iter().map(|warning| warning.kind.word()).collect();
        words.sort_unstable();
        words.dedup();
        words.join(" ")
    }
}

/// Runs all combinations; the table is written whatever becomes of them.
pub fn carry_out(sweep: &Sweep, stop: &Arc<Stop>) -> Result<u8, Refused> {
    let file = sweep.scene.display().to_string();
    let text = read_text(&sweep.scene).map_err(|e| format!("cannot read {file}: {e}\n"))?;
    let runs = combinations(&sweep.over)?;
    let stem = sweep.scene.file_stem().unwrap_or("scene".as_ref()).to_string_lossy();
    let out = sweep.out.clone().unwrap_or_else(|| Path::new("out").join(format!("{stem}-sweep")));
    let scene = Scene::with_overrides(&text, &file, &sweep.replaced);
    if scene.is_ok_and(|scene| scene.error.is_some()) {
        say(
            "warning: a sweep finds no errors, and [error] is left out; run what counts by `coque run --error`",
        );
    }
    let folder = take(&out)?;
    stop.begin();
    folder.clear()?;
    clear_runs(&out)?;
    let next = AtomicUsize::new(0);
    let rows: Mutex<Vec<Option<Row>>> = Mutex::new(runs.iter().map(|_| None).collect());
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if stop.asked() {
                return;
            }
            let Some(values) = runs.get(number) else { return };
            let replaced = [&sweep.replaced[..], &values[..]].concat();
            let row = one(&text, &file, &replaced, &out.join(format!("{:03}", number + 1)), stop);
            let named: Vec<String> = values.iter().map(|(path, value)| format!("{path}={value}")).collect();
            let (all, named) = (runs.len(), named.join(" "));
            for warning in &row.warnings {
                say(&format!("[{}/{all}] warning: {}", number + 1, warning.message));
            }
            let warnings =
                if row.warnings.is_empty() { String::new() } else { format!(", {}", row.warnings()) };
            say(&format!("[{}/{all}] {named}: {}{warnings} ({:.1} s)", number + 1, row.ended, row.seconds));
            // A poisoned lock means that another run panicked; what it left is whole rows.
            rows.lock().unwrap_or_else(|poisoned| poisoned.into_inner())[number] = Some(row);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..usize::from(sweep.jobs).min(runs.len()) {
            scope.spawn(work);
        }
    });
    let rows = rows.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    let table = out.join(ResultFolder::TABLE);
    write_whole(&table, |to| write_table(to, &sweep.over, &runs, &rows))
        .map_err(|e| format!("cannot write {}: {e}\n", table.display()))?;
    let of = |code: u8| rows.iter().flatten().filter(|row| row.code == code).count();
    let unsettled = of(NOT_SETTLED);
    let done = of(DONE) + unsettled;
    say(&format!("{done} of {} runs done; the table is {}", runs.len(), table.display()));
    if unsettled > 0 {
        say(&format!("not settled: {unsettled} of them"));
    }
    Ok(match () {
        () if stop.asked() => INTERRUPTED,
        () if done < runs.len() => DIVERGED,
        () if unsettled > 0 => NOT_SETTLED,
        () => DONE,
    })
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
    let first =
        if columns.iter().any(|column| column.name == MODE) { 0 } else { rows.len().saturating_sub(1) };
    let found = rows[first..].to_vec();
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

type Values = Vec<(String, String)>;

/// Every combination of the values, the last list running fastest.
fn combinations(over: &[(String, String)]) -> Result<Vec<Values>, String> {
    let mut runs = vec![Values::new()];
    for (path, list) in over {
        let values = split(list);
        if values.iter().any(|value| value.is_empty()) {
            return Err(format!("--over {path}={list}: a value is empty; write PATH=V1,V2,…\n"));
        }
        if runs.len() * values.len() > MOST_RUNS {
            return Err(format!("more than {MOST_RUNS} combinations; give fewer values\n"));
        }
        let with = |run: &Values, value: &&str| {
            let mut run = run.clone();
            run.push((path.clone(), (*value).to_owned()));
            run
        };
        runs = runs.iter().flat_map(|run| values.iter().map(move |value| with(run, value))).collect();
    }
    Ok(runs)
}

/// Parts between commas that stand in no bracket and no quotes.
fn split(list: &str) -> Vec<&str> {
    let (mut depth, mut quote, mut start) = (0_i32, None, 0);
    let mut parts = Vec::new();
    for (at, c) in list.char_indices() {
        match (quote, c) {
            (Some(open), _) if c == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth -= 1,
            (None, ',') if depth == 0 => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(list[start..].trim());
    parts
}

/// The table: columns of curves are those of the first run that has any, found by name in the others.
fn write_table(
    to: &mut impl Write,
    over: &[(String, String)],
    runs: &[Values],
    rows: &[Option<Row>],
) -> std::io::Result<()> {
    let mut columns: Vec<&Column> = Vec::new();
    for column in rows.iter().flatten().flat_map(|row| &row.columns) {
        if !columns.contains(&column) {
            columns.push(column);
        }
    }
    let titles = columns.iter().map(|column| column.title());
    let paths = over.iter().map(|(path, _)| quoted(path));
    let head: Vec<String> = std::iter::once("run".into())
        .chain(paths)
        .chain(["ended".into(), "warnings".into(), "wall [s]".into()])
        .chain(titles)
        .collect();
    writeln!(to, "{}", head.join(","))?;
    for (number, (values, row)) in runs.iter().zip(rows).enumerate() {
        let values = values.iter().map(|(_, value)| quoted(value));
        let mut cells: Vec<String> = std::iter::once((number + 1).to_string()).chain(values).collect();
        match row {
            None => cells.extend(["not run".into(), String::new(), String::new()]),
            Some(row) => {
                cells.extend([quoted(&row.ended), row.warnings(), format!("{:.3}", row.seconds)]);
            }
        }
        let known = row.as_ref().map_or(&[][..], |row| &row.columns);
        let places: Vec<_> = columns.iter().map(|column| known.iter().position(|k| k == *column)).collect();
        let none = vec![vec![]];
        let found = row.as_ref().map(|row| &row.found).filter(|found| !found.is_empty()).unwrap_or(&none);
        for values in found {
            let value = |place: &Option<usize>| values.get((*place)?).map(|value| format!("{value:?}"));
            let values = places.iter().map(|place| value(place).unwrap_or_default());
            let line: Vec<String> = cells.iter().cloned().chain(values).collect();
            writeln!(to, "{}", line.join(","))?;
        }
    }
    Ok(())
}

/// A cell of the table: in quotes where it holds a comma, a quote or a line break.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_split_at_outer_commas() {
        assert_eq!(split("1, 2.5,3e4"), ["1", "2.5", "3e4"]);
        assert_eq!(split("[25, 3],[50, 5]"), ["[25, 3]", "[50, 5]"]);
        assert_eq!(split("{ a = [1, 2], b = \"},\" },'x,y'"), ["{ a = [1, 2], b = \"},\" }", "'x,y'"]);
        assert_eq!(split(""), [""]);
    }

    #[test]
    fn combinations_run_through_the_last_list_first() {
        let over = [("a".to_string(), "1,2".to_string()), ("b".to_string(), "x,y,z".to_string())];
        let runs = combinations(&over).unwrap();
        let shown: Vec<String> = runs.iter().map(|run| format!("{}{}", run[0].1, run[1].1)).collect();
        assert_eq!(shown, ["1x", "1y", "1z", "2x", "2y", "2z"]);
        assert!(combinations(&[("a".into(), "1,,2".into())]).is_err());
    }
}
