//! The error of every number of a run: the scene on other lattices, row by row beside it.

use std::ops::ControlFlow;
use std::time::Instant;

use sph_core::{Cell, Vec3};

use super::bars::{OnLattice, bar};
use super::pairing::{Key, Shapes, by_column, by_shape, key};
use super::refined::Refined;
use super::said::{holds, lacks};
use crate::results::curve::{Column, Curve};
use crate::results::error_bars::{ColumnErrors, CriticalError, ErrorBar, Errors, LatticeRun, Verdict};
use crate::run::outcome::{Ended, Outcome};
use crate::run::progress::{Progress, ProgressReport};
use crate::scene::{Analysis, Checked};

/// Columns that count or place a row and have no error.
const PLACES: [&str; 7] =
    ["time", "mode", "iterations", "negative_pivots", "residual", "unbalanced", "remaining_displacement"];
/// Columns that are so small beside others of their unit are zero by symmetry: what differs in them is round-off.
const VANISHING: f64 = 1e-6;
/// Critical points that are located, and so have an error.
const LOCATED: [&str; 2] = ["limit point", "bifurcation"];

/// A run on a lattice.
struct Found {
    spacing: f64,
    curve: Curve,
    critical: Vec<(String, f64)>,
    rest: Vec<Vec3>,
    cells: Vec<Cell>,
    /// Places in each shape.
    shapes: Vec<Vec<Vec3>>,
}

impl Found {
    fn of(spacing: f64, rest: Vec<Vec3>, outcome: &Outcome) -> Self {
        let critical = outcome.summary.record.critical.iter();
        Self {
            spacing,
            curve: outcome.curve.clone(),
            critical: critical.map(|point| (point.kind.clone(), point.level)).collect(),
            rest,
            cells: outcome.cells.clone(),
            shapes: outcome.shapes.iter().map(|shape| shape.positions.clone()).collect(),
        }
    }

    fn shapes(&self) -> Shapes<'_> {
        let modes = self.shapes.iter().take(self.curve.rows.len()).map(Vec::as_slice).collect();
        Shapes { rest: &self.rest, cells: &self.cells, modes }
    }
}

impl Checked {
    /// The errors of what a run of the scene found, by runs on other lattices, one after the other; `progress` may end them, and those that ended
    /// count. Where there can be no bar, it is said in [`Errors::without`].
    pub fn errors(&self, outcome: &Outcome, threads: usize, progress: &mut dyn Progress) -> Errors {
        if outcome.ended != Ended::Done {
            return Errors::none(format!("the run did not reach its end: {}", outcome.ended));
        }
        let found = match self.companions(threads) {
            Ok(found) => found,
            Err(why) => return Errors::none(why),
        };
        let own_words = LatticeRun {
            lattice: "its own".into(),
            spacing: 1.0,
            seconds: outcome.summary.record.wall_seconds,
            ended: outcome.ended.to_string(),
        };
        let mut errors = Errors { lattices: vec![own_words], holds: holds(self), ..Errors::default() };
        errors.lacks = found.lacks.into_iter().chain(lacks(self)).collect();
        let own = Found::of(1.0, found.rest, outcome);
        let mut others = Vec::new();
        for (number, companion) in found.lattices.iter().enumerate() {
            progress.companion(number + 1, found.lattices.len(), &companion.lattice);
            match run(companion, threads, progress, &mut errors) {
                ControlFlow::Continue(found) => others.extend(found),
                ControlFlow::Break(()) => {
                    errors.without.push("a run on another lattice was interrupted".into());
                    break;
                }
            }
        }
        if others.is_empty() {
            errors.without.push("no run on another lattice came to answers".into());
            return errors;
        }
        fill(&mut errors, self, &own, &others, &found.moved);
        errors
    }
}

/// Runs a companion; none where it is refused or finds nothing, which is said; `Break` where it was ended from outside.
fn run(
    companion: &Refined,
    threads: usize,
    progress: &mut dyn Progress,
    errors: &mut Errors,
) -> ControlFlow<(), Option<Found>> {
    let Refined { scene, spacing, lattice } = companion;
    let begun = Instant::now();
    let model = match scene.build(threads) {
        Ok(model) => model,
        Err(error) => {
            errors.without.push(format!("the scene is refused on {lattice}: {error}"));
            return ControlFlow::Continue(None);
        }
    };
    let rest = model.body.body().configuration().rest.to_vec();
    let outcome = model.run(&mut Quiet(progress));
    let (seconds, ended) = (begun.elapsed().as_secs_f64(), outcome.ended.to_string());
    errors.lattices.push(LatticeRun { lattice: lattice.clone(), spacing: *spacing, seconds, ended });
    if let Ended::Interrupted { .. } = outcome.ended {
        return ControlFlow::Break(());
    }
    if outcome.ended != Ended::Done {
        let rows = "; rows beyond have a bar of fewer lattices, or none";
        errors.without.push(format!("the run on {lattice} ended early: {}{rows}", outcome.ended));
    }
    let found = (!outcome.curve.rows.is_empty()).then(|| Found::of(*spacing, rest, &outcome));
    ControlFlow::Continue(found)
}

/// Pairs the rows and gives each number its bar.
fn fill(errors: &mut Errors, scene: &Checked, own: &Found, others: &[Found], moved: &[String]) {
    let curves: Vec<&Curve> =
        [&own.curve].into_iter().chain(others.iter().map(|other| &other.curve)).collect();
    errors.critical = critical(own, others);
    let key = match key(&scene.analysis, &curves) {
        Ok(key) => key,
        Err(why) => {
            errors.without.push(why);
            return;
        }
    };
    let paired: Vec<Vec<Option<Vec<f64>>>> = others.iter().map(|other| rows(own, other, &key)).collect();
    let placed = matches!(scene.analysis, Analysis::Buckling(_));
    for (at, column) in own.curve.columns.iter().enumerate() {
        let name = column.name.as_str();
        let given = name == "level" && !placed && !matches!(scene.analysis, Analysis::ArcLength(_));
        if PLACES.contains(&name) || given || key == Key::Column(at) {
            continue;
        }
        if let Some(set) = moved_set(scene, name, moved) {
            errors.without.push(format!("{name}: its set `{set}` is on no particle of the other lattices"));
            continue;
        }
        let (greatest, beside) = scales(&own.curve, at);
        let vanishes = greatest <= VANISHING * beside;
        let bars = (0..own.curve.rows.len()).map(|row| {
            let answers: Vec<OnLattice> = paired
                .iter()
                .zip(others)
                .filter_map(|(rows, other)| {
                    Some(OnLattice { spacing: other.spacing, value: rows[row].as_ref()?[at] })
                })
                .collect();
            let value = own.curve.rows[row][at];
            let found = bar(OnLattice { spacing: own.spacing, value }, &answers, greatest);
            if vanishes { zero(found, &answers) } else { found }
        });
        errors.columns.push(ColumnErrors { column: column.clone(), bars: bars.collect() });
    }
}

/// The bar of a number that is zero by symmetry: what is there is round-off.
fn zero(found: ErrorBar, answers: &[OnLattice]) -> ErrorBar {
    let most = answers.iter().map(|answer| answer.value.abs()).fold(found.value.abs(), f64::max);
    let known = !answers.is_empty() && most.is_finite();
    if known { ErrorBar { bar: Some(most), order: None, verdict: Verdict::Exact, ..found } } else { found }
}

/// Greatest values of a column and of all columns of its unit.
fn scales(curve: &Curve, at: usize) -> (f64, f64) {
    let greatest = |at: usize| curve.rows.iter().fold(0.0, |most: f64, row| most.max(row[at].abs()));
    let alike =
        |column: &Column| column.unit == curve.columns[at].unit && !PLACES.contains(&column.name.as_str());
    let beside = curve
        .columns
        .iter()
        .enumerate()
        .filter(|(_, column)| alike(column))
        .map(|(other, _)| greatest(other));
    (greatest(at), beside.fold(0.0, f64::max))
}

/// The set of a column, if it is one of those that are on no particle of the other lattices.
fn moved_set<'a>(scene: &Checked, column: &str, moved: &'a [String]) -> Option<&'a String> {
    let probe = scene.curve.iter().find(|probe| probe.name == column)?;
    moved.iter().find(|set| **set == probe.on)
}

/// The rows of another run that answer those of a run.
fn rows(own: &Found, other: &Found, key: &Key) -> Vec<Option<Vec<f64>>> {
    match key {
        Key::Only => {
            own.curve.rows.iter().enumerate().map(|(row, _)| other.curve.rows.get(row).cloned()).collect()
        }
        Key::Column(at) => by_column(&own.curve, &other.curve, *at),
        Key::Shape => {
            let pairs = by_shape(&own.shapes(), &other.shapes());
            (0..own.curve.rows.len())
                .map(|row| pairs.get(row).copied().flatten().and_then(|at| other.curve.rows.get(at).cloned()))
                .collect()
        }
    }
}

/// Levels of critical points, paired by kind and order.
fn critical(own: &Found, others: &[Found]) -> Vec<CriticalError> {
    let scale = own.critical.iter().fold(0.0, |most: f64, (_, level)| most.max(level.abs()));
    let located = |kind: &str| LOCATED.iter().any(|located| kind.starts_with(located));
    let mut found: Vec<CriticalError> = Vec::new();
    for (kind, level) in own.critical.iter().filter(|(kind, _)| located(kind)) {
        let before = found.iter().filter(|known| known.kind == *kind).count();
        let on = |other: &Found| {
            let value = other.critical.iter().filter(|(known, _)| known == kind).nth(before)?.1;
            Some(OnLattice { spacing: other.spacing, value })
        };
        let answers: Vec<OnLattice> = others.iter().filter_map(on).collect();
        let bar = bar(OnLattice { spacing: own.spacing, value: *level }, &answers, scale);
        found.push(CriticalError { kind: kind.clone(), bar });
    }
    found
}

/// A run on another lattice, of which its rows are nobody's.
struct Quiet<'a>(&'a mut dyn Progress);

impl Progress for Quiet<'_> {
    fn update(&mut self, news: &ProgressReport) -> ControlFlow<()> {
        self.0.update(news)
    }
}
